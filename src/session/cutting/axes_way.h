#pragma once
// The way of a machine's axes along a motion, as pieces on which each goes evenly.

#include <functional>
#include <optional>

#include "session/cutting/dog_leg.h"

namespace kadr {

/// From the axes' positions to the next, and to which part of the motion: 0 to 1.
using AxesPiece = std::function<void(const Axes& to, double part)>;

/// `visit` gets the end of each piece in turn; the first begins at step.from.machine. An axis that rolls over counts on beyond its turn.
///   chord  mm or degrees by which a piece may miss the axes' own way
///   apart  rapid rates, where rapid motions are dog-legs
///   pre    step.motion()
void along_axes_way(const Step& step, double chord, const std::optional<Axes>& apart, const AxesPiece& visit);

}  // namespace kadr
