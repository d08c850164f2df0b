// Pockets and slots: cycles 251 to 254, and the older 3, 4, 5, 210 to 212, 214 (spec/heidenhain 12.8, 12.10). The manuals do not lay down
// the path within a pocket: levels, walls, floor and end point are those of the cycle, the path between is Kadr's own clearing. Used by
// control/heidenhain.

#include <algorithm>
#include <cmath>

#include "base/tolerance.h"
#include "control/heidenhain/area_cycles.h"

namespace kadr::heidenhain {
namespace {

/// Slope of a plunge on a helix or to and fro, degrees: INFERRED, as ANGLE of the tool table is not known.
constexpr double plunge_slope = 3;

double drop_of(double way) { return way * std::tan(plunge_slope * rad_per_deg); }

}  // namespace

/// One round at a distance from the outermost one; `start` is its first point.
void AreaMaker::pocket_ring(const PocketShape& shape, double inset, bool clockwise, std::vector<RingMove>& moves) {
  if (shape.arc_radius == 0) return append_ring(moves, shape.outer.inset(inset), clockwise);
  const double out = shape.outer.half_width - inset, radius = shape.arc_radius, part = shape.arc_degrees / 360;
  const auto at = [&](double distance, double degrees) { return rotated(Vec2{distance, 0}, degrees); };
  const double a = 0, b = shape.arc_degrees;
  // Counter-clockwise: along the outer wall to the end of the slot, round its end, back along the inner wall, round its beginning.
  const double mid = b / 2;
  moves.push_back({at(radius + out, mid), {}, 0});
  const double far = clockwise ? a : b, near = clockwise ? b : a;
  moves.push_back({at(radius + out, far), {}, part / 2});
  if (out > tol::same_point) moves.push_back({at(radius - out, far), at(radius, far), 0.5});
  moves.push_back({at(radius - out, near), {}, -part});
  if (out > tol::same_point) moves.push_back({at(radius + out, near), at(radius, near), 0.5});
  moves.push_back({at(radius + out, mid), {}, part / 2});
}

/// Goes down from the present height to `height`: straight (0), on a helix (1) or to and fro (2); ends at the start of the clearing.
void AreaMaker::plunge(MillPath& path, const PocketShape& shape, double height) {
  const double a = shape.outer.half_length, b = shape.outer.half_width, drop = path.height() - height;
  const double room = std::min(a, b);
  const bool on_helix = plunge_kind_ == 1 && room > 0.1 * radius_;
  if (plunge_kind_ == 0 || !(drop > tol::same_point) || !(std::max(a, b) > tol::same_point)) return path.raise(height, plunge_feed_);
  if (on_helix) {
    const double size = std::min(room, 0.8 * radius_), turns = std::ceil(drop / drop_of(2 * pi * size));
    const Vec2 centre = shape.begin, start = centre + Vec2{size, 0};
    path.move(start, feed_);
    path.helix(start, height, centre, turns, clockwise_, plunge_feed_);
    path.arc(start, centre, 1, clockwise_, feed_);
    return path.move(centre, feed_);
  }
  if (shape.arc_radius > 0) {
    const double length_of_arc = shape.arc_radius * shape.arc_degrees * rad_per_deg;
    const double passes = 2 * std::max(1.0, std::ceil(drop / drop_of(length_of_arc) / 2)), each = drop / passes;
    const Vec2 far = rotated(Vec2{shape.arc_radius, 0}, shape.arc_degrees);
    for (int i = 0; i < static_cast<int>(passes); ++i)
      path.helix(i % 2 == 0 ? far : shape.begin, path.height() - each, {}, shape.arc_degrees / 360, i % 2 != 0, plunge_feed_);
    return;
  }
  const double reach = std::min(std::max(a, b), 2 * radius_);
  const Vec2 one = a >= b ? Vec2{reach, 0} : Vec2{0, reach};
  const double passes = 2 * std::max(1.0, std::ceil(drop / drop_of(2 * reach) / 2)), each = (drop) / passes;
  path.move(shape.begin - one, feed_);
  for (int i = 0; i < static_cast<int>(passes); ++i)
    path.slope(i % 2 == 0 ? shape.begin + one : shape.begin - one, path.height() - each, plunge_feed_);
  path.move(shape.begin, feed_);
}

/// The rings of one level, from the middle outwards, and back to the beginning.
void AreaMaker::clear(MillPath& path, const PocketShape& shape, double feed) {
  const double least = shape.arc_radius > 0 ? shape.outer.half_width : std::min(shape.outer.half_length, shape.outer.half_width);
  const auto count = static_cast<int>(std::ceil(least / width_ - 1e-9));
  std::vector<RingMove> moves;
  for (int i = 0; i <= count; ++i) pocket_ring(shape, count == 0 ? 0 : least - least * i / count, clockwise_, moves);
  path.follow(moves, clockwise_, feed);
  path.move(shape.begin, feed);
}

/// One round along the wall, with an arc to it and an arc from it where there is room.
void AreaMaker::finish_wall(MillPath& path, const PocketShape& shape, double feed) {
  std::vector<RingMove> moves;
  pocket_ring(shape, 0, clockwise_, moves);
  if (moves.empty()) return;
  const Vec2 first = moves.front().to;
  const double room = shape.arc_radius > 0 ? shape.outer.half_width : std::min(shape.outer.half_length, shape.outer.half_width);
  const double size = std::min(room, radius_);
  const Vec2 inwards = shape.arc_radius > 0 ? -1 / length(first) * first : shape.outer.is_circle() ? Vec2{-1, 0} : Vec2{0, 1};
  const Vec2 way = clockwise_ ? Vec2{-inwards.y, inwards.x} : Vec2{inwards.y, -inwards.x};  // of the tool at `first`
  const Vec2 centre = first + size * inwards;
  const bool rounded = size > 0.05 * radius_;
  if (rounded) {
    path.move(centre - size * way, feed);
    path.arc(first, centre, 0.25, clockwise_, feed);
  }
  path.follow(moves, clockwise_, feed);
  if (rounded) path.arc(centre + size * way, centre, 0.25, clockwise_, feed);
  path.move(shape.begin, feed);
}

/// Roughing, then the walls, then the floor, as Q215 says.
Status AreaMaker::pocket(MillPath& path, PocketShape shape) {
  const double wall = side_allowance_;
  const auto fits = [](const PocketShape& s) {
    return s.outer.half_width >= -tol::same_point && (s.arc_radius > 0 || s.outer.half_length >= -tol::same_point);
  };
  const auto prepared = [&](double allowance) {
    PocketShape made = shape;
    made.outer = shape.outer.inset(radius_ + allowance);
    return made;
  };
  PocketShape rough = prepared(wall), whole = prepared(0);
  if (!fits(whole) || !fits(rough))
    return fail(alarm(AlarmId::pocket_tool_large, where_, 2 * radius_, 2 * shape.outer.half_length, 2 * shape.outer.half_width));
  for (PocketShape* const each : {&rough, &whole}) {
    each->outer.half_length = std::max(each->outer.half_length, 0.0);
    each->outer.half_width = std::max(each->outer.half_width, 0.0);
    if (each->arc_radius == 0) each->begin = {};
    else each->begin = rotated(Vec2{each->arc_radius, 0}, 0);
  }
  path.raise(clearance_);
  path.move(rough.begin);
  const bool roughs = operation_ == 0 || operation_ == 1, finishes = operation_ == 0 || operation_ >= 2;
  if (roughs) {
    for (const double height : levels_of(surface_, bottom_ + floor_allowance_, infeed_)) {
      plunge(path, rough, height);
      clear(path, rough, feed_);
      if (path.size() > most_steps) return fail(alarm(AlarmId::cycle_endless, where_));
    }
  }
  if (finishes && (wall > 0 || operation_ == 5)) {
    path.raise(clearance_);
    for (const double height : levels_of(surface_, bottom_ + floor_allowance_, finish_infeed_)) {
      path.raise(height, plunge_feed_);
      finish_wall(path, whole, finish_feed_);
      if (path.size() > most_steps) return fail(alarm(AlarmId::cycle_endless, where_));
    }
  }
  if (finishes && floor_allowance_ > 0) {
    path.raise(bottom_, plunge_feed_);
    clear(path, whole, finish_feed_);
  }
  path.raise(clearance_);
  return {};
}

/// 251, 252, 253, 254. Q367 says where the tool is at the call (spec/heidenhain 12.10).
Status AreaMaker::new_pocket(int cycle) {
  KADR_TRY(take_common());
  plunge_kind_ = given(366) ? static_cast<int>(q(366)) : 1;
  const bool circle = cycle == 252, slot = cycle == 253, arc_slot = cycle == 254;
  PocketShape shape;
  const double first = length_of(218), second = length_of(219);
  if (circle) {
    const double radius = length_of(223) / 2;
    shape.outer = {radius, radius, radius};
  } else if (slot) {
    shape.outer = {first / 2, second / 2, second / 2};
  } else if (arc_slot) {
    shape.outer = {0, second / 2, second / 2};
    shape.arc_radius = length_of(375) / 2;
    shape.arc_degrees = q(248);
    if (!(shape.arc_radius > shape.outer.half_width) || !(shape.arc_degrees > 0 && shape.arc_degrees <= 360))
      return fail(alarm(AlarmId::value_out_of_range, where_, "Q248", shape.arc_degrees));
  } else {
    shape.outer = {first / 2, second / 2, std::max(length_of(220), radius_ + side_allowance_)};
    shape.outer.corner = std::min({shape.outer.corner, shape.outer.half_length, shape.outer.half_width});
  }
  MillPath path = new_path();
  const int place = circle ? 0 : static_cast<int>(q(367));
  if (arc_slot) return arc_slots(path, shape, place);
  Vec2 back;  // from the centre to the point at which the tool stands
  const double a = shape.outer.half_length, b = shape.outer.half_width;
  if (slot) {
    const double places[] = {0, -a, -(a - b), a - b, a};
    back = {place >= 0 && place <= 4 ? places[place] : 0, 0};
  } else if (!circle) {
    constexpr Vec2 corners[] = {{0, 0}, {-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
    const Vec2 corner = place >= 0 && place <= 4 ? corners[place] : Vec2{};
    back = {corner.x * a, corner.y * b};
  }
  const double turn = circle ? 0 : q(slot ? 374 : 224);
  path.set_frame(at_ - rotated(back, turn), turn);
  KADR_TRY(pocket(path, shape));
  leave(path);
  return {};
}

/// 254: the slot, and its copies by the angle Q378.
Status AreaMaker::arc_slots(MillPath& path, const PocketShape& shape, int place) {
  const double count = given(377) ? std::max(1.0, std::round(q(377))) : 1;
  if (count > 1000) return fail(alarm(AlarmId::value_out_of_range, where_, "Q377", count));
  const double start = q(376);
  Vec2 centre{length_of(216), length_of(217)};
  if (place >= 1 && place <= 3) {  // 1: the tool stands at the left end, 2: in the middle, 3: at the right end of the slot
    const double parts[] = {0, 0, 0.5, 1};
    centre = at_ - rotated(Vec2{shape.arc_radius, 0}, start + parts[place] * shape.arc_degrees);
  }
  for (int i = 0; i < static_cast<int>(count); ++i) {
    path.set_frame(centre, start + i * q(378));
    if (i > 0) path.move({shape.arc_radius, 0});  // at the height at which the slot before was left
    KADR_TRY(pocket(path, shape));
    leave(path);
  }
  return {};
}

/// 210, 211, 212, 214: slots and the finishing of pockets about Q216, Q217.
Status AreaMaker::old_finishing_pocket(int cycle) {
  KADR_TRY(take_common());
  side_allowance_ = floor_allowance_ = 0;
  plunge_kind_ = cycle <= 211 ? 2 : 0;
  PocketShape shape;
  MillPath path = new_path();
  Vec2 centre{length_of(216), length_of(217)};
  double turn = 0;
  if (cycle == 210) {
    shape.outer = {length_of(218) / 2, length_of(219) / 2, length_of(219) / 2};
    turn = q(224);
    if (shape.outer.half_length < shape.outer.half_width) {
      std::swap(shape.outer.half_length, shape.outer.half_width);
      turn += 90;
    }
    shape.outer.corner = shape.outer.half_width;
  } else if (cycle == 211) {
    shape.outer = {0, length_of(219) / 2, length_of(219) / 2};
    shape.arc_radius = length_of(244) / 2;
    shape.arc_degrees = q(248);
    turn = q(245);
    if (!(shape.arc_radius > shape.outer.half_width) || !(shape.arc_degrees > 0 && shape.arc_degrees <= 360))
      return fail(alarm(AlarmId::value_out_of_range, where_, "Q248", shape.arc_degrees));
  } else if (cycle == 212) {
    shape.outer = {length_of(218) / 2, length_of(219) / 2, std::max(length_of(220), radius_)};
    shape.outer.corner = std::min({shape.outer.corner, shape.outer.half_length, shape.outer.half_width});
  } else {
    const double size = length_of(223) / 2;
    shape.outer = {size, size, size};
  }
  path.set_frame(centre, turn);
  if (cycle >= 212) {
    operation_ = 5;  // the wall alone
    finish_infeed_ = infeed_;
  } else {
    operation_ = static_cast<int>(q(215));
  }
  KADR_TRY(pocket(path, shape));
  leave(path);
  return {};
}

/// 3, 4, 5: slot and pockets, called at the centre above the surface (spec/heidenhain 12.8).
Status AreaMaker::old_pocket(int cycle) {
  const auto cutter = own_.cutter_radius(m_, where_);
  if (!cutter) return fail(cutter.error());
  radius_ = *cutter;
  const Modes& memory = own_.memory;
  const double height = m_.position.programmed[plane_.normal];
  clearance_ = second_ = height;
  surface_ = height - std::fabs(memory.old[1]) * unit_;
  bottom_ = surface_ - std::fabs(memory.old[2]) * unit_;
  infeed_ = std::fabs(memory.old[3]) * unit_;
  plunge_feed_ = memory.old_feed[3] * unit_;
  const std::size_t last = cycle == 5 ? 5 : 6;
  feed_ = finish_feed_ = memory.old_feed[last] * unit_;
  if (!(feed_ > 0) || !(plunge_feed_ > 0)) KADR_TRY(needs_feed());
  width_ = radius_;
  clockwise_ = memory.old_sense[last] < 0;
  operation_ = 1;
  plunge_kind_ = 0;
  PocketShape shape;
  MillPath path = new_path();
  if (cycle == 5) {
    const double size = std::fabs(memory.old[4]) * unit_;
    shape.outer = {size, size, size};
    path.set_frame(at_, 0);
  } else {
    const double x = std::fabs(memory.old[4]) * unit_, y = std::fabs(memory.old[5]) * unit_;
    const double corner = cycle == 3 ? std::min(x, y) / 2 : std::max(memory.old[6] * unit_, radius_);
    shape.outer = {x / 2, y / 2, std::min({corner, x / 2, y / 2})};
    path.set_frame(at_, 0);
  }
  return pocket(path, shape);
}

}  // namespace kadr::heidenhain
