#pragma once
// Reads tools files as ToolGeometry: Kadr's own TOML (docs/commands/cut.md, "Tools"), and the libraries and tables of other programs
// (config/tools/tool_formats.h).

#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "base/file_access.h"
#include "config/tools/tool_geometry.h"

namespace kadr {

namespace limits {
inline constexpr std::size_t tools = 10'000;          // greatest number of tools in one file
inline constexpr std::size_t outline_points = 1'000;  // greatest number of points of a profile, shank or holder
inline constexpr int teeth = 1'000;                   // greatest number of cutting edges of a tool
}  // namespace limits

struct ToolLibrary {
  std::vector<ToolGeometry> tools;
  bool in_machine_units = false;   // lengths are in the machine's units, as in a control's own tool table; take_unit() converts them
  std::vector<std::string> notes;  // one sentence for each thing that was left out or assumed

  /// Returns nullptr if there is no tool with this number. If the library has a single tool, whose number
  /// is missing (0), returns that tool for every number.
  const ToolGeometry* find(std::uint32_t number) const;
};

/// Returns a message that says why the shape is not valid, such as "diameter is missing"; empty if the shape is valid.
std::string tool_fault_message(const ToolGeometry& tool);

/// If neither flute length nor stick-out is given, assumes the usual ones for the diameter: 3 and 5 diameters, for drills 8 and 10.
///   returns  true if the two lengths were assumed
bool assume_heights(ToolGeometry& tool);

/// If only the flute length or only the stick-out is given, sets the other to the same length.
void complete(ToolGeometry& tool);

/// Converts a library in the machine's units to mm. `mm`: length of the machine's unit in mm.
void take_unit(double mm, ToolLibrary& library);

/// Reads Kadr's own format.
///   file     the name used in messages
///   returns  on failure, an error sentence with file and line
tl::expected<ToolLibrary, std::string> tools_of_toml(std::string_view text, const std::string& file);

/// Reads any supported format, recognised by the name's ending and the contents.
///   returns  on failure, an error sentence with the file
tl::expected<ToolLibrary, std::string> load_tools(const std::string& path, const FileAccess* door = nullptr);

std::string_view name_of(ToolKind kind);

}  // namespace kadr
