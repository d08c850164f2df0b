#pragma once
// Tables as the program and the lines of an operator have left them.

#include "config/setup.h"

namespace kadr {

class Emitter;

/// Those that a program can write (G10 and its like), as a set-up would give them: offsets and work zeros that are not 0; of a control with
/// parameters these and its tool tables too. No variables.
Setup tables_of(const Emitter& m);

}  // namespace kadr
