#pragma once
// Tools files ↔ ToolGeometry: our own TOML (design.md 10), and the libraries and tables of others (config/tool_formats.h).

#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "base/file_door.h"
#include "config/tool_geometry.h"

namespace kadr {

namespace limits {
inline constexpr std::size_t tools = 10'000;          // in one file
inline constexpr std::size_t outline_points = 1'000;  // of a profile, shank or holder
inline constexpr int teeth = 1'000;                   // of a tool
}  // namespace limits

struct ToolLibrary {
  std::vector<ToolGeometry> tools;
  bool in_machine_units = false;   // lengths of a machine's own table: mm only where its units are
  std::vector<std::string> notes;  // what of a library of others was left out, or had to be assumed: a sentence each

  /// nullptr: there is none of this number. A library whose only tool has none (0) has it for all.
  const ToolGeometry* find(std::uint32_t number) const;
};

/// Why it has no shape, told: "diameter is missing"; empty: it has one.
std::string told_fault(const ToolGeometry& tool);

/// Flute length and stick-out as most tools of that diameter have them, where neither is given: 3 and 5 diameters, of drills 8 and 10.
///   returns  they are assumed now
bool assume_heights(ToolGeometry& tool);

/// What was not given is what follows from the rest: flutes as long as the tool, a tool as long as its flutes.
void complete(ToolGeometry& tool);

/// The machine's unit, mm, of a library that is in its units: from then on it is in mm.
void take_unit(double mm, ToolLibrary& library);

/// Our own form.
///   file     named in messages
///   returns  an error sentence with file and line
tl::expected<ToolLibrary, std::string> tools_of_toml(std::string_view text, const std::string& file);

/// Any of the known forms, by the ending of the name and what stands in the file.
///   returns  an error sentence with the file
tl::expected<ToolLibrary, std::string> load_tools(const std::string& path, const FileDoor* door = nullptr);

std::string_view name_of(ToolKind kind);

}  // namespace kadr
