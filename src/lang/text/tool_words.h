#pragma once
// The words that comments about tools are made of, and what each says of the figure beside it.

#include <cstdint>
#include <string_view>

#include "lang/text/tool_comment.h"

namespace kadr {

constexpr std::uint64_t bit(unsigned n) { return std::uint64_t{1} << n; }

/// What a word says; a word may say several things.
enum class WordSays : std::uint64_t {
  no_meaning = 0,
  // of the tool
  tool = bit(0),          // names one: a size may stand before it
  size_behind = bit(1),   // … and behind it: ENDMILL 10
  work_too = bit(2),      // … or the work that it does: DRILL 4 is the fourth of them, DRILL 4.2 a drill
  no_bare_size = bit(3),  // only a size with its unit or as a fraction is the tool's: BIT, BROCA
  only_called = bit(4),   // only what is called diameter is: BORING BAR
  part_of_name = bit(5),  // stands in the name of one: END, FACE, SPOT, NOSE
  describes = bit(6),     // may stand between size and name: CARBIDE, LONG
  // of tools whose name is no size, or another one
  centre = bit(7),        // CENTER DRILL #4
  threads = bit(8),       // THREAD MILL 1/2-13
  rounds = bit(9),        // CORNER ROUNDING 1/8
  pipe = bit(10),         // 1/8 NPT
  wide = bit(11),         // a face mill, a saw: inches without a unit are more than of others
  disc = bit(12),         // a slot mill, a key cutter: of two sizes the larger one is the diameter
  not_nominal = bit(13),  // OVERSIZE: the tool is not what it is called
  // of the figure beside it
  unit_mm = bit(14),
  unit_inch = bit(15),
  means_diameter = bit(16),
  means_corner = bit(17),
  degrees = bit(18),
  number = bit(19),        // NO. 7
  letter = bit(20),        // LTR. Q
  tool_number = bit(21),   // T, TOOL
  times = bit(22),         // X: 1/2 X 82 DEG
  other_before = bit(23),  // the figure before it is no size of a tool: 4 FLUTES
  other_behind = bit(24),  // … the one behind it: LENGTH 4.0
  is_numbered = bit(25),   // a number behind it is its own: OP 10, PART NO. 7
  // of what the comment speaks of
  another = bit(26),      // what follows is another thing's: FOR, WITH
  ends_phrase = bit(27),  // no name of a tool goes on behind it: AND, OF, IS
  joins = bit(28),        // DRILL AND TAP, 3/8 OR 1/2
  of_part = bit(29),      // the comment may speak of the part: HOLES, BOSS
  of_tool = bit(30),      // only tools have it: FLUTE, LOC
  offset = bit(31),       // D10 is the number of an offset
  no_diameter = bit(32),  // before DIA: it is not the tool's, MINOR DIA
};

constexpr WordSays operator|(WordSays a, WordSays b) { return WordSays(std::uint64_t(a) | std::uint64_t(b)); }

struct ToolWordMeaning {
  WordSays says = WordSays::no_meaning;
  ToolWord kind = ToolWord::none;
  bool is(WordSays any) const { return (std::uint64_t(says) & std::uint64_t(any)) != 0; }
};

/// `word`: capitals. Nothing of a word that is not known.
ToolWordMeaning meaning_of(std::string_view word);

}  // namespace kadr
