// SourceComments: reads the comments of a program. Used by convert/conversion.

#include "convert/source_comments.h"

#include <algorithm>

namespace kadr {

std::vector<std::string> SourceComments::up_to(std::uint32_t line) {
  std::vector<std::string> found;
  // an earlier call has read this line, and it is not examined again, so the line is assumed to select a row of an offset table
  names_rows_ = next_ > line;
  Line read;
  for (; next_ <= line && !is_over_; ++next_) {
    is_over_ = !reader_.next(read);
    if (is_over_) break;
    std::string_view rest = read.bytes;
    names_rows_ = names_rows_ || rest.find_first_of("HDTLMhdtlm#[") != std::string_view::npos ||
                  rest.find("G4") != std::string_view::npos || rest.find("g4") != std::string_view::npos;
    while (!rest.empty()) {
      const std::size_t open = rest.find_first_of("(;");
      if (open == std::string_view::npos) break;
      const bool to_end = rest[open] == ';';
      rest.remove_prefix(open + 1);
      const std::size_t close = to_end ? rest.size() : std::min(rest.find(')'), rest.size());
      std::string_view text = rest.substr(0, close);
      while (!text.empty() && (text.back() == '\r' || text.back() == ' ')) text.remove_suffix(1);
      if (!text.empty()) found.emplace_back(text);
      rest.remove_prefix(std::min(close + 1, rest.size()));
    }
  }
  return found;
}

}  // namespace kadr
