// Lists the codes, offsets and modes in force, one item each. A restart in mid-program, the panels and the debugger show this list. Tested
// by tests/session/stepping_test.cpp.

#include "action/in_force.h"

#include "control/interpreter.h"

namespace kadr {
namespace {

std::string spindle_code(SpindleDir dir) {
  switch (dir) {
    case SpindleDir::cw: return "M3";
    case SpindleDir::ccw: return "M4";
    case SpindleDir::orient: return "M19";
    default: return "M5";
  }
}

}  // namespace

std::vector<InForce> Interpreter::in_force() {
  using Kind = InForce::Kind;
  std::vector<InForce> all;
  const auto number = [&](Kind kind, std::string name, double value) { all.push_back({kind, std::move(name), {}, value}); };
  const auto axes = [&](Kind kind, const Axes& values) {
    for (std::size_t a = 0; a < axis_count; ++a) number(kind, axis_names[a], values[a]);
  };
  axes(Kind::position, position.work);
  axes(Kind::machine, position.machine);
  for (std::size_t g = 1; g < def.groups.size(); ++g)
    if (modal.rows[g] >= 0) all.push_back({Kind::code, def.groups[g].name, def.codes[static_cast<std::size_t>(modal.rows[g])].code});
  if (modal.feed_known) number(Kind::feed, "F", modal.feed);
  number(Kind::speed, "S", modal.rpm);
  all.push_back({Kind::spindle, {}, spindle_code(modal.spindle)});
  all.push_back({Kind::coolant, {}, modal.flood && modal.mist ? "M7 M8" : modal.flood ? "M8" : modal.mist ? "M7" : "M9"});
  number(Kind::tool, {}, modal.tool);
  number(Kind::selected, "T", modal.tool_selected);
  number(Kind::offset, "D", modal.offset_number);
  number(Kind::length_offset, "H", modal.length_number);
  axes(Kind::origin, frames.origin);
  axes(Kind::length, frames.length);
  if (transform.rotation != 0) number(Kind::rotation, {}, transform.rotation);
  for (std::size_t a = 0; a < axis_count; ++a)
    if (const double scale = transform.scale[a] * transform.mirror[a]; scale != 1) number(Kind::scale, axis_names[a], scale);
  for (const auto& [name, value] : ending().variables) number(Kind::variable, name, value);
  return all;
}

LatheModes Interpreter::lathe_modes() const {
  LatheModes modes;
  modes.diameters = modal.diameter;
  if (modal.feed_mode == FeedMode::per_revolution && modal.feed_known) modes.feed_per_turn = modal.feed;
  modes.surface = surface_speed();
  modes.offset_row = length_row();
  // On a lathe T alone puts the offsets into force, without a code for the length
  if (modes.offset_row == 0 && def.behaviour.lathe != Lathe::none) modes.offset_row = static_cast<std::uint32_t>(modal.length_number);
  if (modes.offset_row == 0) return modes;
  if (modes.offset_row < tables.offsets.size()) {
    modes.offset = tables.offsets[modes.offset_row];
    return modes;
  }
  Setup stated;
  if (!dialect->add_tables(*this, stated)) return modes;
  if (const auto row = stated.offsets.find(int(modes.offset_row)); row != stated.offsets.end()) modes.offset = row->second;
  return modes;
}

}  // namespace kadr
