// Fuzz target for lang/text/tape and lang/text/encoding. The input is a punched tape, or a text in any encoding.

#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "lang/text/encoding.h"
#include "lang/text/tape.h"

namespace {

void require(bool holds) {
  if (!holds) std::abort();
}

bool is_utf8(std::string_view text) {
  while (!text.empty()) {
    const std::size_t size = kadr::first_character(text).size;
    if (size == 0) return false;
    text.remove_prefix(size);
  }
  return true;
}

/// Checks that text which has been encoded and decoded once does not change when this is repeated. (A literal ПС or LF at the end of a
/// line is removed the first time.)
void check_tape(std::string_view bytes) {
  const kadr::TapeText first = kadr::decode_tape(bytes);
  require(is_utf8(first.text));
  if (!first.faults.empty()) return;
  const auto rows = kadr::encode_tape(first.text, 3);
  require(rows.has_value());
  const kadr::TapeText second = kadr::decode_tape(*rows);
  require(second.faults.empty());
  const bool marks = first.text.find("ПС") != std::string::npos || first.text.find("LF") != std::string::npos;
  const bool open_end = !first.text.empty() && first.text.back() != '\n';
  if (!marks) require(second.text == first.text + (open_end ? "\n" : ""));
  const auto again = kadr::encode_tape(second.text, 0);
  require(again.has_value() && kadr::decode_tape(*again).text == second.text);
}

void check_encodings(std::string_view bytes) {
  using kadr::Encoding;
  const auto guess = kadr::detect_encoding(bytes);
  for (const Encoding encoding : {Encoding::utf8, Encoding::cp1251, Encoding::koi8r, Encoding::cp866, Encoding::iso7}) {
    std::string text;
    const kadr::Status status = kadr::append_utf8(bytes, encoding, text);
    require(is_utf8(text));
    if (!status) require(status.error().where.end <= bytes.size() && status.error().where.begin < status.error().where.end);
    if (guess && *guess == Encoding::koi8r) require(encoding != Encoding::koi8r || status);  // in KOI8-R all 256 bytes are valid
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  check_tape(bytes);
  check_encodings(bytes);
  return 0;
}
