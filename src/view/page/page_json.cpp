// Converts values of a run to JSON. Used by view/page/page_session; tests/serve.py compares the structure with docs/panel-protocol.md.

#include "view/page/page_json.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "config/json_text.h"
#include "motion/time/estimate.h"
#include "view/lathe_json.h"

namespace kadr {
namespace {

const char* name_of_kind(FolderEntry::Kind kind) {
  switch (kind) {
    case FolderEntry::Kind::folder: return "folder";
    case FolderEntry::Kind::program: return "program";
    case FolderEntry::Kind::setup: return "setup";
    case FolderEntry::Kind::tools: return "tools";
    default: return "other";
  }
}

const char* name_of_mark(TimeMark::Kind kind) {
  constexpr std::array names = {"tool", "alarm", "warning", "stop", "optional_stop", "message", "dwell", "end"};
  return names[std::size_t(kind)];
}

PageJson vec(Vec3 v) { return {v.x, v.y, v.z}; }
/// Returns the box of the path that the page displays. The box `exact` of the statistics is exact, but in coordinates of a work offset; the
/// box `seen` of the picture contains chords instead of arcs. So the result is `exact` if the two boxes agree, else `seen`.
Box shown_box(const Box& exact, const Box& seen) {
  constexpr double alike = 0.01;  // limit in mm; it is greater than the error of the chords that replace arcs
  const Vec3 least = exact.least - seen.least, most = exact.most - seen.most;
  const double off =
      std::max({std::fabs(least.x), std::fabs(least.y), std::fabs(least.z), std::fabs(most.x), std::fabs(most.y), std::fabs(most.z)});
  return exact.empty != seen.empty || off > alike ? seen : exact;
}

PageJson box_json(const Box& box) { return box.empty ? PageJson() : PageJson{vec(box.least), vec(box.most)}; }
/// Returns a number as JSON. NaN and infinity become null, because JSON does not have them.
PageJson number(double value) { return std::isfinite(value) ? PageJson(value) : PageJson(); }

const InForce* find(const std::vector<InForce>& all, InForce::Kind kind, const std::string& name) {
  for (const InForce& one : all)
    if (one.kind == kind && one.name == name) return &one;
  return nullptr;
}

PageJson of_axes(const std::vector<InForce>& all, InForce::Kind kind) {
  PageJson json = PageJson::object();
  for (const InForce& one : all)
    if (one.kind == kind) json[one.name] = number(one.value);
  return json;
}

bool is_changed(const std::vector<InForce>& before, const InForce& now) {
  const InForce* const then = find(before, now.kind, now.name);
  return then == nullptr || !(*then == now);
}

PageJson modal_json(const InstantState& s) {
  PageJson list = PageJson::array();
  for (const InForce& one : s.after)
    if (!one.code.empty()) list.push_back({{"group", one.name}, {"code", one.code}, {"changed", is_changed(s.before, one)}});
  return list;
}

PageJson variables_json(const InstantState& s) {
  PageJson list = PageJson::array();
  for (const InForce& one : s.after)
    if (one.kind == InForce::Kind::variable)
      list.push_back({{"name", one.name}, {"value", number(one.value)}, {"changed", is_changed(s.before, one)}});
  return list;
}

double value_of(const std::vector<InForce>& all, InForce::Kind kind) {
  for (const InForce& one : all)
    if (one.kind == kind) return one.value;
  return 0;
}

/// Returns the instant in s at which a tool is first put into the spindle; 0 if the tool is in the spindle from the start.
double first_use(const ProgramRun& run, std::uint32_t tool) {
  const std::string name = "T" + std::to_string(tool);
  for (const TimeMark& m : run.marks())
    if (m.kind == TimeMark::Kind::tool && m.text == name) return m.at;
  return 0;
}

/// Returns the distance of the tool from the end of its motion, mm, along X, Y and Z.
Vec3 way_left(const InstantState& s) { return Vec3{double(s.vertex.at[0]), double(s.vertex.at[1]), double(s.vertex.at[2])} - s.place; }

bool runs_on_lathe(const ProgramRun& run) { return run.opened().def->behaviour.lathe != Lathe::none; }

/// Adds the modes of a lathe, and shows its axes where they are: a cycle is one block that the tool takes long for.
void put_lathe_state(PageJson& json, const InstantState& s, const ProgramRun& run) {
  const auto& axes = run.control().axes();
  const AxisRoles roles = AxisRoles::of(axes, run.control().rotary());
  const Vec3 left = runs_on_lathe(run) ? s.block_end - s.place : way_left(s);
  const double back[3] = {left.x, left.y, left.z};
  Axes work{};
  for (std::size_t a = 0; a < std::min(axes.size(), max_axes); ++a)
    if (const InForce* const end = find(s.after, InForce::Kind::position, axes[a])) work[a] = end->value;
  for (std::size_t i = 0; i < 3; ++i) {
    if (roles.xyz[i] < 0) continue;
    const auto a = std::size_t(roles.xyz[i]);
    work[a] -= back[i];
    if (!runs_on_lathe(run)) continue;
    for (const char* const key : {"position", "machine"})
      if (PageJson& value = json[key][axes[a]]; value.is_number()) value = value.get<double>() - back[i];
  }
  const OpenedProgram& opened = run.opened();
  put_lathe(json, s.lathe, axes, work, most_rpm_of(opened.machine, opened.setup), runs_on_lathe(run));
}

/// Adds to the JSON the axis positions during the block, and the distances from these positions to the end of the motion.
void put_position(PageJson& json, const InstantState& s, const ProgramRun& run) {
  json["position"] = of_axes(s.after, InForce::Kind::position);
  json["machine"] = of_axes(s.after, InForce::Kind::machine);
  PageJson to_go = PageJson::object();
  const Vec3 left = way_left(s);
  const double gone[3] = {left.x, left.y, left.z};
  const auto& axes = run.control().axes();
  const AxisRoles roles = AxisRoles::of(axes, run.control().rotary());
  for (std::size_t i = 0; i < 3; ++i)
    if (roles.xyz[i] >= 0) to_go[axes[std::size_t(roles.xyz[i])]] = gone[i];
  json["togo"] = std::move(to_go);
  json["tip"] = vec(s.place);
}

}  // namespace

PageJson call_list_json(const std::vector<AlarmReport::Call>& calls) {
  PageJson list = PageJson::array();
  for (const AlarmReport::Call& call : calls)
    list.push_back({{"what", call.what},
                    {"line", call.line},
                    {"block", call.has_block ? PageJson(call.block) : PageJson()},
                    {"file", call.file.empty() ? PageJson() : PageJson(call.file)}});
  return list;
}

std::string dumped(const PageJson& json) { return json_text(json); }

PageJson files_json(const FolderList& list) {
  PageJson entries = PageJson::array();
  for (const FolderEntry& e : list.entries)
    entries.push_back({{"name", e.name}, {"kind", name_of_kind(e.kind)}, {"size", e.size}, {"modified", e.modified}});
  return {{"entries", std::move(entries)}, {"more", list.more}};
}

PageJson problem_json(const Finding& f, std::uint16_t file, const std::optional<QuickFix>& fix) {
  const std::string_view severity = name_of(f.severity);
  PageJson json = {
      {"id", name_of(f.id)}, {"severity", severity}, {"number", f.number},         {"text", f.text},   {"hint", f.hint},  {"file", file},
      {"line", f.line},      {"column", f.column},   {"end_column", f.end_column}, {"block", f.block}, {"calls", f.calls}};
  if (fix) json["fix"] = {{"text", fix->text}, {"line", f.line}, {"from", fix->from}, {"to", fix->to}, {"insert", fix->insert}};
  return json;
}

PageJson cut_finding_json(PageJson problem, const CutFinding& f) {
  problem["at"] = f.at_time;
  problem["place"] = vec(f.at);
  problem["depth"] = f.depth;
  problem["tool"] = f.tool;
  return problem;
}

PageJson cut_mark_json(const PageJson& reported, const CutFinding& f) {
  return {{"at", f.at_time}, {"kind", reported["severity"]}, {"line", f.origin.line}, {"text", reported["text"]}};
}

PageJson state_json(const InstantState& s, const ProgramRun& run) {
  PageJson json = {{"at", s.at},
                   {"number", s.origin.number},
                   {"line", s.origin.line},
                   {"column", s.origin.column},
                   {"file", s.origin.file},
                   {"file_name", s.line.file},
                   {"block", block_text(s.origin)},
                   {"text", s.line.text},
                   {"pass", s.pass},
                   {"depth", s.calls.size()},
                   {"calls", call_list_json(s.calls)}};
  put_position(json, s, run);
  json["feed"] = s.vertex.feed;
  json["speed"] = s.moves ? s.vertex.speed : 0;
  json["rpm"] = value_of(s.after, InForce::Kind::speed);
  json["tool"] = s.vertex.tool;
  json["modal"] = modal_json(s);
  json["offsets"] = {{"T", value_of(s.after, InForce::Kind::selected)},
                     {"D", value_of(s.after, InForce::Kind::offset)},
                     {"H", value_of(s.after, InForce::Kind::length_offset)},
                     {"length", of_axes(s.after, InForce::Kind::length)}};
  if (s.radius) json["offsets"]["radius"] = number(*s.radius);
  put_lathe_state(json, s, run);
  json["zero"] = of_axes(s.after, InForce::Kind::origin);
  json["variables"] = variables_json(s);
  json["seconds"] = s.at;
  json["left"] = std::max(0.0, run.seconds() - s.at);
  return json;
}

PageJson extents_json(const Statistics& s) { return {{"cutting", box_json(s.cutting_box())}, {"all", box_json(s.box())}}; }

PageJson bounds_json(const MachineBounds& space) {
  const auto box = [](const SpaceBox& b) {
    PageJson corners = {PageJson::array(), PageJson::array()};
    for (std::size_t i = 0; i < 3; ++i) {
      corners[0].push_back(b.least[i] ? PageJson(*b.least[i]) : PageJson());
      corners[1].push_back(b.most[i] ? PageJson(*b.most[i]) : PageJson());
    }
    return corners;
  };
  PageJson zones = PageJson::array();
  for (const ForbiddenZone& zone : space.zones) zones.push_back({{"number", zone.number}, {"inside", zone.inside}, {"box", box(zone.box)}});
  return {{"limits", box(space.limits)}, {"zones", std::move(zones)}};
}

namespace {

PageJson joints_json(const ProgramRun& run) {
  PageJson joints = PageJson::array();
  for (const PartJoint& j : run.path().joints())
    joints.push_back({{"axis", run.control().axes()[std::size_t(j.axis)]},
                      {"turns", j.turns},
                      {"direction", vec(j.direction)},
                      {"through", vec(j.through)},
                      {"from", j.from}});
  return joints;
}

}  // namespace

PageJson done_json(const ProgramRun& run, Lang lang) {
  const Statistics& s = run.statistics();
  const char* const state = run.end() == ProgramRun::End::ended ? "ended" : run.end() == ProgramRun::End::stopped ? "stopped" : "cancelled";
  PageJson tools = PageJson::array(), marks = PageJson::array();
  for (const Statistics::ToolUse& t : s.tools())
    tools.push_back({{"tool", t.tool}, {"from", first_use(run, t.tool)}, {"seconds", t.cutting_s}});
  for (const TimeMark& m : run.marks()) marks.push_back({{"at", m.at}, {"kind", name_of_mark(m.kind)}, {"line", m.line}, {"text", m.text}});
  const TimeSplit& time = s.time();
  return {{"state", state},
          {"seconds", run.seconds()},
          {"blocks", run.control().blocks()},
          {"vertices", run.path().vertices()},
          {"complete", !run.path().is_full()},
          {"zero", vec(run.path().zero())},
          {"joints", joints_json(run)},
          {"extents",
           {{"cutting", box_json(shown_box(s.cutting_box(), run.path().cutting_reach()))},
            {"all", box_json(shown_box(s.box(), run.path().reach()))}}},
          {"distances", {{"cutting", s.cutting_mm()}, {"rapid", s.rapid_mm()}}},
          {"times", {{"cutting", time.cutting}, {"rapid", time.rapid}, {"dwell", time.dwell}, {"tools", time.tool_change}}},
          {"tools", std::move(tools)},
          {"marks", std::move(marks)},
          {"axes", run.control().axes()},
          {"diameters", s.extents().x_is_diameter() ? PageJson::array({"X"}) : PageJson::array()},
          {"units", s.extents().unit() == LengthUnit::inch ? "inch" : "mm"},
          {"summary", s.text(run.control().blocks(), lang)}};
}

}  // namespace kadr
