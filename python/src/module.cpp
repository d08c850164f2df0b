// The extension module kadr._kadr, which the Python files kadr/*.py use. It releases the interpreter lock (GIL) while programs run.

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <cerrno>

#include "file_check.h"
#include "run.h"
#include "views.h"

namespace py = pybind11;
using namespace py::literals;

namespace kadr::python {
namespace {

using Released = py::call_guard<py::gil_scoped_release>;

py::object text_of(const std::string& bytes) {  // a file name may contain any bytes
  return py::reinterpret_steal<py::object>(PyUnicode_DecodeUTF8(bytes.data(), static_cast<Py_ssize_t>(bytes.size()), "replace"));
}

const char* severity_of(const Finding& finding) {
  switch (finding.severity) {
    case Severity::alarm: return "alarm";
    case Severity::warning: return "warning";
    case Severity::advice: return "advice";
    case Severity::note: break;
  }
  return "note";
}

py::dict dict_of(const Finding& f) {
  py::list calls;
  for (const std::string& call : f.calls) calls.append(text_of(call));
  return py::dict("id"_a = std::string(name_of(f.id)), "severity"_a = severity_of(f), "text"_a = text_of(f.text),
                  "hint"_a = text_of(f.hint), "file"_a = text_of(f.file), "line"_a = f.line, "column"_a = f.column,
                  "end_column"_a = f.end_column, "block"_a = text_of(f.block), "number"_a = text_of(f.number),
                  "line_text"_a = text_of(f.line_text), "calls"_a = py::tuple(calls));
}

py::list list_of(const std::vector<Finding>& findings) {
  py::list list;
  for (const Finding& finding : findings) list.append(dict_of(finding));
  return list;
}

py::object tuple_of(const std::optional<Place>& place) {
  if (!place) return py::none();
  return py::make_tuple(text_of(place->file), place->line, place->block < 0 ? py::object(py::none()) : py::int_(place->block),
                        place->depth);
}

void set_error(const char* name, const py::object& about) {
  const py::object raised = py::module_::import("kadr._errors").attr(name)(about);
  PyErr_SetObject(reinterpret_cast<PyObject*>(Py_TYPE(raised.ptr())), raised.ptr());
}

void translate(std::exception_ptr thrown) {
  try {
    if (thrown) std::rethrow_exception(thrown);
  } catch (const Failed& failed) {
    set_error("Error", text_of(failed.text));
  } catch (const Alarmed& alarmed) {
    set_error("alarm_of", dict_of(alarmed.finding));
  } catch (const FileFailed& failed) {
    errno = failed.error;
    PyErr_SetFromErrnoWithFilename(PyExc_OSError, failed.file.c_str());
  } catch (const Interrupted&) {
    if (PyErr_CheckSignals() == 0) PyErr_SetNone(PyExc_KeyboardInterrupt);  // or whatever the Python program's handler raises
  }
}

py::bytearray bytes_of(const std::string& bytes) { return {bytes.data(), bytes.size()}; }

std::shared_ptr<ProgramSpec> spec_of(const py::bytes& file, const std::optional<py::bytes>& text, const std::string& control,
                                     const std::string& machine, const py::bytes& setup_file, const std::string& setup_json,
                                     const std::string& lang) {
  const ProgramRequest request{.file = file,
                               .text = text ? std::optional(std::string(*text)) : std::nullopt,
                               .control = control,
                               .machine = machine,
                               .setup_file = setup_file,
                               .setup_json = setup_json,
                               .lang = lang == "ru" ? Lang::ru : Lang::en};
  const py::gil_scoped_release released;
  return std::make_shared<ProgramSpec>(request);
}

void add_spec(py::module_& module) {
  py::class_<ProgramSpec, std::shared_ptr<ProgramSpec>>(module, "Spec")
      .def(py::init(&spec_of), "file"_a, "text"_a, "control"_a, "machine"_a, "setup_file"_a, "setup_json"_a, "lang"_a)
      .def_property_readonly("control", [](const ProgramSpec& spec) { return spec.control().id; })
      .def_property_readonly("machine", [](const ProgramSpec& spec) { return spec.machine().id; })
      .def("check",
           [](const ProgramSpec& spec) {
             std::vector<Finding> found;
             {
               const py::gil_scoped_release released;
               found = check(spec);
             }
             return list_of(found);
           })
      .def("check_file",
           [](const ProgramSpec& spec) {
             FileCheck checked;
             {
               const py::gil_scoped_release released;
               checked = check_file(spec);
             }
             py::list files;
             for (const std::string& file : checked.files) files.append(text_of(file));
             return py::make_tuple(list_of(checked.findings), files);
           })
      .def("picture",
           [](const ProgramSpec& spec, const std::string& kind) {
             std::string made;
             {
               const py::gil_scoped_release released;
               made = picture(spec, kind);
             }
             return py::bytes(made);
           })
      .def("axes_in_time", [](const ProgramSpec& spec, double rate, double longest) {
        AxesInTime made;
        {
          const py::gil_scoped_release released;
          made = axes_in_time(spec, rate, longest);
        }
        return py::make_tuple(made.axes, bytes_of(made.rows), made.seconds);
      });
}

void add_run(py::module_& module) {
  py::class_<Run::Kept, std::shared_ptr<Run::Kept>>(module, "Kept");
  py::class_<Run>(module, "Run")
      .def(py::init([](std::shared_ptr<ProgramSpec> spec, std::size_t most) { return std::make_unique<Run>(std::move(spec), most); }),
           Released())
      .def("run", &Run::run, Released())
      .def("step",
           [](Run& run) {
             std::optional<Place> place;
             {
               const py::gil_scoped_release released;
               place = run.step();
             }
             return tuple_of(place);
           })
      .def(
          "snapshot", [](Run& run) { return std::const_pointer_cast<Run::Kept>(run.snapshot()); }, Released())
      .def(
          "restore", [](Run& run, const Run::Kept& from) { run.restore(from); }, Released())
      .def("rows", [](Run& run) { return bytes_of(run.rows()); })
      .def("evaluate", &Run::evaluate, Released())
      .def("position", &Run::position, "machine"_a)
      .def("variables", &Run::variables)
      .def("modal", &Run::modal)
      .def("warnings", [](Run& run) { return list_of(run.warnings()); })
      .def("files",
           [](Run& run) {
             py::list names;
             for (const std::string& name : run.files()) names.append(text_of(name));
             return names;
           })
      .def_property_readonly("next", [](Run& run) { return tuple_of(run.next()); })
      .def_property_readonly("state", &Run::state)
      .def_property_readonly("seconds", &Run::seconds)
      .def_property_readonly("motions", &Run::motions)
      .def_property_readonly("axes", &Run::axes);
}

}  // namespace
}  // namespace kadr::python

PYBIND11_MODULE(_kadr, module) {
  using namespace kadr::python;
  module.attr("version") = std::string(kadr::version);
  py::register_exception_translator(&translate);
  module.def("controls", &kadr::built_in_controls);
  module.def("machines", &kadr::built_in_machines);
  py::class_<Remembered>(module, "Remembered")
      .def(py::init<>())
      .def(
          "of", [](Remembered& remembered, const py::bytes& file) { return remembered.of(file); }, "file"_a);
  module.def(
      "name_verdict", [](const py::bytes& name) { return name_verdict(name); }, "name"_a);
  add_spec(module);
  add_run(module);
}
