// Converts the events of a machine to the JSON in which they are saved. Used by view/page/page_panel, view/page/page_tables; tested by
// tests/panel_kills.py.

#include "view/panel_content.h"

#include <fmt/chrono.h>

#include <chrono>
#include <cmath>

#include "config/json_text.h"
#include "view/panel_json.h"

namespace kadr {

std::string log_entry(const std::string& kind, const std::string& text, std::uint32_t line) {
  const auto now = std::chrono::system_clock::now();
  const std::string at = fmt::format("{:%FT%T}Z", fmt::gmtime(std::chrono::system_clock::to_time_t(now)));
  return dumped({{"at", at}, {"kind", kind}, {"text", text}, {"line", line}});
}

std::string spot_text(const PanelLocation& spot) {
  const auto list_of = [](const Axes& axes) {
    PageJson list = PageJson::array();
    for (const double value : axes) list.push_back(std::isfinite(value) ? PageJson(value) : PageJson(0));
    return list;
  };
  PageJson machine = list_of(spot.machine), stands = PageJson::array();
  for (const Axes& axes : spot.stands) stands.push_back(list_of(axes));
  return dumped({{"mode", name_of(spot.mode)},
                 {"number", spot.number},
                 {"line", spot.line},
                 {"file", spot.file},
                 {"text", spot.text},
                 {"machine", std::move(machine)},
                 {"stands", std::move(stands)}});
}

std::optional<PanelLocation> spot_of(const std::string& text) {
  const PageJson json = ordered_json_of(text);
  if (!json.is_object() || !json.contains("machine") || !json["machine"].is_array()) return std::nullopt;
  PanelLocation spot;
  spot.number = json.value("number", 0u), spot.line = json.value("line", 0u);
  spot.file = json.value("file", ""), spot.text = json.value("text", "");
  const auto axes_of = [](const PageJson& list) {
    Axes axes{};
    for (std::size_t a = 0; a < std::min(max_axes, list.size()); ++a)
      if (list[a].is_number()) axes[a] = list[a].get<double>();
    return axes;
  };
  spot.machine = axes_of(json["machine"]);
  if (const auto stands = json.find("stands"); stands != json.end() && stands->is_array())
    for (const PageJson& list : *stands)
      if (list.is_array()) spot.stands.push_back(axes_of(list));
  return spot;
}

}  // namespace kadr
