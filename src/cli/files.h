#pragma once
// Reads whole files, for commands whose input is small. Complaints go to stderr.

#include <optional>
#include <string>

namespace kadr::cli {

/// Returns the bytes of a file, or of standard input ("-"); nullopt if it cannot be read or is longer than `most` bytes.
std::optional<std::string> read_all(const std::string& name, std::size_t most);

/// The same for a small file of our own, which must be a regular one: a device or a pipe might block or never end.
std::optional<std::string> read_small(const std::string& name, std::size_t most);

}  // namespace kadr::cli
