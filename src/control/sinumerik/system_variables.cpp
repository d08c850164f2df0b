// The system variables that Kadr has (spec/sinumerik 17): $P_UIFR and other frames, $AA_IW, $P_EP, $P_GG, tool data. Used by
// control/sinumerik.

#include <algorithm>
#include <cmath>

#include "control/sinumerik/sinumerik.h"

namespace kadr::sinumerik {
namespace {

/// The codes of a group in the order of the manual's list (spec/sinumerik 4.1); empty for a group that Kadr does not list.
const std::vector<std::string>& codes_in_group(int group) {
  static const std::map<int, std::vector<std::string>> lists = {{1, {"G0", "G1", "G2", "G3"}},
                                                                {6, {"G17", "G18", "G19"}},
                                                                {7, {"G40", "G41", "G42"}},
                                                                {8, {"G500", "G54", "G55", "G56", "G57"}},
                                                                {10, {"G60", "G64", "G641", "G642", "G643", "G644", "G645"}},
                                                                {12, {"G601", "G602", "G603"}},
                                                                {13, {"G70", "G71", "G700", "G710"}},
                                                                {14, {"G90", "G91"}},
                                                                {15, {"G93", "G94", "G95", "G96", "G97"}},
                                                                {18, {"G450", "G451"}}};
  static const std::vector<std::string> none;
  const auto list = lists.find(group);
  return list == lists.end() ? none : list->second;
}
constexpr int frames_group = 8, first_further_frame = 505, further_frames_from = 6;  // G505 is the sixth code of group 8

/// Returns the place of the code in force in its group, counted as in the manual's list (spec/sinumerik 4.1).
double place_in_group(const BlockContext& m, double group) {
  const auto number = static_cast<int>(group);
  if (number == 16) return 1.0 + static_cast<double>(sinumerik_of(m).memory.arc_feed);
  if (number == 17) return sinumerik_of(m).memory.goes_around ? 2 : 1;  // NORM, KONT
  const std::string name = std::to_string(number);
  for (std::size_t g = 1; g < m.def.groups.size(); ++g) {
    if (m.def.groups[g].name != name) continue;
    const std::int16_t row = m.modal.rows[g];
    if (row < 0) return 0;
    const std::string& code = m.def.codes[static_cast<std::size_t>(row)].code;
    const auto& list = codes_in_group(number);
    const auto at = std::find(list.begin(), list.end(), code);
    if (at != list.end()) return static_cast<double>(at - list.begin() + 1);
    if (number == frames_group && code.size() == 4)
      return std::strtod(code.c_str() + 1, nullptr) - first_further_frame + further_frames_from;
    return 0;
  }
  return 0;
}

constexpr int lengths[] = {3, 4, 5};
constexpr int most_markers = 1000;  // INFERRED: MD28256, MD28254 of the builder

}  // namespace

Result<double> component_of(const Frame& frame, std::size_t axis, const std::string& name, Span where) {
  if (name == "TR") return frame.shift[axis];
  if (name == "FI") return frame.fine[axis];
  if (axis < 3 && (name == "RT" || name == "SC" || name == "MI")) {
    const FrameParts parts = parts_of(frame.linear);
    if (name == "RT") return parts.angles[axis];
    if (name == "SC") return std::fabs(parts.scale[axis]);
    return parts.scale[axis] < 0 ? 1.0 : 0.0;
  }
  return fail(alarm(AlarmId::frame_component, where, std::string_view(name)));
}

Status set_component_of(Frame& frame, std::size_t axis, const std::string& name, double value, Span where) {
  if (name == "TR") frame.shift[axis] = value;
  else if (name == "FI") frame.fine[axis] = value;
  else if (axis < 3 && (name == "RT" || name == "SC" || name == "MI")) {
    FrameParts parts = parts_of(frame.linear);
    if (name == "RT") parts.angles[axis] = value;
    else if (name == "SC") parts.scale[axis] = parts.scale[axis] < 0 ? -value : value;
    else parts.scale[axis] = std::fabs(parts.scale[axis]) * (value != 0 ? -1 : 1);
    frame.linear = matrix_of(parts);
  } else {
    return fail(alarm(AlarmId::frame_component, where, std::string_view(name)));
  }
  return {};
}

std::optional<int> code_at_place(double group, double place) {
  if (!(group >= 1 && group <= 100) || !(place >= 1 && place <= 1000) || place != std::round(place)) return std::nullopt;
  const auto number = static_cast<int>(group), at = static_cast<int>(place);
  const auto& list = codes_in_group(number);
  if (at <= static_cast<int>(list.size())) return std::atoi(list[static_cast<std::size_t>(at) - 1].c_str() + 1);
  if (number == frames_group && at - further_frames_from < 95) return first_further_frame + at - further_frames_from;
  return std::nullopt;
}

std::optional<std::size_t> Sinumerik::axis_named(const BlockContext& m, std::string_view name) const {
  const auto found = std::find(m.axis_names.begin(), m.axis_names.end(), name);
  if (found == m.axis_names.end()) return std::nullopt;
  return static_cast<std::size_t>(found - m.axis_names.begin());
}

Frame Sinumerik::basic_frame(const BlockContext& m) const {
  Frame frame;
  frame.shift = m.tables.common;
  return frame;
}

// NOLINTNEXTLINE(readability-function-size): one branch per variable
Result<Value> Sinumerik::read_system(BlockContext& m, const std::string& name, const std::vector<Value>& indices, Span where) {
  const auto unknown = [&] { return fail(alarm(AlarmId::name_unknown, where, std::string_view(name))); };
  const auto index = [&](std::size_t i) { return i < indices.size() ? std::round(indices[i].number) : -1.0; };
  const auto axis = [&](std::size_t i) {
    return i < indices.size() && indices[i].type == Type::axis ? axis_named(m, indices[i].text) : std::nullopt;
  };
  const auto of_frame = [&](const Frame& frame, std::size_t first) -> Result<Value> {
    if (indices.size() == first) return frame_value(frame);
    const auto of = axis(first);
    if (!of || indices.size() != first + 2) return unknown();
    const auto value = component_of(frame, *of, indices[first + 1].text, where);
    if (!value) return fail(value.error());
    return real(*value);
  };
  if (name == "$PI") return real(pi);
  if (name == "$P_UIFR") {
    const double n = index(0);
    if (!(n >= 0) || n >= double{settable_frames}) return fail(alarm(AlarmId::index_range, where, std::string_view(name), n));
    return of_frame(memory.settable[static_cast<std::size_t>(n)], 1);
  }
  if (name == "$P_CHBFR" || name == "$P_NCBFR") {
    if (index(0) != 0 || name == "$P_NCBFR") return of_frame(Frame{}, 1);
    return of_frame(basic_frame(m), 1);
  }
  if (name == "$P_BFRAME" || name == "$P_ACTBFRAME") return of_frame(basic_frame(m), 0);
  if (name == "$P_IFRAME") return of_frame(memory.active, 0);
  if (name == "$P_PFRAME") return of_frame(memory.programmable, 0);
  if (name == "$P_ACTFRAME")
    return of_frame(chained(basic_frame(m), chained(memory.active, chained(memory.swivel, memory.programmable))), 0);
  if (const auto of = axis(0); of && indices.size() == 1) {
    if (name == "$AA_IW" || name == "$P_EP") return real(m.position.programmed[*of] * ((m.modal.diameter >> *of & 1U) != 0 ? 2 : 1));
    if (name == "$AA_IM") return real(m.position.machine[*of]);
    if (name == "$AA_MW") return real(memory.measured.work[*of] * ((m.modal.diameter >> *of & 1U) != 0 ? 2 : 1));
    if (name == "$AA_MM") return real(memory.measured.machine[*of]);
    if (name == "$AA_IB") return real(m.position.machine[*of] - m.frames.length[*of]);
    return unknown();
  }
  if (name.starts_with("$P_AXN") && name.size() == 7 && name[6] >= '1' && name[6] <= '3')
    return axis_value(m.axis_names[static_cast<std::size_t>(name[6] - '1')]);
  if (name == "$P_TOOLP") return integer(m.modal.tool_selected);
  if (name == "$P_GWPS") return boolean(m.modal.surface_speed);
  if (name == "$AC_MARKER" || name == "$AC_PARAM") {
    const double n = index(0);
    if (!(n >= 0) || n >= double{most_markers}) return fail(alarm(AlarmId::index_range, where, std::string_view(name), n));
    const auto found = memory.stored.find({name, static_cast<int>(n)});
    const double value = found == memory.stored.end() ? 0.0 : found->second;
    return name == "$AC_MARKER" ? integer(value) : real(value);
  }
  if (name == "$AC_MEA") {
    const double n = index(0);
    if (!(n >= 1 && n <= double{Measured::probes})) return fail(alarm(AlarmId::index_range, where, std::string_view(name), n));
    return integer(memory.measured.touched[static_cast<std::size_t>(n) - 1] ? 1 : 0);
  }
  if (name == "$P_PROG") {
    const double n = indices.empty() ? static_cast<double>(memory.levels.size() - 1) : index(0);
    if (!(n >= 0) || n >= static_cast<double>(memory.levels.size())) return text_value({});
    return text_value(memory.levels[static_cast<std::size_t>(n)].name);
  }
  if (name == "$P_TOOLNO") return integer(m.modal.tool);
  if (name == "$P_TOOL") return integer(memory.edge);
  if (name == "$P_TOOLR") return real(tool_radius(m));
  if (name == "$P_TOOLL" && index(0) >= 1 && index(0) <= 3) {
    const PlaneAxes plane = m.modal.axes;  // length 2 is that of the second axis of the plane, length 3 that of the first (13.1)
    const std::size_t by_number[] = {plane.normal, plane.second, plane.first};
    return real(m.frames.length[by_number[static_cast<std::size_t>(index(0)) - 1]]);
  }
  if (name == "$P_F") return real(m.modal.feed * 100 / memory.override_percent);
  if (name == "$P_S" && (indices.empty() || index(0) == 1)) return real(m.modal.rpm);
  if (name == "$P_SDIR" && (indices.empty() || index(0) == 1))
    return integer(m.modal.spindle == SpindleDir::cw ? 3 : m.modal.spindle == SpindleDir::ccw ? 4 : 5);
  if (name == "$P_GG") return integer(place_in_group(m, index(0)));
  if (name == "$P_SIM" || name == "$P_ISTEST" || name == "$P_SEARCH") return boolean(false);
  if (name == "$P_STACK") return integer(static_cast<double>(memory.levels.size() - 1));
  if (name.starts_with("$TC_DP") && indices.size() == 2) {
    const int number = std::atoi(name.c_str() + 6);
    const auto tool = static_cast<std::uint32_t>(std::max(0.0, index(0))), edge = static_cast<std::uint32_t>(std::max(0.0, index(1)));
    const auto own = memory.edges.find({tool, edge});
    const bool in_table = edge == 1 && tool < tool_rows && tool < m.tables.offsets.size();
    if (own == memory.edges.end() && !in_table) return fail(alarm(AlarmId::edge_missing, where, double(tool), double(edge)));
    const ToolOffset& offset = own != memory.edges.end() ? own->second : m.tables.offsets[tool];
    if (number == lengths[0]) return real(offset.length);
    if (number == 6) return real(offset.radius);
    if (number == 7) return real(offset.corner);
    if (number == 12) return real(offset.length_wear);
    if (number == 15) return real(offset.radius_wear);
    if (number <= 30) return real(0);
    return unknown();
  }
  return unknown();
}

Status Sinumerik::write_system(Interpreter& m, const std::string& name, const std::vector<Value>& indices, const Value& value, Span where) {
  const auto unknown = [&] { return fail(alarm(AlarmId::name_unknown, where, std::string_view(name))); };
  const auto index = [&](std::size_t i) { return i < indices.size() ? std::round(indices[i].number) : -1.0; };
  const auto into = [&](Frame& frame, std::size_t first) -> Status {
    if (indices.size() == first) {
      if (value.type != Type::frame) return fail(alarm(AlarmId::conversion_impossible, where, name_of(value.type), "FRAME"));
      frame = *value.frame;
      return {};
    }
    const auto of = indices.size() == first + 2 && indices[first].type == Type::axis ? axis_named(m, indices[first].text) : std::nullopt;
    if (!of) return unknown();
    if (!value.is_number()) return fail(alarm(AlarmId::conversion_impossible, where, name_of(value.type), "REAL"));
    return set_component_of(frame, *of, indices[first + 1].text, value.number, where);
  };
  if (name == "$P_UIFR") {
    const double n = index(0);
    if (!(n >= 0) || n >= double{settable_frames}) return fail(alarm(AlarmId::index_range, where, std::string_view(name), n));
    Frame frame = memory.settable[static_cast<std::size_t>(n)];
    KADR_TRY(into(frame, 1));
    if (!is_rotation(frame.linear)) return fail(alarm(AlarmId::not_available, where, "$P_UIFR SC, MI"));
    assign_settable(static_cast<std::size_t>(n), frame);
    return {};
  }
  if (name == "$AC_MARKER" || name == "$AC_PARAM") {
    const double n = index(0);
    if (!(n >= 0) || n >= double{most_markers}) return fail(alarm(AlarmId::index_range, where, std::string_view(name), n));
    const auto fits = converted(value, name == "$AC_MARKER" ? Type::integer : Type::real, where);
    if (!fits) return fail(fits.error());
    memory.stored[{name, static_cast<int>(n)}] = fits->number;
    return {};
  }
  if (name == "$P_PFRAME") {
    Frame frame = memory.programmable;
    KADR_TRY(into(frame, 0));
    return set_programmable(m, frame, where);
  }
  if (name == "$P_IFRAME") {
    Frame frame = memory.active;
    KADR_TRY(into(frame, 0));
    if (!is_rotation(frame.linear)) return fail(alarm(AlarmId::not_available, where, "$P_IFRAME SC, MI"));
    memory.active = frame;
    m.change_frames();
    return {};
  }
  if (name.starts_with("$TC_DP") && indices.size() == 2) {
    const int number = std::atoi(name.c_str() + 6);
    const double tool = index(0), edge = index(1);
    if (!value.is_number() || !(tool >= 1 && tool <= 32000) || !(edge >= 1 && edge <= 9)) return unknown();
    const auto t = static_cast<std::uint32_t>(tool), e = static_cast<std::uint32_t>(edge);
    const bool in_table = e == 1 && t < tool_rows && t < m.tables.offsets.size();
    ToolOffset& offset = in_table ? m.tables.offsets[t] : memory.edges[{t, e}];
    if (in_table) m.journal.keep(m.tables.offsets[t]);
    else if (const std::uint32_t row = edge_row(t, e); row < m.tables.offsets.size()) m.journal.keep(m.tables.offsets[row]);
    if (number == lengths[0]) offset.length = value.number;
    else if (number == 6) offset.radius = value.number;
    else if (number == 7) offset.corner = value.number;
    else if (number == 12) offset.length_wear = value.number;
    else if (number == 15) offset.radius_wear = value.number;
    else if (number != 1 && number != 2) return fail(alarm(AlarmId::not_available, where, std::string_view(name)));
    if (m.modal.tool != t || memory.edge != e) return {};
    if (!in_table && edge_row(t, e) < m.tables.offsets.size()) m.tables.offsets[edge_row(t, e)] = offset;
    m.change_frames();
    return {};
  }
  return unknown();
}

}  // namespace kadr::sinumerik
