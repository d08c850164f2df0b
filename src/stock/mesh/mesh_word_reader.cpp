// Reads the words of a text and the positions of these words. Used by the mesh readers.

#include "stock/mesh/mesh_word_reader.h"

#include <fast_float/fast_float.h>

#include <algorithm>
#include <cmath>

#include "base/ascii.h"

namespace kadr {
namespace {

constexpr std::size_t max_shown = 20;

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == '\v' || c == '\f'; }

}  // namespace

void MeshWordReader::to_word() {
  for (; at_ < text_.size() && is_blank(text_[at_]); ++at_)
    if (text_[at_] == '\n') ++line_, line_start_ = at_ + 1;
  word_ = at_;
}

std::string_view MeshWordReader::next() {
  to_word();
  while (at_ < text_.size() && !is_blank(text_[at_])) ++at_;
  return text_.substr(word_, at_ - word_);
}

bool MeshWordReader::more() {
  to_word();
  return at_ < text_.size();
}

void MeshWordReader::rest_of_line() {
  while (at_ < text_.size() && text_[at_] != '\n') ++at_;
}

bool number_of(std::string_view word, double& value) {
  if (word.starts_with('+')) word.remove_prefix(1);
  const auto [end, error] = fast_float::from_chars(word.data(), word.data() + word.size(), value);
  return error == std::errc() && end == word.data() + word.size() && std::isfinite(value);
}

bool equal_ignoring_case(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](char x, char y) { return to_lower(x) == to_lower(y); });
}

std::string shown(std::string_view text) {
  std::string out(text.substr(0, max_shown));
  for (char& c : out)
    if (c < ' ' || c > '~') c = '?';
  return text.size() > max_shown ? out + "..." : out;
}

}  // namespace kadr
