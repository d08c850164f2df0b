// G68.1, G68.2, G69.1: the programming frame, shifted and rotated in space (spec/nct/25c, 25f). Used by control/functions.

#include <array>
#include <cmath>

#include "control/fanuc/fanuc.h"
#include "control/fanuc/five_axis/five_axis_functions.h"
#include "control/fanuc/words/coordinates.h"
#include "control/functions/functions.h"

namespace kadr::fanuc {
namespace {

constexpr Vec3 axis_x{1, 0, 0}, axis_y{0, 1, 0}, axis_z{0, 0, 1};
// The limit by which three points are "almost on one line" (25.8): the sine of the angle at one of them is below least_sine. The manual's
// limit is UNKNOWN; spec/nct/25f suggests this value.
constexpr double least_sine = 1e-4;
constexpr double least_distance = 1e-3;  // least distance in mm between two of the three points that define a tilted plane

FiveAxisState& frame_state(const BlockContext& m) { return fanuc_of(m).state.five_axis; }

Vec3 vector_words(const BlockContext& m) { return {m.value('I'), m.value('J'), m.value('K')}; }

/// Reads the coordinates X, Y, Z of the main axes; a coordinate that is left out is 0. The coordinates are absolute positions in the frame
/// in force before the block, never diameters.
Result<Vec3> point_words(const BlockContext& m) {
  Vec3 point;
  double* const parts[] = {&point.x, &point.y, &point.z};
  for (std::uint32_t i = 0; i < m.block->word_count; ++i) {
    const Word& w = m.block->words[i];
    if (w.address == 0 || (m.letters.axes & letter_bit(w.address)) == 0) continue;
    const std::size_t axis = m.def.address(w.address).axis;
    const int role = fanuc_of(m).settings.axes[axis].role;
    if (role < 1 || role > 3 || w.incremental) return fail(alarm(AlarmId::illegal_address, w.where, w.written));
    *parts[role - 1] = coordinate(m, w, axis);
  }
  return point;
}

/// Puts the programming frame into force. No axis moves: the machine position stays the same, the programmed coordinates change.
void set_frame(Emitter& m, SpaceFrame kind, const Mat3& turn, Vec3 origin) {
  FiveAxisState& five = frame_state(m);
  if (five.frame == SpaceFrame::none)
    for (std::size_t a = 0; a < m.axis_count; ++a) five.outer_shift[a] = m.modal.new_system[a] + m.modal.local[a];
  five.frame = kind;
  five.turn = turn;
  five.origin = origin;
  five.oriented.reset();
  m.change_frames();
}

/// Returns the product of rotations about the fixed axes X, Y, Z (25.7). Word Q gives the order of the rotations. The last rotation is the
/// leftmost factor of the product.
Result<Mat3> by_order(const BlockContext& m, Vec3 angles) {
  const double q = m.value('Q');
  const Mat3 turns[] = {Mat3::about(axis_x, angles.x), Mat3::about(axis_y, angles.y), Mat3::about(axis_z, angles.z)};
  const auto order = static_cast<int>(q);
  const std::array<int, 3> digits{order / 100, order / 10 % 10, order % 10};
  const bool each = digits[0] + digits[1] + digits[2] == 6 && digits[0] * digits[1] * digits[2] == 6 && q == order;
  if (!each) return fail(alarm(AlarmId::plane_q, m.has('Q') ? m.where('Q') : m.block->where, q));
  const auto of = [&](int i) { return turns[digits[static_cast<std::size_t>(i)] - 1]; };
  return of(2) * (of(1) * of(0));
}

/// Returns the rotation of the tilted plane that projection angles define (25.10).
Result<Mat3> by_projections(const BlockContext& m, Vec3 angles) {
  const Vec3 first = Mat3::about(axis_y, angles.x) * axis_x, second = Mat3::about(axis_x, angles.y) * axis_y;
  const Vec3 normal = cross(first, second);
  if (length(normal) < least_sine) return fail(alarm(AlarmId::plane_degenerate, m.block->where));
  const Vec3 z = unit(normal), x = Mat3::about(z, angles.z) * first;
  return Mat3::of_columns(x, cross(z, x), z);
}

Status by_points(Emitter& m, const PlaneBlocks& plane) {
  const Vec3 along = plane.points[2] - plane.points[1], across = plane.points[3] - plane.points[1];
  const double sides = length(along) * length(across);
  const Vec3 normal = cross(along, across);
  if (length(along) < least_distance || length(across) < least_distance || length(plane.points[3] - plane.points[2]) < least_distance ||
      length(normal) < least_sine * sides)
    return fail(alarm(AlarmId::plane_degenerate, m.block->where));
  const Vec3 x = unit(along), z = unit(normal);
  const Mat3 orientation = Mat3::of_columns(x, cross(z, x), z);
  set_frame(m, SpaceFrame::plane, orientation * Mat3::about(axis_z, plane.turn), plane.points[1] + orientation * plane.points[0]);
  return {};
}

Status by_vectors(Emitter& m, const PlaneBlocks& plane) {
  const Vec3 first = plane.vectors[1], second = plane.vectors[2], across = cross(second, first);
  if (length(first) < least_distance || length(second) < least_distance || length(across) < least_sine * length(first) * length(second))
    return fail(alarm(AlarmId::plane_degenerate, m.block->where));
  const Vec3 x = unit(first), y = unit(across);
  set_frame(m, SpaceFrame::plane, Mat3::of_columns(x, y, cross(x, y)), plane.points[0]);
  return {};
}

/// Returns the number (1 … 3) of the first point or vector of a tilted plane that no block has given; 0 if all are given.
int missing_of(const PlaneBlocks& plane) {
  const int count = plane.kind == 2 ? 3 : 2;
  for (int q = 1; q <= count; ++q)
    if ((plane.seen >> q & 1u) == 0) return q;
  return 0;
}

/// Reads a block of a plane that is defined by three points (25.8) or two vectors (25.9). INFERRED: the frame comes into force with the
/// block that gives the last point or vector; a later block with Q0 shifts and rotates the frame.
Status take_plane_block(Emitter& m, std::uint32_t p) {
  PlaneBlocks& plane = frame_state(m).plane;
  if (plane.kind != p) plane = {}, plane.kind = static_cast<std::uint8_t>(p);
  const double q = m.has('Q') ? m.value('Q') : -1;
  const int least = p == 2 ? 0 : 1, most = p == 2 ? 3 : 2;
  if (q != std::round(q) || q < least || q > most) return fail(alarm(AlarmId::plane_q, m.has('Q') ? m.where('Q') : m.block->where, q));
  const auto number = static_cast<std::size_t>(q);
  const auto point = point_words(m);
  if (!point) return fail(point.error());
  if (p == 3 && number == 1 && m.has_axis_words()) plane.points[0] = *point;
  if (p == 2) plane.points[number] = *point;
  plane.vectors[number] = vector_words(m);
  if (p == 2 && number == 0) plane.turn = m.value('R');
  plane.seen = static_cast<std::uint8_t>(plane.seen | 1u << number);
  if (missing_of(plane) != 0) return {};
  return p == 2 ? by_points(m, plane) : by_vectors(m, plane);
}

bool goes_on_plane(const BlockContext& m) {
  return m.has_code({Function::tilted_plane}) && m.has('P') && m.value('P') == frame_state(m).plane.kind;
}

}  // namespace

Status finish_plane(BlockContext& m) {
  if (goes_on_plane(m) || m.block->word_count == 0) return {};
  const PlaneBlocks plane = std::exchange(frame_state(m).plane, {});
  if (const int q = missing_of(plane); q != 0) return fail(alarm(AlarmId::plane_points, m.block->where, double(q)));
  return {};
}

}  // namespace kadr::fanuc

