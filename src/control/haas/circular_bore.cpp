// Circular pockets G12, G13 (spec/haas 7.1). INFERRED: the tool approaches and leaves each circle on a half circle, as in the manual's
// drawing.

#include "base/code_literals.h"
#include "control/fanuc/fanuc.h"
#include "control/fanuc/words/coordinates.h"
#include "control/functions/functions.h"

namespace kadr::functions {
namespace {

/// Cuts the circles of a circular pocket at the present depth; the tool is at the centre of the pocket.
class CircularBore {
 public:
  CircularBore(Emitter& m, const Call& call) : m_(m), call_(call), turn_(call.row->tenth == 12_g ? Turn::cw : Turn::ccw) {}

  Status run() {
    KADR_TRY(sizes());
    KADR_TRY(m_.feed_known(call_.where));
    AxisMask named = 0;
    Axes to;
    KADR_TRY(m_.target(to, named));
    const AxisMask in_plane = AxisMask{1} << plane_.first | AxisMask{1} << plane_.second;
    if ((named & in_plane) != 0) {
      Axes over = m_.position.programmed;
      over[plane_.first] = to[plane_.first];
      over[plane_.second] = to[plane_.second];
      KADR_TRY(m_.straight(MotionKind::rapid, over, named & in_plane));
    }
    center_ = {m_.position.programmed[plane_.first], m_.position.programmed[plane_.second]};
    const double depth = to[plane_.normal] - m_.position.programmed[plane_.normal];
    for (std::uint32_t i = 0; i < passes_; ++i) KADR_TRY(level(depth));
    return {};
  }

 private:
  /// Reads I, K, Q and D, and computes the radii of the tool's path in mm.
  ///   alarms  word_missing, pocket_words_wrong, value_out_of_range
  Status sizes() {
    if (!m_.has('I')) return fail(alarm(AlarmId::word_missing, call_.where, 'I', call_.row->code));
    const double given = m_.has('D') ? m_.value('D') : macro_b_of(m_).state.words.d;
    double tool = 0;
    if (given > 0 && given < static_cast<double>(m_.tables.offsets.size())) {
      const ToolOffset& offset = m_.tables.offsets[static_cast<std::size_t>(given)];
      tool = offset.radius + offset.radius_wear;
    }
    first_ = m_.length_value('I') - tool;
    last_ = m_.has('K') ? m_.length_value('K') - tool : first_;
    step_ = m_.has('Q') ? m_.length_value('Q') : 0;
    const auto wrong = [&](char letter) { return fail(alarm(AlarmId::pocket_words_wrong, m_.where(letter), letter)); };
    if (!(first_ > 0)) return wrong('I');
    if (!(last_ >= first_)) return wrong('K');
    constexpr double max_circles = 10'000;
    if (last_ > first_ && !(step_ > 0 && (last_ - first_) / step_ < max_circles)) return wrong(m_.has('Q') ? 'Q' : 'K');
    if (m_.has('L')) {
      const auto times = m_.whole('L', 1, 1000);
      if (!times) return fail(times.error());
      passes_ = *times;
    }
    return {};
  }

  Status level(double depth) {
    Axes down = m_.position.programmed;
    down[plane_.normal] += depth;
    if (depth != 0) KADR_TRY(m_.straight(MotionKind::feed, down, AxisMask{1} << plane_.normal));
    double radius = first_;
    KADR_TRY(arc(radius / 2, radius, 0.5));
    KADR_TRY(arc(0, radius, 1));
    while (radius < last_) {
      radius = std::min(radius + step_, last_);
      Axes out = m_.position.programmed;
      out[plane_.first] = center_.x + radius;
      KADR_TRY(m_.straight(MotionKind::feed, out, AxisMask{1} << plane_.first));
      KADR_TRY(arc(0, radius, 1));
    }
    return arc(radius / 2, 0, 0.5);
  }

  /// Adds an arc. The points are given by their coordinates on the plane's first axis, relative to the pocket's centre: `around` is the
  /// arc's centre, `to` its end.
  Status arc(double around, double to, double turns) {
    Axes end = m_.position.programmed;
    end[plane_.first] = center_.x + to;
    end[plane_.second] = center_.y;
    const Axes work = m_.transform.identity ? end : m_.transform.to_work(end);
    KADR_TRY(m_.within_reach(work));
    const AxisMask named = AxisMask{1} << plane_.first | AxisMask{1} << plane_.second;
    m_.move_to(end, work, named);
    const bool cw = (turn_ == Turn::cw) != m_.transform.reverses(plane_);
    Motion& motion = m_.add_motion(cw ? MotionKind::arc_cw : MotionKind::arc_ccw, named);
    m_.set_feed(motion);
    const Vec2 center = center_ + Vec2{around, 0};
    motion.center = m_.transform.identity ? center : m_.transform.to_work(center, plane_);
    motion.turns = turns;
    return {};
  }

  Emitter& m_;
  const Call& call_;
  Turn turn_;
  PlaneAxes plane_ = m_.modal.axes;
  Vec2 center_;
  double first_ = 0, last_ = 0, step_ = 0;
  std::uint32_t passes_ = 1;
};

}  // namespace

/// G12 (clockwise) and G13 (counter-clockwise): cuts a circular pocket.
Status circular_bore(Emitter& m, const Call& call) { return CircularBore(m, call).run(); }

}  // namespace kadr::functions
