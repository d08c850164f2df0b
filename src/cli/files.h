#pragma once
// Whole files in, for commands whose input is small. Complaints go to stderr.

#include <optional>
#include <string>

namespace kadr::cli {

/// The bytes of a file, or of standard input ("-"); nothing if it cannot be read or is longer than `most` bytes.
std::optional<std::string> read_all(const std::string& name, std::size_t most);

/// The same of a small file of ours, a regular one: a device or a pipe would be waited for, or never end.
std::optional<std::string> read_small(const std::string& name, std::size_t most);

}  // namespace kadr::cli