namespace kadr::functions {

using namespace fanuc;

/// G68.1 (25.3): rotates the programming frame about one axis. A second G68.1 acts within the frame of the first.
Status space_rotation(Emitter& m, const Call& call) {
  FiveAxisState& five = fanuc_of(m).state.five_axis;
  if (five.frame == SpaceFrame::plane) return fail(alarm(AlarmId::frames_too_many, call.where, call.row->code, "G68.2"));
  if (five.frame == SpaceFrame::turned_twice) return fail(alarm(AlarmId::frames_too_many, call.where, call.row->code, "G68.1"));
  if (m.modal.radius_side != 0) return fail(alarm(AlarmId::compensation_active, call.where, call.row->code));
  const Vec3 axis{m.value('I'), m.value('J'), m.value('K')};
  const bool one = (axis == Vec3{1, 0, 0}) || (axis == Vec3{0, 1, 0}) || (axis == Vec3{0, 0, 1});
  if (!one) return fail(alarm(AlarmId::frame_axis, call.where, call.row->code));
  if (!m.has('R')) return fail(alarm(AlarmId::word_missing, call.where, 'R', call.row->code));
  const auto shift = point_words(m);
  if (!shift) return fail(shift.error());
  const Mat3 turn = Mat3::about(axis, m.value('R'));
  if (five.frame == SpaceFrame::none) set_frame(m, SpaceFrame::turned, turn, *shift);
  else set_frame(m, SpaceFrame::turned_twice, five.turn * turn, five.origin + five.turn * *shift);
  return {};
}

/// G68.2 (25.6 to 25.10): sets a tilted plane. INFERRED: G68.2 without P acts like G68.2 P0.
Status tilted_plane(Emitter& m, const Call& call) {
  if (m.modal.radius_side != 0) return fail(alarm(AlarmId::compensation_active, call.where, call.row->code));
  const auto p = m.has('P') ? m.whole('P', 0, 4) : Result<std::uint32_t>(0);
  if (!p) return fail(p.error());
  FiveAxisState& five = fanuc_of(m).state.five_axis;
  if (five.frame == SpaceFrame::turned || five.frame == SpaceFrame::turned_twice)
    return fail(alarm(AlarmId::frames_too_many, call.where, call.row->code, "G68.1"));
  if (*p == 2 || *p == 3) return take_plane_block(m, *p);
  const auto origin = point_words(m);
  if (!origin) return fail(origin.error());
  const Vec3 angles{m.value('I'), m.value('J'), m.value('K')};
  Result<Mat3> turn = Mat3::about({0, 0, 1}, angles.x) * Mat3::about({1, 0, 0}, angles.y) * Mat3::about({0, 0, 1}, angles.z);
  if (*p == 1) turn = by_order(m, angles);
  else if (*p == 4) turn = by_projections(m, angles);
  if (!turn) return fail(turn.error());
  set_frame(m, SpaceFrame::plane, *turn, *origin);
  return {};
}

/// G69.1: ends all frames in space at once; nothing moves. INFERRED: the rotary axes stay where G53.1 has positioned them.
Status space_frame_off(Emitter& m, const Call& call) {
  FiveAxisState& five = fanuc_of(m).state.five_axis;
  if (five.frame == SpaceFrame::none) return {};
  if (m.modal.radius_side != 0) return fail(alarm(AlarmId::compensation_active, call.where, call.row->code));
  five.frame = SpaceFrame::none;
  five.turn = {};
  five.origin = {};
  five.outer_shift = {};
  five.oriented.reset();
  m.change_frames();
  return {};
}

}  // namespace kadr::functions
