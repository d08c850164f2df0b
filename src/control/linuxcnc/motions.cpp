// Arcs, threads, probing (spec/linuxcnc 7.2, 7.3, 7.7; convert_arc, convert_probe, convert_straight of LinuxCNC's source).

#include "control/linuxcnc/motions.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/units.h"
#include "control/emitter.h"
#include "control/functions/arc_motion.h"
#include "control/functions/functions.h"
#include "control/functions/probe_unstated.h"
#include "control/linuxcnc/linuxcnc.h"
#include "control/linuxcnc/spindles.h"

namespace kadr::linuxcnc {
namespace {

constexpr double least_radius = 0.00127;       // mm
constexpr double spiral_absolute = 0.0282843;  // greatest allowed difference of the radii at start and end of an arc, mm: 2 · 0.01 · √2
constexpr double spiral_relative = 0.001;

class Arc {
 public:
  Arc(Emitter& m, const kadr::Call& call, Turn turn) : m_(m), call_(call), turn_(turn), control_(linuxcnc_of(m)), axes_(m.modal.axes) {}

  Status run() {
    const char centers[] = {m_.letters.center_letter[axes_.first], m_.letters.center_letter[axes_.second]};
    const char normal = m_.letters.center_letter[axes_.normal];
    const bool any_center = m_.has('I') || m_.has('J') || m_.has('K');
    if (control_.state.arc_not_allowed)
      return control_.fault(AlarmId::rs274_compensation, call_.where,
                            "The move just after exiting cutter compensation mode must be straight, not an arc");
    if (!any_center && !m_.has('R')) return wrong("R i j k words all missing for arc");
    if (any_center && m_.has('R')) return wrong("Mixed radius ijk format for arc");
    KADR_TRY(feed());
    AxisMask named = 0;
    Axes end;
    KADR_TRY(m_.target(end, named));
    const Vec2 from{m_.position.programmed[axes_.first], m_.position.programmed[axes_.second]};
    const Vec2 to{end[axes_.first], end[axes_.second]};
    if (m_.has('R')) {
      const bool in_plane = m_.has(letter(axes_.first)) || m_.has(letter(axes_.second));
      if (!in_plane) return wrong(missing_words());
      return by_radius(from, to, end, named);
    }
    if (m_.has(normal)) return wrong(fmt::format("{} word given for arc in {} plane", normal, plane_name()));
    Vec2 center = from;
    for (const int i : {0, 1}) {
      double& at = i == 0 ? center.x : center.y;
      if (m_.has(centers[i])) at = (m_.modal.centers_absolute ? 0.0 : at) + m_.length_value(centers[i]);
      else if (m_.modal.centers_absolute) return wrong(fmt::format("{} word missing in absolute center arc", centers[i]));
    }
    return about(from, to, center, end, named);
  }

  /// Moves along an arc whose end point and centre a canned cycle has computed.
  Status through(const Axes& end, Vec2 center, AxisMask named) {
    KADR_TRY(feed());
    return about({m_.position.programmed[axes_.first], m_.position.programmed[axes_.second]}, {end[axes_.first], end[axes_.second]}, center,
                 end, named);
  }

 private:
  tl::unexpected<Alarm> wrong(std::string text) const { return control_.fault(AlarmId::rs274_arc, call_.where, std::move(text)); }
  char letter(std::size_t axis) const { return m_.letters.axis_letter[axis]; }
  const char* plane_name() const { return m_.modal.plane == Plane::xy ? "xy" : m_.modal.plane == Plane::yz ? "yz" : "xz"; }
  std::string missing_words() const {
    switch (m_.modal.plane) {
      case Plane::xy: return "X and y words missing for arc in xy plane";
      case Plane::yz: return "Y and z words missing for arc in yz plane";
      default: return "X and z words missing for arc in xz plane";
    }
  }

  Status feed() const {
    if (m_.modal.feed_mode == FeedMode::inverse_time)
      return m_.has('F') ? Status() : Status(wrong("F word missing with inverse time arc move"));
    if (!(m_.modal.feed_known && m_.modal.feed > 0)) return wrong("Cannot make arc with zero feed rate");
    return {};
  }

  bool enters() const { return m_.modal.contour == CompensationPhase::on && m_.radius_in_force() != 0; }

  /// Checks an arc that starts cutter compensation before the arc is emitted (convert_arc_comp1). The room path checks the arc again.
  Status may_enter(Vec2 from, Vec2 to) const {
    if (!enters() || std::hypot(to.x - from.x, to.y - from.y) > m_.radius_in_force()) return {};
    return fail(alarm(AlarmId::entry_arc_within_tool, call_.where));
  }

