// Drilling cycles and patterns of holes (spec/sinumerik 14). A cycle is worked out as a list of steps when it is called, and executed a few
// steps at a time. Used by control/sinumerik.

#include <algorithm>
#include <cmath>

#include "base/ascii.h"
#include "base/tolerance.h"
#include "control/sinumerik/sinumerik.h"

namespace kadr::sinumerik {
namespace {

struct CycleStep {
  enum class Kind : std::uint8_t { rapid, feed, dwell, spindle, stop };
  Kind kind = Kind::rapid;
  Axes to{};
  AxisMask named = 0;
  double value = 0;  // feed in mm/min, 0: the feed in force; seconds
  SpindleDir dir = SpindleDir::stop;
  double angle = 0;
};

/// A cycle as its steps.
class CycleSteps final : public SteppedCycleValue<CycleSteps> {
 public:
  explicit CycleSteps(std::vector<CycleStep> steps) : steps_(std::move(steps)) {}

  Result<bool> next(Emitter& m) override {
    for (std::size_t i = 0; i < at_a_time && at_ < steps_.size(); ++i) KADR_TRY(execute(m, steps_[at_++]));
    return at_ < steps_.size();
  }

 private:
  static constexpr std::size_t at_a_time = 8;

  static Status execute(Emitter& m, const CycleStep& step) {
    Axes to = m.position.programmed;
    for (std::size_t a = 0; a < m.axis_count; ++a)
      if ((step.named >> a & 1U) != 0) to[a] = step.to[a];
    switch (step.kind) {
      case CycleStep::Kind::rapid: return m.straight(MotionKind::rapid, to, step.named);
      case CycleStep::Kind::feed: {
        const double feed = m.modal.feed;
        const FeedMode mode = m.modal.feed_mode;
        if (step.value > 0) m.modal.feed = step.value, m.modal.feed_mode = FeedMode::per_minute;
        const Status moved = m.straight(MotionKind::feed, to, step.named);
        m.modal.feed = feed;
        m.modal.feed_mode = mode;
        return moved;
      }
      case CycleStep::Kind::dwell: m.emit(Dwell{step.value}); return {};
      case CycleStep::Kind::spindle:
        m.modal.spindle = step.dir == SpindleDir::position ? SpindleDir::stop : step.dir;
        if (step.dir == SpindleDir::position) m.emit(Spindle{step.dir, 0, 1, std::nullopt, step.angle});
        else m.emit(Spindle{step.dir, step.dir == SpindleDir::stop ? 0 : m.modal.rpm});
        return {};
      case CycleStep::Kind::stop: m.emit(Stop{false}); return {};
    }
    return {};
  }

  std::vector<CycleStep> steps_;
  std::size_t at_ = 0;
};

/// Works out the steps of one call.
class CycleMaker {
 public:
  CycleMaker(Interpreter& m, const std::vector<Value>& arguments, Span where)
      : m_(m), arguments_(arguments), where_(where), axis_(m.modal.axes.normal), at_(m.position.programmed) {}

  std::vector<CycleStep> steps;

  Status run(const std::string& name) {
    if (name == "HOLES1" || name == "HOLES2" || name == "CYCLE801") return pattern(name);
    return drill(name, arguments_);
  }

 private:
  bool given(std::size_t i) const { return i < arguments_.size() && !arguments_[i].omitted; }
  double number(std::size_t i) const { return given(i) ? arguments_[i].number : 0; }

  // ---- steps

  void rapid(double to) {
    CycleStep step;
    step.named = AxisMask{1} << axis_;
    step.to[axis_] = to;
    steps.push_back(step);
  }
  void feed(double to, double value = 0) {
    rapid(to);
    steps.back().kind = CycleStep::Kind::feed;
    steps.back().value = value;
  }
  void in_plane(double first, double second) {
    CycleStep step;
    step.named = AxisMask{1} << m_.modal.axes.first | AxisMask{1} << m_.modal.axes.second;
    step.to[m_.modal.axes.first] = first;
    step.to[m_.modal.axes.second] = second;
    steps.push_back(step);
  }
  void spindle(SpindleDir dir, double angle = 0) {
    CycleStep step;
    step.kind = CycleStep::Kind::spindle;
    step.dir = dir;
    step.angle = angle;
    steps.push_back(step);
  }
  void stop() {
    steps.emplace_back();
    steps.back().kind = CycleStep::Kind::stop;
  }
  /// A dwell in seconds, or in revolutions if the value is negative (spec/sinumerik 14.1).
  Status dwell(double value) {
    if (value == 0) return {};
    if (value < 0 && !(m_.modal.rpm > 0)) return fail(alarm(AlarmId::speed_missing, where_));
    steps.emplace_back();
    steps.back().kind = CycleStep::Kind::dwell;
    steps.back().value = value > 0 ? value : -value / m_.modal.rpm * 60;
    return {};
  }

