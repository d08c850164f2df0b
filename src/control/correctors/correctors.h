#pragma once
// Axis correctors of the generic Soviet ISO control (spec/correctors 1) and its pocket cycle (3).

#include "control/machinery.h"

namespace kadr::correctors {

/// Adds the block's correctors to its motion: sets Transform::added.
///   returns  the axes it moves besides those of the words
///   alarms   corrector_axis: `L17` without exactly one axis word, or an axis code beyond 7; corrector_unknown
Result<AxisMask> apply(Machinery& m);

}  // namespace kadr::correctors
