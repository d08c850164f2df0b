#pragma once
// MeshWordReader: words of a text, parted by blanks and ends of lines, with their places. For the readers of meshes.

#include <string>
#include <string_view>

namespace kadr {

class MeshWordReader {
 public:
  explicit MeshWordReader(std::string_view text) : text_(text) {}
  /// Empty: the text is at its end.
  std::string_view next();
  bool more();
  /// Leaves out what stands in the line after the last word.
  void rest_of_line();
  /// Of the last word, from 1.
  std::size_t line() const { return line_; }
  std::size_t column() const { return word_ - line_start_ + 1; }

 private:
  void to_word();

  std::string_view text_;
  std::size_t at_ = 0, word_ = 0, line_start_ = 0, line_ = 1;
};

/// The whole word is a finite number.
bool number_of(std::string_view word, double& value);

bool equal_ignoring_case(std::string_view a, std::string_view b);

/// For a sentence: at most 20 characters, and what is not ASCII as a question mark.
std::string shown(std::string_view text);

}  // namespace kadr
