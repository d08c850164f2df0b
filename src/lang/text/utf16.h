#pragma once
// Program text in UTF-16, as editors of Windows save it. Detects the encoding, and converts the text to UTF-8.

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "lang/text/encoding.h"
#include "lang/text/line_reader.h"

namespace kadr {

enum class ByteOrder : std::uint8_t { little, big };

/// A kind of UTF-16, as a user names it. For `any` ("utf-16") the byte order mark or the text shows the byte order. `little` is "utf-16le",
/// `big` is "utf-16be".
enum class Utf16 : std::uint8_t { any, little, big };

/// The encoding that the user gives for a program. It is an Encoding or a kind of UTF-16; both members are empty if the user gives none.
struct GivenEncoding {
  std::optional<Encoding> encoding;
  std::optional<Utf16> utf16;
};
/// Reads the name of an encoding into `given`. After an empty name `given` is empty. Returns false if no encoding has this name.
bool read_encoding(std::string_view name, GivenEncoding& given);

/// Detects UTF-16 by its byte order mark (FF FE, FE FF), or by the characters in the first kilobyte: at least half of them are ASCII (every
/// second byte is 0), and none is a control character. Binary files and the blank leader of a tape have control characters. Returns nullopt
/// if the sample is not UTF-16.
std::optional<ByteOrder> look_at_utf16(std::string_view sample);

/// Returns the byte order of a text that is given as UTF-16. The byte order mark decides; without a mark, the given name; if the name is
/// "utf-16", the text. INFERRED: if nothing shows the order, it is little-endian, as on Windows.
ByteOrder order_of(std::string_view sample, Utf16 given);

/// Appends the whole characters of `bytes` in UTF-8. Half a surrogate pair becomes U+FFFD, and so does an odd byte at the end of the text
/// (`last`).
///   returns  number of bytes used: the bytes of an incomplete character at the end are not used, unless `last` is true
std::size_t append_utf16(std::string_view bytes, ByteOrder order, bool last, std::string& text);

/// Appends a whole text in UTF-8 if its bytes are UTF-16. Returns false, and appends nothing, if they are not.
bool append_if_utf16(std::string_view bytes, const GivenEncoding& given, std::string& text);

/// The source of a program's text for a BlockReader, and its encoding if the encoding is known.
struct OpenedText {
  std::unique_ptr<ByteSource> source;
  std::optional<Encoding> encoding;
};

/// Opens a file. For UTF-16 the source is a UTF-8 view of the file, which can be read from any offset and stores an index entry for each 32
/// KiB. For other encodings the source is the file itself.
///   returns  no source if the file cannot be read; the reason is in errno
OpenedText open_text(const std::string& path, const GivenEncoding& given = {}, const FileAccess* door = nullptr);
OpenedText as_text(std::unique_ptr<ByteSource> source, const GivenEncoding& given = {});

}  // namespace kadr
