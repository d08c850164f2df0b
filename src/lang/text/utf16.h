#pragma once
// Program text in UTF-16, as editors of Windows save it: detects the encoding, and converts the text to UTF-8.

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "lang/text/encoding.h"
#include "lang/text/line_reader.h"

namespace kadr {

enum class ByteOrder : std::uint8_t { little, big };

/// A kind of UTF-16, as a user names it. `any` ("utf-16"): the byte order mark or the text shows the byte order. `little`: "utf-16le";
/// `big`: "utf-16be".
enum class Utf16 : std::uint8_t { any, little, big };

/// The encoding that the user gives for a program: an Encoding, a kind of UTF-16, or none.
struct GivenEncoding {
  std::optional<Encoding> encoding;
  std::optional<Utf16> utf16;
};
/// Reads the name of an encoding into `said`; an empty name leaves it empty. Returns false if no encoding has this name.
bool read_encoding(std::string_view name, GivenEncoding& said);

/// Detects UTF-16 by its byte order mark (FF FE, FE FF), or by the characters in the first kilobyte: at least half of them are ASCII (every
/// other byte is 0), and none is a control character. Binary files and a tape's blank leader have control characters. Returns nullopt if
/// the sample is not UTF-16.
std::optional<ByteOrder> look_at_utf16(std::string_view sample);

/// Returns the byte order of a text that is given as UTF-16: that of its byte order mark, else of the given name, else the one that the
/// text shows. INFERRED: if nothing shows the order, it is little-endian, as on Windows.
ByteOrder order_of(std::string_view sample, Utf16 said);

/// Appends the whole characters of `bytes` as UTF-8. Half a surrogate pair becomes U+FFFD, and so does an odd byte at the end of the text
/// (`last`).
///   returns  number of bytes used: the bytes of an incomplete character at the end are not used, unless `last`
std::size_t append_utf16(std::string_view bytes, ByteOrder order, bool last, std::string& text);

/// Appends a whole text as UTF-8, if its bytes are UTF-16. Returns false, with nothing changed, if they are not.
bool append_if_utf16(std::string_view bytes, const GivenEncoding& said, std::string& text);

/// The source of a program's text for a BlockReader, with the encoding if it is known.
struct OpenedText {
  std::unique_ptr<ByteSource> source;
  std::optional<Encoding> encoding;
};

/// Opens a file. For UTF-16 the source is a UTF-8 view of the file, which can be read from any offset and stores an index entry for each 32
/// KiB; for other encodings it is the file itself.
///   returns  no source if the file cannot be read; the reason is in errno
OpenedText open_text(const std::string& path, const GivenEncoding& said = {}, const FileAccess* door = nullptr);
OpenedText as_text(std::unique_ptr<ByteSource> source, const GivenEncoding& said = {});

}  // namespace kadr
