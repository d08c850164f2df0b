// Canned cycles G73, G74, G81 to G89 (spec/linuxcnc 7.6; convert_cycle, convert_cycle_xy, CYCLE_MACRO of the source).

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/units.h"
#include "base/vec.h"
#include "control/functions/functions.h"
#include "control/interpreter.h"
#include "control/linuxcnc/linuxcnc.h"

namespace kadr::linuxcnc {
namespace {

constexpr double above_bottom = 0.254;  // mm; G83, G73
constexpr double same_level = 1e-9;
constexpr double most_pecks = 1e6;
constexpr double most_repeats = 1e8;

struct Hole {
  std::int32_t code = 810;
  std::size_t first = 0, second = 1, drill = 2;  // axes
  double at_first = 0, at_second = 0;
  double step_first = 0, step_second = 0;  // G91, from repetition to repetition
  double level = 0, bottom = 0, clear = 0, present = 0;
  double peck = 0, dwell = 0, i = 0, j = 0, back = 0;
  std::uint32_t repeats = 1;
  bool up_first = false;  // from below R
  bool polar = false;     // G91 with @ ^: each repetition turns on
  double polar_radius = 0, polar_angle = 0;
  AlarmId fault = AlarmId::count;  // what the control finds at the hole only, when the approach has been made
  bool fault_above = false;        // … when it has risen to R, if it has to
  const char* fault_text = "";
  Span where;
  SpindleDir spindle = SpindleDir::stop;
  Plane plane = Plane::xy;
};

/// Goes on a few actions at a time.
class Drilling final : public RunningValue<Drilling> {
 public:
  explicit Drilling(const Hole& hole) : h_(hole), depth_(hole.level) {}

  Result<bool> next(Interpreter& m) override {
    for (std::size_t i = 0; i < batch_size / 8; ++i) {
      if (done_ == h_.repeats) return false;
      KADR_TRY(go_on(m));
    }
    return done_ < h_.repeats;
  }

 private:
  Status go_on(Interpreter& m) {
    if (!in_hole_) return approach(m);
    const bool pecks = h_.code == 830 || h_.code == 730;
    if (pecks && depth_ - h_.peck > h_.bottom + same_level) return peck(m);
    KADR_TRY(finish(m));
    in_hole_ = false;
    ++done_;
    return {};
  }

  Status approach(Interpreter& m) {
    in_hole_ = true;
    depth_ = h_.level;
    if (done_ == 0 && h_.up_first) KADR_TRY(drill(m, MotionKind::rapid, h_.level));
    if (h_.fault_above) return linuxcnc_of(m).fault(h_.fault, h_.where, h_.fault_text);
    if (h_.polar) {
      const Vec2 here{m.position.programmed[0], m.position.programmed[1]};
      const double radius = length(here) + h_.polar_radius;
      const SinCos by = sincos_deg(angle_deg(here) + h_.polar_angle);
      h_.at_first = radius * by.cos;
      h_.at_second = radius * by.sin;
    }
    h_.at_first += h_.step_first;
    h_.at_second += h_.step_second;
    const double here = m.position.programmed[h_.drill];
    if (done_ == 0 && here > h_.level + same_level) {
      KADR_TRY(place(m, h_.at_first, h_.at_second, here));
    } else {
      KADR_TRY(place(m, h_.at_first, h_.at_second, h_.clear));
    }
    KADR_TRY(drill(m, MotionKind::rapid, h_.level));
    if (h_.fault != AlarmId::count) return linuxcnc_of(m).fault(h_.fault, h_.where, h_.fault_text);
    return {};
  }

  Status peck(Interpreter& m) {
    depth_ -= h_.peck;
    KADR_TRY(drill(m, MotionKind::feed, depth_));
    if (h_.code == 830) KADR_TRY(drill(m, MotionKind::rapid, h_.level));
    return drill(m, MotionKind::rapid, depth_ + above_bottom);
  }

  Status finish(Interpreter& m) {
    switch (h_.code) {
      case 740: return tap(m);
      case 840: return tap(m);
      case 850:
        KADR_TRY(drill(m, MotionKind::feed, h_.bottom));
        KADR_TRY(drill(m, MotionKind::feed, h_.level));
        return drill(m, MotionKind::rapid, h_.clear);
      case 860:
        KADR_TRY(drill(m, MotionKind::feed, h_.bottom));
        dwell(m);
        spindle(m, SpindleDir::stop);
        KADR_TRY(drill(m, MotionKind::rapid, h_.clear));
        spindle(m, h_.spindle);
        return {};
      case 870: return back_bore(m);
      case 880:
        KADR_TRY(drill(m, MotionKind::feed, h_.bottom));
        dwell(m);
        spindle(m, SpindleDir::stop);
        m.emit(Stop{false});
        spindle(m, h_.spindle);
        m.position.programmed[h_.drill] = h_.clear;  // the control takes it so: the operator has brought the tool out
        m.place_plainly(AxisMask{1} << h_.drill);
        return {};
      case 890:
        KADR_TRY(drill(m, MotionKind::feed, h_.bottom));
        dwell(m);
        return drill(m, MotionKind::feed, h_.clear);
      default:
        KADR_TRY(drill(m, MotionKind::feed, h_.bottom));
        if (h_.code == 820) dwell(m);
        return drill(m, MotionKind::rapid, h_.clear);
    }
  }

