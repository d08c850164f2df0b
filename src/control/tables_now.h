#pragma once
// Returns the tables of a control (offsets, work offsets, parameters) with the values that the program and the lines of the operator have
// written.

#include "config/setup/setup.h"

namespace kadr {

class Emitter;

/// Returns the tables that a program can write (G10 and similar codes), in the form of a set-up. They are the offsets and work offsets that
/// are not 0; on a control with parameters also the parameters and the tool tables. Variables are not included.
Setup tables_of(const Emitter& m);

}  // namespace kadr
