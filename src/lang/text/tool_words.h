#pragma once
// The vocabulary of comments about tools, and what each word says about the figure next to it.

#include <cstdint>
#include <string_view>

#include "lang/text/tool_comment.h"

namespace kadr {

constexpr std::uint64_t bit(unsigned n) { return std::uint64_t{1} << n; }

/// Meanings of a word; a word may have several.
enum class WordSays : std::uint64_t {
  no_meaning = 0,
  // ---- about the tool
  tool = bit(0),          // names a tool: a size may be before it
  size_behind = bit(1),   // … and after it: ENDMILL 10
  work_too = bit(2),      // names a tool or its operation: DRILL 4 is the fourth operation, DRILL 4.2 a drill
  no_bare_size = bit(3),  // only a size with a unit, or a fraction, is the tool's: BIT, BROCA
  only_called = bit(4),   // only a figure called diameter is the size: BORING BAR
  part_of_name = bit(5),  // is part of a tool's name: END, FACE, SPOT, NOSE
  describes = bit(6),     // may be between size and name: CARBIDE, LONG
  // ---- tools whose name contains no size, or another size
  centre = bit(7),        // CENTER DRILL #4
  threads = bit(8),       // THREAD MILL 1/2-13
  rounds = bit(9),        // CORNER ROUNDING 1/8
  pipe = bit(10),         // 1/8 NPT
  wide = bit(11),         // a face mill, a saw: figures in inches may be larger than for other tools
  disc = bit(12),         // a slot mill, a key cutter: the larger of two sizes is the diameter
  not_nominal = bit(13),  // OVERSIZE: the tool does not have its nominal size
  // ---- about the figure next to it
  unit_mm = bit(14),
  unit_inch = bit(15),
  means_diameter = bit(16),
  means_corner = bit(17),
  degrees = bit(18),
  number = bit(19),        // NO. 7
  letter = bit(20),        // LTR. Q
  tool_number = bit(21),   // T, TOOL
  times = bit(22),         // X: 1/2 X 82 DEG
  other_before = bit(23),  // the figure before it is not a tool's size: 4 FLUTES
  other_behind = bit(24),  // … nor is the one after it: LENGTH 4.0
  is_numbered = bit(25),   // a number after it belongs to it: OP 10, PART NO. 7
  // ---- what the comment is about
  another = bit(26),      // what follows belongs to another thing: FOR, WITH
  ends_phrase = bit(27),  // ends the name of a tool: AND, OF, IS
  joins = bit(28),        // DRILL AND TAP, 3/8 OR 1/2
  of_part = bit(29),      // the comment may be about the part: HOLES, BOSS
  of_tool = bit(30),      // only tools have it: FLUTE, LOC
  offset = bit(31),       // D10 is an offset number
  no_diameter = bit(32),  // before DIA: not the tool's diameter, as in MINOR DIA
};

constexpr WordSays operator|(WordSays a, WordSays b) { return WordSays(std::uint64_t(a) | std::uint64_t(b)); }

struct ToolWordMeaning {
  WordSays says = WordSays::no_meaning;
  ToolWord kind = ToolWord::none;
  bool is(WordSays any) const { return (std::uint64_t(says) & std::uint64_t(any)) != 0; }
};

/// `word`: in capitals. Returns no meaning for an unknown word.
ToolWordMeaning meaning_of(std::string_view word);

}  // namespace kadr
