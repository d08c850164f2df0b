#pragma once
// Rewriting: rewrites a program line by line for another control: its blocks word by word, comments and empty lines where they are, with
// written-out ranges in between.

#include <functional>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "convert/block_rewriter.h"
#include "convert/flat_places.h"
#include "lang/block/block_reader.h"

namespace kadr {

/// A line that the other control cannot express.
struct UnsaidLine {
  std::uint32_t line = 0;
  Alarm why;
};

struct RewriteSpec {
  std::shared_ptr<ByteSource> source;  // UTF-8
  const ControlDef* from = nullptr;
  const ControlDef* to = nullptr;
  const std::vector<FlatPlace>* places = nullptr;    // in order, each settled
  const std::vector<TextLines>* left_out = nullptr;  // subprograms that are no longer called
  std::set<std::uint32_t> used_variables{};          // by their numbers
  MacroShape macros{};
  StopToken stop{};
  bool ends_early = false;  // stop soon after the last line that cannot be expressed, since the text is written again anyway
  bool russian = false;     // language of the comments that are added
};

/// Maps lines of the new text to lines of the source. Stored as runs, since most lines follow each other in both.
class LineOrigins {
 public:
  /// The next line of the text comes from that line of the source.
  void add(std::uint32_t source) {
    if (stretches_.empty() || source != stretches_.back().source + (count_ - stretches_.back().made))
      stretches_.push_back({count_, source});
    ++count_;
  }
  /// The lines of another text follow.
  void add(const LineOrigins& others) {
    for (std::uint32_t line = 1; line <= others.count_; ++line) add(others.of(line));
  }
  /// Returns the source line of a line of the text, counted from 1; 0: none.
  std::uint32_t of(std::uint32_t line) const;

 private:
  struct Stretch {
    std::uint32_t made = 0, source = 0;  // line of the text, from 0; line of the source, from 1
  };
  std::vector<Stretch> stretches_;
  std::uint32_t count_ = 0;
};

struct Rewritten {
  std::vector<UnsaidLine> unsaid;
  LineOrigins lines;  // source lines by line of the text, its head included
  std::string head;   // goes before the text that was put: a section of subprograms
};

/// Lines that cannot be expressed are left out and reported; if `ends_early`, not all of them.
///   alarms  conversion_too_long
Result<Rewritten> rewrite(const RewriteSpec& spec, const std::function<bool(std::string_view)>& put);

}  // namespace kadr
