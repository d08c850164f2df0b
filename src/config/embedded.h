#pragma once
// The built-in files (controls/, machines/), embedded by dev/embed.cmake.

#include <span>
#include <string_view>

namespace kadr {

struct EmbeddedFile {
  std::string_view name;  // "controls/s2c42.toml"
  std::string_view text;
};

std::span<const EmbeddedFile> embedded_files();

}  // namespace kadr
