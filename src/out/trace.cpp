#include "out/trace.h"

#include <algorithm>
#include <array>

namespace kadr {
namespace {

constexpr std::size_t number_room = 32;
constexpr std::size_t head_room = 192;
constexpr std::size_t most_digits = 20;  // of a block number

constexpr std::array<std::string_view, 7> motion_names = {"rapid", "feed", "arc_cw", "arc_ccw", "probe", "home", "thread"};
constexpr std::array<std::string_view, 3> unit_names = {"mm/min", "mm/rev", "1/min"};
constexpr std::array<std::string_view, 5> dir_names = {"stop", "cw", "ccw", "orient", "position"};
constexpr std::array<std::string_view, 3> coolant_names = {"off", "mist", "flood"};
constexpr std::array<std::string_view, 3> coolant_codes = {"M9", "M7", "M8"};

template <class E>
constexpr std::size_t index(E value) {
  return static_cast<std::size_t>(value);
}

char* put_block(char* at, const Origin& origin) {
  *at++ = origin.main_block ? ':' : 'N';
  std::array<char, most_digits> digits;
  std::size_t count = 0;
  for (std::uint32_t rest = origin.block; count < most_digits && (rest != 0 || count < std::max<std::size_t>(origin.block_digits, 1));
       rest /= 10)
    digits[count++] = static_cast<char>('0' + rest % 10);
  while (count > 0) *at++ = digits[--count];
  return at;
}

char* put_field(char* at, std::string_view key, double value) { return put_number(put_text(at, key), value); }

std::string number_string(double value) {
  std::array<char, number_room> text;
  return {text.data(), put_number(text.data(), value)};
}

std::string json(std::string_view text) {
  std::string quoted;
  append_json(quoted, text);
  return quoted;
}

/// A control's number as a JSON number if it is one.
std::string number_or_text(const std::string& number) {
  if (number.empty()) return "null";
  const bool digits =
      number.size() <= 9 && number[0] != '0' && std::all_of(number.begin(), number.end(), [](char c) { return c >= '0' && c <= '9'; });
  return digits ? number : json(number);
}

/// `"do":"spindle"` and the fields of what is no motion; empty: no line.
std::string fields_of(const Action& action) {
  struct Fields {
    std::string operator()(const Motion&) const { return {}; }
    std::string operator()(const Dwell& d) const { return R"(dwell","seconds":)" + number_string(d.seconds); }
    std::string operator()(const Spindle& s) const {
      return R"(spindle","spindle":1,"dir":")" + std::string(dir_names[index(s.dir)]) + R"(","rpm":)" + number_string(s.rpm);
    }
    std::string operator()(const Speed& s) const {
      return (s.surface ? R"(speed","spindle":1,"surface_speed":)" : R"(speed","spindle":1,"rpm":)") + number_string(s.value);
    }
    std::string operator()(const CoolantSwitch& c) const {
      return R"(coolant","what":")" + std::string(coolant_names[index(c.what)]) + R"(","code":")" +
             std::string(coolant_codes[index(c.what)]) + '"';
    }
    std::string operator()(const ToolSelect& t) const {
      return R"(tool","tool":)" + std::to_string(t.tool) + (t.corrector == 0 ? "" : R"(,"corrector":)" + std::to_string(t.corrector));
    }
    std::string operator()(const ToolChange& t) const { return R"(toolchange","tool":)" + std::to_string(t.tool); }
    std::string operator()(const MachineFunction& m) const {
      std::string text = R"(m","code":"M)" + std::to_string(m.code) + '"';
      if (m.p) text += R"(,"P":)" + number_string(*m.p);
      if (m.q) text += R"(,"Q":)" + number_string(*m.q);
      return text;
    }
    std::string operator()(const Stop& s) const { return s.optional ? R"(optional_stop")" : R"(stop")"; }
    std::string operator()(const Message& m) const { return R"(message","text":)" + json(m.text); }
    std::string operator()(const FrameChange&) const { return {}; }
    std::string operator()(const AuxiliaryFunction&) const { return {}; }
    std::string operator()(const Sync&) const { return {}; }
    std::string operator()(const ZoneChange&) const { return {}; }
  };
  return std::visit(Fields{}, action.what);
}

}  // namespace

TraceWriter::TraceWriter(std::FILE* file, const std::vector<std::string>& axes, AxisMask rotary, const ToolPosition& start,
                         std::vector<double> points)
    : out_(file), roles_(AxisRoles::of(axes, rotary)), points_(std::move(points)), position_(start) {
  for (std::size_t i = 0; i < roles_.count; ++i) keys_.push_back(json(axes[i]) + ":");
  names_ = axes;
}

