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
  std::size_t lines = 0;  // of the source, about
  StopToken stop{};
  bool ends_early = false;  // some way behind the last line that cannot be said: it is written anew anyway
  bool russian = false;     // what is said about it
};

struct Rewritten {
  std::vector<UnsaidLine> unsaid;
  std::vector<std::uint32_t> lines;  // of the source, by line of the text, from 0
};

/// Lines that cannot be said are left out and told; of a text that ends early not all.
///   alarms  conversion_too_long
Result<Rewritten> rewrite(const RewriteSpec& spec, const std::function<bool(std::string_view)>& put);

}  // namespace kadr
