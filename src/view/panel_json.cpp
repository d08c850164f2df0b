// Converts the state of an operator panel to JSON. Used by view/page/page_panel; tests/panel.py compares the structure with
// docs/panel-protocol.md.

#include "view/panel_json.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "motion/time/estimate.h"
#include "out/text/limit_text.h"
#include "view/lathe_json.h"

namespace kadr {
namespace {

/// Returns a number as JSON. NaN and infinity become null, because JSON does not have them.
PageJson finite(double value) { return std::isfinite(value) ? PageJson(value) : PageJson(); }

PageJson axes_json(const std::vector<std::string>& names, const Axes& values) {
  PageJson json = PageJson::object();
  for (std::size_t a = 0; a < std::min(names.size(), max_axes); ++a) json[names[a]] = finite(values[a]);
  return json;
}

PageJson stops_json(const std::map<std::size_t, StopPoint>& stops) {
  PageJson list = PageJson::array();
  for (const auto& [number, p] : stops)
    list.push_back(
        {{"number", number}, {"line", p.line}, {"pass", p.pass}, {"call", p.call}, {"condition", p.condition}, {"tool", p.tool}});
  return list;
}

/// Converts the channels of a machine to JSON; an empty list if the machine has only one channel.
PageJson channels_json(const std::vector<PanelChannel>& channels) {
  PageJson list = PageJson::array();
  for (const PanelChannel& one : channels) {
    const Axes work = one.block.work_of(one.sample.machine);
    PageJson waits;
    if (one.waits) waits = {{"code", one.waits->code}, {"channels", one.waits->channels}, {"here", one.waits->here}};
    list.push_back({{"number", one.number},
                    {"axes", one.axes},
                    {"position", axes_json(one.axes, work)},
                    {"machine", axes_json(one.axes, one.sample.machine)},
                    {"diameters", diameters_json(one.axes, one.block.modes ? one.block.modes->lathe.diameters : 0)},
                    {"feed", finite(one.block.feed)},
                    {"speed", finite(one.sample.speed)},
                    {"moves", one.sample.plays && !one.sample.held},
                    {"line", one.line.number},
                    {"text", one.line.text},
                    {"waits", std::move(waits)}});
  }
  return list;
}

/// Adds to the JSON the codes in force, and the values in force that belong to no axis (feed, tool, …).
void put_modes(PageJson& json, const PanelModes& modes) {
  PageJson codes = PageJson::array();
  for (const InForce& one : modes.in_force)
    if (!one.code.empty()) codes.push_back({{"group", one.name}, {"code", one.code}});
  json["modal"] = std::move(codes);
  const auto value = [&](InForce::Kind kind) {
    const auto found = std::find_if(modes.in_force.begin(), modes.in_force.end(), [&](const InForce& one) { return one.kind == kind; });
    return found == modes.in_force.end() ? PageJson() : finite(found->value);
  };
  json["rpm"] = value(InForce::Kind::speed);
  json["tool"] = value(InForce::Kind::tool);
  json["offsets"] = {
      {"T", value(InForce::Kind::selected)}, {"D", value(InForce::Kind::offset)}, {"H", value(InForce::Kind::length_offset)}};
  PageJson zero = PageJson::object();
  for (const InForce& one : modes.in_force)
    if (one.kind == InForce::Kind::origin) zero[one.name] = finite(one.value);
  json["zero"] = std::move(zero);
  json["calls"] = call_list_json(modes.calls);
}

PageJson real_json(const RealMachine& real) {
  return {{"port", real.port},       {"controller", real.controller},   {"state", real.state},  {"inputs", real.inputs},
          {"age", finite(real.age)}, {"pending", finite(real.pending)}, {"lost", real.is_lost}, {"locked", real.is_locked}};
}

}  // namespace

const char* name_of(PanelMode mode) {
  constexpr std::array names = {"standing", "running", "held", "ended", "alarm", "emergency"};
  return names[std::size_t(mode)];
}

PageJson panel_json(const PanelState& s, const std::vector<std::string>& axes, const OpenedProgram& opened, Lang lang) {
  const Axes work = s.block.work_of(s.sample.machine);
  Axes left{};
  for (std::size_t a = 0; a < max_axes; ++a) left[a] = s.sample.plays ? s.block.work[a] - work[a] : 0;
  PageJson json = {{"mode", name_of(s.mode)},
                   {"instant", s.sample.instant},
                   {"position", axes_json(axes, work)},
                   {"machine", axes_json(axes, s.sample.machine)},
                   {"togo", axes_json(axes, left)},
                   {"feed", finite(s.block.feed)},
                   {"speed", finite(s.sample.speed)},
                   {"share", finite(s.sample.share * s.block.factor)},
                   {"override", s.shares.feed},
                   {"rapid", s.shares.rapid},
                   {"spindle", s.shares.spindle},
                   {"dry_feed", s.shares.dry_feed},
                   {"line", s.line.number},
                   {"file", !s.entered && (s.mode == PanelMode::running || s.mode == PanelMode::held) ? s.block.origin.file : 0},
                   {"text", s.line.text},
                   {"number", s.block.origin.number},
                   {"entered", s.entered},
                   {"single", s.single},
                   {"optional_stop", s.optional_stop},
                   {"skip", s.skip},
                   {"stops", stops_json(s.stops)},
                   {"hit", s.hit},
                   {"told", s.message},
                   {"why", s.why},
                   {"stop_line", s.stop.number},
                   {"stop_text", s.stop.text},
                   {"goes_there", s.goes_there},
                   {"asks", s.asks},
                   {"takes_tables", s.takes_tables},
                   {"not_kept", s.save_fault},
                   {"can_undo", s.can_undo},
                   {"limit", s.limit ? limit_text(s.limit->by, s.limit->rapid, axes, lang) : std::string()},
                   {"channels", channels_json(s.channels)},
                   {"blocks", s.blocks}};
  json["real"] = s.real ? real_json(*s.real) : PageJson();
  static const PanelModes none;
  const PanelModes& modes = s.block.modes ? *s.block.modes : none;
  put_modes(json, modes);
  put_lathe(json, modes.lathe, axes, work, most_rpm_of(opened.machine, opened.setup), opened.def->behaviour.lathe != Lathe::none);
  if (json["rpm"].is_number()) json["rpm"] = json["rpm"].get<double>() * s.shares.spindle;
  return json;
}

}  // namespace kadr
