// TOOL CALL, TOOL DEF (spec/heidenhain 2.3, 2.4). Used by control/heidenhain.

#include <cmath>

#include "control/heidenhain/heidenhain.h"

namespace kadr::heidenhain {

bool Heidenhain::knows_tool(const BlockContext& m, std::uint32_t tool) const {
  if (tool == 0 || table_.empty() || table_.contains(tool)) return true;
  return tool < m.tables.offsets.size() && !(m.tables.offsets[tool] == ToolOffset{});
}

Status Heidenhain::tool_definition(Interpreter& m, const KlartextBlock& block) {
  const KlartextWord* const word = block.find("T");
  if (word == nullptr || word->bare) return {};
  const auto number = value(m, block, *word);
  if (!number) return fail(number.error());
  if (!(*number >= 0 && *number <= 32'767.9)) return fail(alarm(AlarmId::value_out_of_range, word->where, "TOOL DEF", *number));
  const auto tool = static_cast<std::uint32_t>(*number);
  const KlartextWord *const length = block.find("L"), *const radius = block.find("R");
  if (length == nullptr && radius == nullptr) {
    m.modal.tool_selected = tool;
    m.emit(ToolSelect{tool, 0});
    return {};
  }
  if (m.tables.offsets.size() <= tool) m.tables.offsets.resize(tool + 1);
  ToolOffset made = m.tables.offsets[tool];
  if (length != nullptr) {
    const auto read = value(m, block, *length);
    if (!read) return fail(read.error());
    made.length = *read * m.unit_scale();
  }
  if (radius != nullptr) {
    const auto read = value(m, block, *radius);
    if (!read) return fail(read.error());
    made.radius = *read * m.unit_scale();
  }
  m.journal.keep(m.tables.offsets[tool]);
  m.tables.offsets[tool] = made;
  if (!table_.empty()) table_.insert(tool);
  return {};
}

// NOLINTNEXTLINE(readability-function-size): the words in the order of the manual
Status Heidenhain::tool_call(Interpreter& m, const KlartextBlock& block) {
  const auto number_of = [&](std::string_view name) -> Result<double> {
    const KlartextWord* const word = block.find(name);
    return word == nullptr ? Result<double>(0.0) : value(m, block, *word);
  };
  for (const std::size_t axis : {0U, 1U, 2U}) {
    constexpr std::string_view names[] = {"X", "Y", "Z"};
    if (block.find(names[axis]) == nullptr) continue;
    m.run_modes({axis == 2 ? Function::plane_xy : axis == 1 ? Function::plane_zx : Function::plane_yz});
  }
  if (const KlartextWord* const word = block.find("T")) {
    if (m.modal.radius_side != 0) return fail(alarm(AlarmId::compensation_active, word->where, "TOOL CALL"));
    std::uint32_t tool = m.modal.tool;
    if (!word->bare) {
      const auto number = value(m, block, *word);
      if (!number) return fail(number.error());
      if (!(*number >= 0 && *number <= 32'767.9)) return fail(alarm(AlarmId::value_out_of_range, word->where, "TOOL CALL", *number));
      tool = static_cast<std::uint32_t>(*number + 1e-9);
      if (!knows_tool(m, tool)) return fail(alarm(AlarmId::tool_not_found, word->where, *number));
    } else {
      constexpr std::uint32_t first_name = 30'000;  // tools with names are numbered in the order of their first call
      const std::string name = word->text.empty() ? memory.texts[block.target.index] : word->text;
      std::uint32_t& known = names_[name];
      if (known == 0) known = first_name + static_cast<std::uint32_t>(names_.size());
      tool = known;
    }
    if (m.tables.offsets.size() <= tool) m.tables.offsets.resize(tool + 1);
    m.modal.tool_selected = m.modal.tool = tool;
    m.modal.offset_number = tool;
    memory.delta_length = memory.delta_radius = 0;
    if (tool != 0) m.use.note(UseKind::tool, tool, m.origin);
    m.use.change_to(tool);
    if (m.modal.spindle != SpindleDir::stop) {
      m.modal.spindle = SpindleDir::stop;
      memory.spindle_code = memory.spindle_code < 0 ? 2 : memory.spindle_code;
    }
    m.emit(ToolChange{tool});
  }
  for (const bool is_length : {true, false}) {
    if (block.find(is_length ? "DL" : "DR") == nullptr) continue;
    const auto delta = number_of(is_length ? "DL" : "DR");
    if (!delta) return fail(delta.error());
    (is_length ? memory.delta_length : memory.delta_radius) = *delta * m.unit_scale();
  }
  if (block.find("S") != nullptr || block.find("VC") != nullptr) {
    auto speed = number_of(block.find("S") != nullptr ? "S" : "VC");
    if (!speed) return fail(speed.error());
    double rpm = *speed;
    if (block.find("S") == nullptr) rpm = tool_radius(m) > 0 ? 1000 * *speed / (2 * pi * tool_radius(m)) : 0;
    if (!(rpm >= 0)) return fail(alarm(AlarmId::value_out_of_range, block.where, "S", rpm));
    m.modal.rpm = rpm;
    if (m.modal.spindle == SpindleDir::cw || m.modal.spindle == SpindleDir::ccw) m.emit(Spindle{m.modal.spindle, rpm});
    else m.emit(Speed{rpm, false});
  }
  if (block.find("F") != nullptr) {
    const auto feed = number_of("F");
    if (!feed) return fail(feed.error());
    m.modal.feed = memory.tool_feed = *feed * m.unit_scale();
    m.modal.feed_known = true;
    m.modal.feed_mode = FeedMode::per_minute;
  }
  m.change_frames();
  return {};
}

}  // namespace kadr::heidenhain