  /// Fault of the control: in G18, G19 both strokes go to turned axes; so does Kadr, and a warning has told.
  Status tap(Interpreter& m) {
    const SpindleDir in = h_.code == 840 ? SpindleDir::cw : SpindleDir::ccw;
    KADR_TRY(stroke(m, h_.bottom));
    spindle(m, SpindleDir::stop);
    spindle(m, in == SpindleDir::cw ? SpindleDir::ccw : SpindleDir::cw);
    dwell(m);
    KADR_TRY(stroke(m, h_.clear));
    spindle(m, SpindleDir::stop);
    spindle(m, in);
    if (h_.plane != Plane::xy) stand(m);
    return {};
  }

  /// The strokes have gone to turned axes; the control takes the tool for where they should have left it.
  void stand(Interpreter& m) const {
    Axes to = m.position.programmed;
    to[h_.first] = h_.at_first;
    to[h_.second] = h_.at_second;
    to[h_.drill] = h_.clear;
    m.move_to(to, to, 7);
  }

  Status stroke(Interpreter& m, double level) {
    if (h_.plane == Plane::xy) return drill(m, MotionKind::feed, level);
    Axes to = m.position.programmed;
    const double x = h_.plane == Plane::zx ? h_.at_second : 0, z = h_.plane == Plane::zx ? h_.at_first : h_.at_second;
    if (h_.plane == Plane::zx) to[0] = level, to[1] = z, to[2] = x;
    else to[0] = z, to[1] = level, to[2] = h_.at_first;
    return m.straight(MotionKind::feed, to, 7);
  }

  Status back_bore(Interpreter& m) {
    KADR_TRY(place(m, h_.at_first + h_.i, h_.at_second + h_.j, h_.level));
    spindle(m, SpindleDir::stop);
    spindle(m, SpindleDir::orient);
    KADR_TRY(drill(m, MotionKind::rapid, h_.bottom));
    KADR_TRY(place(m, h_.at_first, h_.at_second, h_.bottom));
    spindle(m, h_.spindle);
    KADR_TRY(drill(m, MotionKind::feed, h_.back));
    KADR_TRY(drill(m, MotionKind::feed, h_.bottom));
    spindle(m, SpindleDir::stop);
    spindle(m, SpindleDir::orient);
    KADR_TRY(place(m, h_.at_first + h_.i, h_.at_second + h_.j, h_.bottom));
    KADR_TRY(drill(m, MotionKind::rapid, h_.clear));
    KADR_TRY(place(m, h_.at_first, h_.at_second, h_.clear));
    spindle(m, h_.spindle);
    return {};
  }

  Status drill(Interpreter& m, MotionKind kind, double level) {
    Axes to = m.position.programmed;
    if (std::fabs(to[h_.drill] - level) <= same_level) return {};
    to[h_.drill] = level;
    return m.straight(kind, to, AxisMask{1} << h_.drill);
  }

  Status place(Interpreter& m, double first, double second, double level) {
    Axes to = m.position.programmed;
    to[h_.first] = first;
    to[h_.second] = second;
    to[h_.drill] = level;
    return m.straight(MotionKind::rapid, to, 7);
  }

  void dwell(Interpreter& m) const {
    m.emit(Dwell{h_.dwell});  // of no time too, as the control does
  }
  static void spindle(Interpreter& m, SpindleDir dir) {
    const bool turns = dir == SpindleDir::cw || dir == SpindleDir::ccw;
    Spindle spindle{dir, turns ? m.modal.rpm : 0};
    if (dir == SpindleDir::orient) spindle.angle = 0;
    m.emit(spindle);
  }

  Hole h_;
  std::uint32_t done_ = 0;
  bool in_hole_ = false;
  double depth_;
};

/// G17.1, G18.1, G19.1: the machine that is assumed has no axes U, V, W.
bool other_plane(const Interpreter& m) {
  return std::any_of(m.modal.rows.begin(), m.modal.rows.end(), [&](std::int16_t row) {
    if (row < 0) return false;
    const CodeRow& code = m.def.codes[static_cast<std::size_t>(row)];
    return code.letter == 'G' && (code.tenth == 171 || code.tenth == 181 || code.tenth == 191);
  });
}

/// Words → levels, checked in the order of the source.
class Reader {
 public:
  Reader(Interpreter& m, const kadr::Call& call) : m_(m), call_(call), control_(linuxcnc_of(m)) {}

