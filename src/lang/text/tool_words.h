#pragma once
// The vocabulary of comments about tools, and what each word says about the figure (number) next to it.

#include <cstdint>
#include <string_view>

#include "lang/text/tool_comment.h"

namespace kadr {

constexpr std::uint64_t bit(unsigned n) { return std::uint64_t{1} << n; }

/// Meanings of a word; a word may have several.
enum class WordHints : std::uint64_t {
  no_meaning = 0,
  // ---- about the tool
  tool = bit(0),          // the word names a tool: a size may be before the word
  size_after = bit(1),    // a size may also be after the word: ENDMILL 10
  work_too = bit(2),      // the word names a tool or its operation: DRILL 4 is the fourth operation, DRILL 4.2 a drill
  no_bare_size = bit(3),  // only a figure with a unit, or a fraction, is the size of this tool: BIT, BROCA
  only_called = bit(4),   // only a figure that is called diameter is the size of this tool: BORING BAR
  part_of_name = bit(5),  // the word is part of a tool's name: END, FACE, SPOT, NOSE
  describes = bit(6),     // the word may be between size and name: CARBIDE, LONG
  // ---- tools whose name contains no size, or a size that is not the diameter
  centre = bit(7),        // a centre drill, named by a number: CENTER DRILL #4
  threads = bit(8),       // a tool named by its thread: THREAD MILL 1/2-13
  rounds = bit(9),        // a tool named by the rounding that it cuts: CORNER ROUNDING 1/8
  pipe = bit(10),         // pipe thread: 1/8 NPT
  wide = bit(11),         // a face mill, a saw: its size in inches may be larger than that of other tools
  disc = bit(12),         // a slot mill, a key cutter: the larger of two sizes is the diameter
  not_nominal = bit(13),  // OVERSIZE: the tool does not have its nominal size
  // ---- about the figure next to it
  unit_mm = bit(14),
  unit_inch = bit(15),
  means_diameter = bit(16),
  means_corner = bit(17),
  degrees = bit(18),
  number = bit(19),        // the figure after the word is the number of a drill or screw: NO. 7
  letter = bit(20),        // the letter after the word is a drill size: LTR. Q
  tool_number = bit(21),   // T, TOOL
  times = bit(22),         // the sign between two sizes, X: 1/2 X 82 DEG
  other_before = bit(23),  // the figure before the word is not a tool's size: 4 FLUTES
  other_after = bit(24),   // the figure after the word is not a tool's size: LENGTH 4.0
  is_numbered = bit(25),   // a number after the word belongs to the word: OP 10, PART NO. 7
  // ---- what the comment is about
  another = bit(26),      // what follows describes another thing, not the tool: FOR, WITH
  ends_phrase = bit(27),  // the word ends the name of a tool: AND, OF, IS
  joins = bit(28),        // the word joins two tools or sizes: DRILL AND TAP, 3/8 OR 1/2
  of_part = bit(29),      // the comment may be about the workpiece: HOLES, BOSS
  of_tool = bit(30),      // the word names a thing that only tools have: FLUTE, LOC
  offset = bit(31),       // D10 in the clause of this word is an offset number
  no_diameter = bit(32),  // a DIA after the word is not the diameter of the tool: MINOR DIA
};

constexpr WordHints operator|(WordHints a, WordHints b) { return WordHints(std::uint64_t(a) | std::uint64_t(b)); }

struct ToolWordMeaning {
  WordHints says = WordHints::no_meaning;
  ToolWord kind = ToolWord::none;
  bool is(WordHints any) const { return (std::uint64_t(says) & std::uint64_t(any)) != 0; }
};

/// Returns the meanings of a word, given in capitals; none for an unknown word.
ToolWordMeaning meaning_of(std::string_view word);

}  // namespace kadr
