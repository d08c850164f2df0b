#pragma once
// ProgramIndex: the labels of one file, and the corner elements behind its blocks (spec/heidenhain 6, 9). A file is read once, line by
// line.

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <unordered_map>

#include "lang/block/block.h"

namespace kadr {
class ProgramFile;
}

namespace kadr::heidenhain {

class ProgramIndex {
 public:
  explicit ProgramIndex(const ProgramFile& file);

  struct Label {
    Position at;
    bool twice = false;
  };
  /// Returns a label by its number in decimal digits, or by `"` and its name; nullptr if it is missing.
  const Label* label(const std::string& name) const;
  bool has_corners() const { return !corners_.empty(); }
  /// Returns the RND or CHF that follows the positioning block at this offset.
  struct Corner {
    Position at;
    bool beside_arc = false;  // one of the two elements is an arc
  };
  std::optional<Corner> corner_after(std::uint64_t offset) const;
  bool has_begin() const { return has_begin_; }
  std::uint64_t end() const { return end_; }  // offset behind END PGM, or the end of the file
  /// Returns the first label that is there twice; empty if none is.
  const std::string& twice() const { return twice_; }

 private:
  std::map<std::string, Label> labels_;
  std::unordered_map<std::uint64_t, Corner> corners_;
  std::string twice_;
  bool has_begin_ = false;
  std::uint64_t end_ = 0;
};

}  // namespace kadr::heidenhain
