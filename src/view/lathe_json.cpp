// Converts what the panel of a lathe shows to JSON. Tested by tests/view/lathe_json_test.cpp.

#include "view/lathe_json.h"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace kadr {
namespace {

PageJson limit_json(double rpm) { return rpm > 0 && rpm < SurfaceSpeed::no_limit ? PageJson(rpm) : PageJson(); }

PageJson offset_json(std::uint32_t row, const ToolOffset& o) {
  return {{"row", row},
          {"geometry", {{"X", o.length_x}, {"Y", o.length_y}, {"Z", o.length}}},
          {"wear", {{"X", o.length_x_wear}, {"Y", o.length_y_wear}, {"Z", o.length_wear}}},
          {"radius", o.whole_radius()},
          {"tip", o.tip_position}};
}

}  // namespace

PageJson diameters_json(const std::vector<std::string>& axes, AxisMask diameters) {
  PageJson names = PageJson::array();
  for (std::size_t a = 0; a < std::min(axes.size(), max_axes); ++a)
    if ((diameters >> a & 1U) != 0) names.push_back(axes[a]);
  return names;
}

void put_lathe(PageJson& json, const LatheModes& modes, const std::vector<std::string>& axes, const Axes& work, double most_rpm,
               bool is_lathe) {
  json["diameters"] = diameters_json(axes, modes.diameters);
  json["feed_per_turn"] = modes.feed_per_turn ? PageJson(*modes.feed_per_turn) : PageJson();
  json["surface"] = PageJson();
  if (modes.surface.on) {
    const double machine_most = most_rpm > 0 ? most_rpm : SurfaceSpeed::no_limit;
    json["surface"] = {{"speed", modes.surface.metres}, {"most", limit_json(modes.surface.most)}};
    json["rpm"] = limit_json(std::min(modes.surface.rpm(work), machine_most));
  }
  const bool has_offset = modes.offset_row != 0 && (is_lathe || modes.diameters != 0);
  json["tool_offset"] = has_offset ? offset_json(modes.offset_row, modes.offset) : PageJson();
}

}  // namespace kadr
