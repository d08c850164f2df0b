#pragma once
// A small file of ours, whole: set-up, control, machine, contour. Only a regular file, only up to its limit, without waiting for anybody.

#include <cstddef>
#include <string>
#include <string_view>
#include <tl/expected.hpp>

#include "base/file_door.h"

namespace kadr {

namespace limits {
inline constexpr std::size_t config_file_bytes = 16u << 20;  // a set-up, a control's or a machine's file; ours have 0.1 MB
}

/// What stands under a name in the file system, told: "a directory", "a pipe" …; empty: a regular file, or nothing at all.
std::string told_kind(const std::string& path);

/// Why a file could not be opened or read, told: `error` is an errno.
std::string told_errno(int error);

/// The bytes of a file.
///   most     bytes; more are refused, and not read
///   returns  an error sentence naming the file: no file, a directory, a device or a pipe (which would be waited for, or never end),
///            no right, too long, not behind the door
tl::expected<std::string, std::string> read_file(const std::string& path, std::size_t most = limits::config_file_bytes,
                                                 const FileDoor* door = nullptr);

/// What keeps bytes from being a text in UTF-8 for a person: UTF-16, NUL bytes. Told, with line and column; empty: nothing.
///   file  the beginning of the sentence; empty: "line 1, column 2: "
std::string told_no_text(std::string_view text, const std::string& file);

/// "file:line:column: "; without a file "line 3, column 5: ".
std::string told_place(const std::string& file, std::size_t line, std::size_t column);

/// The same of a byte of the text; columns count characters of UTF-8.
std::string told_place(const std::string& file, std::string_view text, std::size_t at);

}  // namespace kadr