  Status by_radius(Vec2 from, Vec2 to, const Axes& end, AxisMask named) {
    const double radius = m_.length_value('R');
    KADR_TRY(may_enter(from, to));
    if (enters() && std::fabs(radius) <= m_.radius_in_force() && (m_.modal.radius_side < 0) == (turn_ == Turn::ccw))
      return fail(alarm(AlarmId::arc_within_tool, call_.where));
    const auto arc = of_radius(from, to, radius);
    if (!arc) return fail(arc.error());
    return emit_arc_motion(*arc, end, named);
  }

  Status about(Vec2 from, Vec2 to, Vec2 center, const Axes& end, AxisMask named) {
    KADR_TRY(may_enter(from, to));
    const auto arc = of_center(from, to, center);
    if (!arc) return fail(arc.error());
    return emit_arc_motion(*arc, end, named);
  }

 public:
  Result<PlaneArc> of_radius(Vec2 from, Vec2 to, double radius) const {
    const double half = length(to - from) / 2;
    if (from == to) return wrong("Current point same as end point of arc");
    if (half - std::fabs(radius) > least_radius) return wrong("Arc radius too small to reach end point");
    const double sign = radius < 0 ? -1 : 1;
    return arc_by_radius(from, to, sign * std::max(std::fabs(radius), half), turn_, 1e9);
  }

  Result<PlaneArc> of_center(Vec2 from, Vec2 to, Vec2 center) const {
    const double unit = m_.modal.inch ? mm_per_inch : 1;
    const double r1 = length(from - center), r2 = length(to - center);
    const auto point = [&](Vec2 at) {
      return fmt::format("({}{:.4f},{}{:.4f})", letter(axes_.first), at.x / unit, letter(axes_.second), at.y / unit);
    };
    if (r1 < least_radius || r2 < least_radius)
      return wrong(fmt::format("Zero-radius arc: start={} center={} end={} r1={:.4f} r2={:.4f}", point(from), point(center), point(to),
                               r1 / unit, r2 / unit));
    const double error = std::fabs(r1 - r2), relative = error / std::max(r1, r2);
    const double allowed = m_.modal.inch ? control_.machine.arc_tolerance_inch.value_or(spiral_absolute / 10) * mm_per_inch
                                         : control_.machine.arc_tolerance_mm.value_or(spiral_absolute);
    if (error > 100 * allowed || (error > allowed && relative > spiral_relative))
      return wrong(
          fmt::format("Radius to end of arc differs from radius to start: start={} center={} end={} r1={:.4f} r2={:.4f} "
                      "abs_err={:.4g} rel_err={:.4f}%",
                      point(from), point(center), point(to), r1 / unit, r2 / unit, error / unit, relative * 100));
    return arc_around(from, to, center, turn_, 1e9);
  }

 private:
  Status emit_arc_motion(const PlaneArc& arc, const Axes& end, AxisMask named) {
    arc_motion(m_, arc, turn_, end, named, m_.has('P') ? std::round(m_.value('P')) - 1 : 0);
    return {};
  }

