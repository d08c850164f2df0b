#pragma once
// Reads whole files, for commands with small input files. Errors are printed on stderr.

#include <optional>
#include <string>

namespace kadr::cli {

/// Returns the bytes of a file, or of standard input if the name is "-". Returns nullopt if the file cannot be read or is longer than
/// `most` bytes.
std::optional<std::string> read_all(const std::string& name, std::size_t most);

/// Does the same as read_all(), for a small file that belongs to Kadr. The file must be a regular file, since reading from a device or a
/// pipe might never end.
std::optional<std::string> read_small(const std::string& name, std::size_t most);

}  // namespace kadr::cli
