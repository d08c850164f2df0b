// TraceWriter: writes Steps as JSON Lines (tests/golden/README.md). It is used by cli/run_view and tested by tests/out/trace_test.cpp.

#include "out/trace/trace.h"

#include <algorithm>
#include <array>

#include "action/by_kind.h"
#include "base/ascii.h"
#include "motion/time/polar_feed.h"
#include "out/text/alarm_print.h"
#include "out/trace/trace_fields.h"

namespace kadr {
namespace {

constexpr std::size_t head_room = 192;
constexpr std::size_t max_digits = 20;  // greatest number of digits in a block number

constexpr std::array<std::string_view, 8> motion_names = {"rapid", "feed", "arc_cw", "arc_ccw", "probe", "home", "thread", "spline"};
constexpr std::array<std::string_view, 3> unit_names = {"mm/min", "mm/rev", "1/min"};

char* put_block(char* at, const Origin& origin) {
  *at++ = origin.main_block ? ':' : 'N';
  std::array<char, max_digits> digits;
  std::size_t count = 0;
  for (std::uint32_t rest = origin.block; count < max_digits && (rest != 0 || count < std::max<std::size_t>(origin.block_digits, 1));
       rest /= 10)
    digits[count++] = static_cast<char>('0' + rest % 10);
  while (count > 0) *at++ = digits[--count];
  return at;
}

char* put_field(char* at, std::string_view key, double value) { return put_number(put_text(at, key), value); }

/// Returns the work coordinates of the tool at the fraction `part` of the motion. `work`: the point of the motion's curve there.
Axes tool_at(const Motion& motion, double part, const Axes& work) {
  const TipPath* const tip_path = motion.detail ? motion.detail->tip_path.get() : nullptr;
  return tip_path != nullptr ? tip_path->at(part, work) : work;
}

/// Returns a control's alarm number as a JSON number if it consists of digits, otherwise as a JSON string.
std::string number_or_text(const std::string& number) {
  if (number.empty()) return "null";
  const bool digits = number.size() <= 9 && number[0] != '0' && std::all_of(number.begin(), number.end(), is_digit);
  return digits ? number : json_string(number);
}

}  // namespace

TraceWriter::TraceWriter(std::FILE* file, const std::vector<std::string>& axes, AxisMask rotary, std::vector<double> points)
    : out_(file), roles_(AxisRoles::of(axes, rotary)), points_(std::move(points)) {
  for (std::size_t i = 0; i < roles_.count; ++i) keys_.push_back(json_string(axes[i]) + ":");
  names_ = axes;
  line_room_ = 3 * head_room;
  for (const std::string& key : keys_) line_room_ += 2 * (key.size() + number_room);
}

char* TraceWriter::put_head(char* at, std::string_view kind, const Origin& origin) const {
  at = put_text(put_text(at, R"({"do":")"), kind);
  *at++ = '"';
  if (origin.has_block) {
    at = put_block(put_text(at, R"(,"block":")"), origin);
    *at++ = '"';
  }
  if (channel_ > 0) at = put_field(at, R"(,"channel":)", channel_);
  at = put_field(at, R"(,"line":)", origin.line);
  if (origin.column > 0) at = put_field(at, R"(,"col":)", origin.column);
  return at;
}

char* TraceWriter::put_axes(char* at, std::string_view key, const Axes& axes) const {
  at = put_text(at, key);
  *at++ = '{';
  for (std::size_t i = 0; i < roles_.count; ++i) {
    if (i > 0) *at++ = ',';
    at = put_number(put_text(at, keys_[i]), axes[i]);
  }
  *at++ = '}';
  return at;
}

char* TraceWriter::put_arc(char* at, const Motion& motion) const {
  at = put_number(put_text(put_text(at, R"(,"center":{)"), keys_[motion.first]), motion.center.x);
  *at++ = ',';
  at = put_number(put_text(at, keys_[motion.second]), motion.center.y);
  at = put_text(put_text(at, R"(},"plane":")"), names_[motion.first]);
  at = put_text(at, names_[motion.second]);
  return put_field(at, R"(","turns":)", motion.turns);
}

/// Writes a motion. Fields that every motion has are written in one call. Fields that are rarely present are appended one by one.
void TraceWriter::write_motion(const Step& step, const Motion& motion) {
  const MotionTime& time = step.time;
  char* at = put_head(out_.room(line_room_), motion_names[row_of(motion.kind)], step.action.origin);
  const WorkTransform* const space = step.from.space.get();
  const Axes& to = motion.to;
  at = put_axes(at, R"(,"to":)", space == nullptr ? to : space->in_system(tool_at(motion, 1, to)));
  at = put_axes(at, R"(,"machine":)", motion.machine);
  if (is_arc(motion.kind)) at = put_arc(at, motion);
  if (motion.feed > 0) {
    at = put_field(at, R"(,"feed":)", motion.feed);
    at = put_text(put_text(at, R"(,"unit":")"), unit_names[row_of(motion.unit)]);
    *at++ = '"';
  }
  if (motion.kind != MotionKind::rapid) at = put_text(at, motion.exact ? R"(,"exact":true)" : R"(,"exact":false)");
  out_.done(at);
  if (motion.as_programmed) out_.done(put_axes(out_.room(line_room_), R"(,"programmed":)", to));
  if (space != nullptr) write_space({step, motion, 1, to, motion.machine});
  if (after_probe_) write_path(step, motion);
  after_probe_ = motion.kind == MotionKind::probe;
  if (motion.detail) [[unlikely]]
    write_detail(step, motion);
  if (time.exact || is_arc(motion.kind) || motion.detail) write_time(motion, time);
  if (!points_.empty()) write_points(step, motion);
  out_.append("}\n");
}

/// Writes the travel of each axis that the block names. The field is needed after a probe motion: a probe motion ends at contact, so the
/// program does not determine where the next motion begins (nct 21.1).
void TraceWriter::write_path(const Step& step, const Motion& motion) {
  if (motion.detail && motion.detail->rolled != 0) return;  // write_detail() writes the travel of an axis with rollover instead
  char* at = put_text(out_.room(line_room_), R"(,"travel":)");
  char separator = '{';
  for (std::size_t i = 0; i < roles_.count; ++i) {
    if ((motion.named >> i & 1U) == 0) continue;
    *at++ = std::exchange(separator, ',');
    at = put_number(put_text(at, keys_[i]), motion.to[i] - step.from.work[i]);
  }
  if (separator == '{') *at++ = '{';
  *at++ = '}';
  out_.done(at);
}

char* TraceWriter::put_vector(char* at, std::string_view key, Vec3 v) const {
  at = put_text(at, key);
  *at++ = '{';
  const double values[] = {v.x, v.y, v.z};
  char separator = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    if (roles_.xyz[i] < 0) continue;
    if (separator != 0) *at++ = separator;
    separator = ',';
    at = put_number(put_text(at, keys_[static_cast<std::size_t>(roles_.xyz[i])]), values[i]);
  }
  *at++ = '}';
  return at;
}

/// Writes the position and the direction of the tool relative to the part (nct 25), and in which coordinate frame the words of the program
/// are.
void TraceWriter::write_space(const Place& at_place) {
  const auto& [step, motion, part, work, machine] = at_place;
  const WorkTransform& space = *step.from.space;
  char* at = out_.room(3 * line_room_);
  if (motion.as_programmed && part < 1) at = put_axes(at, R"(,"programmed":)", work);
  const Pose pose = space.pose(machine);
  at = put_vector(at, R"(,"tip":)", pose.tip);
  at = put_vector(at, R"(,"tool_dir":)", pose.direction);
  const TipPath* const tip_path = motion.detail ? motion.detail->tip_path.get() : nullptr;
  if (const Vec3 normal = tip_path != nullptr ? tip_path->normal(part) : Vec3{}; !(normal == Vec3{})) {
    const auto of = [this, &at_work = work](std::size_t i) {
      return roles_.xyz[i] < 0 ? 0.0 : at_work[static_cast<std::size_t>(roles_.xyz[i])];
    };
    at = put_vector(put_vector(at, R"(,"contact":)", {of(0), of(1), of(2)}), R"(,"normal":)", normal);
  }
  out_.done(at);
}

void TraceWriter::write_detail(const Step& step, const Motion& motion) {
  const MotionDetail& detail = *motion.detail;
  char* at = out_.room(2 * line_room_);
  if (detail.rolled != 0) {
    at = put_text(at, R"(,"travel":)");
    char separator = '{';
    for (std::size_t i = 0; i < roles_.count; ++i) {
      if ((detail.rolled >> i & 1U) == 0) continue;
      *at++ = std::exchange(separator, ',');
      at = put_number(put_text(at, keys_[i]), detail.travel[i]);
    }
    *at++ = '}';
  }
  if (detail.has_programmed) {
    at = put_axes(at, R"(,"programmed":)", detail.programmed);
  } else if (detail.surface != PathSurface::plane) {
    at = put_axes(at, R"(,"programmed":)", step.curve().programmed(1));
  }
  const auto put = [&](std::string_view key, const std::optional<double>& value) {
    if (value) at = put_field(at, key, *value);
  };
  put(R"(,"lead":)", detail.lead);
  put(R"(,"angle":)", detail.start_angle);
  put(R"(,"turn":)", detail.turn);
  put(R"(,"torque":)", detail.torque);
  out_.done(at);
}

void TraceWriter::write_time(const Motion& motion, const MotionTime& time) {
  char* at = out_.room(head_room);
  const bool curved =
      is_arc(motion.kind) || motion.kind == MotionKind::spline || (motion.detail && motion.detail->surface != PathSurface::plane);
  if (curved && time.length > 0) at = put_field(at, R"(,"length":)", time.length);
  // Duration and highest feed of a motion are written only if they are exact. Without the axes' accelerations in the set-up they would be
  // wrong.
  if (time.exact) {
    at = put_field(at, R"(,"seconds":)", time.seconds);
    if (time.feed_most > 0) at = put_field(at, R"(,"feed_max":)", time.feed_most);
    if (time.feed_end) at = put_field(at, R"(,"feed_end":)", *time.feed_end);
  }
  out_.done(at);
}

void TraceWriter::write_points(const Step& step, const Motion& motion) {
  const MotionTime& time = step.time;
  const Curve& curve = step.curve();
  const bool surface = curve.surface() != PathSurface::plane;
  out_.append(R"(,"points":[)");
  for (std::size_t n = 0; n < points_.size(); ++n) {
    const Axes to = curve.at(points_[n]);
    const Axes machine = machine_along(roles_, step.from, motion, to, points_[n]);
    char* at = put_field(out_.room(2 * line_room_), n == 0 ? R"({"part":)" : R"(,{"part":)", points_[n]);
    const WorkTransform* const space = step.from.space.get();
    at = put_axes(at, R"(,"to":)", space == nullptr ? to : space->in_system(tool_at(motion, points_[n], to)));
    at = put_axes(at, R"(,"machine":)", machine);
    if (space != nullptr) {
      out_.done(at);
      write_space({step, motion, points_[n], to, machine});
      at = out_.room(2 * line_room_);
    }
    if (surface) at = put_axes(at, R"(,"programmed":)", curve.programmed(points_[n]));
    if (surface && time.exact && time.feed > 0)
      at = put_field(at, R"(,"feed":)", feed_at(curve, {time.feed, motion.detail->max_rotary_speed, motion.along}, points_[n]));
    *at++ = '}';
    out_.done(at);
  }
  out_.append("]");
}

void TraceWriter::write_other(const Action& action) {
  const std::string fields = fields_of(action);
  if (fields.empty()) return;
  const std::size_t kind_end = fields.find('"');
  out_.done(put_head(out_.room(head_room), std::string_view(fields).substr(0, kind_end), action.origin));
  out_.append(std::string_view(fields).substr(kind_end + 1));
  out_.append("}\n");
}

void TraceWriter::write(const Step& step) {
  if (const Motion* const motion = step.motion()) return write_motion(step, *motion);
  if (is_by_control(step.action) && !writes_program_ends_) return;
  if (!std::holds_alternative<FrameChange>(step.action.what)) write_other(step.action);
}

void TraceWriter::write_state(const FinalState& ending, const LastLine& more) {
  out_.done(
      put_axes(put_axes(out_.room(line_room_), R"(,"position":)", ending.position), R"(,"machine_position":)", ending.machine_position));
  out_.append(R"(,"variables":{)");
  bool first = true;
  const auto variable = [&](const std::string& name, const std::string& value) {
    out_.append(first ? "" : ",");
    out_.append(json_string(name));
    out_.append(":");
    out_.append(value);
    first = false;
  };
  for (const auto& [name, value] : ending.variables) variable(name, number_string(value));
  for (const auto& [name, watched] : ending.watched_unset) variable(name, "null");
  out_.append(R"(},"modal":[)");
  for (std::size_t i = 0; i < ending.modal.size(); ++i) {
    if (i > 0) out_.append(",");
    out_.append(json_string(ending.modal[i]));
  }
  out_.append("]");
  if (!more.state.empty()) {
    out_.append(R"(,"state":)");
    out_.append(more.state);
  }
  out_.append("}\n");
  out_.flush();
}

void TraceWriter::finish(const FinalState& ending, const LastLine& more) {
  out_.append(R"({"do":"end")");
  if (channel_ > 0) out_.append(R"(,"channel":)" + std::to_string(channel_));
  write_state(ending, more);
}

void TraceWriter::finish(const FinalState& ending, const AlarmReport& report, const AlarmTexts& texts, Lang lang, const LastLine& more) {
  const Alarm& alarm = report.alarm;
  out_.done(put_head(out_.room(head_room), "alarm", report.origin));
  if (more.alarm_channel > 0) out_.append(R"(,"alarm_channel":)" + std::to_string(more.alarm_channel));
  out_.append(R"(,"id":)" + json_string(name_of(alarm.id)) + R"(,"number":)" + number_or_text(texts.number(alarm)));
  out_.append(R"(,"text":)" + json_string(sentence_of(report, texts, lang)) + R"(,"args":[)");
  for (std::size_t i = 0; i < alarm.arg_count; ++i) {
    const AlarmArg& arg = alarm.args[i];
    if (i > 0) out_.append(",");
    out_.append(arg.is_number() ? number_string(arg.number()) : json_string(arg.text()));
  }
  out_.append("]");
  write_state(ending, more);
}

}  // namespace kadr