  // ---- levels

  /// Reads RTP, RFP, SDIS, DP, DPR (spec/sinumerik 14.1).
  Status levels() {
    retract_ = number(0);
    reference_ = number(1);
    const bool relative = given(4) && number(4) != 0;
    if (!given(3) && !relative) return fail(alarm(AlarmId::cycle_reference_plane, where_));
    if (relative && retract_ == reference_) return fail(alarm(AlarmId::cycle_reference_plane, where_));
    // With a relative depth, the side of the retraction plane decides which way is down.
    const double side = relative ? (retract_ > reference_ ? -1 : 1) : (number(3) < reference_ ? -1 : 1);
    depth_ = relative ? reference_ + side * std::fabs(number(4)) : number(3);
    if ((reference_ - depth_) * (retract_ - reference_) < 0) return fail(alarm(AlarmId::cycle_reference_plane, where_));
    down_ = depth_ < reference_ ? -1 : 1;
    level_ = reference_ - down_ * std::fabs(number(2));
    return {};
  }

  Result<SpindleDir> direction(std::size_t i) const {
    if (number(i) == 3) return SpindleDir::cw;
    if (number(i) == 4) return SpindleDir::ccw;
    return fail(alarm(AlarmId::cycle_direction, where_, number(i)));
  }

  Status drill(const std::string& name, std::vector<Value> arguments) {
    std::swap(arguments_, arguments);
    const Status done = drill_by_arguments(name);
    std::swap(arguments_, arguments);
    return done;
  }

  // NOLINTNEXTLINE(readability-function-size): the steps of each cycle, as the manual lists them
  Status drill_by_arguments(const std::string& name) {
    const bool known = name.size() == 7 && name.starts_with("CYCLE8") && name[6] >= '1' && name[6] <= '9';
    if (!known) return fail(alarm(AlarmId::not_available, where_, std::string_view(name)));
    KADR_TRY(levels());
    if (name != "CYCLE84" && name != "CYCLE85") KADR_TRY(m_.feed_known(where_));
    if (name == "CYCLE83") return peck();
    if (name == "CYCLE84") return tap();
    if (name == "CYCLE86") return bore();
    rapid(level_);
    if (name == "CYCLE85") {
      if (!(number(6) > 0) || !(number(7) > 0)) KADR_TRY(m_.feed_known(where_));
      feed(depth_, number(6));
      KADR_TRY(dwell(number(5)));
      feed(level_, number(7));
      rapid(retract_);
      return {};
    }
    feed(depth_);
    if (name == "CYCLE81" || name == "CYCLE82" || name == "CYCLE88" || name == "CYCLE89") KADR_TRY(dwell(number(5)));
    if (name == "CYCLE87" || name == "CYCLE88") {
      spindle(SpindleDir::stop);
      stop();
    }
    if (name == "CYCLE89") feed(level_);
    rapid(retract_);
    const std::size_t turns = name == "CYCLE87" ? 5 : 6;
    if ((name == "CYCLE87" || name == "CYCLE88") && given(turns)) {
      const auto dir = direction(turns);
      if (!dir) return fail(dir.error());
    }
    return {};
  }

