// Reads the files of a machine at power-on: ini file, parameter file, tool table. Writes the parameter file and the tool table at the end
// of the program (spec/linuxcnc 1.1, 4.4, 9, 10.1).

#include "config/read_file.h"
#include "control/emitter.h"
#include "control/linuxcnc/linuxcnc.h"
#include "control/linuxcnc/tools.h"

namespace kadr::linuxcnc {
namespace {

constexpr std::size_t max_bytes = 1'000'000;  // greatest size in bytes of an ini file, parameter file or tool table file that is read

/// Returns the path of a file that the ini file or the set-up names. A relative path is relative to `folder` of the program memory.
std::string path_in(const std::string& folder, const std::string& name) { return name.starts_with('/') ? name : folder + "/" + name; }

}  // namespace

/// Reads the ini file that the set-up names (spec/linuxcnc 10.1).
void LinuxCnc::read_machine_file(BlockContext& m, const Setup& setup, const RunLimits& limits) {
  if (setup.ini.empty()) return;
  const auto text = read_file(path_in(limits.files, setup.ini), max_bytes, limits.door);
  if (text) machine = machine_of(Ini(*text));
  else m.start_fault = {"ini", text.error(), text.error()};
}

/// Reads the parameter file that the ini file names. If the file is missing, there is no alarm (spec/linuxcnc 4.4).
void LinuxCnc::read_parameter_file(BlockContext& m, const RunLimits& limits) {
  if (machine.parameter_file.empty()) return;
  writes_parameters_ = limits.writes_files;
  const auto text = read_file(path_in(limits.files, machine.parameter_file), max_bytes, limits.door);
  if (!text) return;
  const auto read = read_parameters(*text);
  if (!read) {
    m.start_fault = {"ini", machine.parameter_file + ": " + read.error(), machine.parameter_file + ": " + read.error()};
    return;
  }
  stored_ = *read;
  parameters_before_ = *text;
}

/// Sets the parameters to the values in the parameter file. Values in the set-up have priority.
void LinuxCnc::take_parameters(BlockContext& m) {
  for (const auto& [n, value] : stored_) {
    if (n <= max_arguments) levels_.front().arguments[n] = value;
    else if (m.variables.raw(n) == 0) m.variables.set_raw(n, value);
  }
}

void LinuxCnc::save_parameters(Emitter& m, bool program_ends) {
  if (!writes_parameters_) return;
  const std::string text = parameters_text(stored_, [&](std::uint32_t n) {
    if (n <= max_arguments) return levels_.front().arguments[n];
    return program_ends && n == system_number ? 1.0 : m.variables.raw(n);
  });
  const Status saved = outputs.replace(ProgramFiles::Which::parameters, machine.parameter_file, parameters_before_, text);
  if (!saved) m.warn(warning(saved.error().id, {}, std::string_view(machine.parameter_file)));
}

/// Reads LinuxCNC's tool table file (spec/linuxcnc 9).
void LinuxCnc::read_tool_file(const RunLimits& limits) {
  if (limits.files.empty()) return;
  const std::string table = machine.tool_table.empty() ? "tool.tbl" : machine.tool_table;
  if (const auto text = read_file(path_in(limits.files, table), max_bytes, limits.door); text) {
    tools = read_tools(*text, machine.unit);
    tools_before_ = *text;
    table_is_known = true;
    writes_tools_ = limits.writes_files && !machine.tool_table.empty();
  }
}

/// Writes the tool table to its file, which the ini file names, if G10 has changed the table.
void LinuxCnc::save_tools(Emitter& m) {
  if (!writes_tools_ || !tools_changed) return;
  const Status saved = outputs.replace(ProgramFiles::Which::tools, machine.tool_table, tools_before_, tools_text(tools, machine.unit));
  if (!saved) m.warn(warning(saved.error().id, {}, std::string_view(machine.tool_table)));
}

}  // namespace kadr::linuxcnc
