// CYCLE72: milling along a contour (spec/sinumerik 14.5). The contour is read once (control/outline_run.h); the passes are the path of the
// tool's centre along it, with an approach and a retraction of the cycle. Used by control/sinumerik.

#include <cmath>

#include "control/outline_run.h"
#include "control/sinumerik/mill_steps.h"
#include "path/pocketing/edge.h"

namespace kadr::sinumerik {
namespace {

/// The way to the contour or from it: _AS1, _LP1 or _AS2, _LP2.
struct Way {
  enum class Form : std::uint8_t { line = 1, quarter = 2, half = 3 };
  Form form = Form::line;
  bool in_space = false;  // the tool axis moves along it too
  double length = 0;      // of the line, or the radius of the arc of the tool's centre, mm
};

/// Works out the steps of one call.
class ContourMaker {
 public:
  ContourMaker(Interpreter& m, const std::vector<Value>& arguments, Span where) : m_(m), arguments_(arguments), where_(where) {}

  std::vector<MillStep> steps;

  Status take_parameters() {
    KADR_TRY(take_levels());
    const int kind = digits(10, 1);
    finishes_ = kind % 10 == 2;
    if (kind % 10 < 1 || kind % 10 > 2 || kind / 10 % 10 > 1 || kind / 100 % 10 > 3 || kind >= 1000)
      return fail(alarm(AlarmId::not_available, where_, "_VARI"));
    between_at_feed_ = kind / 10 % 10 == 1;
    between_ = kind / 100 % 10;
    const int side = digits(11, 41);
    if (side < 40 || side > 42) return fail(alarm(AlarmId::value_out_of_range, where_, "_RL", double(side)));
    side_ = side == 40 ? 0 : side == 41 ? 1 : -1;
    KADR_TRY(take_way(approach_, 12));
    KADR_TRY(take_way(leave_, 15));
    feed_ = number(8), plunge_ = number(9);
    between_feed_ = number(14) > 0 ? number(14) : feed_;
    if (!(feed_ > 0) || !(plunge_ > 0)) KADR_TRY(m_.feed_known(where_));
    return {};
  }

  Status run(const Edges& outline) {
    const auto cutter = side_ == 0 ? Result<double>(0.0) : sinumerik_of(m_).cutter_radius(m_, where_);
    if (!cutter) return fail(cutter.error());
    const double radius = *cutter;
    // Without compensation there is no side on which an allowance could be left.
    const double distance = side_ == 0 ? 0 : radius + (finishes_ ? 0 : std::fabs(number(6)));
    const auto path = offset_outline(m_, outline, distance, side_, CornerJoin::arc, where_);
    if (!path) return fail(path.error());
    const double bottom = number(4) + (finishes_ ? 0 : std::fabs(number(7)));
    std::vector<double> all;
    KADR_TRY(add_depths(all, reference_, bottom, finishes_ ? 0 : number(5), where_));
    if (all.size() * path->size() > most_steps) return fail(alarm(AlarmId::cycle_endless, where_));
    const Axes& at = m_.position.programmed;
    const PlaneAxes plane = m_.modal.axes;
    at_ = {at[plane.first], at[plane.second]};
    height_ = at[plane.normal];
    if (height_ < retract_) go(MillStep::Kind::rapid, at_, retract_);
    const Vec2 begin = way_point(path->front(), 0, approach_);
    go(MillStep::Kind::rapid, begin, height_);
    go(MillStep::Kind::rapid, begin, level_);
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (i > 0) to_next(begin);
      pass(*path, begin, all[i]);
    }
    go(MillStep::Kind::rapid, at_, retract_);
    return {};
  }

 private:
  bool given(std::size_t i) const { return i < arguments_.size() && !arguments_[i].omitted; }
  double number(std::size_t i) const { return given(i) ? arguments_[i].number : 0; }
  int digits(std::size_t i, int otherwise) const { return given(i) ? static_cast<int>(std::lround(number(i))) : otherwise; }

  Status take_levels() {
    for (std::size_t i = 1; i < arguments_.size(); ++i)
      if (given(i) && (!arguments_[i].is_number() || !(std::fabs(arguments_[i].number) <= farthest)))
        return fail(alarm(AlarmId::operand_type, where_, "CYCLE72"));
    retract_ = number(1), reference_ = number(2);
    level_ = reference_ + std::fabs(number(3));
    if (!(retract_ >= reference_) || !(number(4) < reference_)) return fail(alarm(AlarmId::cycle_reference_plane, where_));
    return {};
  }

  Status take_way(Way& way, std::size_t first) {
    const int kind = digits(first, 1), form = kind % 10;
    if (form < 1 || form > 3 || kind / 10 > 1) return fail(alarm(AlarmId::value_out_of_range, where_, "_AS", double(kind)));
    way.form = side_ == 0 ? Way::Form::line : static_cast<Way::Form>(form);  // with G40 there is no side for an arc
    way.in_space = kind / 10 == 1;
    way.length = std::fabs(number(first + 1));
    return {};
  }

  Vec2 outwards(Vec2 along) const { return double(side_) * Vec2{-along.y, along.x}; }