  /// CYCLE83 (spec/sinumerik 14.3).
  Status peck() {
    const double whole = std::fabs(reference_ - depth_);
    double first = 0;
    if (given(5)) first = (reference_ - number(5)) * -down_;
    if (!given(5) && given(6)) first = std::fabs(number(6));
    if (!(first > 0) && !given(5) && !given(6)) return fail(alarm(AlarmId::cycle_first_depth, where_));
    if (!(first > 0)) return fail(alarm(AlarmId::cycle_first_depth, where_));
    const double step = number(7);
    const double factor = number(10) > 0 ? number(10) : 1;
    const bool swarf = number(11) == 1;
    const double least = number(13), back = number(14) > 0 ? number(14) : 1, last_dwell = number(15) > 0 ? number(15) : number(8);
    const double before = number(16) > 0 ? number(16) : whole <= 30 ? 0.6 : std::min(7.0, whole / 50);
    std::vector<double> depths;
    KADR_TRY(strokes(whole, std::min(first, whole), step, least, depths));
    rapid(level_);
    double previous = 0;
    for (std::size_t i = 0; i < depths.size(); ++i) {
      const double to = reference_ + down_ * depths[i];
      if (swarf && i > 0) rapid(reference_ + down_ * (previous - before));
      feed(to, i == 0 && factor != 1 ? m_.modal.feed * factor : 0);
      const bool last = i + 1 == depths.size();
      KADR_TRY(dwell(last ? last_dwell : number(8)));
      if (!last && swarf) {
        rapid(level_);
        KADR_TRY(dwell(number(9)));
      } else if (!last) {
        feed(to - down_ * back);
      }
      previous = depths[i];
    }
    rapid(retract_);
    return {};
  }

  /// Returns the depths of the strokes: each DAM shorter than the one before, then DAM, at the end two equal halves of what is left.
  Status strokes(double whole, double first, double step, double least, std::vector<double>& depths) const {
    constexpr std::size_t most = 100'000;
    double depth = first, last = first;
    depths.push_back(depth);
    while (whole - depth > tol::same_point) {
      if (depths.size() >= most) return fail(alarm(AlarmId::cycle_endless, where_));
      const double rest = whole - depth;
      double stroke = first;
      if (step > 0) {
        stroke = last - step > step ? last - step : step;
        if (stroke <= step && rest < 2 * step) stroke = rest > step ? rest / 2 : rest;
      } else if (step < 0) {
        stroke = std::max(-step * last, least > 0 ? least : 1e-3);
      }
      stroke = std::min(stroke, rest);
      depth = whole - depth - stroke <= tol::same_point ? whole : depth + stroke;
      last = stroke;
      depths.push_back(depth);
    }
    return {};
  }

  /// CYCLE84: rigid tapping.
  Status tap() {
    constexpr std::pair<double, double> sizes[] = {{3, 0.5},  {4, 0.7},  {5, 0.8},  {6, 1},    {8, 1.25}, {10, 1.5}, {12, 1.75},
                                                   {14, 2},   {16, 2},   {18, 2.5}, {20, 2.5}, {22, 2.5}, {24, 3},   {27, 3},
                                                   {30, 3.5}, {33, 3.5}, {36, 4},   {39, 4},   {42, 4.5}, {45, 4.5}, {48, 5}};
    double pitch = std::fabs(number(8));
    const double size = std::fabs(number(7));
    if (size != 0) {
      const auto row = std::find_if(std::begin(sizes), std::end(sizes), [&](const auto& each) { return each.first == size; });
      if (row == std::end(sizes) || (pitch != 0 && std::fabs(pitch - row->second) > 1e-9)) return fail(alarm(AlarmId::cycle_lead, where_));
      pitch = row->second;
    }
    if (!(pitch > 0)) return fail(alarm(AlarmId::cycle_lead, where_));
    if (number(15) != 0) return fail(alarm(AlarmId::not_available, where_, "CYCLE84 _VARI"));
    const double speed = number(10), back = number(11) > 0 ? number(11) : speed;
    if (!(speed > 0)) return fail(alarm(AlarmId::speed_missing, where_));
    rapid(level_);
    spindle(SpindleDir::position, number(9));
    feed(depth_, speed * pitch);
    KADR_TRY(dwell(number(5)));
    feed(level_, back * pitch);
    rapid(retract_);
    if (number(6) == 3) spindle(SpindleDir::cw);
    if (number(6) == 4) spindle(SpindleDir::ccw);
    if (number(6) == 5) spindle(SpindleDir::stop);
    return {};
  }

  /// CYCLE86: boring, with the spindle oriented before the tool is lifted off the wall.
  Status bore() {
    const auto dir = direction(6);
    if (!dir) return fail(dir.error());
    rapid(level_);
    if (m_.modal.spindle != *dir) spindle(*dir);
    feed(depth_);
    KADR_TRY(dwell(number(5)));
    spindle(SpindleDir::position, number(10));
    const std::size_t first = m_.modal.axes.first, second = m_.modal.axes.second;
    CycleStep lift;
    lift.named = AxisMask{1} << first | AxisMask{1} << second | AxisMask{1} << axis_;
    lift.to[first] = at_[first] + number(7);
    lift.to[second] = at_[second] + number(8);
    lift.to[axis_] = depth_ + number(9);
    steps.push_back(lift);
    rapid(level_);
    CycleStep home = lift;
    home.to[first] = at_[first];
    home.to[second] = at_[second];
    home.to[axis_] = retract_;
    steps.push_back(home);
    return {};
  }

