#pragma once
// Interrupt macro: M96, M97, the signal CP_MINT (spec/nct/23 23.4).

#include "base/result.h"

namespace kadr {
class Machinery;
}

namespace kadr::nct {}
