// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The module _hygroloom: its parts, and the core's exceptions as Python's.
#include "app/python/bindings.h"
#include "app/python/unlocked.h"
#include "app/python/watched.h"

#include "core/base/utf8.h"

namespace hygroloom::python {
namespace {

/// The package's exception of that name with these arguments.
template <typename... Arguments> void raise(const char* name, const Arguments&... arguments)
{
    const py::object type = py::module_::import("hygroloom.errors").attr(name);
    PyErr_SetObject(type.ptr(), type(arguments...).ptr());
}

py::list issue_list(const std::vector<Issue>& issues)
{
    constexpr const char* severities[] = {"note", "warning", "error"};
    py::list list;
    for (const Issue& issue : issues)
        list.append(
            py::make_tuple(severities[static_cast<int>(issue.severity)], text(issue.code), text(issue.where.text()), text(issue.text())));
    return list;
}

void translate(std::exception_ptr failure) // NOLINT(performance-unnecessary-value-param): so pybind11 has it
{
    if (!failure) return;
    try {
        std::rethrow_exception(failure);
    } catch (const InvalidProject& error) {
        raise("InvalidProject", text(error.what()), issue_list(error.issues));
    } catch (const FileError& error) {
        raise("FileError", text(error.what()));
    } catch (const DeviceError& error) {
        raise("DeviceError", text(error.what()));
    } catch (const Error& error) {
        raise("Error", text(error.what()));
    } catch (const std::bad_alloc&) {
        PyErr_SetString(PyExc_MemoryError, "Out of memory; use a smaller sample or a lower fidelity.");
    }
}

} // namespace

py::str text(const std::string& utf8)
{
    const std::string whole = in_whole_utf8(utf8);
    return {whole.data(), whole.size()};
}

void add_errors(py::module_& module)
{
    py::register_exception_translator(&translate);
    module.def("validate", [](const Design& design) {
        std::vector<Issue> issues;
        {
            const Unlocked no_python;
            issues = validate(design);
        }
        return issue_list(issues);
    });
}

} // namespace hygroloom::python

PYBIND11_MODULE(_hygroloom, module)
{
    module.doc() = "The C++ side of hygroloom; use the package.";
    module.attr("version") = HYGROLOOM_VERSION;
    module.def("end_all_work", &hygroloom::python::end_all_work);
    hygroloom::python::add_projects(module);
    hygroloom::python::add_errors(module);
    hygroloom::python::add_recordings(module);
    hygroloom::python::add_wear_recordings(module);
    hygroloom::python::add_runs(module);
    hygroloom::python::add_studies(module);
    hygroloom::python::add_sweeps(module);
}
