// Writes the fields of a trace line for actions other than motions (tests/golden/README.md "Actions"). This file is used by
// out/trace/trace.

#include "out/trace/trace_fields.h"

#include <array>

#include "out/trace/text_buffer.h"

namespace kadr {
namespace {

constexpr std::array<std::string_view, 5> dir_names = {"stop", "cw", "ccw", "orient", "position"};
constexpr std::array<std::string_view, 3> coolant_names = {"off", "mist", "flood"};
constexpr std::array<std::string_view, 3> coolant_codes = {"M9", "M7", "M8"};
// Names of the stop reasons, in the order of the enum StopReason. The first two names are empty, since the field `do` of the trace line
// already states those reasons.
constexpr std::array<std::string_view, 4> reason_names = {"", "", "single_block", "message"};

std::string field(std::string_view key, double value) { return ",\"" + std::string(key) + "\":" + number_string(value); }
std::string field(std::string_view key, const std::optional<double>& value) { return value ? field(key, *value) : std::string(); }
std::string field(std::string_view key, std::string_view text) { return ",\"" + std::string(key) + "\":" + json_string(text); }

/// Returns a JSON field; empty if the value is 0.
template <class N>
std::string field_if(std::string_view key, N value) {
  return value == 0 ? std::string() : field(key, double(value));
}

std::string place(const ToolPlace& at) {
  return field_if("data", at.data) + field_if("magazine", at.magazine) + field_if("pocket", at.pocket);
}

struct Fields {
  std::string operator()(const Motion&) const { return {}; }
  std::string operator()(const FrameChange&) const { return {}; }
  std::string operator()(const SurfaceSpeed&) const { return {}; }
  std::string operator()(const ZoneChange&) const { return {}; }
  std::string operator()(const CompensationBreak&) const { return {}; }
  std::string operator()(const CompensationCorner&) const { return {}; }
  std::string operator()(const CompensationCheck&) const { return {}; }
  std::string operator()(const Dwell& d) const { return "dwell\"" + field("seconds", d.seconds); }
  std::string operator()(const Spindle& s) const {
    return "spindle\"" + field("spindle", s.number) + field("dir", dir_names[row_of(s.dir)]) + field("rpm", s.rpm) + field("turn", s.turn) +
           field("angle", s.angle);
  }
  std::string operator()(const Speed& s) const {
    return "speed\"" + field("spindle", s.number) + field(s.surface ? "surface_speed" : "rpm", s.value) + field_if("range", s.range);
  }
  std::string operator()(const CoolantSwitch& c) const {
    return "coolant\"" + field("what", coolant_names[row_of(c.what)]) + field("code", coolant_codes[row_of(c.what)]);
  }
  std::string operator()(const ToolSelect& t) const {
    return "tool\"" + field("tool", t.tool) + field_if("corrector", t.corrector) + place(t.place);
  }
  std::string operator()(const ToolChange& t) const {
    return "toolchange\"" + field("tool", t.tool) + place(t.place) + (t.there ? ",\"there\":true" : "");
  }
  std::string operator()(const MachineFunction& m) const {
    return "m\"" + field("code", "M" + std::to_string(m.code)) + field("P", m.p) + field("Q", m.q) + field_if("spindle", m.spindle) +
           field("number", m.number) + field("value", m.value);
  }
  std::string operator()(const AuxiliaryFunction& a) const {
    return "aux\"" + field("address", std::string_view(&a.address, 1)) + field("value", a.value);
  }
  std::string operator()(const Stop& s) const {
    const std::string_view reason = reason_names[row_of(s.reason)];
    return (s.optional ? "optional_stop\"" : "stop\"") + (reason.empty() ? std::string() : field("reason", reason));
  }
  std::string operator()(const Message& m) const {
    return "message\"" + (m.number < 0 ? std::string() : field("number", m.number)) + field("text", m.text);
  }
  std::string operator()(const Couple& c) const {
    return "couple\"" + field("master", c.master) + field("slave", c.slave) + field("ratio", c.ratio) + field("rpm", c.rpm) +
           field("phase", c.phase) + field_if("helix", c.helix) + (c.along.empty() ? std::string() : field("along", c.along));
  }
  std::string operator()(const Uncouple& u) const { return "uncouple\"" + field("slave", u.slave); }
  std::string operator()(const Sync& s) const {
    std::string channels;
    for (const std::uint8_t channel : s.channels) channels += (channels.empty() ? "" : ",") + std::to_string(channel);
    return "sync\"" + field("code", "M" + std::to_string(s.code)) + ",\"channels\":[" + channels + "]" + field("at", s.at);
  }
};

}  // namespace

std::string number_string(double value) {
  std::array<char, number_room> text;
  return {text.data(), put_number(text.data(), value)};
}

std::string json_string(std::string_view text) {
  std::string quoted;
  append_json(quoted, text);
  return quoted;
}

std::string fields_of(const Action& action) { return std::visit(Fields{}, action.what); }

}  // namespace kadr
