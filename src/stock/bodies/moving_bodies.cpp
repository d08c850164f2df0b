// Solid bodies on the links of a machine, and where they collide. Used by session/cutting/machine_watch; tested by
// tests/stock/moving_bodies_test.cpp.

#include "stock/bodies/moving_bodies.h"

#include <algorithm>
#include <cmath>

namespace kadr {
namespace {

constexpr int depth_samples = 8;  // number of positions, from the collision to the end of the motion, at which the overlap is measured

Axes scaled(const Axes& axes, double by) {
  Axes scaled{};
  for (std::size_t i = 0; i < max_axes; ++i) scaled[i] = by * axes[i];
  return scaled;
}

Axes along_axes(const Axes& from, const Axes& by, double part) {
  Axes at = from;
  for (std::size_t i = 0; i < max_axes; ++i) at[i] += part * by[i];
  return at;
}

}  // namespace

std::size_t MovingBodies::add(const SolidBody& body, std::size_t link, BodyKind kind, std::size_t group) {
  const std::size_t number = bodies_.size();
  bodies_.push_back({body, {}, link, group, kind, true});
  for (std::size_t other = 0; other < number; ++other) {
    const Pair pair{other, number, links_.carrier(bodies_[other].link, link)};
    if (belongs_together(pair)) pairs_.push_back(pair);
  }
  choose();
  return number;
}

/// Returns true if the pair has to be checked. Contacts of the tool with blank and fixtures are found by the cutting simulation instead.
bool MovingBodies::belongs_together(const Pair& pair) const {
  const Body &a = bodies_[pair.first], &b = bodies_[pair.second];
  return a.link != b.link && (a.kind == BodyKind::machine || b.kind == BodyKind::machine);
}

/// Chooses the pairs of bodies to check. A pair is checked if neither of its bodies is excluded, and accept_initial_contacts() has not
/// excluded the pair.
void MovingBodies::choose() {
  chosen_.clear();
  for (std::size_t i = 0; i < pairs_.size(); ++i)
    if (!pairs_[i].as_built && bodies_[pairs_[i].first].there && bodies_[pairs_[i].second].there) chosen_.push_back(i);
}

void MovingBodies::put(std::size_t body, const LinkPose& on_link) {
  bodies_[body].on_link = on_link;
  for (Pair& pair : pairs_)
    if (pair.first == body || pair.second == body) pair.at_least = 0, pair.touches = pair.touched = pair.is_checked = pair.as_built = false;
  choose();
}

void MovingBodies::show(std::size_t body, bool is_there) {
  if (bodies_[body].there == is_there) return;
  bodies_[body].there = is_there;
  put(body, bodies_[body].on_link);
}

void MovingBodies::jump() {
  for (Pair& pair : pairs_) pair.at_least = 0, pair.touches = false;
}

std::vector<std::pair<std::size_t, std::size_t>> MovingBodies::accept_initial_contacts() {
  std::vector<std::pair<std::size_t, std::size_t>> built;
  links_.poses({}, start_);
  for (const std::size_t i : chosen_) {
    Pair& pair = pairs_[i];
    if (pair.is_checked) continue;
    pair.is_checked = true;
    const Body &a = bodies_[pair.first], &b = bodies_[pair.second];
    const bool of_machine = a.kind == BodyKind::machine && b.kind == BodyKind::machine;
    // A body on a link that carries the tool may touch the tool by design, because the tool is in the spindle. But a contact between the
    // tool and a body of the table at axis positions 0 does not prove that the machine is built so; that pair is still checked.
    const Body& other = a.kind == BodyKind::tool ? b : a;
    const bool about_spindle = (a.kind == BodyKind::tool || b.kind == BodyKind::tool) && links_.carries_tool(other.link);
    if (!of_machine && !about_spindle) continue;
    pair.as_built = gap(pair, start_).distance < bodies_meet;
    if (pair.as_built && of_machine) built.emplace_back(pair.first, pair.second);
  }
  choose();
  return built;
}

Travel MovingBodies::travel(std::size_t body, std::size_t from, const std::vector<LinkPose>& links, const Axes& by) const {
  const Body& b = bodies_[body];
  return links_.travel(b.link, from, {pose(body, links).of(b.solid.ball.centre), b.solid.ball.radius}, links, by);
}

BodyGap MovingBodies::gap(const Pair& pair, const std::vector<LinkPose>& links) {
  ++queries_;
  return world_.gap(bodies_[pair.first].solid, pose(pair.first, links), bodies_[pair.second].solid, pose(pair.second, links));
}

/// Returns an upper bound for the approach of two bodies. Between convex bodies there is a separating plane, so only motion across this
/// plane brings the bodies closer.
double MovingBodies::nearing(const Pair& pair, const BodyGap& gap, const std::vector<LinkPose>& links, const Axes& by) const {
  const Travel a = travel(pair.first, pair.carrier, links, by), b = travel(pair.second, pair.carrier, links, by);
  const Vec3 together = a.together - b.together;
  const bool convex = bodies_[pair.first].solid.convex && bodies_[pair.second].solid.convex;
  const double towards = convex ? std::max(0.0, dot(together, unit(gap.on_second - gap.on_first))) : length(together);
  return towards + a.besides + b.besides;
}

void MovingBodies::move(const Axes& from, const Axes& to, std::vector<BodyMeeting>& found) {
  Axes by{};
  for (std::size_t i = 0; i < max_axes; ++i) by[i] = to[i] - from[i];
  const std::size_t first_new = found.size();
  links_.poses(from, start_);
  travels_.resize(bodies_.size());
  for (std::size_t i = 0; i < bodies_.size(); ++i)
    if (bodies_[i].there) travels_[i] = travel(i, MachineLinks::bed, start_, by);
  std::vector<BodyMeeting> met;
  for (const std::size_t i : chosen_) {
    Pair& pair = pairs_[i];
    pair.touched = pair.touches;
    if (pair.touches) {
      part_from(pair, to);
      continue;
    }
    const bool by_bed = pair.carrier == MachineLinks::bed;
    const Travel a = by_bed ? travels_[pair.first] : travel(pair.first, pair.carrier, start_, by);
    const Travel b = by_bed ? travels_[pair.second] : travel(pair.second, pair.carrier, start_, by);
    const double left = pair.at_least - length(a.together - b.together) - a.besides - b.besides;
    if (left >= bodies_meet) pair.at_least = left;
    else follow(pair, from, by, met);
  }
  for (const BodyMeeting& meeting : met) report_meeting(meeting, first_new, found);
}

/// Advances along the motion in steps, each too short for the two bodies to meet.
void MovingBodies::follow(Pair& pair, const Axes& from, const Axes& by, std::vector<BodyMeeting>& found) {
  double part = 0;
  while (true) {
    links_.poses(along_axes(from, by, part), now_);
    const BodyGap apart = gap(pair, now_);
    if (apart.distance < bodies_meet) {
      const Vec3 at =
          apart.distance < 0 ? pose(pair.first, now_).of(bodies_[pair.first].solid.ball.centre) : 0.5 * (apart.on_first + apart.on_second);
      pair.touches = true;
      pair.at_least = 0;
      found.push_back({pair.first, pair.second, part, at, depth_after(pair, from, by, part)});
      return;
    }
    const double nearer = part < 1 ? nearing(pair, apart, now_, scaled(by, 1 - part)) : 0;
    if (apart.distance - nearer >= bodies_meet) {
      pair.at_least = apart.distance - nearer;
      return;
    }
    part = std::min(1.0, part + (1 - part) * (apart.distance - bodies_meet / 2) / nearer);
  }
}

/// Checks whether two bodies that have met have separated at the axis positions `to`. Bodies that are still in contact are not reported
/// again.
void MovingBodies::part_from(Pair& pair, const Axes& to) {
  links_.poses(to, now_);
  const double distance = gap(pair, now_).distance;
  pair.touches = distance < bodies_meet;
  pair.at_least = pair.touches ? 0 : distance;
}

double MovingBodies::depth(std::size_t first, std::size_t second, const Axes& axes) {
  const SolidBody &a = bodies_[first].solid, &b = bodies_[second].solid;
  if (!a.convex || !b.convex) return 0;
  links_.poses(axes, now_);
  return world_.depth(a, pose(first, now_), b, pose(second, now_));
}

double MovingBodies::depth_after(const Pair& pair, const Axes& from, const Axes& by, double part) {
  double deepest = 0;
  for (int i = 0; i <= depth_samples; ++i)
    deepest = std::max(deepest, depth(pair.first, pair.second, along_axes(from, by, part + (1 - part) * i / depth_samples)));
  return deepest;
}

bool MovingBodies::same_groups(std::size_t a, std::size_t b, std::size_t c, std::size_t d) const {
  return bodies_[a].group == bodies_[c].group && bodies_[b].group == bodies_[d].group;
}

/// Reports the first collision of two groups in a motion; reports nothing if other bodies of these groups are already in contact.
void MovingBodies::report_meeting(const BodyMeeting& meeting, std::size_t first_new, std::vector<BodyMeeting>& found) const {
  for (const Pair& pair : pairs_)
    if (pair.touched && same_groups(pair.first, pair.second, meeting.first, meeting.second)) return;
  for (std::size_t i = first_new; i < found.size(); ++i) {
    BodyMeeting& other = found[i];
    if (!same_groups(other.first, other.second, meeting.first, meeting.second)) continue;
    const double depth = std::max(other.depth, meeting.depth);
    if (meeting.part < other.part) other = meeting;
    other.depth = depth;
    return;
  }
  found.push_back(meeting);
}

}  // namespace kadr
