#pragma once
// A part program in conversational blocks of a Heidenhain control (spec/heidenhain 1 to 4). Used by out/program/part_program.

#include "out/program/part_program.h"

namespace kadr {

/// Creates the program: L and, for arcs, CC and C. An arc becomes a line if it is too short for the least increment.
PartProgram klartext_part_program(const std::vector<area::Move>& moves, const Technology& technology);

}  // namespace kadr
