// Detects a file whose end is missing. Used by control/interpreter.

#include "control/flow/file_end.h"

#include <algorithm>
#include <string>

#include "control/flow/program_file.h"

namespace kadr {
namespace {

constexpr std::size_t end_bytes = 4096;  // number of bytes that are read at the start and at the end of the file

std::string bytes_at(const ProgramFile& file, std::uint64_t from) {
  std::string bytes(end_bytes, '\0');
  bytes.resize(file.source()->read(from, bytes.data(), bytes.size()));
  return bytes;
}

bool is_control_or_blank(char c) { return static_cast<unsigned char>(c) <= ' '; }

}  // namespace

bool lacks_closing_sign(const ProgramFile& file) {
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
  if (is_tape(file.reader().encoding())) return false;
  const std::string head = bytes_at(file, 0);
  std::size_t sign = head.starts_with(byte_order_mark) ? byte_order_mark.size() : 0;
  while (sign < head.size() && is_control_or_blank(head[sign])) ++sign;
  if (sign == head.size() || head[sign] != '%') return false;
  const std::uint64_t size = file.source()->size();
  const std::uint64_t from = std::max<std::uint64_t>(size > end_bytes ? size - end_bytes : 0, sign + 1);
  const std::string tail = bytes_at(file, from);
  bool begins_line = false;
  for (const char c : tail) {
    if (c == '%' && begins_line) return false;
    begins_line = c == '\n' || c == '\r' || (begins_line && is_control_or_blank(c));
  }
  return true;
}

}  // namespace kadr
