// EditProof: proves that an edit has changed what it was to change. Used by edit/editing; tested by tests/edit.py.

#include "edit/edit_proof.h"

#include <algorithm>

#include "config/setup/setup_names.h"
#include "convert/open_states.h"
#include "edit/expected_course.h"

namespace kadr {
namespace {

constexpr int other_states = 2;
// Permitted distances of the paths, mm. Words that no edit rounds state the same positions, so that their last digit counts.
constexpr double of_arithmetic = 1e-6;
constexpr double of_distances = 2e-4;  // distances in inches have five decimals
constexpr double chord = 1e-4;         // both programs have the same arcs, so that their chords are the same too

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

/// Returns the permitted distance of the paths, mm.
double tolerance_of(const EditSpec& spec, const ControlDef& def) {
  std::vector<PlaneMap> maps = spec.edits.places;
  if (spec.edits.plane) maps.push_back(*spec.edits.plane);
  const auto any = [&](bool (*is)(const PlaneMap&)) { return std::any_of(maps.begin(), maps.end(), is); };
  // Turned coordinates are rounded to the increment of the words
  if (any([](const PlaneMap& map) { return !map.is_quarter(); })) return std::max(spec.tolerance, usual_tolerance(def, def, true));
  if (spec.tolerance > 0) return spec.tolerance;
  const bool adds = !spec.edits.shift.empty() || any([](const PlaneMap& map) { return map.by.x != 0 || map.by.y != 0; });
  return adds ? of_distances : of_arithmetic;
}

/// Puts the start of the run, if the set-up does not state it, on a point of the plane that the map leaves where it is: a program that
/// begins with increments, or that sets the position, is mapped about the point where it starts.
void start_at_fixed_point(Setup& setup, const Edits& edits, const Session& session) {
  if (!edits.plane || setup.start_in_work || setup.start.contains("X") || setup.start.contains("Y")) return;
  const std::vector<std::string>& axes = session.control().axes();
  const Vec2 fixed = edits.plane->fixed_point();
  const ToolPosition& stand = session.stand();
  for (std::size_t i = 0; i < axes.size(); ++i)
    if (axes[i] == "X" || axes[i] == "Y") setup.start[axes[i]] = stand.machine[i] - stand.work[i] + (axes[i] == "X" ? fixed.x : fixed.y);
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
  rules.tolerance = tolerance_of(spec, def);
  rules.chord = chord;
  rules.same_control = true;
  rules.stop = spec.stop;
  EditProof proof;
  for (Setup& setup : setups) {
    auto a = spec.old_program(setup_of_old(setup, def, spec.edits));
    if (!a) return tl::unexpected(a.error());
    if (spec.edits.plane) {
      start_at_fixed_point(setup, spec.edits, **a);
      a = spec.old_program(setup_of_old(setup, def, spec.edits));
      if (!a) return tl::unexpected(a.error());
    }
    ExpectedCourse expected(spec.edits, (*a)->control().axes(), (*a)->stand().machine);
    rules.expected_of_a = [&expected](ItemRing& from, ItemRing& to) { expected.take(from, to); };
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
