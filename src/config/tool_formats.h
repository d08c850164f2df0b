#pragma once
// Tool libraries and tables of others, read into ToolGeometry. What has no shape that Kadr knows is left out, and said
// (ToolLibrary::notes).

#include <cstdint>
#include <string>
#include <string_view>
#include <tl/expected.hpp>

#include "config/tool_library.h"

namespace kadr {

enum class ToolFormat : std::uint8_t {
  toml,      // our own
  linuxcnc,  // tool table, .tbl: T… P… D… ; diameters only
  camotics,  // tool table or project, JSON: {"tools": {"1": {"shape": …}}}
  freecad,   // .fctb, JSON: {"shape": "endmill.fcstd", "parameter": …}
  fusion,    // Fusion 360 library, JSON: {"data": [{"type": …, "geometry": …}]}
};

/// By the ending of the name (.toml, .tbl), else by what the text begins with.
ToolFormat tool_format_of(std::string_view text, const std::string& path);

/// An error sentence with the file and, where there is one, the line.
tl::expected<ToolLibrary, std::string> tools_of_linuxcnc(std::string_view text, const std::string& file);
tl::expected<ToolLibrary, std::string> tools_of_camotics(std::string_view text, const std::string& file);
tl::expected<ToolLibrary, std::string> tools_of_freecad(std::string_view text, const std::string& file);
tl::expected<ToolLibrary, std::string> tools_of_fusion(std::string_view text, const std::string& file);

}  // namespace kadr
