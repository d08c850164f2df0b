#pragma once
// Divides a motion into pieces on which each axis of the machine moves at a constant rate.

#include <functional>
#include <optional>

#include "session/cutting/dog_leg.h"

namespace kadr {

/// Receives the machine position at the end of a piece, and the part of the motion completed there: 0 to 1.
using AxesVisitor = std::function<void(const Axes& to, double part)>;

/// Calls `visit` for each piece in order. The first piece starts at step.from.machine. The position of a rollover axis may exceed one
/// revolution.
///   chord  mm or degrees by which the pieces may deviate from the true travel of the axes
///   apart  rapid rates of the axes, if each moves at its own rate during rapid motions (DogLeg)
///   pre    step.motion()
void along_axes_path(const Step& step, double chord, const std::optional<Axes>& apart, const AxesVisitor& visit);

}  // namespace kadr
