#pragma once
// Returns a path for a temporary file of a test. The path contains the process id, because tests run in parallel.

#include <unistd.h>

#include <filesystem>
#include <string>

namespace kadr {

/// `name` is the end of the file's name, for example "machine.toml".
inline std::filesystem::path own_place(const std::string& name) {
  return std::filesystem::temp_directory_path() / ("kadr_" + std::to_string(::getpid()) + "_" + name);
}

}  // namespace kadr
