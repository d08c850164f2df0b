#pragma once
// MeshWordReader: reads the words of a text and their positions. Blanks and line ends separate words. Used by the mesh readers.

#include <string>
#include <string_view>

namespace kadr {

class MeshWordReader {
 public:
  explicit MeshWordReader(std::string_view text) : text_(text) {}
  /// Returns the next word; an empty word at the end of the text.
  std::string_view next();
  bool more();
  /// Skips the rest of the text line that contains the last word.
  void rest_of_line();
  /// Position of the last word: line and column of the text, counted from 1.
  std::size_t line() const { return line_; }
  std::size_t column() const { return word_ - line_start_ + 1; }

 private:
  void to_word();

  std::string_view text_;
  std::size_t at_ = 0, word_ = 0, line_start_ = 0, line_ = 1;
};

/// Returns true if the whole word is a finite number, and stores this number in `value`.
bool number_of(std::string_view word, double& value);

bool equal_ignoring_case(std::string_view a, std::string_view b);

/// Returns a text for a message: the first 20 characters, with a question mark for each byte that is not printable ASCII.
std::string shown(std::string_view text);

}  // namespace kadr
