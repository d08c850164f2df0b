#pragma once
// Reads small files as a whole: set-up, control, machine, contour. Only regular files up to a size limit are read, so reading never blocks.

#include <cstddef>
#include <string>
#include <string_view>
#include <tl/expected.hpp>

#include "base/file_access.h"

namespace kadr {

namespace limits {
// Greatest size, in bytes, of a set-up, control or machine file; the built-in files have up to 0.1 MB.
inline constexpr std::size_t config_file_bytes = 16u << 20;
}  // namespace limits

/// Returns the type of a path in words: "a directory", "a pipe" …; empty for a regular file, and if nothing exists at the path.
std::string file_type_in_words(const std::string& path);

/// Returns in words the reason why a file could not be opened or read; `error` is an errno.
std::string errno_message(int error);

/// Reads the bytes of a file.
///   most     greatest size in bytes; a larger file is rejected without being read
///   returns  on failure, an error sentence with the file's name: no file, a directory, a device or a pipe (which would block or never
///            end), no permission, too long, or not permitted by `door`
///   door     opens the file; nullptr: the file is opened in the file system directly
tl::expected<std::string, std::string> read_file(const std::string& path, std::size_t most = limits::config_file_bytes,
                                                 const FileAccess* door = nullptr);

/// Returns a message with line and column if the bytes are no UTF-8 text for people (UTF-16, NUL bytes); empty if they are UTF-8 text.
///   file  name with which the message starts; if empty, the message starts with "line 1, column 2: "
std::string no_text_message(std::string_view text, const std::string& file);

/// Returns the location as the beginning of a message: "file:line:column: "; without a file, "line 3, column 5: ".
std::string location_prefix(const std::string& file, std::size_t line, std::size_t column);

/// Returns the location of the byte at the offset `at` of `text`, as the beginning of a message: "file:line:column: ". Columns are counted
/// in characters of UTF-8.
std::string location_prefix(const std::string& file, std::string_view text, std::size_t at);

}  // namespace kadr
