// TextBuffer: collects text and writes it to a file in large blocks of bytes. It is used by the rest of out.

#include "out/trace/text_buffer.h"

#include <fmt/format.h>

#include <cerrno>
#include <cmath>
#include <cstdint>
#include <limits>

namespace kadr {
namespace {

constexpr double decimals = 1e9;
constexpr std::uint64_t decimals_whole = 1'000'000'000;
constexpr double most_exact = 4e6;  // largest value that, multiplied by 1e9, fits into the 53 bits of a double

char* put_whole(char* at, std::uint64_t value) {
  char digits[20];
  char* first = digits + sizeof digits;
  do {
    *--first = static_cast<char>('0' + value % 10);
    value /= 10;
  } while (value != 0);
  return put_text(at, {first, static_cast<std::size_t>(digits + sizeof digits - first)});
}

char* put_fraction(char* at, std::uint32_t billionths) {
  int places = 9;
  if (billionths % 1'000'000 == 0) {
    billionths /= 1'000'000;
    places = 3;
  } else if (billionths % 1000 == 0) {
    billionths /= 1000;
    places = 6;
  }
  for (; billionths % 10 == 0; --places) billionths /= 10;
  *at = '.';
  for (int i = places; i > 0; --i, billionths /= 10) at[i] = static_cast<char>('0' + billionths % 10);
  return at + 1 + places;
}

}  // namespace

char* put_number(char* at, double value) {
  const double size = std::abs(value);
  if (!(size < most_exact)) {
    if (!std::isfinite(value)) return put_text(at, "null");
    return fmt::format_to_n(at, 32, "{}", size < 1e15 ? std::round(value * 1e6) / 1e6 : value).out;
  }
  const auto billionths = static_cast<std::uint64_t>(size * decimals + 0.5);
  if (value < 0 && billionths != 0) *at++ = '-';
  at = put_whole(at, billionths / decimals_whole);
  const auto fraction = static_cast<std::uint32_t>(billionths % decimals_whole);
  return fraction == 0 ? at : put_fraction(at, fraction);
}

void append_json(std::string& to, std::string_view text) {
  to += '"';
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') (to += '\\') += c;
    else if (c == '\n') to += "\\n";
    else if (c == '\t') to += "\\t";
    else if (byte < 0x20 || byte == 0x7F) to += fmt::format("\\u{:04x}", byte);
    else to += c;
  }
  to += '"';
}

void TextBuffer::append(std::string_view text) {
  while (!text.empty()) {
    const std::string_view piece = text.substr(0, size / 2);
    done(put_text(room(piece.size()), piece));
    text.remove_prefix(piece.size());
  }
}

bool TextBuffer::flush() {
  const auto filled = static_cast<std::size_t>(at_ - text_.get());
  if (filled > 0 && ok()) {
    errno = 0;
    if (std::fwrite(text_.get(), 1, filled, file_) != filled || std::fflush(file_) != 0) error_ = errno != 0 ? errno : EIO;
  }
  at_ = text_.get();
  return ok();
}

}  // namespace kadr