  Status run() {
    hole_.code = call_.row->tenth;
    hole_.plane = m_.modal.plane;
    hole_.first = m_.modal.axes.first;
    hole_.second = m_.modal.axes.second;
    hole_.drill = m_.modal.axes.normal;
    const bool same = control_.codes.g1() < 0 || control_.state.motion == hole_.code;
    const bool follows = control_.state.cycle_began;
    KADR_TRY(allowed(same));
    remember();
    levels(follows);
    const double least = std::min(hole_.bottom, hole_.level);
    if (!(std::fabs(least) <= farthest && std::fabs(hole_.level) <= farthest))
      return fail(alarm(AlarmId::position_out_of_range, call_.where, m_.letters.axis_letter[hole_.drill], least));
    if (hole_.level < hole_.bottom) return wrong(fmt::format("R less than {} in cycle in {} plane", drill_letter(), plane_name()));
    KADR_TRY(of_code(same));
    spindle_turns();
    KADR_TRY(holes());
    tell_turned();
    control_.state.cycle_began = true;
    m_.modal.motion = MotionMode::cycle;
    m_.modal.motion_row = static_cast<std::int16_t>(call_.row - m_.def.codes.data());
    m_.cycle_memory.row = m_.modal.motion_row;
    m_.running = std::make_unique<Drilling>(hole_);
    return {};
  }

 private:
  tl::unexpected<Alarm> wrong(std::string text) const { return control_.fault(AlarmId::rs274_cycle, call_.where, std::move(text)); }
  char drill_letter() const { return static_cast<char>(m_.letters.axis_letter[hole_.drill] | 0x20); }
  const char* plane_name() const { return hole_.plane == Plane::xy ? "xy" : hole_.plane == Plane::yz ? "yz" : "xz"; }

  Status allowed(bool same) {
    const char drill = m_.letters.axis_letter[hole_.drill];
    if (other_plane(m_)) return fail(alarm(AlarmId::not_available, call_.where, "G17.1 G18.1 G19.1"));
    if (m_.modal.feed_mode == FeedMode::inverse_time) return wrong("Cannot use inverse time feed with canned cycles");
    if (!(m_.modal.feed_known && m_.modal.feed > 0)) return wrong("Cannot feed with zero feed rate");
    if (m_.modal.radius_side != 0)
      return control_.fault(AlarmId::rs274_compensation, call_.where, "Cannot use canned cycles with cutter compensation on");
    if (!same && !m_.has('R')) return wrong("R clearance plane unspecified in cycle");
    if (m_.has('L') && std::round(m_.value('L')) == 0) return wrong("Cannot do zero repeats of cycle");
    if (!same && !m_.has(drill)) return wrong(fmt::format("{} value unspecified in {} plane canned cycle", drill, plane_name()));
    return {};
  }

  /// What a single cycle finds out at its hole.
  void at_hole(AlarmId id, const char* text) {
    if (hole_.fault != AlarmId::count) return;
    hole_.fault = id;
    hole_.fault_text = text;
    hole_.where = call_.where;
  }

  void spindle_turns() {
    const SpindleDir dir = m_.modal.spindle;
    const bool turns = dir == SpindleDir::cw || dir == SpindleDir::ccw;
    const auto spindle = [&](const char* text) { at_hole(AlarmId::rs274_spindle, text); };
    if (hole_.code == 840 && !turns) spindle("Spindle not turning in G84");
    if (hole_.code == 840 && dir == SpindleDir::ccw) spindle("Spindle turning counterclockwise in G84");
    if (hole_.code == 740 && !turns) spindle("Spindle not turning in G74");
    if (hole_.code == 740 && dir == SpindleDir::cw) spindle("Spindle turning clockwise in G74");
    if (hole_.code == 860 && !turns) spindle("Spindle not turning in g86");
    if (hole_.code == 870 && !turns) spindle("Spindle not turning in g87");
    if (hole_.code == 880 && !turns) spindle("Spindle not turning in g88");
  }

  void remember() {
    CycleMemory& memory = m_.cycle_memory;
    if (m_.has(m_.letters.axis_letter[hole_.drill])) memory.bottom = m_.length_value(m_.letters.axis_letter[hole_.drill]);
    if (m_.has('R')) memory.level = m_.length_value('R');
    if (m_.has('P')) memory.dwell = m_.value('P');
    if (m_.has('Q')) memory.peck = m_.length_value('Q');
    if (m_.has('I')) memory.i = m_.length_value('I');
    if (m_.has('J')) memory.j = m_.length_value('J');
    if (m_.has('K')) memory.k = m_.length_value('K');
  }

