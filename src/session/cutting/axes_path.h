#pragma once
// Divides a motion into segments on which each axis of the machine moves at a constant rate.

#include <functional>
#include <optional>

#include "session/cutting/dog_leg.h"

namespace kadr {

/// A function of the caller that receives the machine position at the end of a segment, and the fraction (0 to 1) of the motion that is
/// complete there.
using AxesVisitor = std::function<void(const Axes& to, double part)>;

/// Calls `visit` for each segment of the step's motion in order. The first segment starts at step.from.machine. The position of a rollover
/// axis may exceed one revolution.
///   chord  greatest deviation of the segments from the true motion of the axes, mm or degrees
///   apart  rapid rates of the axes, if each axis moves at its own rate during rapid motions (DogLeg)
///   pre    the step is a motion: step.motion() is not nullptr
void along_axes_path(const Step& step, double chord, const std::optional<Axes>& apart, const AxesVisitor& visit);

}  // namespace kadr
