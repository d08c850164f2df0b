// Converts the steps of a run to vertices of a path (PathRecord). Used by view/program_run; tested by tests/serve.py.

#include "view/path_record.h"

#include <algorithm>

namespace kadr {
namespace {

constexpr double chord = 0.002;      // greatest distance in mm between a chord and the arc that the chord replaces
constexpr double same_place = 1e-6;  // limit in mm: points whose distance is smaller count as the same
constexpr double seconds_a_minute = 60;
constexpr double shortest_dwell = 1e-3;  // least time in s of a dwell that gets its own vertex

PathKind kind_of(MotionKind kind) {
  switch (kind) {
    case MotionKind::rapid: return PathKind::rapid;
    case MotionKind::feed: return PathKind::feed;
    case MotionKind::arc_cw: return PathKind::arc_cw;
    case MotionKind::arc_ccw: return PathKind::arc_ccw;
    case MotionKind::probe: return PathKind::probe;
    case MotionKind::home: return PathKind::home;
    case MotionKind::thread: return PathKind::thread;
    default: return PathKind::spline;
  }
}

/// Returns the joints that turn the part: the control's own joints if tool centre point control is active, else the joints of the machine
/// file.
std::vector<PartJoint> joints_at(const Step& step, const MachineTree* tree) {
  const auto* const space = dynamic_cast<const FiveAxisTransform*>(step.from.space.get());
  if (space != nullptr && space->has_rotary()) return part_joints(space->data());
  return tree != nullptr ? part_joints(*tree) : std::vector<PartJoint>();
}

std::array<float, 3> single(Vec3 v) { return {float(v.x), float(v.y), float(v.z)}; }

}  // namespace

PathRecord::PathRecord(const AxisRoles& roles, std::shared_ptr<const MachineTree> tree, const std::optional<Axes>& apart,
                       std::uint32_t tool)
    : roles_(roles), tree_(std::move(tree)), tool_path_(roles, chord, {}, tree_, apart), tool_(tool) {}

void PathRecord::begin_piece() {
  ViewPiece& piece = pieces_.emplace_back();
  open_ = true;
  piece.begins = last_time_;
  piece.first = std::uint32_t(vertices_);
  piece.vertices.reserve(pieces_.size() > 1 ? ViewPiece::most : 64);
}

void PathRecord::add(const PathVertex& vertex, Vec3 at, Vec3 direction, double time) {
  if (is_full()) return;
  if (open_ && pieces_.back().vertices.size() >= ViewPiece::most) flush();
  if (!open_) {
    const PathVertex before = pieces_.empty() ? PathVertex() : pieces_.back().vertices.back();
    const bool leant = !pieces_.empty() && !pieces_.back().directions.empty();
    const bool first = pieces_.empty();
    begin_piece();
    if (!first) {
      pieces_.back().vertices.push_back(before);
      pieces_.back().vertices.back().time = 0;
      pieces_.back().positions = last_stand_;
      if (leant) pieces_.back().directions.push_back(single(last_direction_));
    }
  }
  ViewPiece& piece = pieces_.back();
  if (piece.vertices.empty()) piece.begins = time;
  if (piece.directions.empty() && direction != Vec3{0, 0, 1}) piece.directions.assign(piece.vertices.size(), {0, 0, 1});
  const bool leans = !piece.directions.empty() || direction != Vec3{0, 0, 1};
  piece.vertices.push_back(vertex);
  piece.vertices.back().at = single(at);
  piece.vertices.back().time = float(time - piece.begins);
  if (leans) piece.directions.push_back(single(direction));
  piece.positions.insert(piece.positions.end(), stand_.begin(), stand_.end());
  last_stand_ = stand_;
  ++vertices_;
  last_time_ = time;
  last_ = at;
  last_direction_ = direction;
}

void PathRecord::consume(const Step& step, double later, double longer) {
  if (const auto* const change = std::get_if<ToolChange>(&step.action.what)) tool_ = change->tool;
  tool_path_.take(step, segments_);
  const Motion* const motion = step.motion();
  const double begins = step.begins + later, seconds = step.time.seconds + longer;
  PathVertex vertex;
  vertex.line = step.action.origin.line;
  vertex.number = step.action.origin.number;
  vertex.file = step.action.origin.file;
  vertex.tool = std::uint16_t(std::min<std::uint32_t>(tool_, 65535));
  if (motion == nullptr && begun_ && step.pause > shortest_dwell) add(vertex, last_, last_direction_, begins + step.pause);
  if (motion == nullptr) return;
  if (!begun_) joints_ = joints_at(step, tree_.get());
  if (segments_.empty()) turn_on_the_spot(step);
  if (segments_.empty()) return;
  note_reach(*motion);
  vertex.kind = kind_of(motion->kind);
  const bool rapid = motion->kind == MotionKind::rapid || motion->kind == MotionKind::home;
  vertex.feed = rapid ? 0 : float(step.time.feed);
  vertex.speed = seconds > 0 ? float(step.time.length / seconds * seconds_a_minute) : 0;
  const PathSegment& start = segments_.front();
  if (!begun_ || length(start.from - last_) > same_place) {
    PathVertex there = vertex;
    there.kind = PathKind::jump;
    stand_at(step, 0);
    add(there, start.from, start.from_direction, begins);
    begun_ = true;
  }
  for (const PathSegment& w : segments_) {
    stand_at(step, w.ends);
    add(vertex, w.to, w.to_direction, begins + seconds * w.ends);
  }
}

/// Adds vertices for a rotation of the part during which the tool tip does not move relative to the part.
void PathRecord::turn_on_the_spot(const Step& step) {
  if (!begun_ || joints_.empty()) return;
  stand_at(step, 1);
  if (stand_ != last_stand_) segments_.push_back({last_, last_, 0, 1, last_direction_, last_direction_});
}

void PathRecord::stand_at(const Step& step, double part) {
  if (joints_.empty()) return;
  const Axes axes = ToolPath::axes_at(step, part);
  stand_.clear();
  for (const PartJoint& joint : joints_) stand_.push_back(float(axes[std::size_t(joint.axis)]));
}

void PathRecord::note_reach(const Motion& motion) {
  Box box;
  box.take(segments_.front().from);
  for (const PathSegment& w : segments_) box.take(w.to);
  all_.take(box);
  if (cuts(motion)) cutting_.take(box);
}

Box PathRecord::moved(Box box) const {
  box.least = box.least - zero();
  box.most = box.most - zero();
  return box;
}

void PathRecord::flush() {
  if (!open_) return;
  open_ = false;
  set_levels(pieces_.back());
  if (on_piece) on_piece(pieces_.back());
}

double PathRecord::end_of_block(std::uint32_t number) const {
  const auto begins = [&](const ViewPiece& p) { return p.vertices.front().number <= number; };
  auto piece = std::partition_point(pieces_.begin(), pieces_.end(), begins);
  if (piece == pieces_.begin()) return 0;
  --piece;
  const auto after =
      std::partition_point(piece->vertices.begin(), piece->vertices.end(), [&](const PathVertex& v) { return v.number <= number; });
  return time_of(*piece, *(after - 1));
}

void PathRecord::take_times_of(const PathRecord& path) {
  for (ViewPiece& piece : pieces_) {
    if (piece.vertices.empty()) continue;
    piece.begins = path.end_of_block(piece.vertices.front().number);
    for (PathVertex& vertex : piece.vertices) vertex.time = float(path.end_of_block(vertex.number) - piece.begins);
  }
}

const PathVertex* PathRecord::at(double instant) const {
  const auto ends_before = [](const ViewPiece& p, double t) { return p.vertices.empty() || time_of(p, p.vertices.back()) < t; };
  const auto piece = std::partition_point(pieces_.begin(), pieces_.end(), [&](const ViewPiece& p) { return ends_before(p, instant); });
  if (piece == pieces_.end()) return nullptr;
  const auto vertex = std::partition_point(piece->vertices.begin(), piece->vertices.end(),
                                           [&](const PathVertex& v) { return time_of(*piece, v) < instant; });
  return vertex == piece->vertices.end() ? nullptr : &*vertex;
}

}  // namespace kadr
