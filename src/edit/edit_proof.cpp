// EditProof: proves that an edit has changed what it was to change. Used by edit/editing; tested by tests/edit.py.

#include "edit/edit_proof.h"

#include <algorithm>

#include "config/setup/setup_names.h"
#include "convert/open_states.h"

namespace kadr {
namespace {

constexpr int other_states = 2;

/// Returns the name that a work system has in a set-up: "G54", "G54.1 P3".
std::string name_of(const SystemCode& system) {
  std::string name = "G" + std::to_string(system.code / 10);
  if (system.code % 10 != 0) name += "." + std::to_string(system.code % 10);
  if (system.further) name += " P" + std::to_string(*system.further);
  return name;
}

/// Returns a pointer to the offsets of a work system in the set-up; nullptr if the control has no such system.
AxisValues* zero_of(Setup& setup, const ControlDef& def, const std::string& name) {
  for (const WorkSystem& system : work_systems(def)) {
    if (system.name != name || !system.works) continue;
    return allows_key(def, "zeros") ? &setup.zeros[static_cast<int>(system.row)] : &setup.work_offsets[name];
  }
  return nullptr;
}

/// Returns the set-up with which the old program does what the new program does with `setup`.
Setup setup_of_old(const Setup& setup, const ControlDef& def, const Edits& edits) {
  Setup old = setup;
  Setup source = setup;
  for (const auto& [from, to] : edits.work_systems) {
    const AxisValues* const there = zero_of(source, def, name_of(to));
    if (AxisValues* const here = zero_of(old, def, name_of(from)); here != nullptr && there != nullptr) *here = *there;
  }
  for (const auto& [from, to] : edits.tools) {
    const auto there = source.offsets.find(static_cast<int>(to));
    if (there != source.offsets.end()) old.offsets[static_cast<int>(from)] = there->second;
    if (setup.tool == static_cast<int>(to)) old.tool = static_cast<int>(from);
  }
  if (edits.shift.empty()) return old;
  // The old program runs at another place of the machine: its zeros lie where the new program's positions are
  const auto shift = [&](AxisValues& zero) {
    for (const auto& [axis, by] : edits.shift) zero[axis] += by;
  };
  if (allows_key(def, "zeros"))
    for (auto& [number, zero] : old.zeros) shift(zero);
  else
    for (const WorkSystem& system : work_systems(def))
      if (system.works) shift(old.work_offsets[system.name]);
  if (old.start_in_work)
    for (const auto& [axis, by] : edits.shift) old.start[axis] -= by;
  return old;
}

/// Returns the function that changes the course of the old program to what is expected of the new one; empty if nothing changes.
std::function<void(CourseItem&)> expected_by(const Edits& edits) {
  if (edits.feeds.empty() && edits.speeds.empty() && edits.tools.empty()) return {};
  const auto new_tool = [&edits](std::uint32_t tool) {
    for (const auto& [from, to] : edits.tools)
      if (from == tool) return to;
    return tool;
  };
  return [&edits, new_tool](CourseItem& item) {
    CourseState& state = item.state;
    const double speed = factor_for(edits.speeds, state.tool);
    state.speed *= speed;
    if (state.move == CourseMove::feed || state.move == CourseMove::probe) {
      const bool keeps_lead = state.taps && state.unit == FeedUnit::mm_per_min;
      state.feed *= keeps_lead ? speed : state.taps ? 1 : factor_for(edits.feeds, state.tool);
    }
    state.tool = new_tool(state.tool);
    if (item.act && item.act->kind == CourseEvent::Kind::tool) {
      CourseEvent changed = *item.act;
      changed.value = new_tool(static_cast<std::uint32_t>(changed.value));
      item.act = std::make_shared<const CourseEvent>(std::move(changed));
    }
  };
}

}  // namespace

tl::expected<EditProof, std::string> prove_edit(const EditSpec& spec, const std::shared_ptr<ByteSource>& text) {
  auto opened = spec.old_program(spec.setup);
  if (!opened) return tl::unexpected(opened.error());
  const ControlDef& def = (*opened)->def();
  const ProgramShape shape(spec.source_text, def, spec.stop);
  ProgramNames names = shape.names();
  for (const auto& [from, to] : spec.edits.tools) names.tools.insert(to);
  std::vector<Setup> setups{spec.setup};
  for (OpenState& state : open_states(spec.setup, def, def, (*opened)->control().axes(), names, other_states))
    setups.push_back(std::move(state.setup));
  CompareRules rules;
  rules.tolerance = spec.tolerance;
  rules.expected_of_a = expected_by(spec.edits);
  rules.stop = spec.stop;
  EditProof proof;
  for (const Setup& setup : setups) {
    auto a = spec.old_program(setup_of_old(setup, def, spec.edits));
    if (!a) return tl::unexpected(a.error());
    auto b = spec.new_program(text, setup);
    if (!b) return tl::unexpected(b.error());
    Comparison made = compare_sessions(std::move(*a), std::move(*b), rules);
    // A further state in which the old program itself stops says nothing
    if (proof.states > 0 && made.stopped_a && made.stopped_b) continue;
    proof.comparison = std::move(made);
    if (!proof.is_proven()) return proof;
    ++proof.states;
  }
  return proof;
}

}  // namespace kadr
