#pragma once
// SourceComments: reads the comments of a program in the order of its lines. On any control, text in round brackets or after a semicolon
// counts as a comment.

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "lang/text/line_reader.h"

namespace kadr {

class SourceComments {
 public:
  explicit SourceComments(std::shared_ptr<ByteSource> text) : reader_(std::move(text)) {}
  /// Returns the comments up to this line that earlier calls have not returned.
  std::vector<std::string> up_to(std::uint32_t line);
  std::vector<std::string> rest() { return up_to(~std::uint32_t{0}); }
  /// True if a line read by the last up_to() may select another row of an offset table: the line contains one of the address letters that
  /// do so.
  bool names_rows() const { return names_rows_; }

 private:
  LineReader reader_;
  std::uint32_t next_ = 1;  // next line to read
  bool is_over_ = false;
  bool names_rows_ = true;
};

}  // namespace kadr
