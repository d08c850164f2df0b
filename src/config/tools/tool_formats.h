#pragma once
// Reads tool libraries and tool tables of other programs as ToolGeometry. A tool whose shape Kadr does not support is left out, and a note
// reports this (ToolLibrary::notes).

#include <cstdint>
#include <string>
#include <string_view>
#include <tl/expected.hpp>

#include "config/tools/tool_library.h"

namespace kadr {

enum class ToolFormat : std::uint8_t {
  toml,      // tools file of Kadr, TOML
  linuxcnc,  // LinuxCNC's tool table, .tbl, with lines "T… P… D… ;…"; of the shapes, it states only the diameters
  camotics,  // CAMotics' tool table or project, JSON: {"tools": {"1": {"shape": …}}}
  freecad,   // FreeCAD's tool, .fctb, JSON: {"shape": "endmill.fcstd", "parameter": …}
  fusion,    // Fusion 360 library, JSON: {"data": [{"type": …, "geometry": …}]}
};

/// Recognises the format by the ending of the file name (.toml, .tbl); for other endings, by the start of the text.
ToolFormat tool_format_of(std::string_view text, const std::string& path);

/// Each of these functions reads one format. On failure, it returns an error sentence with the file and, if known, the line.
tl::expected<ToolLibrary, std::string> tools_of_linuxcnc(std::string_view text, const std::string& file);
tl::expected<ToolLibrary, std::string> tools_of_camotics(std::string_view text, const std::string& file);
tl::expected<ToolLibrary, std::string> tools_of_freecad(std::string_view text, const std::string& file);
tl::expected<ToolLibrary, std::string> tools_of_fusion(std::string_view text, const std::string& file);

}  // namespace kadr
