#pragma once
// Program text in UTF-16, as Windows' editors save it: recognised, and read as UTF-8.

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "lang/text/encoding.h"
#include "lang/text/line_reader.h"

namespace kadr {

enum class ByteOrder : std::uint8_t { little, big };

/// "utf-16": its mark or its text tells the order of bytes; "utf-16le", "utf-16be".
enum class Utf16 : std::uint8_t { any, little, big };

/// What somebody says of a program's encoding: one of those, or nothing.
struct SaidEncoding {
  std::optional<Encoding> encoding;
  std::optional<Utf16> utf16;
};
/// No name: nothing is said. False: no such encoding.
bool read_encoding(std::string_view name, SaidEncoding& said);

/// By its mark (FF FE, FE FF), or where half of the characters of the first kilobyte and more are ASCII, every other byte 0, and none is a
/// control character, as in binary files and on a tape's blank leader. Nothing: no UTF-16.
std::optional<ByteOrder> look_at_utf16(std::string_view sample);

/// The order of bytes of a text that is said to be UTF-16: its mark decides, then the name, then the text; INFERRED: without any of them
/// that of Windows, little.
ByteOrder order_of(std::string_view sample, Utf16 said);

/// Appends whole characters of `bytes` as UTF-8, U+FFFD for half a surrogate pair; where the text ends here (`last`) for an odd byte, too.
///   returns  bytes taken: a character that is cut is left, unless `last`
std::size_t append_utf16(std::string_view bytes, ByteOrder order, bool last, std::string& text);

/// A whole text; false, and nothing done, where it is no UTF-16.
bool append_if_utf16(std::string_view bytes, const SaidEncoding& said, std::string& text);

/// Program text for a BlockReader, with its encoding if that is known.
struct OpenedText {
  std::unique_ptr<ByteSource> source;
  std::optional<Encoding> encoding;
};

/// The file itself; or, of UTF-16, a view of it as UTF-8 that can be read from any place and knows of each 32 KiB where they begin.
///   returns  no source: the file cannot be read, errno tells why
OpenedText open_text(const std::string& path, const SaidEncoding& said = {}, const FileDoor* door = nullptr);
OpenedText as_text(std::unique_ptr<ByteSource> source, const SaidEncoding& said = {});

}  // namespace kadr
