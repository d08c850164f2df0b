#pragma once
// Comments of a program in the order of its lines, whatever control it is for: what stands in round brackets, or behind a semicolon.

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "lang/text/line_reader.h"

namespace kadr {

class SourceComments {
 public:
  explicit SourceComments(std::shared_ptr<ByteSource> text) : reader_(std::move(text)) {}
  /// Those of the lines that have not been asked for yet, up to this one.
  std::vector<std::string> up_to(std::uint32_t line);
  std::vector<std::string> rest() { return up_to(~std::uint32_t{0}); }
  /// A line of the last up_to() may have changed which row of a table is in force: it holds one of these letters.
  bool names_rows() const { return names_rows_; }

 private:
  LineReader reader_;
  std::uint32_t next_ = 1;  // line
  bool is_over_ = false;
  bool names_rows_ = true;
};

}  // namespace kadr
