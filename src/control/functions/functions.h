#pragma once
// The engine's functions, one for each row of config/function.h that acts. A row of a control's file calls one by name.

#include "control/interpreter.h"

namespace kadr::functions {

#define KADR_FUNCTION_DECLARE(name, ...) Status name(Interpreter& m, const Call& call);
KADR_FUNCTIONS(KADR_FUNCTION_DECLARE)
#undef KADR_FUNCTION_DECLARE

}  // namespace kadr::functions
