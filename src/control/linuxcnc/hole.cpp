// Executes the motions of canned cycles (spec/linuxcnc 7.6; convert_cycle_g81 … convert_cycle_g89, CYCLE_MACRO of LinuxCNC's source).

#include "control/linuxcnc/hole.h"

#include <cmath>

#include "base/code_literals.h"
#include "base/vec.h"
#include "control/cycles/hole_work.h"
#include "control/linuxcnc/linuxcnc.h"

namespace kadr::linuxcnc {
namespace {

// Distance in mm from the last depth at which the rapid down ends (G83), and length of the retract (G73).
constexpr double above_bottom = 0.254;
constexpr double same_height = 1e-9;

/// Executes a canned cycle, a few actions at a time.
class Drilling final : public SteppedCycleValue<Drilling> {
 public:
  explicit Drilling(const Hole& hole) : h_(hole), depth_(hole.level) {}

  Result<bool> next(Emitter& m) override {
    for (std::size_t i = 0; i < batch_size / 8; ++i) {
      if (done_ == h_.repeats) return false;
      KADR_TRY(emit_of_cycle(*m.batch, [&] { return go_on(m); }));
      // the caller of run() needs the state after each drilled hole, so only one drilled hole is executed in this call
      if (m.each_block) break;
    }
    return done_ < h_.repeats;
  }

  bool repeats(const BlockContext& m) const override {
    const bool taps = h_.code == 84_g || h_.code == 74_g;
    const bool warns = taps && h_.plane != Plane::xy;  // each block with such a cycle has its warning
    return h_.fault == no_alarm && h_.repeats == 1 && !h_.polar && m.modal.absolute && !warns;
  }
  void repeat_at(const Axes& to) override {
    h_.at_first = to[h_.first];
    h_.at_second = to[h_.second];
    done_ = 0;
    in_hole_ = false;
  }

 private:
  Status go_on(Emitter& m) {
    if (!in_hole_) return approach(m);
    const bool pecks = h_.code == 83_g || h_.code == 73_g;
    if (pecks && depth_ - h_.peck > h_.bottom + same_height) return peck(m);
    KADR_TRY(end_hole(m));
    in_hole_ = false;
    ++done_;
    return {};
  }

  Status approach(Emitter& m) {
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
    if (done_ == 0 && here > h_.level + same_height) {
      KADR_TRY(place(m, h_.at_first, h_.at_second, here));
    } else {
      KADR_TRY(place(m, h_.at_first, h_.at_second, h_.clear));
    }
    KADR_TRY(drill(m, MotionKind::rapid, h_.level));
    if (h_.fault != no_alarm) return linuxcnc_of(m).fault(h_.fault, h_.where, h_.fault_text);
    return {};
  }

  Status peck(Emitter& m) {
    depth_ -= h_.peck;
    KADR_TRY(drill(m, MotionKind::feed, depth_));
    if (h_.code == 83_g) KADR_TRY(drill(m, MotionKind::rapid, h_.level));
    return drill(m, MotionKind::rapid, depth_ + above_bottom);
  }

  Status end_hole(Emitter& m) {
    switch (h_.code) {
      case 74_g: return tap(m);
      case 84_g: return tap(m);
      case 85_g:
        KADR_TRY(drill(m, MotionKind::feed, h_.bottom));
        KADR_TRY(drill(m, MotionKind::feed, h_.level));
        return drill(m, MotionKind::rapid, h_.clear);
      case 86_g:
        KADR_TRY(drill(m, MotionKind::feed, h_.bottom));
        dwell(m);
        turn_spindle(m, SpindleDir::stop);
        KADR_TRY(drill(m, MotionKind::rapid, h_.clear));
        turn_spindle(m, h_.spindle);
        return {};
      case 87_g: return back_bore(m);
      case 88_g:
        KADR_TRY(drill(m, MotionKind::feed, h_.bottom));
        dwell(m);
        turn_spindle(m, SpindleDir::stop);
        m.emit(Stop{false});
        turn_spindle(m, h_.spindle);
        // In LinuxCNC the run waits here until the operator has withdrawn the tool by hand. Kadr continues from the retract level.
        m.position.programmed[h_.drill] = h_.clear;
        m.set_plain_position(AxisMask{1} << h_.drill);
        return {};
      case 89_g:
        KADR_TRY(drill(m, MotionKind::feed, h_.bottom));
        dwell(m);
        return drill(m, MotionKind::feed, h_.clear);
      default:
        KADR_TRY(drill(m, MotionKind::feed, h_.bottom));
        if (h_.code == 82_g) dwell(m);
        return drill(m, MotionKind::rapid, h_.clear);
    }
  }

