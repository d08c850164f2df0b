#pragma once
// The functions of the interpreter: one for each row of config/control/function.h that has an effect. A row of a control's file names the
// function that executes it.

#include <type_traits>

#include "control/interpreter.h"

namespace kadr::functions {

/// Returns true for a function that may change the program flow (calls, returns, jumps, ends), or that executes other codes. Such
/// a function receives the Interpreter; all others receive an Emitter.
constexpr bool steers(Function function) {
  switch (function) {
    case Function::repeat_word:
    case Function::call_word:
    case Function::machine_function:
    case Function::program_end:
    case Function::tape_end:
    case Function::repeat_program:
    case Function::call_subprogram:
    case Function::drilling_off:
    case Function::turning_cycle:
    case Function::macro_call:
    case Function::macro_modal:
    case Function::interrupt_on:
    case Function::interrupt_off:
    case Function::call_program:
    case Function::return_program:
    case Function::subprogram_return:
    case Function::subprogram_end:
    case Function::repetition_end:
    case Function::permanent_subprogram:
    case Function::modes_kept:
    case Function::profile_cycle:
    case Function::call_numbered:
    case Function::return_numbered:
    case Function::call_local:
    case Function::jump_by_input: return true;
    default: return false;
  }
}

template <Function function>
using Part = std::conditional_t<steers(function), Interpreter, Emitter>;

#define KADR_FUNCTION_DECLARE(name, ...) Status name(Part<Function::name>& m, const Call& call);
KADR_FUNCTIONS(KADR_FUNCTION_DECLARE)
#undef KADR_FUNCTION_DECLARE

}  // namespace kadr::functions
