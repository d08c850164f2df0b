#pragma once
// Reads whole files, for commands whose input is small. Errors are printed to stderr.

#include <optional>
#include <string>

namespace kadr::cli {

/// Returns the bytes of a file, or of standard input ("-"); nullopt if it cannot be read or is longer than `most` bytes.
std::optional<std::string> read_all(const std::string& name, std::size_t most);

/// Like read_all(), for a small file that belongs to Kadr. It must be a regular file: reading a device or a pipe might wait forever or
/// never end.
std::optional<std::string> read_small(const std::string& name, std::size_t most);

}  // namespace kadr::cli
