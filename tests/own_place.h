#pragma once
// A place for a file of a test: of this process alone, for tests are run side by side.

#include <unistd.h>

#include <filesystem>
#include <string>

namespace kadr {

/// `name`: "machine.toml".
inline std::filesystem::path own_place(const std::string& name) {
  return std::filesystem::temp_directory_path() / ("kadr_" + std::to_string(::getpid()) + "_" + name);
}

}  // namespace kadr
