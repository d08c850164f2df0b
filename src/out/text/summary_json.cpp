// Formats the summary of a run as JSON. This file is used by cli/run and tested by tests/run_summary.py, which compares it with the text.

#include "out/text/summary_json.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "config/json_text.h"

namespace kadr {
namespace {

using Json = nlohmann::ordered_json;

/// Rounds a value to 1e-9, since further digits are not significant.
double figure(double value) { return std::round(value * 1e9) / 1e9 + 0.0; }

const char* word_of(LengthUnit unit) { return unit == LengthUnit::mm ? "mm" : unit == LengthUnit::inch ? "inch" : "mixed"; }

const char* word_of(TimeBasis basis) {
  return basis == TimeBasis::programmed ? "programmed" : basis == TimeBasis::limited ? "limited" : "accelerated";
}

Json extents_json(const Statistics& statistics, RunExtents::Of of) {
  Json all = Json::array();
  for (const RunExtents::Row& row : statistics.extent_rows(of)) {
    Json axes = Json::object();
    for (const RunExtents::AxisRange& axis : row.axes) axes[axis.name] = {figure(axis.least), figure(axis.most)};
    all.push_back({{"system", row.system.empty() ? Json() : Json(row.system)}, {"axes", axes}});
  }
  return all;
}

/// Returns the least and the greatest spindle speed; null instead of the greatest if nothing limits it.
Json speeds_json(const Range& rpm) {
  return Json::array({figure(rpm.least), rpm.most < SpindleTurning::fastest ? Json(figure(rpm.most)) : Json()});
}

Json time_json(const TimeSplit& t, TimeBasis basis) {
  return {{"all", figure(t.total())}, {"cutting", figure(t.cutting)},         {"rapid", figure(t.rapid)},
          {"dwell", figure(t.dwell)}, {"tool_change", figure(t.tool_change)}, {"basis", word_of(basis)}};
}

Json planned_json(const PlannedTime& t) {
  const auto share = [](const PlannedTime::Share& s) -> Json {
    return {{"all", figure(s.all)}, {"speeding_up", figure(s.speeding_up)}, {"slowing_down", figure(s.slowing_down)}};
  };
  return {{"all", figure(t.total())},
          {"cutting", share(t.cutting)},
          {"rapid", share(t.rapid)},
          {"dwell", figure(t.dwell)},
          {"tool_change", figure(t.tool_change)}};
}

Json channel_json(const ChannelSummary& channel, PlannerMode counts) {
  const Statistics& s = *channel.statistics;
  const bool planned_counts = channel.planned != nullptr && counts == PlannerMode::optimal;
  Json tools = Json::array();
  for (const Statistics::ToolUse& use : s.tools()) tools.push_back({{"tool", use.tool}, {"cutting", figure(use.cutting_s)}});
  return {{"channel", channel.channel},
          {"blocks", channel.blocks},
          {"motions",
           {{"all", s.rapids() + s.feeds() + s.arcs() + s.others()},
            {"rapid", s.rapids()},
            {"feed", s.feeds()},
            {"arcs", s.arcs()},
            {"other", s.others()}}},
          {"unit", word_of(s.extents().unit())},
          {"diameters", s.extents().x_is_diameter() ? Json::array({"X"}) : Json::array()},
          {"path", {{"cutting", figure(s.cutting_mm())}, {"rapid", figure(s.rapid_mm())}}},
          {"cutting", extents_json(s, RunExtents::Of::cutting)},
          {"all", extents_json(s, RunExtents::Of::all)},
          {"surface_speed_rpm", s.surface_speeds() ? speeds_json(*s.surface_speeds()) : Json()},
          {"time", planned_counts ? Json() : time_json(s.time(), s.basis())},
          {"least_time", channel.planned != nullptr ? planned_json(*channel.planned) : Json()},
          {"waited", figure(channel.waited)},
          {"motions_without_time", s.time().unknown},
          {"tools", tools},
          {"alarms", s.alarms()},
          {"warnings", s.warnings()}};
}

}  // namespace

std::string summary_json(const RunSummary& run) {
  double longest = 0;
  Json channels = Json::array();
  for (const ChannelSummary& channel : run.channels) {
    channels.push_back(channel_json(channel, run.counts));
    const bool planned_counts = channel.planned != nullptr && run.counts == PlannerMode::optimal;
    const double busy = planned_counts ? channel.planned->total() : channel.statistics->time().total();
    longest = std::max(longest, busy + channel.waited);
  }
  const Json all = {{"program", run.program},
                    {"control", run.control},
                    {"complete", run.complete},
                    {"machining_time", figure(longest)},
                    {"channels", channels}};
  return json_text(all, 1) + "\n";
}

}  // namespace kadr
