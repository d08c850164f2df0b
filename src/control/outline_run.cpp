// Converts between the motions of a subprogram and the edges of an outline. Used by the dialects' milling cycles.

#include "control/outline_run.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "action/by_kind.h"
#include "base/tolerance.h"
#include "control/interpreter.h"
#include "path/pocketing/edge.h"

namespace kadr {
namespace {

constexpr std::size_t most_motions = limits::drawing_edges;
constexpr std::uint64_t most_repeated_blocks = 1'000'000;

/// The program's bytes for a second reader of the same file.
class SameBytes final : public ByteSource {
 public:
  explicit SameBytes(std::shared_ptr<ByteSource> of) : of_(std::move(of)) {}
  std::size_t read(std::uint64_t offset, char* to, std::size_t size) override { return of_->read(offset, to, size); }
  std::uint64_t size() const override { return of_->size(); }

 private:
  std::shared_ptr<ByteSource> of_;
};

Vec2 in_plane(const Axes& point, PlaneAxes plane) { return {point[plane.first], point[plane.second]}; }

/// Adds the way of a motion, an arc in parts of at most half a circle.
void add_edges(Edges& edges, Vec2 from, const Motion& motion, PlaneAxes plane) {
  const Vec2 to = in_plane(motion.to, plane);
  if (!is_arc(motion.kind)) {
    if (length(to - from) > tol::same_point) edges.push_back({from, to});
    return;
  }
  const double sense = motion.kind == MotionKind::arc_ccw ? 1 : -1, turns = std::fabs(motion.turns);
  const double parts = std::max(1.0, std::ceil(2 * turns - 1e-9));
  const Vec2 arm = from - motion.center;
  const double bulge = sense * std::tan(turns / parts * pi / 2);
  for (double i = 1; i <= parts; ++i) {
    const Vec2 end = i < parts ? motion.center + rotated(arm, sense * 360 * turns * i / parts) : to;
    edges.push_back({from, end, bulge});
    from = end;
  }
}

/// Keeps of a motion what its way in the plane is made of.
Motion plain_motion(const Motion& motion) {
  Motion plain;
  plain.kind = is_arc(motion.kind) ? motion.kind : MotionKind::feed;
  plain.first = motion.first, plain.second = motion.second;
  plain.named = motion.named;
  plain.center = motion.center;
  plain.turns = motion.turns;
  plain.feed = 1;
  plain.to = plain.machine = motion.to;
  if (motion.detail && motion.detail->contour) {
    auto detail = std::make_shared<MotionDetail>();
    detail->contour = motion.detail->contour;
    plain.detail = std::move(detail);
  }
  return plain;
}

/// Executes the subprogram until it returns, and collects its motions in the plane.
class OutlineRun {
 public:
  OutlineRun(Interpreter& m, Span where, RunLimits limits)
      : m_(m),
        where_(where),
        plane_(m.modal.axes),
        stop_(limits.stop),
        copy_(m.def, nullptr, *m.kept_setup(), program_of(m), with_limit(limits), std::make_shared<Commons>()) {}

  Status run(const std::function<Status(Interpreter&)>& call) {
    const auto now = m_.snapshot(0);
    if (!now) return fail(alarm(AlarmId::outline_missing, where_));
    static std::function<void(const AlarmReport&)> nobody;
    copy_.on_warning = &nobody;
    copy_.make_no_copies();
    KADR_TRY(copy_.restore(*now));
    ActionBatch batch;
    copy_.batch = &batch;
    if (!copy_.modal.feed_known) copy_.modal.feed = 1, copy_.modal.feed_known = true;  // the cycle has feeds of its own
    const std::size_t depth = copy_.program().depth();
    KADR_TRY(call(copy_));
    const std::function<bool(const Origin&)> returned = [&](const Origin& block) {
      if (copy_.program().depth() <= depth) return true;
      m_.use.pass(block);  // the cycle carries this line out
      if (m_.line_marks != nullptr) m_.line_marks->note(block.file, block.line);
      return false;
    };
    copy_.holds_before = &returned;
    for (Control::State state = Control::State::running; state == Control::State::running;) {
      if (stop_.requested()) return fail(alarm(AlarmId::interrupted, where_));
      state = copy_.run(batch);
      KADR_TRY(take(batch));
      if (state == Control::State::needs_probe || state == Control::State::waiting) return fail(alarm(AlarmId::outline_missing, where_));
      if (state == Control::State::stopped) return fault();
    }
    return {};
  }

  ActionBatch path;
  Axes start{};
  int side = 0;

 private:
  static Program program_of(const Interpreter& m) {
    const ProgramFile& file = m.program().file(0);
    return {file.path(), std::make_unique<SameBytes>(file.source()), file.reader().encoding()};
  }
  static RunLimits with_limit(RunLimits limits) {
    limits.repeated_blocks = std::min(limits.repeated_blocks, most_repeated_blocks);
    limits.writes_files = false;
    return limits;
  }

