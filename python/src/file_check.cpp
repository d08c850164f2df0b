// Checks a file as `kadr check` does. Used by module.cpp; tested by tests/archive.py and tests/python_binding.py.

#include "file_check.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "interrupt.h"

namespace kadr::python {
namespace {

/// Adds the files that the session has read to a list without repetitions. The first file of a channel is its program.
void add_files(const Session& session, const std::string& own, std::vector<std::string>& files) {
  for (const Channel& channel : session.channels())
    for (const std::string& file : channel.control->files_read())
      if (file != own && std::find(files.begin(), files.end(), file) == files.end()) files.push_back(file);
}

}  // namespace

FileCheck check_file(const ProgramSpec& spec) {
  if (const std::string why = spec.refusal(); !why.empty()) throw Failed{why};
  FileCheck checked;
  const std::size_t programs = spec.count_programs();
  const ChecklistBasis basis{.tools = {}, .own_tools = false, .own_setup = false};  // the set-up is that of many programs
  std::atomic<bool> stop = false;
  ProgramCheck check({.stated = spec.stated(), .basis = basis, .stop = StopToken(stop)}, [&](std::size_t, const AlarmReport& report) {
    checked.findings.push_back(spec.finding(report));
    return true;
  });
  RunLimits limits;
  limits.restarts = 0;
  const CatchInterrupt interrupt(stop);
  for (std::size_t i = 0; i < programs && !stop; ++i) {
    const auto session = spec.open(stop, limits, i);
    check.check(*session);
    add_files(*session, spec.file(), checked.files);
  }
  if (stop) throw Interrupted{};
  return checked;
}

std::string Remembered::of(const std::string& file) {
  std::string control = controls_.of(file);
  if (!fault_.empty()) throw Failed{fault_};
  return control;
}

std::string name_verdict(const std::string& name) {
  switch (judge_name(name)) {
    case NameVerdict::program: return "program";
    case NameVerdict::nothing: return "nothing";
    case NameVerdict::other: break;
  }
  return "other";
}

}  // namespace kadr::python
