// KlartextProgram: conversational blocks. Used by convert/conversion; tested by tests/convert_heidenhain.py.

#include "convert/flat/klartext_program.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "action/by_kind.h"
#include "base/tolerance.h"

namespace kadr {
namespace {

constexpr double same_place = 1e-9;

Status lacks(const std::string& what) { return fail(alarm(AlarmId::function_has_no_code, {}, std::string_view(what))); }

/// Returns a number with its sign and at most `digits` decimals, as the control writes it: +10, -0.5.
std::string signed_number(double value, int digits) {
  std::string text = fmt::format("{:+.{}f}", value, digits);
  if (text.find('.') != std::string::npos) {
    while (text.back() == '0') text.pop_back();
    if (text.back() == '.') text.pop_back();
  }
  return text == "-0" ? "+0" : text;
}

std::string plain_number(double value, int digits) { return signed_number(value, digits).substr(1); }

constexpr int length_digits = 4, angle_digits = 6, feed_digits = 3;

}  // namespace

Status KlartextProgram::write(const std::string& block) {
  blocks_.text(block);
  return blocks_.end();
}

Status KlartextProgram::begin(const ToolPosition& stand, const Placement& placement) {
  placement_ = placement;
  at_ = stand.machine;
  return write("BEGIN PGM KADR MM");
}

Status KlartextProgram::finish() {
  KADR_TRY(write("M30"));
  return write("END PGM KADR MM");
}

Status KlartextProgram::take(const Action& action, const OffsetsInForce&) {
  return by_kind(
      action, [&](const Motion& m) { return motion(m); },
      [&](const FrameChange& frame) -> Status {
        placement_ = frame.placement;
        return Status();
      },
      [&](const MachineFunction& function) -> Status { return function.by_control ? Status() : machine_code(function.code); },
      [&](const Spindle& turned) { return spindle(turned); },
      [&](const Speed& of) -> Status { return of.surface || of.number != 1 ? lacks("surface_speed") : speed(of.value); },
      [&](const ToolSelect& selected) { return write(fmt::format("TOOL DEF {}", selected.tool)); },
      [&](const ToolChange& change) -> Status { return change.there ? lacks("tool_word") : tool(change.tool); },
      [&](const Dwell& pause) -> Status {
        KADR_TRY(write("CYCL DEF 9.0 DWELL TIME"));
        return write("CYCL DEF 9.1 DWELL " + plain_number(pause.seconds, feed_digits));
      },
      [&](const CoolantSwitch& switched) -> Status {
        return switched.what == Coolant::mist ? lacks("coolant_mist") : write(switched.what == Coolant::flood ? "M8" : "M9");
      },
      [&](const Stop& stop) -> Status {
        if (stop.reason == StopReason::single_block || (stop.reason == StopReason::message && source_.same_messages)) return Status();
        return write(stop.optional ? "M1" : "STOP");
      },
      [&](const Message& message) -> Status {
        if (source_.same_messages || message.asks) return lacks("message");
        blocks_.comment(message.text);
        return blocks_.end();
      },
      [&](const AuxiliaryFunction&) { return lacks("auxiliary_word"); }, [&](const ZoneChange&) { return lacks("work_area_on"); },
      [&](const Couple&) { return lacks("gear_on"); }, [&](const Uncouple&) { return lacks("gear_on"); },
      [&](const SurfaceSpeed& law) -> Status { return law.on ? lacks("surface_speed") : Status(); },
      same<Sync, CompensationBreak, CompensationCorner, CompensationCheck>(Status()));
}

Axes KlartextProgram::base() const {
  if (form_ == FlatForm::plain) return {};
  Axes base = placement_.length;
  if (const auto found = source_.zeros.find(system_); found != source_.zeros.end())
    for (std::size_t a = 0; a < max_axes; ++a) base[a] += found->second[a];
  return base;
}

bool KlartextProgram::is_allowed_axis(std::size_t axis) const {
  return axis < source_.axes.size() && source_.axes[axis].size() == 1 && blocks_.has_word(source_.axes[axis].front());
}

std::string KlartextProgram::word(std::size_t axis, double value) const {
  return ' ' + source_.axes[axis] + signed_number(value, length_digits);
}

/// Cycle 247 where the work offset changes: row 1 of the preset table is G54 (spec/heidenhain 11.6).
Status KlartextProgram::preset(const Motion& motion) {
  if (form_ == FlatForm::plain || motion.system == system_ || !source_.has_systems) return {};
  constexpr std::uint16_t rows = 6;
  if (motion.system > rows) return lacks("work_system");
  system_ = motion.system;
  known_ = 0;
  pole_.clear();
  return write(fmt::format("CYCL DEF 247 DATUM SETTING ~\n  Q339=+{} ;DATUM NUMBER", motion.system));
}

Status KlartextProgram::motion(const Motion& motion) {
  const bool in_machine = motion.end_reference == EndReference::by_machine && form_ != FlatForm::plain;
  if (motion.detail && motion.detail->surface != PathSurface::plane) return lacks("polar_surface_on");
  KADR_TRY(preset(motion));
  switch (motion.kind) {
    case MotionKind::rapid:
    case MotionKind::home:
    case MotionKind::feed: KADR_TRY(line(motion, in_machine)); break;
    case MotionKind::arc_cw:
    case MotionKind::arc_ccw: KADR_TRY(arc(motion)); break;
    case MotionKind::probe: return lacks("probe");
    case MotionKind::thread: return lacks("thread");
    case MotionKind::spline: return lacks("spline");
  }
  at_ = motion.machine;
  if (in_machine) {
    known_ &= ~motion.named;
  } else {
    if (!counts_from_) counts_from_ = motion.system;
    else if (*counts_from_ != motion.system) counts_from_several_ = true;
  }
  return {};
}

/// Adds R0, RL, RR, the feed, and M91.
Status KlartextProgram::tail(std::string& block, const Motion& motion, bool in_machine) {
  if (form_ == FlatForm::contours && motion.side != side_) {
    side_ = motion.side;
    block += side_ == 0 ? " R0" : side_ > 0 ? " RL" : " RR";
  }
  if (motion.kind == MotionKind::rapid || motion.kind == MotionKind::home) {
    block += " FMAX";
  } else {
    double feed = motion.feed;
    if (motion.unit == FeedUnit::mm_per_rev) {
      if (turns_ == SpindleDir::stop || !(rpm_ > 0)) return lacks("feed_per_revolution");
      feed *= rpm_;
    } else if (motion.unit != FeedUnit::mm_per_min) {
      return lacks("feed_inverse_time");
    }
    if (feed != feed_) block += " F" + plain_number(feed_ = feed, feed_digits);
  }
  if (in_machine) block += " M91";
  return {};
}

Status KlartextProgram::line(const Motion& motion, bool in_machine) {
  const Axes zero = in_machine ? Axes{} : base();
  std::string block = "L";
  for (const bool all_named : {false, true}) {
    for (std::size_t a = 0; a < source_.axes.size() && a < max_axes; ++a) {
      const bool named = (motion.named >> a & 1U) != 0, moves = std::fabs(motion.machine[a] - at_[a]) > same_place;
      if (in_machine ? !named : !moves && !(named && ((known_ >> a & 1U) == 0 || all_named))) continue;
      if (!is_allowed_axis(a)) return lacks(source_.axes[a]);
      block += word(a, motion.machine[a] - zero[a]);
      known_ |= AxisMask{1} << a;
    }
    if (block.size() > 1 || in_machine) break;
  }
  if (block.size() == 1) return {};
  KADR_TRY(tail(block, motion, in_machine));
  return write(block);
}

/// An arc of the plane as CC and C; a helix, or more than one turn, as CP with IPA.
Status KlartextProgram::arc(const Motion& motion) {
  const std::size_t first = motion.first, second = motion.second;
  Axes middle = motion.to;
  middle[first] = motion.center.x, middle[second] = motion.center.y;
  const Axes on_machine = placement_.machine_of(middle), zero = base();
  const Vec2 centre{on_machine[first], on_machine[second]};
  constexpr double alike = 0.01;  // within the difference of radii that the control accepts (spec/heidenhain 4.1)
  const double from = std::hypot(at_[first] - centre.x, at_[second] - centre.y);
  if (std::fabs(std::hypot(motion.machine[first] - centre.x, motion.machine[second] - centre.y) - from) > alike) return lacks("arc_cw");
  const bool in_plane = source_.axes[first] == "X" && source_.axes[second] == "Y";
  bool alone = true;
  for (std::size_t a = 0; a < source_.axes.size() && a < max_axes; ++a)
    if (a != first && a != second && std::fabs(motion.machine[a] - at_[a]) > same_place) alone = false;
  const bool simple = alone && motion.turns <= 1 + tol::whole_number;
  if (!is_allowed_axis(first) || !is_allowed_axis(second) || (!simple && !in_plane)) return lacks("arc_cw");
  const std::string pole = "CC" + word(first, centre.x - zero[first]) + word(second, centre.y - zero[second]);
  if (pole != pole_) KADR_TRY(write(pole_ = pole));
  const char sense = motion.kind == MotionKind::arc_ccw ? '+' : '-';
  std::string block = simple ? "C" : "CP IPA" + signed_number((sense == '+' ? 360 : -360) * motion.turns, angle_digits);
  for (std::size_t a = 0; a < source_.axes.size() && a < max_axes; ++a) {
    const bool of_plane = a == first || a == second;
    if (of_plane ? !simple : std::fabs(motion.machine[a] - at_[a]) <= same_place) continue;
    if (!is_allowed_axis(a)) return lacks(source_.axes[a]);
    block += word(a, motion.machine[a] - zero[a]);
    known_ |= AxisMask{1} << a;
  }
  block += std::string(" DR") + sense;
  if (!simple) known_ &= ~(AxisMask{1} << first | AxisMask{1} << second);
  KADR_TRY(tail(block, motion, false));
  return write(block);
}

Status KlartextProgram::speed(double rpm) {
  if (rpm == rpm_) return {};
  rpm_ = rpm;
  return write("TOOL CALL S" + plain_number(rpm, feed_digits));
}

Status KlartextProgram::spindle(const Spindle& spindle) {
  if (spindle.number != 1) return lacks("spindle_axis_word");
  const bool turns = spindle.dir == SpindleDir::cw || spindle.dir == SpindleDir::ccw;
  if (turns && spindle.rpm > 0) KADR_TRY(speed(spindle.rpm));
  turns_ = spindle.dir;
  switch (spindle.dir) {
    case SpindleDir::cw: return write("M3");
    case SpindleDir::ccw: return write("M4");
    case SpindleDir::stop: return write("M5");
    default: return lacks("spindle_orient");
  }
}

/// A change stops the spindle, so it starts again; the length of the tool is in force from here on.
Status KlartextProgram::tool(std::uint32_t number) {
  KADR_TRY(write(fmt::format("TOOL CALL {} Z", number) + (rpm_ > 0 ? " S" + plain_number(rpm_, feed_digits) : "")));
  known_ = 0;
  pole_.clear();
  if (turns_ == SpindleDir::cw) return write("M3");
  return turns_ == SpindleDir::ccw ? write("M4") : Status();
}

/// An M code of the machine. Numbers that are functions of the path on the target control are not used for others (spec/heidenhain 3.8).
Status KlartextProgram::machine_code(std::uint32_t code) {
  const auto mapped = source_.machine_codes.find(code);
  const std::uint32_t there = mapped != source_.machine_codes.end() ? mapped->second : code;
  constexpr std::uint32_t least = 15, path_from = 89, path_to = 150, most = 9999;
  if (there < least || there > most || (there >= path_from && there <= path_to)) return lacks("M" + std::to_string(code));
  return write("M" + std::to_string(there));
}

}  // namespace kadr