  // ---- patterns

  Status pattern(const std::string& name) {
    const PlaneAxes plane = m_.modal.axes;
    std::vector<Vec2> holes;
    constexpr double most = 10'000;
    if (name == "HOLES1") {
      const double count = std::round(number(5));
      if (!(count >= 1)) return fail(alarm(AlarmId::pattern_empty, where_));
      if (count > most) return fail(alarm(AlarmId::value_out_of_range, where_, "NUM", count));
      const SinCos turn = sincos_deg(number(2));
      for (double i = 0; i < count; ++i) {
        const double way = number(3) + i * number(4);
        holes.push_back({number(0) + way * turn.cos, number(1) + way * turn.sin});
      }
      const Vec2 tool{at_[plane.first], at_[plane.second]};
      if (length(holes.back() - tool) < length(holes.front() - tool)) std::reverse(holes.begin(), holes.end());
    } else if (name == "HOLES2") {
      const double count = std::round(number(5));
      if (!(count >= 1)) return fail(alarm(AlarmId::pattern_empty, where_));
      if (count > most) return fail(alarm(AlarmId::value_out_of_range, where_, "NUM", count));
      const double step = number(4) != 0 ? number(4) : 360 / count;
      for (double i = 0; i < count; ++i) {
        const SinCos turn = sincos_deg(number(3) + i * step);
        holes.push_back({number(0) + number(2) * turn.cos, number(1) + number(2) * turn.sin});
      }
    } else {
      KADR_TRY(grid(holes));
    }
    const Sinumerik& own = sinumerik_of(m_);
    const auto& modal = own.memory.levels.back().modal_call;
    for (const Vec2 hole : holes) {
      in_plane(hole.x, hole.y);
      at_[plane.first] = hole.x;
      at_[plane.second] = hole.y;
      if (!modal) continue;
      if (!Sinumerik::is_cycle(modal->name)) return fail(alarm(AlarmId::not_available, where_, std::string_view("MCALL " + modal->name)));
      KADR_TRY(drill(modal->name, modal->arguments));
    }
    return {};
  }

  /// CYCLE801: a grid, row by row, there and back.
  Status grid(std::vector<Vec2>& holes) const {
    const double columns = std::round(number(5)), rows = std::round(number(6));
    if (!(columns >= 1) || !(rows >= 1)) return fail(alarm(AlarmId::pattern_empty, where_));
    if (columns * rows > 10'000) return fail(alarm(AlarmId::value_out_of_range, where_, "NUM", columns * rows));
    if (number(7) != 0) return fail(alarm(AlarmId::not_available, where_, "CYCLE801 _VARI"));
    const SinCos turn = sincos_deg(number(2));
    for (double r = 0; r < rows; ++r)
      for (double c = 0; c < columns; ++c) {
        const double x = (std::fmod(r, 2) == 0 ? c : columns - 1 - c) * number(3), y = r * number(4);
        holes.push_back({number(0) + x * turn.cos - y * turn.sin, number(1) + x * turn.sin + y * turn.cos});
      }
    return {};
  }

  Interpreter& m_;
  std::vector<Value> arguments_;
  Span where_;
  std::size_t axis_;
  Axes at_;
  double retract_ = 0, reference_ = 0, level_ = 0, depth_ = 0, down_ = -1;
};

}  // namespace

Status Sinumerik::start_cycle(Interpreter& m, const std::string& name, const std::vector<Value>& arguments, Span where) {
  if (name != "HOLES1" && name != "HOLES2" && m.modal.radius_side != 0)
    return fail(alarm(AlarmId::compensation_active, where, std::string_view(name)));
  for (const Value& each : arguments)
    if (!each.is_number() && (name.starts_with("CYCLE8") || name.starts_with("HOLES")))
      return fail(alarm(AlarmId::operand_type, where, std::string_view(name)));
  CycleMaker maker(m, arguments, where);
  KADR_TRY(maker.run(name));
  m.running = std::make_unique<CycleSteps>(std::move(maker.steps));
  return {};
}

}  // namespace kadr::sinumerik
