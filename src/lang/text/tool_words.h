#pragma once
// The vocabulary of comments about tools, and the information that each word gives about the number next to it.

#include <cstdint>
#include <string_view>

#include "lang/text/tool_comment.h"

namespace kadr {

constexpr std::uint64_t bit(unsigned n) { return std::uint64_t{1} << n; }

/// Meanings of a word; a word may have several.
enum class WordHints : std::uint64_t {
  no_meaning = 0,
  // ---- about the tool
  tool = bit(0),        // the word names a tool, and a size may be before the word
  size_after = bit(1),  // a size may also be after the word, as in ENDMILL 10
  // the word names a tool or its operation: in the comment DRILL 4 the 4 is the number of the operation, but DRILL 4.2 is a drill
  work_too = bit(2),
  no_bare_size = bit(3),  // only a number with a unit, or a fraction, is the size of this tool: BIT, BROCA
  only_called = bit(4),   // only a number that the comment calls diameter is the size of this tool: BORING BAR
  part_of_name = bit(5),  // the word is part of a tool's name: END, FACE, SPOT, NOSE
  describes = bit(6),     // the word may be between the size and the name: CARBIDE, LONG
  // ---- tools whose name contains no size, or a size that is not the diameter
  centre = bit(7),        // the word names a centre drill, whose size is given by a number: CENTER DRILL #4
  threads = bit(8),       // the word names a tool whose size is given by its thread: THREAD MILL 1/2-13
  rounds = bit(9),        // the word names a tool whose size is given by the rounding that it cuts: CORNER ROUNDING 1/8
  pipe = bit(10),         // the word means a pipe thread: 1/8 NPT
  wide = bit(11),         // the word names a face mill or a saw, whose size in inches may be larger than that of other tools
  disc = bit(12),         // the word names a slot mill or a key cutter; the larger of its two sizes is the diameter
  not_nominal = bit(13),  // the tool does not have its nominal size: OVERSIZE
  // ---- about the number next to the word
  unit_mm = bit(14),
  unit_inch = bit(15),
  means_diameter = bit(16),
  means_corner = bit(17),
  degrees = bit(18),
  number = bit(19),        // the number after the word is that of a drill or screw: NO. 7
  letter = bit(20),        // the letter after the word is the size of a drill: LTR. Q
  tool_number = bit(21),   // T, TOOL
  times = bit(22),         // the word X or a sign between two sizes: 1/2 X 82 DEG
  other_before = bit(23),  // the number before the word is not a tool's size: 4 FLUTES
  other_after = bit(24),   // the number after the word is not a tool's size: LENGTH 4.0
  is_numbered = bit(25),   // a number after the word belongs to the word, and is not a size: OP 10, PART NO. 7
  // ---- what the comment is about
  another = bit(26),      // the words after FOR or WITH describe another thing, not the tool
  ends_phrase = bit(27),  // the word ends the name of a tool: AND, OF, IS
  joins = bit(28),        // the word joins two tools or sizes: DRILL AND TAP, 3/8 OR 1/2
  of_part = bit(29),      // the comment may be about the workpiece, not about a tool: HOLES, BOSS
  of_tool = bit(30),      // the word names a thing that only tools have: FLUTE, LOC
  offset = bit(31),       // in a clause that contains this word, D10 is an offset number and not a diameter
  no_diameter = bit(32),  // a DIA after the word is not the diameter of the tool, as in MINOR DIA
};

constexpr WordHints operator|(WordHints a, WordHints b) { return WordHints(std::uint64_t(a) | std::uint64_t(b)); }

struct ToolWordMeaning {
  WordHints means = WordHints::no_meaning;
  ToolWord kind = ToolWord::none;
  bool is(WordHints any) const { return (std::uint64_t(means) & std::uint64_t(any)) != 0; }
};

/// Returns the meanings of a word, which must be in capitals. An unknown word has no meanings.
ToolWordMeaning meaning_of(std::string_view word);

}  // namespace kadr