  Status take(ActionBatch& batch) {
    for (Action& action : batch) {
      const Motion* const motion = motion_of(action);
      if (motion == nullptr) continue;
      const Vec2 to = in_plane(motion->to, plane_);
      const bool moves = is_arc(motion->kind) || length(to - in_plane(at_, plane_)) > tol::same_point;
      if (is_arc(motion->kind) && (motion->first != plane_.first || motion->second != plane_.second))
        return fail(alarm(AlarmId::outline_missing, where_));
      at_ = motion->to;
      if (!begun_) {
        const AxisMask both = AxisMask{1} << plane_.first | AxisMask{1} << plane_.second;
        begun_ = (motion->named & both) != 0;
        start = motion->to;
        continue;
      }
      if (!moves) continue;
      if (path.size() >= most_motions) return fail(alarm(AlarmId::mill_too_long, where_, double(most_motions)));
      if (motion->side != 0) side = motion->side;
      Action& kept = path.add();
      kept.origin = action.origin;
      Motion plain = plain_motion(*motion);
      plain.to[plane_.normal] = plain.machine[plane_.normal] = start[plane_.normal];
      kept.what = std::move(plain);
    }
    return {};
  }

  /// The alarm of a block of the subprogram, which the report shows instead of the block with the cycle.
  Status fault() const {
    m_.fault_place = {copy_.report.origin, copy_.report.line_text};
    return fail(copy_.report.alarm);
  }

  Interpreter& m_;
  Span where_;
  PlaneAxes plane_;
  StopToken stop_;
  Interpreter copy_;
  Axes at_{};
  bool begun_ = false;
};

Edges edges_of(const ActionBatch& path, Vec2 from, PlaneAxes plane) {
  Edges edges;
  for (const Action& action : path) {
    const Motion* const motion = motion_of(action);
    if (motion == nullptr) continue;
    add_edges(edges, from, *motion, plane);
    from = in_plane(motion->to, plane);
  }
  return edges;
}

}  // namespace

Result<Outline> outline_of(Interpreter& m, Span where, const std::function<Status(Interpreter& copy)>& call) {
  if (m.kept_setup() == nullptr) return fail(alarm(AlarmId::outline_missing, where));  // the cycle is in a contour
  OutlineRun run(m, where, m.program().limits());
  if (const Status done = run.run(call); !done) return fail(done.error());
  const bool resolves = m.find_corners != nullptr && *m.find_corners;
  if (run.path.empty()) return fail(alarm(AlarmId::outline_missing, where));
  if (resolves)
    if (auto fault = (*m.find_corners)(run.path, run.start)) {
      fault->where = where;
      return fail(*fault);
    }
  Outline outline{edges_of(run.path, in_plane(run.start, m.modal.axes), m.modal.axes), run.side};
  if (outline.edges.empty()) return fail(alarm(AlarmId::outline_missing, where));
  return outline;
}

Result<Edges> offset_outline(Interpreter& m, const Edges& outline, double radius, int side, CornerJoin join, Span where) {
  if (radius <= tol::same_point || m.find_corners == nullptr || !*m.find_corners) return outline;
  const PlaneAxes plane = m.modal.axes;
  Axes at{};
  const auto place = [&](Vec2 point) {
    at[plane.first] = point.x;
    at[plane.second] = point.y;
    return at;
  };
  const auto outwards = [&](Vec2 along) { return double(side) * Vec2{-along.y, along.x}; };
  ActionBatch path;
  const auto add = [&](Vec2 to) -> Motion& {
    Motion motion;
    motion.kind = MotionKind::feed;
    motion.first = static_cast<std::uint8_t>(plane.first), motion.second = static_cast<std::uint8_t>(plane.second);
    motion.named = AxisMask{1} << plane.first | AxisMask{1} << plane.second;
    motion.feed = 1;
    motion.tool_radius = radius;
    motion.side = static_cast<std::int8_t>(side);
    motion.join_corner = join;
    motion.entry = CompensationApproach::square;
    motion.to = motion.machine = place(to);
    Action& action = path.add();
    action.origin = m.origin;
    action.what = std::move(motion);
    return *motion_of(action);
  };
  const Vec2 begin = outline.front().from, end = outline.back().to;
  const Axes start = place(begin + 3 * radius * outwards(area::direction(outline.front(), 0)));
  add(begin).side_step = SideStep::begins;
  for (const Edge& edge : outline) {
    Motion& motion = add(edge.to);
    if (area::is_line(edge)) continue;
    motion.kind = edge.bulge > 0 ? MotionKind::arc_ccw : MotionKind::arc_cw;
    motion.center = area::circle_of(edge).centre;
    motion.turns = 2 * std::atan(std::fabs(edge.bulge)) / pi;
  }
  Motion& last = add(end + 3 * radius * outwards(area::direction(outline.back(), 1)));
  last.side = 0;
  last.side_step = SideStep::ends;
  if (auto fault = (*m.find_corners)(path, start)) {
    fault->where = where;
    return fail(*fault);
  }
  Edges edges = edges_of(path, in_plane(start, plane), plane);
  if (edges.size() < 3) return fail(alarm(AlarmId::outline_missing, where));
  edges.erase(edges.begin());
  edges.pop_back();
  return edges;
}

bool is_closed(const Edges& outline) { return length(outline.back().to - outline.front().from) <= tol::contour_gap; }

}  // namespace kadr