  /// Returns the other end of the way to the beginning of an edge (`part` 0), or from its end (1).
  Vec2 way_point(const Edge& edge, double part, const Way& way) const {
    const Vec2 along = area::direction(edge, part), at = part == 0 ? edge.from : edge.to;
    const Vec2 back = part == 0 ? -1.0 * along : along;
    switch (way.form) {
      case Way::Form::quarter: return at + way.length * (back + outwards(along));
      case Way::Form::half: return at + 2 * way.length * outwards(along);
      default: return at + way.length * back;
    }
  }

  void go(MillStep::Kind kind, Vec2 to, double height, double feed = 0) {
    at_ = to, height_ = height;
    steps.push_back({kind, to, height, feed, {}, 0});
  }

  /// Moves along the way to the contour or from it.
  void follow(const Way& way, Vec2 to, double height, Vec2 contour, Vec2 along) {
    if (way.form == Way::Form::line || way.length <= tol::same_point) return go(MillStep::Kind::feed, to, height, feed_);
    const Vec2 centre = contour + way.length * outwards(along);
    at_ = to, height_ = height;
    steps.push_back({side_ < 0 ? MillStep::Kind::arc_cw : MillStep::Kind::arc_ccw, to, height, feed_, centre,
                     way.form == Way::Form::half ? 0.5 : 0.25});
  }

  void pass(const Edges& path, Vec2 begin, double depth) {
    const Vec2 first = area::direction(path.front(), 0), last = area::direction(path.back(), 1);
    if (!approach_.in_space) go(MillStep::Kind::feed, begin, depth, plunge_);
    follow(approach_, path.front().from, depth, path.front().from, first);
    for (const Edge& edge : path) {
      if (area::is_line(edge)) {
        go(MillStep::Kind::feed, edge.to, depth, feed_);
        continue;
      }
      at_ = edge.to;
      steps.push_back({edge.bulge > 0 ? MillStep::Kind::arc_ccw : MillStep::Kind::arc_cw, edge.to, depth, feed_,
                       area::circle_of(edge).centre, 2 * std::atan(std::fabs(edge.bulge)) / pi});
    }
    const double up = leave_.in_space ? std::min(level_, depth + std::fabs(number(3))) : depth;
    follow(leave_, way_point(path.back(), 1, leave_), up, path.back().to, last);
  }

  /// From the end of a pass to the beginning of the next one (_VARI, hundreds and tens).
  void to_next(Vec2 begin) {
    const double depth = height_;
    const double heights[] = {retract_, level_, std::min(retract_, depth + std::fabs(number(3))), depth};
    const double high = std::max(depth, heights[between_]);
    const bool at_feed = between_at_feed_ || high <= depth + tol::same_point;  // what is at the depth may not have been cut yet
    const auto kind = at_feed ? MillStep::Kind::feed : MillStep::Kind::rapid;
    go(kind, at_, high, between_feed_);
    go(kind, begin, high, between_feed_);
  }

  Interpreter& m_;
  const std::vector<Value>& arguments_;
  Span where_;
  double retract_ = 0, reference_ = 0, level_ = 0, feed_ = 0, plunge_ = 0, between_feed_ = 0;
  bool finishes_ = false, between_at_feed_ = false;
  int side_ = 0, between_ = 0;
  Way approach_, leave_;
  Vec2 at_;
  double height_ = 0;
};

/// Starts the contour's subprogram, "NAME", or a part of the program, "FROM:TO", in a copy of the interpreter.
Status call_contour(Interpreter& copy, const std::string& name, Span where) {
  Sinumerik& own = sinumerik_of(copy);
  own.words = {};
  own.memory.pattern.reset();
  for (Level& level : own.memory.levels) level.modal_call.reset();
  KADR_TRY(own.set_programmable(copy, {}, where));  // the cycle executes the path within the frame in force
  const std::size_t colon = name.find(':');
  if (colon != std::string::npos) return own.call_section(copy, name.substr(0, colon), name.substr(colon + 1), where);
  const auto found = own.find_program(copy, name);
  if (!found) return fail(alarm(AlarmId::program_missing, where, std::string_view(name)));
  return own.call(copy, *found, name, {}, {}, false, 1, where);
}

}  // namespace

Status Sinumerik::mill_contour(Interpreter& m, const std::vector<Value>& arguments, Span where) {
  if (m.modal.radius_side != 0) return fail(alarm(AlarmId::compensation_active, where, "CYCLE72"));
  if (m.transform.leaves(m.modal.axes) || m.transform.distorts(m.modal.axes))
    return fail(alarm(AlarmId::not_together, where, "SCALE", "CYCLE72"));
  if (arguments.empty() || arguments[0].type != Type::text) return fail(alarm(AlarmId::operand_type, where, "_KNAME"));
  ContourMaker maker(m, arguments, where);
  KADR_TRY(maker.take_parameters());
  const std::string name = arguments[0].text;
  const auto outline = outline_of(m, where, [&](Interpreter& copy) { return call_contour(copy, name, where); });
  if (!outline) return fail(outline.error());
  KADR_TRY(maker.run(outline->edges));
  m.running = std::make_unique<MillSteps>(std::move(maker.steps));
  return {};
}

}  // namespace kadr::sinumerik
