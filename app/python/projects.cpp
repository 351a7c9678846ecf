// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Projects for Python: a design is a value that never changes; each change gives another.
#include "app/python/bindings.h"
#include "app/python/unlocked.h"

#include "core/base/words.h"
#include "core/project/library.h"
#include "core/project/project_file.h"
#include "core/project/project_value.h"

#include <fmt/format.h>
#include <pybind11/stl.h>

#include <algorithm>

namespace hygroloom::python {
namespace {

template <typename Item> const Item& chosen(const std::vector<Item>& items, const std::string& name, const char* what)
{
    for (const Item& item : items)
        if (item.name == name || (name.empty() && items.size() == 1)) return item;
    const std::vector<std::string> known = names_in(items);
    const std::string names = listed_in_quotes(known);
    if (items.empty()) throw Error(fmt::format("The project has no {}.", what));
    if (name.empty()) throw Error(fmt::format("The project has several {0}s; name one with {0}=: {1}.", what, names));
    throw Error(fmt::format("The project has no {} \"{}\"{} It has {}.", what, name, did_you_mean(name, known), names));
}

/// Without what the command line puts before its paths.
std::string without_option(std::string sentence)
{
    constexpr std::string_view option = "--set";
    if (sentence.starts_with(option)) sentence.erase(0, option.size());
    return sentence.substr(std::min(sentence.size(), sentence.find_first_not_of(": ")));
}

Design changed(const Design& design, const std::string& path, const std::string& value)
try {
    return with_value(design, path, value);
} catch (const Error& error) {
    throw Error(without_option(error.what()));
}

std::string first_of(const char* what, const std::vector<Issue>& issues)
{
    const auto errors = std::count_if(issues.begin(), issues.end(), [](const Issue& issue) { return issue.severity == Severity::error; });
    const Issue* first = first_error(issues);
    const std::string more = errors > 1 ? fmt::format(" There are {} more errors; see .issues.", errors - 1) : "";
    return fmt::format("The {} has errors; nothing was computed. {}: {}{}", what, first->where.text(), first->text(), more);
}

py::list fabric_names(const Design& design)
{
    py::list names;
    for (const Fabric& fabric : design.fabrics) names.append(text(fabric.name));
    return names;
}

/// Pairs of name and type.
py::list experiment_names(const Design& design)
{
    py::list names;
    for (const Experiment& experiment : design.experiments) names.append(py::make_tuple(text(experiment.name), name_of(experiment.type)));
    for (const WearExperiment& wear : design.wears) names.append(py::make_tuple(text(wear.name), "wear"));
    return names;
}

} // namespace

InvalidProject::InvalidProject(const char* what, std::vector<Issue> found) : Error(first_of(what, found)), issues(std::move(found)) {}

std::vector<std::shared_ptr<const FittedFabric>> require_valid(const Design& design)
{
    Validation found = validate_and_fit(design);
    if (has_error(found.issues)) throw InvalidProject("project", std::move(found.issues));
    return std::move(found.fabrics);
}

const Fabric& chosen_fabric(const Design& design, const std::string& name) { return chosen(design.fabrics, name, "fabric"); }

const Experiment& chosen_experiment(const Design& design, const std::string& name)
{
    return chosen(design.experiments, name, "experiment");
}

const WearExperiment* chosen_wear(const Design& design, const std::string& name)
{
    if (name.empty() && design.experiments.empty() && !design.wears.empty()) return &chosen(design.wears, name, "experiment");
    return find_wear(design, name);
}

void add_projects(py::module_& module)
{
    using released = py::call_guard<Unlocked>;
    py::class_<Design>(module, "Design").def("__eq__", [](const Design& one, const Design& other) { return one == other; });
    module.def(
        "read_project", [](const std::string& path) { return read_project(path); }, released());
    module.def(
        "parse_project", [](const std::string& json, const std::string& name) { return parse_project(json, name); }, released());
    module.def(
        "write_project", [](const Design& design, const std::string& path) { write_project(design, path); }, released());
    module.def("format_project", [](const Design& design) { return text(format_project(design)); });
    module.def("with_value", &changed, released());
    module.def("value_at", [](const Design& design, const std::string& path) -> py::object {
        const ProjectJson value = value_at(design, path);
        return value.is_null() ? py::object(py::none()) : py::object(text(value.dump()));
    });
    module.def("fabric_names", &fabric_names);
    module.def("yarn_table", [](const std::string& library) { return text(csv_of_yarns(read_yarns(library), true)); });
    module.def("experiment_names", &experiment_names);
}

} // namespace hygroloom::python
