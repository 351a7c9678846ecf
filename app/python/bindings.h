// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The module _hygroloom, which the package hygroloom wraps: what each file adds to it. Texts of names and files come as bytes.
#pragma once

#include "core/base/error.h"
#include "core/design/validate.h"

#include <pybind11/pybind11.h>

#include <string>
#include <vector>

namespace hygroloom::python {

namespace py = pybind11;

/// Runs were asked for of a project or a study that has errors.
struct InvalidProject : Error {
    /// what: "project" or "study".
    InvalidProject(const char* what, std::vector<Issue> found);
    std::vector<Issue> issues;
};

/// Each fabric as it was fitted. Throws InvalidProject.
std::vector<std::shared_ptr<const FittedFabric>> require_valid(const Design& design);

/// The fabric, or sample's experiment, of that name; the only one for an empty name. Throws Error with the names there are.
const Fabric& chosen_fabric(const Design& design, const std::string& name);
const Experiment& chosen_experiment(const Design& design, const std::string& name);

/// The experiment of a garment of that name, or without a name of a project that has no others; null: the name is of another or of none.
/// Throws Error where several could be meant.
const WearExperiment* chosen_wear(const Design& design, const std::string& name);

/// For Python's JSON reader.
py::str text(const std::string& utf8);

void add_errors(py::module_& module);
void add_projects(py::module_& module);
void add_recordings(py::module_& module);
void add_wear_recordings(py::module_& module);
void add_runs(py::module_& module);
void add_studies(py::module_& module);
void add_sweeps(py::module_& module);

} // namespace hygroloom::python
