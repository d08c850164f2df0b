#pragma once
// Divides the travel of a machine's axes during a motion into pieces on which each axis moves at a constant rate.

#include <functional>
#include <optional>

#include "session/cutting/dog_leg.h"

namespace kadr {

/// Receives the positions of the axes at the end of a piece, and the part of the motion there: 0 to 1.
using AxesPiece = std::function<void(const Axes& to, double part)>;

/// Calls `visit` with the end of each piece in turn; the first piece starts at step.from.machine. The position of a rollover axis continues
/// beyond one revolution.
///   chord  mm or degrees by which a piece may differ from the true travel of the axes
///   apart  rapid rates, if rapid motions are dog-legs
///   pre    step.motion()
void along_axes_way(const Step& step, double chord, const std::optional<Axes>& apart, const AxesPiece& visit);

}  // namespace kadr