  Emitter& m_;
  const kadr::Call& call_;
  Turn turn_;
  LinuxCnc& control_;
  PlaneAxes axes_;
};

}  // namespace

Status thread_to(Emitter& m, const Axes& to, AxisMask named, double lead) {
  KADR_TRY(m.straight(MotionKind::thread, to, named));
  Motion& motion = std::get<Motion>(m.batch->back().what);
  motion.own_override = motion.no_hold = true;
  motion.unit = FeedUnit::mm_per_rev;
  motion.feed = lead;
  motion.spindle = machine_number(linuxcnc_of(m).state.active_spindle);
  auto detail = std::make_shared<MotionDetail>();
  detail->lead = lead;
  motion.detail = std::move(detail);
  return {};
}

Status arc_to(Emitter& m, Span where, Turn turn, const Axes& to, Vec2 center, AxisMask named) {
  const kadr::Call call{nullptr, nullptr, where};
  return Arc(m, call, turn).through(to, center, named);
}

Status LinuxCnc::arc(Emitter& m, const kadr::Call& call, Turn turn) { return Arc(m, call, turn).run(); }

Result<PlaneArc> LinuxCnc::arc_of_center(Emitter& m, const ArcRule&, const ArcEnds& ends, Vec2 center) const {
  const kadr::Call call{nullptr, nullptr, m.block->where};
  return Arc(m, call, ends.turn).of_center(ends.from, ends.to, center);
}

Result<PlaneArc> LinuxCnc::arc_of_radius(Emitter& m, const ArcRule&, const ArcEnds& ends, double radius) const {
  const kadr::Call call{nullptr, nullptr, m.block->where};
  return Arc(m, call, ends.turn).of_radius(ends.from, ends.to, radius);
}

/// Writes a probed position to the file of probed points: X Y Z A B C U V W in the unit of the program. The coordinate of an axis that the
/// machine lacks is 0 (spec/linuxcnc 2.4).
Status LinuxCnc::write_probed(const BlockContext& m) {
  std::string line;
  for (std::size_t a = 0; a < axes_of_tables; ++a) {
    const bool is_angle = a >= 3 && a < 6;
    const double at = a < m.axis_count ? probed[a] / (is_angle || !m.modal.inch ? 1 : mm_per_inch) : 0;
    line += fmt::format("{}{:.6f}", a == 0 ? "" : " ", at);
  }
  return outputs.write(ProgramFiles::Which::probe, line);
}

Status LinuxCnc::accept_answer(Emitter& m, const ProbeAnswer& answer) {
  m.needs_probe = false;
  for (std::size_t a = 0; a < m.axis_count; ++a) m.position.work[a] = answer.at[a];
  m.position.machine = m.frames.machine_of(m.position.work);
  m.position.programmed = m.position.work;
  probed = m.position.work;
  const bool must = probe_kind == 2 || probe_kind == 4;
  const bool touched = must ? made_contact(m, answer) : answer.touched;
  probe_tripped = touched;
  m.variables.set_raw(5070, touched ? 1 : 0);
  (void)m.variables.consume_frames_changed();
  if (touched) KADR_TRY(write_probed(m));
  if (touched || !must) return {};
  return fault(AlarmId::rs274_probe, m.probe_where,
               fmt::format("G38.{} move finished without {} contact.", probe_kind, probe_kind == 2 ? "making" : "breaking"));
}

}  // namespace kadr::linuxcnc

namespace kadr::functions {

using linuxcnc::linuxcnc_of;

/// G38.2 to G38.5: probe motions. arg: the digit after the point.
Status probe_move(Emitter& m, const Call& call) {
  linuxcnc::LinuxCnc& control = linuxcnc_of(m);
  if (m.modal.radius_side != 0) return control.fault(AlarmId::rs274_compensation, call.where, "Cannot probe with cutter radius comp on");
  if (!(m.modal.feed_known && m.modal.feed > 0)) return control.fault(AlarmId::rs274_probe, call.where, "Cannot probe with zero feed rate");
  if (m.modal.feed_mode == FeedMode::per_revolution)
    return control.fault(AlarmId::rs274_probe, call.where, "Cannot probe with feed per rev mode");
  AxisMask named = 0;
  Axes to;
  KADR_TRY(m.target(to, named));
  const bool stays = to == m.position.programmed;
  if (stays && (call.row->arg == 2 || call.row->arg == 4))
    return control.fault(AlarmId::rs274_probe, call.where, "Start point too close to probe point");
  control.probe_kind = call.row->arg;
  m.needs_probe = true;
  m.probe_where = call.where;
  return m.straight(MotionKind::probe, to, named);
}

/// G33 K: moves to the programmed point in synchronism with the spindle. G33.1 (arg 1): taps to the point and returns to the start.
Status thread_by_spindle(Emitter& m, const Call& call) {
  linuxcnc::LinuxCnc& control = linuxcnc_of(m);
  const bool back = call.row->arg == 1;
  // The room path converts the threading motion to a straight one, or raises an alarm (spec/linuxcnc 7.5).
  if (m.modal.radius_side != 0 && m.radius_in_force() != 0) {
    AxisMask moved = 0;
    Axes end;
    KADR_TRY(m.target(end, moved));
    return m.straight(MotionKind::thread, end, moved);
  }
  KADR_TRY(
      linuxcnc::take_spindle(m, back ? "Invalid spindle ($) number in G33.1 move" : "Invalid spindle ($) number in G33 move", call.where));
  if (!linuxcnc::active_spindle_turns(m))
    return control.fault(AlarmId::rs274_spindle, call.where, back ? "Spindle not turning in G33.1" : "Spindle not turning in G33");
  AxisMask named = 0;
  Axes to;
  KADR_TRY(m.target(to, named));
  const Axes from = m.position.programmed;
  KADR_TRY(linuxcnc::thread_to(m, to, named, std::fabs(m.length_value('K'))));
  m.modal.motion = MotionMode::none;
  m.modal.motion_row = static_cast<std::int16_t>(call.row - m.def.codes.data());
  return back ? linuxcnc::thread_to(m, from, named, std::fabs(m.length_value('K'))) : Status();
}

}  // namespace kadr::functions
