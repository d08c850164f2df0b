#pragma once
// Rewriting: a program line by line as one of another control: its blocks word by word, comments and empty lines where they are, and
// places that are written out in between.

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

/// A line that the other control cannot say.
struct UnsaidLine {
  std::uint32_t line = 0;
  Alarm why;
};

struct RewriteSpec {
  std::shared_ptr<ByteSource> source;  // UTF-8
  const ControlDef* from = nullptr;
  const ControlDef* to = nullptr;
  const std::vector<FlatPlace>* places = nullptr;    // in their order, settled
  const std::vector<TextLines>* left_out = nullptr;  // subprograms that nobody calls any more
  std::set<std::uint32_t> used_variables{};          // by their numbers
  MacroShape macros{};
  StopToken stop{};
  bool ends_early = false;  // some way behind the last line that cannot be said: it is written anew anyway
  bool russian = false;     // what is said about it
};

/// Lines of the source by lines of the text that is made of it: stretches, for most lines follow each other in both.
class LineOrigins {
 public:
  /// The next line of the text is made of that line.
  void add(std::uint32_t source) {
    if (stretches_.empty() || source != stretches_.back().source + (count_ - stretches_.back().made))
      stretches_.push_back({count_, source});
    ++count_;
  }
  /// The lines of another text follow.
  void add(const LineOrigins& others) {
    for (std::uint32_t line = 1; line <= others.count_; ++line) add(others.of(line));
  }
  /// Of a line of the text, from 1; 0: there is none.
  std::uint32_t of(std::uint32_t line) const;

 private:
  struct Stretch {
    std::uint32_t made = 0, source = 0;  // from 0; from 1
  };
  std::vector<Stretch> stretches_;
  std::uint32_t count_ = 0;
};

struct Rewritten {
  std::vector<UnsaidLine> unsaid;
  LineOrigins lines;  // of the source, by line of the text with its head
  std::string head;   // that stands before what has been put: a section of subprograms
};

/// Lines that cannot be said are left out and told; of a text that ends early not all.
///   alarms  conversion_too_long
Result<Rewritten> rewrite(const RewriteSpec& spec, const std::function<bool(std::string_view)>& put);

}  // namespace kadr
