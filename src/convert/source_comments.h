#pragma once
// SourceComments: reads the comments of a program in the order of its lines, whatever its control: text in round brackets or after a
// semicolon.

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "lang/text/line_reader.h"

namespace kadr {

class SourceComments {
 public:
  explicit SourceComments(std::shared_ptr<ByteSource> text) : reader_(std::move(text)) {}
  /// Returns the comments of the lines up to this one that were not returned before.
  std::vector<std::string> up_to(std::uint32_t line);
  std::vector<std::string> rest() { return up_to(~std::uint32_t{0}); }
  /// True if a line of the last up_to() may have changed which row of a table is in force, because it has one of the letters for that.
  bool names_rows() const { return names_rows_; }

 private:
  LineReader reader_;
  std::uint32_t next_ = 1;  // line
  bool is_over_ = false;
  bool names_rows_ = true;
};

}  // namespace kadr
