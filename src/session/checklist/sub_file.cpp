// Detects files that contain only O subprograms. This file is used by session/checklist/program_check and tested by tests/run_check.py.

#include "session/checklist/sub_file.h"

#include <string>
#include <string_view>

#include "base/ascii.h"

namespace kadr {
namespace {

/// Removes comments and blanks from a line, and converts it to lower case.
std::string plain(std::string_view line) {
  std::string text;
  bool remark = false;
  for (const char c : line) {
    if (c == ';' && !remark) break;
    if (c == '(') remark = true;
    if (!remark && static_cast<unsigned char>(c) > ' ') text += to_lower(c);
    if (c == ')') remark = false;
  }
  return text;
}

/// Returns the label before the keyword `word` of an O line, e.g. `<name>` for `o<name>sub`. Returns an empty string if the line is not an
/// O line with this keyword.
std::string label_before(const std::string& line, std::string_view word) {
  if (line.size() <= word.size() + 1 || line[0] != 'o') return {};
  const bool named = line[1] == '<';
  const std::size_t last = named ? line.find('>') : line.find_first_not_of("0123456789", 1);
  if (last == std::string::npos) return {};
  const std::size_t end = named ? last + 1 : last;  // index after the last character of the label
  return end > 1 && line.compare(end, word.size(), word) == 0 ? line.substr(1, end - 1) : std::string();
}

}  // namespace

bool holds_only_subprograms(LineReader reader) {
  std::string open;  // label of the subprogram whose definition has not ended yet; empty: none
  bool any = false;
  for (Line line; reader.next(line);) {
    const std::string text = plain(line.bytes);
    if (!open.empty()) {
      if (label_before(text, "endsub") == open) open.clear();
    } else if (!text.empty()) {
      open = label_before(text, "sub");
      if (open.empty()) return false;
      any = true;
    }
  }
  return any && open.empty();
}

}  // namespace kadr