char* TraceWriter::put_head(char* at, std::string_view kind, const Origin& origin) const {
  at = put_text(put_text(at, R"({"do":")"), kind);
  *at++ = '"';
  if (origin.has_block) {
    at = put_block(put_text(at, R"(,"block":")"), origin);
    *at++ = '"';
  }
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

void TraceWriter::write_motion(const Motion& motion, const Origin& origin) {
  std::size_t most = 3 * head_room;
  for (const std::string& key : keys_) most += 2 * (key.size() + number_room);
  char* at = put_head(out_.room(most), motion_names[index(motion.kind)], origin);
  at = put_axes(put_axes(at, R"(,"to":)", motion.to), R"(,"machine":)", motion.machine);
  if (is_arc(motion.kind)) at = put_arc(at, motion);
  if (motion.feed > 0) {
    at = put_field(at, R"(,"feed":)", motion.feed);
    at = put_text(put_text(at, R"(,"unit":")"), unit_names[index(motion.unit)]);
    *at++ = '"';
  }
  if (motion.kind != MotionKind::rapid) at = put_text(at, motion.exact ? R"(,"exact":true)" : R"(,"exact":false)");
  out_.done(at);
  if (!points_.empty()) write_points(motion);
  out_.append("}\n");
  position_.take(motion);
}

void TraceWriter::write_points(const Motion& motion) {
  const Curve curve(roles_, position_.work, motion);
  out_.append(R"(,"points":[)");
  for (std::size_t n = 0; n < points_.size(); ++n) {
    const Axes to = curve.at(points_[n]);
    const Axes machine = machine_along(roles_, position_, motion, to, points_[n]);
    std::size_t most = head_room;
    for (const std::string& key : keys_) most += 2 * (key.size() + number_room);
    char* at = put_field(out_.room(most), n == 0 ? R"({"part":)" : R"(,{"part":)", points_[n]);
    at = put_axes(put_axes(at, R"(,"to":)", to), R"(,"machine":)", machine);
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

void TraceWriter::write(const Action& action) {
  if (const auto* motion = std::get_if<Motion>(&action.what)) return write_motion(*motion, action.origin);
  if (const auto* frame = std::get_if<FrameChange>(&action.what)) return position_.take(*frame);
  write_other(action);
}

void TraceWriter::write_state(const Ending& ending) {
  std::size_t most = head_room;
  for (const std::string& key : keys_) most += 2 * (key.size() + number_room);
  out_.done(put_axes(put_axes(out_.room(most), R"(,"position":)", ending.position), R"(,"machine_position":)", ending.machine_position));
  out_.append(R"(,"variables":{)");
  bool first = true;
  const auto variable = [&](const std::string& name, const std::string& value) {
    out_.append(first ? "" : ",");
    out_.append(json(name));
    out_.append(":");
    out_.append(value);
    first = false;
  };
  for (const auto& [name, value] : ending.variables) variable(name, number_string(value));
  for (const auto& [name, asked] : ending.watched_unset) variable(name, "null");
  out_.append(R"(},"modal":[)");
  for (std::size_t i = 0; i < ending.modal.size(); ++i) {
    if (i > 0) out_.append(",");
    out_.append(json(ending.modal[i]));
  }
  out_.append("]}\n");
  out_.flush();
}

void TraceWriter::finish(const Ending& ending) {
  out_.append(R"({"do":"end")");
  write_state(ending);
}

void TraceWriter::finish(const Ending& ending, const AlarmReport& report, const AlarmTexts& texts, Lang lang) {
  const Alarm& alarm = report.alarm;
  out_.done(put_head(out_.room(head_room), "alarm", report.origin));
  out_.append(R"(,"id":)" + json(name_of(alarm.id)) + R"(,"number":)" + number_or_text(texts.number(alarm.id)));
  out_.append(R"(,"text":)" + json(texts.sentence(alarm, lang)) + R"(,"args":[)");
  for (std::size_t i = 0; i < alarm.arg_count; ++i) {
    const AlarmArg& arg = alarm.args[i];
    if (i > 0) out_.append(",");
    out_.append(arg.is_number() ? number_string(arg.number()) : json(arg.text()));
  }
  out_.append("]");
  write_state(ending);
}

}  // namespace kadr
