#pragma once
// LineChanges: pieces of one line that are replaced by other texts.

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/span.h"

namespace kadr {

class LineChanges {
 public:
  /// Replaces the bytes of `where`; an empty span inserts the text there. Of two changes that overlap, the one added first counts.
  void replace(Span where, std::string text) { changes_.push_back({where, std::move(text)}); }
  void remove(Span where) { replace(where, {}); }
  bool empty() const { return changes_.empty(); }
  void clear() { changes_.clear(); }

  /// Returns the line with all changes made.
  std::string applied(std::string_view line) {
    std::stable_sort(changes_.begin(), changes_.end(), [](const auto& a, const auto& b) { return a.where.begin < b.where.begin; });
    std::string made;
    std::size_t at = 0;
    for (const Change& change : changes_) {
      if (change.where.begin < at || change.where.end > line.size()) continue;
      made += line.substr(at, change.where.begin - at);
      made += change.text;
      at = change.where.end;
    }
    return made += line.substr(at);
  }

 private:
  struct Change {
    Span where;
    std::string text;
  };
  std::vector<Change> changes_;
};

}  // namespace kadr
