// Studs and faces: cycles 213, 215, 256, 257, 230 to 232 (spec/heidenhain 12.10, 12.13). The way from one round to the next is Kadr's own.
// Used by control/heidenhain.

#include <algorithm>
#include <cmath>

#include "base/tolerance.h"
#include "control/heidenhain/area_cycles.h"

namespace kadr::heidenhain {

/// The rounds of one level, from the blank to the finished outline. The frame's -Y is the side of the approach; `blank` is the distance
/// from the finished outline of the tool's centre to a round that does not cut yet.
void AreaMaker::around_stud(MillPath& path, RoundedRectangle finished, double blank, double feed) {
  const auto count = std::max(1, static_cast<int>(std::ceil(blank / width_ - 1e-9)));
  const bool clockwise = !clockwise_;  // climb milling outside is the other way round
  const double size = radius_;
  for (int i = 1; i <= count; ++i) {
    std::vector<RingMove> moves;
    append_ring(moves, finished.inset(-blank * (count - i) / count), clockwise);
    if (moves.empty()) return;
    const Vec2 first = moves.front().to;
    const Vec2 outwards = 1 / length(first) * first;
    const Vec2 way = clockwise ? Vec2{outwards.y, -outwards.x} : Vec2{-outwards.y, outwards.x};
    const Vec2 centre = first + size * outwards;
    // The arc bends away from the stud, against the sense of the round.
    path.move(centre - size * way, feed);
    path.arc(first, centre, 0.25, !clockwise, feed);
    path.follow(moves, clockwise, feed);
    path.arc(centre + size * way, centre, 0.25, !clockwise, feed);
  }
}

/// 256 and 257: from the blank in rounds; 213 and 215: the last round alone, about Q216, Q217.
Status AreaMaker::stud(int cycle) {
  KADR_TRY(take_common());
  const bool circle = cycle == 257 || cycle == 215, old = cycle == 213 || cycle == 215;
  if (old) side_allowance_ = 0;
  double a = circle ? length_of(223) / 2 : length_of(218) / 2, b = circle ? a : length_of(219) / 2;
  double blank_a = a, blank_b = b;
  if (cycle == 256) blank_a = std::max(a, length_of(424) / 2), blank_b = std::max(b, length_of(425) / 2);
  if (cycle == 257 || cycle == 215) blank_a = blank_b = std::max(a, length_of(222) / 2);
  if (cycle == 213) blank_a = a + std::max(0.0, length_of(221)), blank_b = b + std::max(0.0, length_of(221));
  double corner = circle ? a : given(220) ? length_of(220) : 0;
  if (corner < 0) return fail(alarm(AlarmId::not_available, where_, "Q220"));  // a chamfer
  if (!(a > 0 && b > 0)) return fail(alarm(AlarmId::value_out_of_range, where_, circle ? "Q223" : "Q218", 2 * std::min(a, b)));
  corner = std::min({corner, a, b});
  const double turn = cycle == 256 ? q(224) : 0;
  Vec2 middle = at_;
  if (old) middle = {length_of(216), length_of(217)};
  if (cycle == 256) {
    constexpr Vec2 corners[] = {{0, 0}, {-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
    const int place = given(367) ? static_cast<int>(q(367)) : 0;
    if (place >= 1 && place <= 4) middle = at_ - rotated(Vec2{corners[place].x * a, corners[place].y * b}, turn);
  }
  // The side of the approach: without Q437 towards -X, by it towards +X (0, 2, 3) or -X (1, 4): INFERRED.
  bool right = given(437) && (q(437) == 0 || q(437) == 2 || q(437) == 3);
  double side = right ? 90 : -90;
  if (circle && given(376) && q(376) >= 0) side = q(376) + 90;
  const double out = radius_ + side_allowance_;
  RoundedRectangle finished{a + out, b + out, corner + out};
  const bool upright = !circle;  // the frame is turned by a quarter, so length and width change places
  if (upright) std::swap(finished.half_length, finished.half_width);
  const double blank = std::max({blank_a - a, blank_b - b, 0.0});
  const double beside = (circle || upright ? blank_a : blank_b) + radius_ + std::max(length_of(200), 0.0);
  MillPath path = new_path();
  path.set_frame(middle, turn + (circle ? side - 90 : side));
  const Vec2 begin = circle ? Vec2{beside, 0} : Vec2{0, -beside};
  path.raise(std::max(second_, clearance_));
  path.move(begin);
  path.raise(clearance_);
  for (const double height : levels_of(surface_, bottom_, infeed_)) {
    path.raise(height, plunge_feed_);
    around_stud(path, finished, old ? 0 : blank, feed_);
    path.move(begin, feed_);
    if (path.size() > most_steps) return fail(alarm(AlarmId::cycle_endless, where_));
  }
  path.raise(clearance_);
  leave(path);
  return {};
}

/// 230: lines to and fro on one level (spec/heidenhain 12.13).
Status AreaMaker::multipass() {
  const double start_height = length_of(227) + raised_, high = start_height + length_of(200);
  const double along = length_of(218), across = length_of(219), lines = std::round(q(240));
  if (!(lines >= 1 && lines <= 10'000)) return fail(alarm(AlarmId::value_out_of_range, where_, "Q240", lines));
  const double feed = feed_of(207), sideways = feed_of(209);
  if (feed == 0 || sideways == 0 || q(206) == 0) KADR_TRY(needs_feed());
  MillPath path = new_path();
  path.set_frame({length_of(225), length_of(226)}, 0);
  path.raise(std::max(high, path.height()));
  path.move({0, 0});
  path.raise(high);
  path.raise(start_height, feed_of(206));
  for (int i = 0; i < static_cast<int>(lines); ++i) {
    const double y = lines > 1 ? across * i / (lines - 1) : 0;
    if (i > 0) path.move({i % 2 == 0 ? 0 : along, y}, sideways);
    path.move({i % 2 == 0 ? along : 0, y}, feed);
  }
  path.raise(high);
  return {};
}

/// 231: lines from the side between points 1 and 4 to the side between points 2 and 3. INFERRED: they divide both sides evenly, and the
/// tool comes back above the surface, higher than the corners by its diameter (spec/heidenhain 12.13: four points, Q240, Q207).
Status AreaMaker::ruled_surface() {
  const auto cutter = own_.cutter_radius(m_, where_);
  if (!cutter) return fail(cutter.error());
  const double lines = std::round(q(240)), feed = feed_of(207);
  if (!(lines >= 1 && lines <= 10'000)) return fail(alarm(AlarmId::value_out_of_range, where_, "Q240", lines));
  if (feed == 0) KADR_TRY(needs_feed());
  const auto corner = [&](std::size_t first) { return Vec3{length_of(first), length_of(first + 1), length_of(first + 2) + raised_}; };
  const Vec3 one = corner(225), two = corner(228), three = corner(231), four = corner(234);
  const double high = std::max({one.z, two.z, three.z, four.z}) + 2 * *cutter;
  MillPath path = new_path();
  path.raise(std::max(high, path.height()));
  for (int i = 0; i < static_cast<int>(lines); ++i) {
    const double part = lines > 1 ? i / (lines - 1) : 0;
    const Vec3 from = one + part * (four - one), to = two + part * (three - two);
    path.move({from.x, from.y});
    path.raise(high);
    path.raise(from.z, feed);
    path.slope({to.x, to.y}, to.z, feed);
    path.raise(high);
  }
  return {};
}

/// 232: levels of lines over the face, to and fro (Q389 = 0, 1) or all in one direction (2).
Status AreaMaker::face() {
  const auto cutter = own_.cutter_radius(m_, where_);
  if (!cutter) return fail(cutter.error());
  radius_ = *cutter;
  const double start_height = length_of(227) + raised_, end = length_of(386) + raised_,
               floor = given(369) ? std::max(0.0, length_of(369)) : 0;
  const double along = length_of(218), across = length_of(219), infeed = std::fabs(length_of(202));
  const int strategy = static_cast<int>(q(389));
  if (strategy < 0 || strategy > 2) return fail(alarm(AlarmId::value_out_of_range, where_, "Q389", q(389)));
  if (along == 0 || across == 0) return fail(alarm(AlarmId::value_out_of_range, where_, "Q218", along));
  const double feed = feed_of(207), finish = given(385) && q(385) != 0 ? feed_of(385) : feed;
  if (feed == 0) KADR_TRY(needs_feed());
  const double between = given(253) && q(253) != 0 ? feed_of(253) : -1;
  const double factor = given(370) && q(370) > 0 ? std::min(q(370), 2.0) : 1;
  const double lines = std::max(1.0, std::ceil(std::fabs(across) / (factor * radius_) - 1e-9));
  if (!(lines <= 10'000)) return fail(alarm(AlarmId::cycle_endless, where_));
  const double side = (radius_ + (strategy == 1 ? 0 : std::max(0.0, length_of(357)))) * (along < 0 ? -1 : 1);
  MillPath path = new_path();
  path.set_frame({length_of(225), length_of(226)}, 0);
  std::vector<double> all = levels_of(start_height, end + floor, infeed);
  if (floor > 0 || all.empty()) all.push_back(end);
  clearance_ = start_height + length_of(200);
  second_ = start_height + length_of(204);
  const double high = std::max(clearance_, second_);
  path.raise(std::max(high, path.height()));
  for (const double height : all) {
    const bool last = floor > 0 && height == end;
    for (int i = 0; i < static_cast<int>(lines); ++i) {
      const double y = across * (i + 0.5) / lines;
      const bool back = strategy != 2 && i % 2 != 0;
      const Vec2 from{back ? along + side : -side, y}, to{back ? -side : along + side, y};
      if (i == 0) {
        path.move(from);
        path.raise(clearance_);
        path.raise(height, between);
      } else if (strategy == 2) {
        path.raise(height + length_of(200));
        path.move(from, between);
        path.raise(height, between);
      } else {
        path.move(from, strategy == 0 ? between : feed);
      }
      path.move(to, last ? finish : feed);
      if (path.size() > most_steps) return fail(alarm(AlarmId::cycle_endless, where_));
    }
    path.raise(height + length_of(200));
    path.raise(high);
  }
  return {};
}

}  // namespace kadr::heidenhain
