#pragma once
// Rewriting: rewrites a program line by line for the target control. Blocks are rewritten word by word, comments and empty lines stay
// between the same blocks, and expanded ranges are inserted.

#include <functional>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "config/alarm_texts.h"
#include "convert/block_rewriter.h"
#include "convert/flat/flat_ranges.h"
#include "lang/block/block_reader.h"

namespace kadr {

/// A line that the target control cannot express.
struct InexpressibleLine {
  std::uint32_t line = 0;
  Alarm why;
};

struct RewriteSpec {
  std::shared_ptr<ByteSource> source;  // the source program, UTF-8
  const ControlDef* from = nullptr;
  const ControlDef* to = nullptr;
  // expanded ranges, in order; each of them must have a text that is the same in all executions (FlatRange::settled)
  const std::vector<FlatRange>* places = nullptr;
  const std::vector<TextLines>* left_out = nullptr;  // lines of subprograms that nothing calls any more, so they are left out
  std::set<std::uint32_t> used_variables{};          // numbers of the variables that the program uses
  MacroShape macros{};
  StopToken stop{};
  // The rewriting stops soon after the last line that cannot be expressed, because a further round will rewrite the program anyway.
  bool ends_early = false;
  Lang lang = Lang::en;  // language of the comments that the rewriting adds
};

/// Maps lines of the new text to lines of the source program. Stored as ranges of successive lines, since most lines follow each other in
/// both texts.
class LineOrigins {
 public:
  /// Records that the next line of the new text comes from this line of the source program.
  void add(std::uint32_t source) {
    if (runs_.empty() || source != runs_.back().source + (count_ - runs_.back().made)) runs_.push_back({count_, source});
    ++count_;
  }
  /// Appends the line origins of another text, which follows this one.
  void add(const LineOrigins& others) {
    for (std::uint32_t line = 1; line <= others.count_; ++line) add(others.of(line));
  }
  /// Returns the source line of a line of the new text, both counted from 1; 0: the line has no source line.
  std::uint32_t of(std::uint32_t line) const;

 private:
  struct LineRun {
    // made: number, from 0, of the first line of the range in the new text. source: number, from 1, of the source line that it comes from.
    std::uint32_t made = 0, source = 0;
  };
  std::vector<LineRun> runs_;
  std::uint32_t count_ = 0;
};

struct Rewritten {
  std::vector<InexpressibleLine> unsaid;
  LineOrigins lines;  // source line of each line of the new text, including the lines of `head`
  std::string head;   // text that must precede the text passed to `put`: a section of subprograms
};

/// Rewrites the program. Lines that the target control cannot express are left out and reported. With `ends_early`, only the first of these
/// lines are reported.
///   alarms  conversion_too_long
Result<Rewritten> rewrite(const RewriteSpec& spec, const std::function<bool(std::string_view)>& put);

}  // namespace kadr
