// Compares an exactly computed arc with the arc that Grbl computes in 32 bits. Used by control/grbl/block_check; tested by
// tests/grbl_arcs.py.

#include "control/grbl/arc_readings.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/tolerance.h"

namespace kadr::grbl {
namespace {

constexpr double parts_at = 0.01;  // mm; greatest distance of the two arcs without a warning
// Grbl reports no error if the radii at start and end differ by at most arc_error (mm); above arc_error_most (mm) it always does so; in
// between if the difference exceeds the fraction arc_error_of_radius of the radius (spec/grbl 5.2).
constexpr double arc_error = 0.005, arc_error_most = 0.5, arc_error_of_radius = 0.001;
// greatest difference of the radii in mm that arc_around() accepts; practically no limit, because the radii have been checked already
constexpr double any_difference = 1e7;

/// The result of computing an arc from its words: an alarm, or an arc. If both are empty, Grbl moves on a straight line.
struct Reading {
  std::optional<Alarm> refused;
  std::optional<PlaneArc> arc;
};

Reading of_arc(const Result<PlaneArc>& arc) {
  if (!arc) return {arc.error(), {}};
  return {{}, *arc};
}

Reading exact_reading(const ArcWords& w) {
  if (w.by_radius) {
    const double half = length(w.to - w.from) / 2;
    if (w.same_point) return {alarm(AlarmId::full_circle_by_radius, w.where), {}};
    // The start and the end are equal in the plane, but not on the third axis: Grbl divides by 0 and moves straight.
    if (w.from == w.to) return {};
    if (std::fabs(w.radius) < half) return {alarm(AlarmId::radius_too_small, w.radius_where, std::fabs(w.radius), half), {}};
    return of_arc(arc_by_radius(w.from, w.to, w.radius, w.turn, any_difference));
  }
  const double radius = length(w.offset), end_radius = length(w.to - w.from - w.offset), error = std::fabs(end_radius - radius);
  if (error > arc_error && (error > arc_error_most || error > arc_error_of_radius * radius))
    return {alarm(AlarmId::radius_mismatch, w.where, radius, end_radius), {}};
  // Grbl moves straight if the circle's diameter is at most the arc tolerance $12 (spec/grbl 5.4).
  if (2 * radius <= double{w.tolerance}) return {};
  return of_arc(arc_around(w.from, w.to, w.from + w.offset, w.turn, any_difference));
}

Float32Arc single_arc(const ArcWords& w) {
  return w.by_radius ? float32_arc_by_radius(w.single_from, w.single_to, w.single_radius, w.turn, w.tolerance)
                     : float32_arc_by_center(w.single_from, w.single_to, w.single_offset, w.turn, w.tolerance);
}

/// Changes Grbl's arc so that it ends at the programmed end point, where the last segment of Grbl ends in any case. The number of whole
/// revolutions does not change.
PlaneArc closed(const ArcWords& w, const PlaneArc& single) {
  const auto around = arc_around(w.from, w.to, single.center, w.turn, any_difference);
  if (!around) return single;
  const double within = std::fmod(around->turns, 1.0);
  const double turns = within + std::round(single.turns - within);
  return {single.center, turns > 0 ? turns : single.turns};
}

Reading float32_reading(const ArcWords& w, const Float32Arc& single) {
  if (w.by_radius && w.single_same_point) return {alarm(AlarmId::full_circle_by_radius, w.where), {}};
  const double radius = double{single.radius}, other = double{single.other};
  switch (single.answer) {
    case Float32Arc::Answer::radius_small: return {alarm(AlarmId::radius_too_small, w.radius_where, radius, other), {}};
    case Float32Arc::Answer::radius_wrong: return {alarm(AlarmId::radius_mismatch, w.where, radius, other), {}};
    case Float32Arc::Answer::moves: break;
  }
  return single.segments == 0 ? Reading() : Reading{{}, PlaneArc{w.from + single.offset, single.turns}};
}

Vec2 point(const ArcWords& w, const Reading& reading, double part) {
  if (!reading.arc) return w.from + part * (w.to - w.from);
  const double whole = w.turn == Turn::ccw ? 360 : -360;
  return reading.arc->center + rotated(w.from - reading.arc->center, whole * reading.arc->turns * part);
}

/// Returns the exact arc in the form in which Grbl would execute it. If the arc is too short to be divided into segments, Grbl executes a
/// straight line.
Reading in_segments(const ArcWords& w, Reading exact) {
  if (!exact.arc) return exact;
  const double tolerance = double{w.tolerance}, radius = length(w.from - exact.arc->center), turn = 2 * std::numbers::pi;
  const double chord = std::sqrt(tolerance * (2 * radius - tolerance));
  if (turn * exact.arc->turns * radius / 2 < chord) exact.arc.reset();
  return exact;
}

double turned(const Reading& reading) { return reading.arc ? reading.arc->turns : 0; }

double rounded(double value) { return std::round(value * 1000) / 1000; }

/// Returns a warning that describes how the exact arc and Grbl's arc differ; nullopt if they agree.
std::optional<Alarm> parting(const ArcWords& w, const Reading& exact, const Reading& single) {
  if (single.refused && exact.refused) return std::nullopt;
  if (single.refused) return warning(AlarmId::single_arc_refused, w.where);
  if (exact.refused) return warning(AlarmId::single_arc_passed, w.where);
  const Reading by_segments = in_segments(w, exact);
  double apart = 0;
  for (const double part : {0.25, 0.5, 0.75}) apart = std::max(apart, length(point(w, by_segments, part) - point(w, single, part)));
  if (!(apart > parts_at)) return std::nullopt;
  if (std::fabs(turned(single) - turned(exact)) > 0.25)
    return warning(AlarmId::single_arc_turns, w.where, rounded(360 * turned(single)), rounded(360 * turned(exact)));
  return warning(AlarmId::single_arc_path, w.where, rounded(apart));
}

}  // namespace

ArcReading read_arc(const ArcWords& words) {
  const Float32Arc single = single_arc(words);
  const Reading exact = exact_reading(words), by_grbl = float32_reading(words, single);
  ArcReading all;
  all.segments = single.segments;
  all.parted = parting(words, exact, by_grbl);
  const bool agree = !all.parted && exact.refused.has_value() == by_grbl.refused.has_value();
  all.refused = agree ? exact.refused : by_grbl.refused;
  all.arc = exact.arc;
  if (!agree) all.arc = by_grbl.arc ? std::optional(closed(words, *by_grbl.arc)) : std::nullopt;
  return all;
}

}  // namespace kadr::grbl