  void levels(bool follows) {
    const CycleMemory& memory = m_.cycle_memory;
    const double here = m_.position.programmed[hole_.drill];
    if (!follows) control_.state.old_z = here;
    double old_z = control_.state.old_z;
    hole_.level = m_.modal.absolute ? memory.level : old_z + memory.level;
    hole_.bottom = m_.modal.absolute ? memory.bottom : hole_.level + memory.bottom;
    hole_.up_first = old_z < hole_.level - same_level;
    if (hole_.up_first) old_z = hole_.level;
    hole_.clear = m_.modal.retract_initial ? old_z : hole_.level;
    hole_.peck = memory.peck;
    hole_.dwell = memory.dwell;
    hole_.i = memory.i;
    hole_.j = memory.j;
    hole_.back = m_.modal.absolute ? memory.k : hole_.bottom + memory.k;
    hole_.spindle = m_.modal.spindle;
  }

  /// Words that a code needs, given or sticky; found out when the tool has risen to R. P and Q of -1 are as missing (2.2).
  Status of_code(bool same) {
    const auto wants = [&](char letter, const char* text) {
      const bool there = m_.has(letter) && !((letter == 'P' || letter == 'Q') && m_.value(letter) == -1);
      if (same || there || hole_.fault_above) return;
      at_hole(AlarmId::rs274_cycle, text);
      hole_.fault_above = true;
    };
    if (hole_.code == 830 || hole_.code == 730) {
      wants('Q', hole_.code == 830 ? "Q word missing with g83" : "Q word missing with g73");
      if (!(hole_.peck > 0)) at_hole(AlarmId::rs274_cycle, "Negative or zero q value used");
      else if ((hole_.level - hole_.bottom) / hole_.peck > most_pecks) return fail(alarm(AlarmId::cycle_peck, m_.where('Q'), hole_.peck));
    }
    if (hole_.code == 820) wants('P', "Dwell time p word missing with g82");
    if (hole_.code == 860) wants('P', "Dwell time p word missing with g86");
    if (hole_.code == 880) wants('P', "Dwell time p word missing with g88");
    if (hole_.code == 890) wants('P', "Dwell time p word missing with g89");
    if (hole_.code != 870) return {};
    wants('I', "I word missing with g87");
    wants('J', "J word missing with g87");
    wants('K', "K word missing with g87");
    return {};
  }

  Status holes() {
    AxisMask named = 0;
    Axes to;
    KADR_TRY(m_.target(to, named));
    hole_.at_first = to[hole_.first];
    hole_.at_second = to[hole_.second];
    if (!m_.modal.absolute) {  // each repetition steps on, the first one too
      hole_.step_first = to[hole_.first] - m_.position.programmed[hole_.first];
      hole_.step_second = to[hole_.second] - m_.position.programmed[hole_.second];
      hole_.at_first = m_.position.programmed[hole_.first];
      hole_.at_second = m_.position.programmed[hole_.second];
    }
    if (control_.state.polar_step) {
      hole_.polar = true;
      hole_.polar_radius = control_.state.polar_radius;
      hole_.polar_angle = control_.state.polar_angle;
      hole_.step_first = hole_.step_second = 0;
    }
    if (!m_.has('L')) return {};
    const double repeats = std::round(m_.value('L'));
    if (repeats > most_repeats) return fail(alarm(AlarmId::cycle_repeats, m_.where('L'), repeats));
    hole_.repeats = static_cast<std::uint32_t>(repeats);
    for (const double last : {hole_.at_first + repeats * hole_.step_first, hole_.at_second + repeats * hole_.step_second})
      if (!(std::fabs(last) <= farthest)) return fail(alarm(AlarmId::position_out_of_range, call_.where, "X", last));
    return {};
  }

  void tell_turned() const {
    if ((hole_.code == 840 || hole_.code == 740) && hole_.plane != Plane::xy)
      m_.warn(warning(AlarmId::tapping_axes_turned, call_.where, call_.row->code));
  }

  Interpreter& m_;
  const kadr::Call& call_;
  LinuxCnc& control_;
  Hole hole_;
};

}  // namespace

Status canned_cycle(Interpreter& m, const kadr::Call& call) { return Reader(m, call).run(); }

}  // namespace kadr::linuxcnc

namespace kadr::functions {

Status canned_cycle(Interpreter& m, const Call& call) { return linuxcnc::canned_cycle(m, call); }

}  // namespace kadr::functions
