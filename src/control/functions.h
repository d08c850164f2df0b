#pragma once
// The engine's functions, one for each row of config/function.h that acts. A row of a control's file calls one by name.

#include "control/machinery.h"

namespace kadr::functions {

#define KADR_FUNCTION_DECLARE(name, ...) Status name(Machinery& m, const Call& call);
KADR_FUNCTIONS(KADR_FUNCTION_DECLARE)
#undef KADR_FUNCTION_DECLARE

}  // namespace kadr::functions
