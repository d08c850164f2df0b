#pragma once
// Comments of a program in the order of its lines, whatever control it is for: what stands in round brackets, or behind a semicolon.

#include <string>
#include <string_view>
#include <vector>

namespace kadr {

class SourceComments {
 public:
  /// `text` must outlive this.
  explicit SourceComments(std::string_view text) : text_(text) {}
  /// Those of the lines that have not been asked for yet, up to this one.
  std::vector<std::string> up_to(std::uint32_t line);
  std::vector<std::string> rest() { return up_to(~std::uint32_t{0}); }
  /// A line of the last up_to() may have changed which row of a table is in force: it holds one of these letters.
  bool names_rows() const { return names_rows_; }

 private:
  std::string_view text_;
  std::size_t at_ = 0;
  std::uint32_t next_ = 1;  // line
  bool names_rows_ = true;
};

}  // namespace kadr