  /// Taps: feeds in, reverses the spindle, and feeds out. In G18 and G19 LinuxCNC moves the wrong axes, which is a fault of LinuxCNC. Kadr
  /// moves the same wrong axes, after a warning.
  Status tap(Emitter& m) {
    const SpindleDir in = h_.code == 84_g ? SpindleDir::cw : SpindleDir::ccw;
    KADR_TRY(emit_in_hole(*m.batch, HoleWork::taps, [&] { return stroke(m, h_.bottom); }));
    turn_spindle(m, SpindleDir::stop);
    turn_spindle(m, in == SpindleDir::cw ? SpindleDir::ccw : SpindleDir::cw);
    dwell(m);
    KADR_TRY(emit_in_hole(*m.batch, HoleWork::taps, [&] { return stroke(m, h_.clear); }));
    turn_spindle(m, SpindleDir::stop);
    turn_spindle(m, in);
    if (h_.plane != Plane::xy) stand(m);
    return {};
  }

  /// Sets the position after tapping along the wrong axes. LinuxCNC assumes that the tool is where the cycle should have ended.
  void stand(Emitter& m) const {
    Axes to = m.position.programmed;
    to[h_.first] = h_.at_first;
    to[h_.second] = h_.at_second;
    to[h_.drill] = h_.clear;
    m.move_to(to, to, axes());
  }

  Status stroke(Emitter& m, double level) {
    if (h_.plane == Plane::xy) return drill(m, MotionKind::feed, level);
    Axes to = m.position.programmed;
    const double x = h_.plane == Plane::zx ? h_.at_second : 0, z = h_.plane == Plane::zx ? h_.at_first : h_.at_second;
    if (h_.plane == Plane::zx) to[0] = level, to[1] = z, to[2] = x;
    else to[0] = z, to[1] = level, to[2] = h_.at_first;
    return m.straight(MotionKind::feed, to, axes());
  }

  Status back_bore(Emitter& m) {
    KADR_TRY(place(m, h_.at_first + h_.i, h_.at_second + h_.j, h_.level));
    turn_spindle(m, SpindleDir::stop);
    turn_spindle(m, SpindleDir::orient);
    KADR_TRY(emit_in_hole(*m.batch, HoleWork::clear_of_wall, [&] { return enter(m); }));
    turn_spindle(m, h_.spindle);
    KADR_TRY(drill(m, MotionKind::feed, h_.back));
    KADR_TRY(drill(m, MotionKind::feed, h_.bottom));
    turn_spindle(m, SpindleDir::stop);
    turn_spindle(m, SpindleDir::orient);
    KADR_TRY(emit_in_hole(*m.batch, HoleWork::clear_of_wall, [&] { return leave(m); }));
    turn_spindle(m, h_.spindle);
    return {};
  }

  /// Back boring (G87): moves the oriented tool down at a distance from the hole's centre line, then to the centre line.
  Status enter(Emitter& m) {
    KADR_TRY(drill(m, MotionKind::rapid, h_.bottom));
    return place(m, h_.at_first, h_.at_second, h_.bottom);
  }

  Status leave(Emitter& m) {
    KADR_TRY(place(m, h_.at_first + h_.i, h_.at_second + h_.j, h_.bottom));
    KADR_TRY(drill(m, MotionKind::rapid, h_.clear));
    return place(m, h_.at_first, h_.at_second, h_.clear);
  }

  Status drill(Emitter& m, MotionKind kind, double level) {
    Axes to = m.position.programmed;
    if (std::fabs(to[h_.drill] - level) <= same_height) return {};
    to[h_.drill] = level;
    return m.straight(kind, to, AxisMask{1} << h_.drill);
  }

  Status place(Emitter& m, double first, double second, double level) {
    Axes to = m.position.programmed;
    to[h_.first] = first;
    to[h_.second] = second;
    to[h_.drill] = level;
    return m.straight(MotionKind::rapid, to, axes());
  }

  AxisMask axes() const { return AxisMask{1} << h_.first | AxisMask{1} << h_.second | AxisMask{1} << h_.drill; }

  void dwell(Emitter& m) const {
    m.emit(Dwell{h_.dwell});  // an action is emitted also for a dwell of 0 s, as in LinuxCNC
  }
  void turn_spindle(Emitter& m, SpindleDir dir) const {
    const bool turns = dir == SpindleDir::cw || dir == SpindleDir::ccw;
    Spindle spindle{dir, turns ? h_.rpm : 0, static_cast<std::uint8_t>(h_.spindle_number + 1)};
    if (dir == SpindleDir::orient) spindle.angle = 0;
    m.emit(spindle);
  }

  Hole h_;
  std::uint32_t done_ = 0;
  bool in_hole_ = false;
  double depth_;
};

}  // namespace

void begin_drilling(Emitter& m, const Hole& hole) { m.start_cycle<Drilling>(hole); }

}  // namespace kadr::linuxcnc
