// Finds the names of tools in a comment. Used by lang/text/tool_comment, lang/text/tool_size; tested by
// tests/lang/tool_comment_test.cpp.

#include "lang/text/tool_names.h"

#include <algorithm>
#include <array>

namespace kadr {
namespace {

using enum WordHints;

/// Types in the order of their rank. If the words of a name mean several types, the first of these types in the list applies: BALL END
/// MILL, CHAMFER MILL.
constexpr std::array<ToolWord, 7> by_rank = {ToolWord::ball,   ToolWord::chamfer, ToolWord::taper, ToolWord::tap,
                                             ToolWord::reamer, ToolWord::drill,   ToolWord::mill};

ToolWord first_in_rank(ToolWord a, ToolWord b) {
  const auto* const found = std::find_if(by_rank.begin(), by_rank.end(), [&](ToolWord k) { return k == a || k == b; });
  return found == by_rank.end() ? ToolWord::none : *found;
}

}  // namespace

ToolNames::ToolNames(const std::vector<CommentPiece>& pieces) : pieces_(pieces) {
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    if (!is_of_name(i)) continue;
    const ToolName name = name_from(i);
    if (!is_none(name)) all_.push_back(name);
    i = name.last;
  }
}

bool ToolNames::is_of_name(std::size_t i) const {
  return i < pieces_.size() && pieces_[i].is_word() && !pieces_[i].of_another && pieces_[i].meaning.is(tool | part_of_name);
}

/// Returns the index of the next piece after `i` that belongs to the same name, also across a hyphen (MILL-DRILL); `i` itself if no such
/// piece follows.
std::size_t ToolNames::next_of_name(std::size_t i) const {
  if (is_of_name(i + 1)) return i + 1;
  const bool hyphen = i + 2 < pieces_.size() && pieces_[i + 1].is_sign('-') && pieces_[i + 1].joined && pieces_[i + 2].joined;
  return hyphen && is_of_name(i + 2) ? i + 2 : i;
}

ToolName ToolNames::name_from(std::size_t first) const {
  ToolName name{first, first};
  bool slot = false, v = false;
  for (std::size_t i = first;; i = next_of_name(i)) {
    const CommentPiece& piece = pieces_[i];
    const std::size_t next = next_of_name(i);
    const bool is_tap_drill = piece.meaning.kind == ToolWord::tap && next != i && pieces_[next].meaning.kind == ToolWord::drill;
    if (!is_tap_drill) name.kind = first_in_rank(name.kind, piece.meaning.kind);
    name.is_tap_drill = name.is_tap_drill || is_tap_drill;
    name.size_after = name.size_after || piece.meaning.is(size_after);
    name.work_too = name.work_too || piece.meaning.is(work_too);
    name.no_bare_size = name.no_bare_size || piece.meaning.is(no_bare_size);
    name.only_called = name.only_called || piece.meaning.is(only_called);
    slot = slot || piece.text == "SLOT", v = v || piece.text == "V";
    name.last = i;
    if (next == i) break;
  }
  // END MILL names a tool; MILL alone may be the name of an operation.
  const bool is_mill = name.kind == ToolWord::mill && name.last != name.first;
  if (is_mill) name.size_after = true;
  if (slot && name.kind == ToolWord::drill) name.kind = ToolWord::mill, name.size_after = true;
  if (v && name.no_bare_size) name.kind = ToolWord::chamfer;  // V-BIT
  return name;
}

/// Returns true for words that do not name a tool: a single part of a name (FACE TOP OF BLOCK), another kind of ball (BALL VALVE), a bar
/// that does not bore, the machine (CNC MILL).
bool ToolNames::is_none(const ToolName& name) const {
  bool is_tool = false, bores = false, bar = false;
  for (std::size_t i = name.first; i <= name.last; ++i) {
    is_tool = is_tool || pieces_[i].meaning.is(tool);
    bores = bores || pieces_[i].text == "BORING" || (i > 0 && pieces_[i - 1].text == "BORE"), bar = bar || pieces_[i].text == "BAR";
  }
  const std::size_t after = name.last + 1;
  const bool goes_on = after < pieces_.size() && pieces_[after].is_word() &&
                       !pieces_[after].meaning.is(means_diameter | means_corner | describes | of_tool | tool_number | other_after);
  const bool is_alone = name.first == name.last;
  const std::string before = name.first > 0 ? pieces_[name.first - 1].text : "";
  const bool of_machine = before == "CNC" || before == "VMC" || before == "HMC";
  return !is_tool || (bar && !bores) || (is_alone && pieces_[name.first].text == "BALL" && goes_on) || of_machine;
}

ToolWord ToolNames::kind() const {
  ToolWord kind = ToolWord::none;
  for (const ToolName& name : all_) kind = first_in_rank(kind, name.kind);
  return kind;
}

bool ToolNames::any(WordHints what) const {
  return std::any_of(pieces_.begin(), pieces_.end(),
                     [&](const CommentPiece& p) { return !p.of_another && !p.is_figure() && p.meaning.is(what); });
}

}  // namespace kadr
