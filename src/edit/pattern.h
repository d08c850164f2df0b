#pragma once
// Pattern: repeats the cutting of a program at other places. For each tool, the lines from its first position to its last motion are
// repeated before the next tool change, so that no tool is changed more often than before.

#include <tl/expected.hpp>

#include "edit/line_patches.h"
#include "edit/program_editor.h"

namespace kadr {

struct Pattern {
  std::vector<EditLines> pieces;  // the lines that are repeated
  LinePatches patches;
};

/// Finds the lines to be repeated and writes them for each place.
///   edits    places; `copied`: the lines, nullopt: those of each tool
///   returns  a fault if some line cannot be repeated by its text (calls, jumps, assignments), or if a piece does not begin with a position
tl::expected<Pattern, EditFault> pattern_of(const EditedSource& program, const Edits& edits, const StopToken& stop);

}  // namespace kadr
