// Drilling cycles and patterns of holes (spec/sinumerik 14). A cycle is worked out as a list of steps when it is called, and executed a few
// steps at a time. Used by control/sinumerik.

#include <algorithm>
#include <cmath>

#include "base/ascii.h"
#include "base/tolerance.h"
#include "control/sinumerik/cycle_steps.h"

namespace kadr::sinumerik {
namespace {

/// Works out the steps of one call.
class CycleMaker {
 public:
  CycleMaker(Interpreter& m, const std::vector<Value>& arguments, Span where)
      : m_(m), arguments_(arguments), where_(where), axis_(m.modal.axes.normal), at_(m.position.programmed) {}

  std::vector<CycleStep> steps;

  Status run(const std::string& name) {
    if (name == "HOLES1" || name == "HOLES2" || name == "CYCLE801" || name == "CYCLE802") return pattern(name);
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
    if (name == "CYCLE840") {
      KADR_TRY(levels());
      return tap_in_chuck();
    }
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

  /// CYCLE840: tapping with a compensating chuck. Without an encoder (ENC 1) and without a pitch the feed is F (spec/sinumerik 14.2).
  Status tap_in_chuck() {
    const auto pitch = pitch_of(std::fabs(number(9)), std::fabs(number(10)));
    const bool plain = number(8) == 1;
    if (!pitch || (*pitch == 0 && !plain)) return fail(alarm(AlarmId::cycle_lead, where_));
    const SpindleDir turning = m_.modal.spindle;
    if (turning != SpindleDir::cw && turning != SpindleDir::ccw) return fail(alarm(AlarmId::cycle_direction, where_, 0.0));
    if (!(m_.modal.rpm > 0)) return fail(alarm(AlarmId::speed_missing, where_));
    const double value = m_.modal.rpm * *pitch;
    if (value == 0) KADR_TRY(m_.feed_known(where_));
    SpindleDir back = turning == SpindleDir::cw ? SpindleDir::ccw : SpindleDir::cw;
    if (number(6) != 0) {
      const auto stated = direction(6);
      if (!stated) return fail(stated.error());
      back = *stated;
    }
    rapid(level_);
    feed(depth_, value);
    if (plain) KADR_TRY(dwell(number(5)));
    spindle(back);
    feed(level_, value);
    rapid(retract_);
    if (number(7) == 3) spindle(SpindleDir::cw);
    if (number(7) == 4) spindle(SpindleDir::ccw);
    if (number(7) == 5) spindle(SpindleDir::stop);
    return {};
  }

  /// CYCLE84: rigid tapping.
  Status tap() {
    const auto found = pitch_of(std::fabs(number(7)), std::fabs(number(8)));
    if (!found || !(*found > 0)) return fail(alarm(AlarmId::cycle_lead, where_));
    const double pitch = *found;
    const double kind = number(15), stroke = number(16), back_by = number(17) > 0 ? number(17) : 1;
    if (kind != 0 && kind != 1 && kind != 2) return fail(alarm(AlarmId::not_available, where_, "CYCLE84 _VARI"));
    if (kind != 0 && !(stroke > 0)) return fail(alarm(AlarmId::value_out_of_range, where_, "_DAM", stroke));
    const double whole = std::fabs(reference_ - depth_);
    if (kind != 0 && whole / stroke > 10'000) return fail(alarm(AlarmId::cycle_endless, where_));
    const double speed = number(10), back = number(11) > 0 ? number(11) : speed;
    if (!(speed > 0)) return fail(alarm(AlarmId::speed_missing, where_));
    rapid(level_);
    spindle(SpindleDir::position, number(9));
    for (double depth = stroke; kind != 0 && depth < whole - tol::same_point; depth += stroke) {  // 1 chip breaking, 2 swarf removal
      feed(reference_ + down_ * depth, speed * pitch);
      feed(kind == 1 ? reference_ + down_ * (depth - back_by) : level_, back * pitch);
    }
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

  Status positions(const std::string& name, std::vector<Vec2>& holes) const {
    const PlaneAxes plane = m_.modal.axes;
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
    } else if (name == "CYCLE802") {
      return single_positions(holes);
    } else {
      return grid(holes);
    }
    return {};
  }

  /// CYCLE802: up to nine positions. INFERRED: the digits of _XA and _YA are 1 for an absolute position; other digits are refused.
  Status single_positions(std::vector<Vec2>& holes) const {
    for (std::size_t i = 0; i < 9 && given(2 + 2 * i) && given(3 + 2 * i); ++i) holes.push_back({number(2 + 2 * i), number(3 + 2 * i)});
    if (holes.empty()) return fail(alarm(AlarmId::pattern_empty, where_));
    for (const std::size_t mode : {std::size_t{0}, std::size_t{1}}) {
      const std::string digits = std::to_string(std::llround(number(mode)));
      if (given(mode) && digits.find_first_not_of('1') != std::string::npos)
        return fail(alarm(AlarmId::not_available, where_, "CYCLE802 _XA, _YA"));
    }
    return {};
  }

  Status pattern(const std::string& name) {
    const PlaneAxes plane = m_.modal.axes;
    std::vector<Vec2> holes;
    KADR_TRY(positions(name, holes));
    Sinumerik& own = sinumerik_of(m_);
    const auto& modal = own.memory.levels.back().modal_call;
    if (modal && (!Sinumerik::is_cycle(modal->name) || own.find_program(m_, modal->name))) {
      own.memory.pattern = Pattern{holes, 0, m_.program().depth()};  // finish() calls the program at each position
      return {};
    }
    for (const Vec2 hole : holes) {
      in_plane(hole.x, hole.y);
      at_[plane.first] = hole.x;
      at_[plane.second] = hole.y;
      if (!modal) continue;
      KADR_TRY(drill(modal->name, modal->arguments));
    }
    return {};
  }

  /// CYCLE801: a grid, row by row, there and back.
  Status grid(std::vector<Vec2>& holes) const {
    const double columns = std::round(number(5)), rows = std::round(number(6));
    if (!(columns >= 1) || !(rows >= 1)) return fail(alarm(AlarmId::pattern_empty, where_));
    if (columns * rows > 10'000) return fail(alarm(AlarmId::value_out_of_range, where_, "NUM", columns * rows));
    if (number(7) != 0 && number(7) != 1) return fail(alarm(AlarmId::not_available, where_, "CYCLE801 _VARI"));
    if (number(9) != 0 || number(10) != 0) return fail(alarm(AlarmId::not_available, where_, "CYCLE801 _ANG1, _ANG2"));
    const bool frame = number(7) == 1;
    const SinCos turn = sincos_deg(number(2));
    for (double r = 0; r < rows; ++r)
      for (double c = 0; c < columns; ++c) {
        const double column = std::fmod(r, 2) == 0 ? c : columns - 1 - c;
        if (frame && r > 0 && r < rows - 1 && column > 0 && column < columns - 1) continue;
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
