#pragma once
// Reads tools files as ToolGeometry: the TOML format of Kadr (docs/commands/cut.md, "Tools"), and the libraries and tables of other
// programs (config/tools/tool_formats.h).

#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "base/file_access.h"
#include "config/tools/tool_geometry.h"

namespace kadr {

namespace limits {
inline constexpr std::size_t tools = 10'000;          // greatest number of tools in one file
inline constexpr std::size_t outline_points = 1'000;  // greatest number of points in a profile, shank or holder
inline constexpr int teeth = 1'000;                   // greatest number of cutting edges of a tool
}  // namespace limits

struct ToolLibrary {
  std::vector<ToolGeometry> tools;
  // True if lengths are in the machine's units, as in the tool table of a control; take_unit() converts them
  bool in_machine_units = false;
  std::vector<std::string> notes;  // notes for the user: one sentence for each tool left out and for each assumption

  /// Returns the tool with this number; nullptr if the library has no such tool. If the library has a single tool without a number (0),
  /// returns this tool for every number.
  const ToolGeometry* find(std::uint32_t number) const;
};

/// Returns a message with the reason why the shape is not valid, such as "diameter is missing"; empty if the shape is valid.
std::string tool_fault_message(const ToolGeometry& tool);

/// Sets flute length and stick-out to the usual lengths for the diameter if the file states neither: 3 and 5 diameters, for drills 8 and
/// 10.
///   returns  true if both lengths were assumed
bool assume_heights(ToolGeometry& tool);

/// Sets flute length and stick-out to the same length if the file states only one of them.
void complete(ToolGeometry& tool);

/// Converts the lengths of a library from the machine's units to mm. `mm`: length of the machine's unit in mm.
void take_unit(double mm, ToolLibrary& library);

/// Reads tools from the TOML format of Kadr.
///   file     the name used in messages
///   returns  on failure, an error sentence with file and line
tl::expected<ToolLibrary, std::string> tools_of_toml(std::string_view text, const std::string& file);

/// Reads any supported format, which is recognised by the ending of the file's name and by the contents.
///   returns  on failure, an error sentence with the file
tl::expected<ToolLibrary, std::string> load_tools(const std::string& path, const FileAccess* door = nullptr);

std::string_view name_of(ToolKind kind);

}  // namespace kadr
