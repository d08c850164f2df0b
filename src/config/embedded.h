#pragma once
// The built-in files (controls/, machines/, macros/), which dev/embed.cpp embeds in the executable.

#include <span>
#include <string_view>

namespace kadr {

struct EmbeddedFile {
  std::string_view name;   // name of the file with its folder: "controls/s2c42.toml"
  std::string_view text;   // empty for a control's file in a build for browsers
  std::string_view table;  // a TOML file in packed form, for unpacked()
};

std::span<const EmbeddedFile> embedded_files();

/// Returns the built-in file with this name; nullptr if there is no such file.
inline const EmbeddedFile* embedded(std::string_view name) {
  for (const EmbeddedFile& file : embedded_files())
    if (file.name == name) return &file;
  return nullptr;
}

}  // namespace kadr
