// Answers the requests `restart` and `go_there` (to continue in mid-program), and `move_along_path` (to move the axes by hand along a
// path). Used by view/page/page_session; tested by tests/panel_restart.py.

#include <fmt/core.h>

#include "out/text/in_force_text.h"
#include "texts/panel_page.h"
#include "view/page/page_inside.h"
#include "view/panel_json.h"

namespace kadr {
namespace {

constexpr std::size_t max_sheet_variables = 1000;  // greatest number of variables on a restart sheet
constexpr std::size_t max_points = 100;            // greatest number of motions in a path that a request contains

PageJson value_json(const std::optional<InForce>& one) {
  if (!one) return PageJson();
  if (!one->code.empty()) return one->code;
  return one->value;
}

const char* name_of(PanelSheet::By by) {
  switch (by) {
    case PanelSheet::By::path: return "way";
    case PanelSheet::By::line: return "line";
    case PanelSheet::By::memory: return "memory";
    default: return "";
  }
}

/// Converts the rows of a restart sheet to JSON. `before` is a prefix for the key of each row.
PageJson rows_json(const std::vector<PanelSheet::Row>& rows, const std::string& before = {}) {
  PageJson list = PageJson::array();
  std::size_t variables = 0;
  for (const PanelSheet::Row& row : rows) {
    const InForce& one = row.required ? *row.required : *row.now;
    if (one.kind == InForce::Kind::variable && ++variables > max_sheet_variables) continue;
    const std::string key = key_of(one);
    list.push_back({{"key", before + key},
                    {"kind", key.substr(0, key.find(':'))},
                    {"name", one.name},
                    {"wanted", value_json(row.required)},
                    {"now", value_json(row.now)},
                    {"by", name_of(row.by)},
                    {"may_be_left", row.may_be_left}});
  }
  return list;
}

PageJson codes_json(const std::vector<BlockSearch::Code>& codes) {
  PageJson list = PageJson::array();
  for (const BlockSearch::Code& code : codes) list.push_back({{"text", code.text}, {"line", code.origin.line}});
  return list;
}

PageJson search_json(const std::optional<BlockSearch>& search, Lang lang) {
  if (!search) return {};
  return {{"carried_out", codes_json(search->carried_out)},
          {"of_no_group", codes_json(search->of_no_group)},
          {"forgotten", in_force_text(search->forgotten, lang, "")}};
}

PageJson path_json(const std::vector<WayPoint>& path, const std::vector<std::string>& axes) {
  PageJson list = PageJson::array();
  for (const WayPoint& point : path) {
    PageJson to = PageJson::object();
    for (std::size_t a = 0; a < axes.size() && a < max_axes; ++a)
      if ((point.named >> a & 1U) != 0) to[axes[a]] = point.machine[a];
    list.push_back({{"rapid", point.rapid}, {"to", std::move(to)}, {"feed", point.feed}});
  }
  return list;
}

tl::unexpected<std::string> no_path() { return tl::unexpected(translated(texts::panel_page::way_wanted)); }

/// Reads the motions of a path from a request. Returns an error sentence if a motion is invalid.
tl::expected<std::vector<WayPoint>, std::string> path_of(const PageJson& question, const std::vector<std::string>& axes) {
  const auto list = question.find("way");
  std::vector<WayPoint> path;
  if (list == question.end() || !list->is_array() || list->size() > max_points) return no_path();
  for (const PageJson& entry : *list) {
    if (!entry.is_object() || !entry.contains("to") || !entry["to"].is_object()) return no_path();
    WayPoint point;
    point.rapid = entry.value("rapid", false);
    point.feed = value_in<double>(entry, "feed", 0);
    for (const auto& [axis, value] : entry["to"].items()) {
      const auto found = std::find(axes.begin(), axes.end(), axis);
      if (found == axes.end() || !value.is_number()) return no_path();
      const auto a = std::size_t(found - axes.begin());
      point.named |= AxisMask{1} << a;
      point.machine[a] = value.get<double>();
    }
    path.push_back(point);
  }
  return path;
}

/// Reads the paths of a request: the path of the program's own channel, or the paths of several channels in the order in which the axes
/// must travel them.
tl::expected<std::vector<PanelPath>, std::string> paths_of(const PageJson& question, const PanelMachine& machine) {
  const auto list = question.find("ways");
  if (list == question.end()) {
    auto own = path_of(question, machine.axes());
    if (!own) return tl::unexpected(own.error());
    return std::vector<PanelPath>{{machine.own(), std::move(*own)}};
  }
  if (!list->is_array() || list->size() > machine.channel_count()) return no_path();
  std::vector<PanelPath> paths;
  for (const PageJson& entry : *list) {
    if (!entry.is_object()) return no_path();
    std::size_t channel = 0;
    while (channel < machine.channel_count() && std::uint32_t(machine.number_of(channel)) != count_in(entry, "channel", 0)) ++channel;
    if (channel == machine.channel_count()) return no_path();
    auto path = path_of(entry, machine.axes(channel));
    if (!path) return tl::unexpected(path.error());
    paths.push_back({channel, std::move(*path)});
  }
  return paths;
}

PanelSearch::SearchRequest search_request_in(const PageJson& question) {
  PanelSearch::SearchRequest request{stop_point_of(question), count_in(question, "hole", 0), false};
  const auto by = question.find("by_control");
  request.by_control = by != question.end() && by->is_boolean() && by->get<bool>();
  return request;
}

/// Returns the machine position of the work zero in mm, including the tool length offset.
PageJson zero_json(const ToolPosition& stand, const std::vector<std::string>& axes) {
  PageJson zero = PageJson::object();
  for (std::size_t a = 0; a < axes.size() && a < max_axes; ++a) zero[axes[a]] = stand.machine[a] - stand.work[a];
  return zero;
}

/// Converts the states of the other channels to JSON; an empty list if the machine has only one channel.
PageJson other_channels_json(const RestartPoint& place, const std::vector<PanelSheet>& sheets, const PanelMachine& machine, Lang lang) {
  PageJson list = PageJson::array();
  for (std::size_t i = 0; i < place.other_channels.size(); ++i) {
    const OtherChannelState& one = place.other_channels[i];
    const PanelSheet& sheet = sheets[i + 1];
    const auto& axes = machine.axes(one.channel);
    list.push_back({{"number", one.number},
                    {"line", one.is_over ? 0 : one.line.number},
                    {"text", one.is_over ? std::string() : one.line.text},
                    {"stands", one.is_over    ? "over"
                               : one.waits    ? "waits"
                               : one.in_block ? "within"
                                              : "before"},
                    {"rows", rows_json(sheet.rows, fmt::format("{}/", one.number))},
                    {"way", path_json(sheet.path, axes)},
                    {"zero", zero_json(one.restart.stand, axes)},
                    {"blocks", sheet.blocks.blocks},
                    {"by_hand", in_force_text(sheet.blocks.by_hand, lang, "")}});
  }
  return list;
}

}  // namespace

StopPoint stop_point_of(const PageJson& question) {
  StopPoint point;
  point.line = count_in(question, "line", 0), point.pass = count_in(question, "pass", 0);
  point.file = value_in<std::string>(question, "of_file", "");
  point.call = value_in<std::string>(question, "call", ""), point.condition = value_in<std::string>(question, "condition", "");
  point.number = count_in(question, "number", 0), point.tool = count_in(question, "tool", 0);
  return point;
}

tl::expected<PanelSearch::Answer, Refusal> PageSession::Inside::find_place(PanelMachine& machine, const PageJson& question) const {
  const PanelSearch::SearchRequest request = search_request_in(question);
  if (request.target == StopPoint{}) return refused(translated(texts::panel_page::stop_point_wanted));
  PanelSearch::Answer found = machine.find(request);
  if (found.ready && !found.place) return refused(found.error);
  return found;
}

/// Searches for the restart position. If `ready` is false in the answer, the search is not complete, and the page must repeat the request.
PageSession::Inside::Answer PageSession::Inside::restart(const PageJson& question) {
  const auto machine = held_machine();
  if (!machine) return tl::unexpected(machine.error());
  const auto found = find_place(**machine, question);
  if (!found) return tl::unexpected(found.error());
  if (!found->ready) return PageJson{{"ready", false}};
  constexpr double lowest = -1e9;
  const WayRules rules{value_in<double>(question, "clearance", lowest), value_in<double>(question, "above", 2),
                       value_in<double>(question, "feed", 100)};
  const RestartPoint& place = *found->place;
  const auto sheets = (*machine)->sheets(found->place, rules);
  if (!sheets) return refused(sheets.error());
  const PanelSheet* const sheet = &sheets->front();
  const auto& axes = (*machine)->axes();
  PageJson calls = call_list_json(place.calls);
  show_files(calls);
  return PageJson{{"ready", true},
                  {"line", place.line.number},
                  {"file", place.restart.at.file == 0 ? std::string() : server.folder.shown(place.line.file)},
                  {"text", place.line.text},
                  {"calls", std::move(calls)},
                  {"rows", rows_json(sheet->rows)},
                  {"way", path_json(sheet->path, axes)},
                  {"normal", place.restart.normal < axes.size() ? axes[place.restart.normal] : std::string()},
                  {"zero", zero_json(place.restart.stand, axes)},
                  {"blocks", sheet->blocks.blocks},
                  {"by_hand", in_force_text(sheet->blocks.by_hand, lang, "")},
                  {"search", search_json(place.by_control, lang)},
                  {"number", (*machine)->number_of((*machine)->own())},
                  {"beside", other_channels_json(place, *sheets, **machine, lang)}};
}

/// Moves the axes by hand along a path.
PageSession::Inside::Answer PageSession::Inside::move_along_path(const PageJson& question) {
  const auto machine = held_machine();
  if (!machine) return tl::unexpected(machine.error());
  const auto path = path_of(question, (*machine)->axes());
  if (!path) return refused(path.error());
  const auto went = (*machine)->move_along_path(*path);
  if (!went) return refused(went.error());
  return PageJson::object();
}

PageSession::Inside::Answer PageSession::Inside::go_there(const PageJson& question) {
  const auto machine = held_machine();
  if (!machine) return tl::unexpected(machine.error());
  const auto found = find_place(**machine, question);
  if (!found) return tl::unexpected(found.error());
  if (!found->ready) return refused(translated(texts::panel_page::still_searching));
  auto paths = paths_of(question, **machine);
  if (!paths) return refused(paths.error());
  std::set<std::string> left;
  if (const auto list = question.find("leave"); list != question.end() && list->is_array())
    for (const PageJson& key : *list)
      if (key.is_string()) left.insert(key.get<std::string>());
  const auto went = (*machine)->go_there(found->place, left, std::move(*paths));
  if (!went) return refused(went.error());
  return PageJson::object();
}

}  // namespace kadr
