// Automatic geometry (spec/nct/17): the words ,C ,R ,A, over-determined blocks, end points given by an angle. Used by the rest of control.

#include "control/fanuc/geometry/automatic_geometry.h"

#include <cmath>

#include "control/fanuc/fanuc.h"
#include "control/fanuc/words/coordinates.h"
#include "control/functions/functions.h"

namespace kadr::fanuc {
namespace {

constexpr std::uint64_t shape_bits = letter_bit(comma_chamfer) | letter_bit(comma_rounding);
constexpr std::uint64_t geometry_bits = shape_bits | letter_bit(comma_angle) | letter_bit('Q');

/// Converts the directions and lengths of automatic geometry (chapter 17) from programmed to work coordinates; nothing else converts these
/// data. If the axes have different scale factors, a length is scaled by the mean of the factors (16.2 for ,R).
CornerData in_work(const BlockContext& m, CornerData c) {
  const Transform& t = m.transform;
  if (t.identity) return c;
  const PlaneAxes& plane = m.modal.axes;
  // The direction of the line is transformed as the difference of two points, so it is scaled in the same way as the line.
  const Vec2 direction = t.to_work(c.direction, plane) - t.to_work(Vec2{}, plane);
  if (const double size = length(direction); size > 0) c.direction = 1 / size * direction;
  c.chamfer *= t.corner_scale(plane);
  c.rounding *= t.corner_scale(plane);
  c.radius *= t.radius_scale(plane);
  c.mirrored = t.reverses(plane);
  return c;
}

/// Reads ,A in a block that gives neither or both coordinates of the plane. Such a block is a line that starts or ends at a computed point
/// (17.3).
Status supporting_line(const BlockContext& m, MotionKind kind, PlaneWords words, CornerData& contour) {
  const Span where = m.where(comma_angle);
  // A lathe computes the point without compensation too (spec/fanuc-t 3.5)
  const bool computes = m.modal.radius_side != 0 || m.def.behaviour.lathe != Lathe::none;
  if (kind != MotionKind::feed || (!words.both() && !computes)) return fail(alarm(AlarmId::angle_alone, where));
  if (!computes) return fail(alarm(AlarmId::intersection_needs_side, where, ",A"));
  if (m.modal.polar_data) return fail(alarm(AlarmId::not_together, where, "G16", ",A"));
  const SinCos angle = sincos_deg(m.value(comma_angle));
  contour.on = words.both() ? SupportingCurve::line : SupportingCurve::ray;
  contour.direction = {angle.cos, angle.sin};
  contour.farther = m.value('Q') > 0;  // 17.3 rule 6. INFERRED: a missing Q acts like a negative Q
  return {};
}

/// Reads the corner words I, K, R of a lathe's G1 (spec/fanuc-t 3.4): I after a motion along the first axis of the plane, K after one along
/// the second; R is a rounding. The signs are INFERRED to have no effect, because the next motion determines the direction.
///   alarms  chamfer_and_rounding: two of I, K, R; chamfer_in_taper: a motion of two axes; chamfer_not_square: I with the wrong axis
Status corner_words(const BlockContext& m, CornerData& contour) {
  const char* const given = m.has('I') ? "I" : m.has('K') ? "K" : "R";
  if (int{m.has('I')} + int{m.has('K')} + int{m.has('R')} > 1) return fail(alarm(AlarmId::chamfer_and_rounding, m.where('K')));
  const PlaneWords words = plane_words(m);
  if (!words.one()) return fail(alarm(AlarmId::chamfer_in_taper, m.where(*given)));
  if ((*given == 'I' && !words.first) || (*given == 'K' && !words.second)) return fail(alarm(AlarmId::chamfer_not_square, m.where(*given)));
  const double size = std::fabs(m.length_value(*given));
  if (!(size <= farthest)) return fail(alarm(AlarmId::value_out_of_range, m.where(*given), *given, m.value(*given)));
  (*given == 'R' ? contour.rounding : contour.chamfer) = size;
  contour.square = true;
  return {};
}

/// Checks that a motion with a corner neither begins nor ends compensation on a lathe of Fanuc (spec/fanuc-t 3.4).
///   alarms  corner_at_side_change
Status no_side_change(const BlockContext& m, const Call& call) {
  const SideStep step = fanuc_of(m).state.side_step;
  if (m.def.behaviour.lathe != Lathe::fanuc || (step != SideStep::begins && step != SideStep::ends)) return {};
  return fail(alarm(AlarmId::corner_at_side_change, call.where));
}

/// Returns true if the block is executed as G1: no other code of its group, and no function that acts once, is in the block.
bool is_line(const BlockContext& m) {
  const Fanuc& fanuc = fanuc_of(m);
  bool line = m.modal.motion_row >= 0 && m.def.codes[static_cast<std::size_t>(m.modal.motion_row)].function == Function::linear;
  for (std::uint32_t i = 0; i < m.block->word_count; ++i) {
    const Word& w = m.block->words[i];
    const std::int32_t index = w.address != 'G' || w.code < 0 ? -1 : m.def.row_of('G', w.code);
    if (index < 0) continue;
    const CodeRow& row = m.def.codes[static_cast<std::size_t>(index)];
    if (row.function == Function::linear) line = true;
    else if (!row.modal || row.group == fanuc.motion_group || row.group == fanuc.drilling_group) return false;
  }
  return line;
}

}  // namespace

void take_corner_letters(BlockContext& m) {
  if (!fanuc_of(m).settings.lathe.corners_without_comma || !is_line(m)) return;
  for (std::uint32_t i = 0; i < m.block->word_count; ++i) {
    Word& w = m.block->words[i];
    const bool means = w.address == 'R' || ((w.address == 'C' || w.address == 'A') && (m.letters.axes & letter_bit(w.address)) == 0);
    if (!means) continue;
    w.address = comma_address(w.address);
    m.block->altered = true;
  }
  if (m.block->altered) m.note_addresses();
}

bool has_corner_words(const BlockContext& m) {
  if (m.def.behaviour.lathe == Lathe::none) return false;
  // With G40, G41 or G42, I and K are the direction of the wall (spec/fanuc-t 7.3)
  constexpr std::uint64_t directions = letter_bit('I') | letter_bit('K');
  const std::uint64_t corner_bits = letter_bit('R') | (m.has_code({Function::radius_side}) ? 0 : directions);
  return (m.block->letters & corner_bits) != 0;
}

bool has_geometry_words(const BlockContext& m) { return (m.block->letters & geometry_bits) != 0; }
bool has_shape_words(const BlockContext& m) { return (m.block->letters & shape_bits) != 0; }

PlaneWords plane_words(const BlockContext& m) {
  PlaneWords words;
  for (std::uint32_t i = 0; i < m.block->word_count; ++i) {
    const Word& w = m.block->words[i];
    if (w.address == 0 || (m.letters.axes & letter_bit(w.address)) == 0) continue;
    const std::size_t axis = m.def.address(w.address).axis;
    words.first = words.first || axis == m.modal.axes.first;
    words.second = words.second || axis == m.modal.axes.second;
  }
  return words;
}

Status end_by_angle(const BlockContext& m, Axes& to, AxisMask& named) {
  const PlaneWords words = plane_words(m);
  if (!words.one()) return {};
  const Span where = m.where(comma_angle);
  if (m.modal.polar_data && !fanuc_of(m).cartesian_block) return fail(alarm(AlarmId::not_together, where, "G16", ",A"));
  const SinCos angle = sincos_deg(m.value(comma_angle));
  const std::size_t given = words.first ? m.modal.axes.first : m.modal.axes.second;
  const std::size_t other = words.first ? m.modal.axes.second : m.modal.axes.first;
  const double along = words.first ? angle.cos : angle.sin, across = words.first ? angle.sin : angle.cos;
  const double travel = to[given] - m.position.programmed[given];
  if (travel != 0 && along == 0) return fail(alarm(AlarmId::angle_meets_not, where, m.value(comma_angle), m.axis_names[given]));
  if (travel != 0) to[other] += travel * across / along;
  named |= AxisMask{1} << other;
  if (!(std::fabs(to[other]) <= farthest))
    return fail(alarm(AlarmId::position_out_of_range, where, std::string_view(m.axis_names[other]), to[other]));
  return {};
}

Status one_coordinate(const BlockContext& m) {
  return plane_words(m).one() ? Status() : Status(fail(alarm(AlarmId::angle_alone, m.where(comma_angle))));
}

Status shape_words(const BlockContext& m, CornerData& contour) {
  const auto take = [&](char address, double& to) -> Status {
    if (!m.has(address)) return {};
    to = m.length_value(address);
    if (to >= 0 && to <= farthest) return {};
    return fail(alarm(AlarmId::value_out_of_range, m.where(address), address, m.value(address)));
  };
  if (m.has(comma_chamfer) && m.has(comma_rounding)) return fail(alarm(AlarmId::chamfer_and_rounding, m.where(comma_rounding)));
  KADR_TRY(take(comma_chamfer, contour.chamfer));
  return take(comma_rounding, contour.rounding);
}

Status shaped_line(Emitter& m, const Call& call, MotionKind kind) {
  CornerData contour;
  KADR_TRY(shape_words(m, contour));
  const bool cornered = kind == MotionKind::feed && has_corner_words(m) && m.has_axis_words();
  if (cornered) KADR_TRY(corner_words(m, contour));
  const PlaneWords words = plane_words(m);
  const bool shaped = has_shape_words(m) || cornered;
  if (shaped) KADR_TRY(no_side_change(m, call));
  const bool supports = m.has(comma_angle) && !words.one();
  if (shaped && (kind != MotionKind::feed || !(m.has(comma_angle) || words.first || words.second)))
    return fail(alarm(AlarmId::corner_illegal, m.where(m.has(comma_chamfer) ? comma_chamfer : comma_rounding)));
  if (m.modal.surface != PathSurface::plane) return fail(alarm(AlarmId::surface_state, call.where, ",A ,C ,R"));
  if (supports) KADR_TRY(supporting_line(m, kind, words, contour));
  const bool lathe = m.def.behaviour.lathe != Lathe::none;
  if (m.has('Q') && contour.on != SupportingCurve::line && !lathe) return fail(alarm(AlarmId::illegal_address, m.where('Q'), 'Q'));
  Axes to;
  AxisMask named = 0;
  fanuc_of(m).absolute_block = contour.on == SupportingCurve::line;
  const Status read = m.target(to, named);
  fanuc_of(m).absolute_block = false;
  KADR_TRY(read);
  if (kind == MotionKind::feed) KADR_TRY(m.feed_known(call.where));
  if (supports) named |= AxisMask{1} << m.modal.axes.first | AxisMask{1} << m.modal.axes.second;
  KADR_TRY(m.straight(kind, to, named));
  if (shaped || supports) attach(m, contour);
  return {};
}

Result<bool> is_over_determined_arc(const BlockContext& m, bool has_both_centers) {
  const bool all = has_both_centers && m.has('R') && plane_words(m).both();
  if (all && m.modal.radius_side != 0) return true;
  if (!m.has('Q')) return false;  // 4.3, INFERRED: in G40, R has priority over the centre
  if (all) return fail(alarm(AlarmId::intersection_needs_side, m.where('Q'), "Q"));
  return fail(alarm(AlarmId::illegal_address, m.where('Q'), 'Q'));
}

Status circle_words(const BlockContext& m, Vec2 center, Vec2 end, CornerData& contour) {
  contour.on = SupportingCurve::circle;
  contour.radius = std::fabs(m.length_value('R'));
  contour.farther = m.value('Q') > 0;
  if (!(contour.radius > 0 && contour.radius <= farthest)) return fail(alarm(AlarmId::value_out_of_range, m.where('R'), 'R', m.value('R')));
  const double there = length(end - center);
  if (std::fabs(there - contour.radius) <= fanuc_of(m).settings.radius_difference) return {};
  return fail(alarm(AlarmId::radius_mismatch, m.block->where, contour.radius, there));
}

void attach(Emitter& m, const CornerData& contour) {
  if (contour.chamfer == 0 && contour.rounding == 0 && contour.on == SupportingCurve::none) return;
  detail_of(m, std::get<Motion>(m.batch->back().what)).contour = in_work(m, contour);
}

}  // namespace kadr::fanuc
