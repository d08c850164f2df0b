// Axes that follow a master axis: synchronous axes and gantry axes (spec/nct/20 20.2, 20.6). Used by the rest of control; tested by
// tests/control/nct/coupling_test.cpp.

#include "control/nct/axes/coupling.h"

#include <algorithm>
#include <cmath>

#include "control/emitter.h"
#include "control/fanuc/words/coordinates.h"
#include "control/nct/nct.h"
#include "control/start_fault.h"
#include "texts/control_start.h"

namespace kadr::nct {
namespace {

int axis_named(const BlockContext& m, const std::string& name) {
  const auto found = std::find(m.axis_names.begin(), m.axis_names.end(), name);
  return found == m.axis_names.end() ? -1 : static_cast<int>(found - m.axis_names.begin());
}

double master_number(const BlockContext& m, std::size_t axis) {
  const ParameterStore& store = macro_b_of(m).parameters;
  return store.value(store.named("2101"), m.def.axis_numbers[axis]);
}

/// Returns the master of an axis, whose number is in parameter N2101. Returns nullopt if the number is not that of another axis of this
/// channel.
std::optional<std::size_t> master_of(const BlockContext& m, std::size_t axis) { return axis_numbered(m, master_number(m, axis), axis); }

/// Returns true if the axis has a master, in this channel or in another one.
bool has_master(const BlockContext& m, std::size_t axis) { return master_of(m, axis) || is_cross_channel_axis(m, master_number(m, axis)); }

bool bit_of(const BlockContext& m, std::size_t axis, int bit) {
  const ParameterStore& store = macro_b_of(m).parameters;
  return store.bit(store.named("2102"), bit, m.def.axis_numbers[axis]);
}

/// Returns true if `axis` follows `master`, directly or through other axes. In this case `master` must not follow `axis`, because the
/// coupling would be a loop.
bool follows(const Couplings& couplings, std::size_t axis, std::size_t master) {
  for (auto follower = couplings.followers.rbegin(); follower != couplings.followers.rend(); ++follower)
    if (follower->axis == axis) axis = follower->master;
  return axis == master;
}

/// Sorts the followers so that each follower comes after its own master.
void sort(std::vector<Follower>& followers) {
  std::vector<Follower> sorted;
  AxisMask waiting = 0;
  for (const Follower& follower : followers) waiting |= AxisMask{1} << follower.axis;
  while (sorted.size() < followers.size())
    for (const Follower& follower : followers) {
      if ((waiting >> follower.axis & 1u) == 0 || (waiting >> follower.master & 1u) != 0) continue;
      sorted.push_back(follower);
      waiting &= ~(AxisMask{1} << follower.axis);
    }
  followers = std::move(sorted);
}

void add(BlockContext& m, std::size_t axis, std::size_t master, double sign) {
  Couplings& c = nct_of(m).couplings;
  c.followers.push_back({static_cast<std::uint8_t>(axis), static_cast<std::uint8_t>(master), sign});
  fanuc_of(m).following |= AxisMask{1} << axis;
  sort(c.followers);
  follow_from_here(m);
}

/// Computes the new position and the signed travel of a follower whose master rolls over.
void roll(BlockContext& m, const Follower& follower, MotionDetail& detail) {
  const AxisSettings& settings = fanuc_of(m).settings.axes[follower.axis];
  const double travel = follower.sign * detail.travel[follower.master];
  double& work = m.position.work[follower.axis];
  const double from = work;
  work += travel;
  if (settings.rolls) {
    work -= settings.period * std::floor(work / settings.period);
    detail.rolled |= AxisMask{1} << follower.axis;
    detail.travel[follower.axis] = travel;
  }
  m.position.machine[follower.axis] += work - from;
}

}  // namespace

std::optional<std::size_t> axis_numbered(const BlockContext& m, double number, std::size_t axis) {
  for (std::size_t a = 0; a < m.axis_count; ++a)
    if (a != axis && number > 0 && m.def.axis_numbers[a] == number) return a;
  return std::nullopt;
}

bool is_cross_channel_axis(const BlockContext& m, double number) {
  const bool is_own = std::any_of(m.def.axis_numbers.begin(), m.def.axis_numbers.begin() + static_cast<std::ptrdiff_t>(m.axis_count),
                                  [&](std::uint8_t own) { return own == number; });
  return !is_own && number >= 1 && number <= nct_of(m).axes_in_all;
}

SetupFault coupling_fault(const BlockContext& m, const std::vector<SetupEvent>& events) {
  // only the NCT has parameter N2101, which names the master of an axis; other controls couple no axes
  const bool names_masters = macro_b_of(m).parameters.named("2101") != ParameterId::none;
  for (const SetupEvent& event : events)
    for (const std::string& name : event.what == SetupEvent::Do::synchronise ? event.axes : std::vector<std::string>()) {
      const int axis = axis_named(m, name);
      if (axis < 0 || has_master(m, static_cast<std::size_t>(axis))) continue;
      const TextId<1> fault = names_masters ? texts::control_start::master_is_no_axis : texts::control_start::no_parameter_of_master;
      return start_fault_of("events", fault, name);
    }
  return {};
}

void couple_gantries(BlockContext& m) {
  for (std::size_t axis = 0; axis < m.axis_count; ++axis) {
    constexpr int psn = 4;
    const auto master = bit_of(m, axis, psn) ? master_of(m, axis) : std::nullopt;
    if (!master || follows(nct_of(m).couplings, *master, axis)) continue;
    add(m, axis, *master, 1);
    m.position.machine[axis] = m.position.machine[*master];
    m.position.work[axis] = m.position.machine[axis] - m.frames.origin[axis] - m.frames.length[axis];
  }
  m.position.programmed = m.transform.to_programmed(m.position.work);
  follow_from_here(m);
}

void couple_axis(Emitter& m, const std::string& name, bool on) {
  const int found = axis_named(m, name);
  if (found < 0) return;
  const auto axis = static_cast<std::size_t>(found);
  Couplings& c = nct_of(m).couplings;
  constexpr int msy = 0, psn = 4;
  const double sign = bit_of(m, axis, msy) ? -1 : 1;
  const double number = master_number(m, axis);
  if (!on && is_cross_channel_axis(m, number))
    return link_cross_channel(m, {axis, static_cast<int>(number), AxisLink::follows, sign}, false);
  if (!on && !bit_of(m, axis, psn)) {
    std::erase_if(c.followers, [&](const Follower& follower) { return follower.axis == axis; });
    fanuc_of(m).following &= ~(AxisMask{1} << axis);
  }
  if (!on || (fanuc_of(m).following >> axis & 1u) != 0) return;
  if (is_cross_channel_axis(m, number) && !fanuc_of(m).settings.axes[axis].rolls)
    return link_cross_channel(m, {axis, static_cast<int>(number), AxisLink::follows, sign}, true);
  const auto master = master_of(m, axis);
  if (!master || follows(c, *master, axis)) {
    constexpr double parameter = 2101;
    m.warn(warning(AlarmId::coupling_parameter, {}, parameter));
    return;
  }
  add(m, axis, *master, sign);
}

void link_cross_channel(BlockContext& m, const CrossChannelAxis& axis, bool on) {
  Couplings& c = nct_of(m).couplings;
  std::erase_if(c.far, [&](const CrossChannelAxis& far) { return far.axis == axis.axis && far.link == axis.link; });
  if (on) c.far.push_back(axis);
  if (axis.link != AxisLink::follows) return;
  const AxisMask bit = AxisMask{1} << axis.axis;
  AxisMask& following = fanuc_of(m).following;
  following = on ? following | bit : following & ~bit;
}

void Nct::drop_cross_channel(Emitter& m, const CrossChannelAxis& axis) {
  link_cross_channel(m, axis, false);
  const bool follows = axis.link == AxisLink::follows;
  constexpr double parameter = 2101;
  m.warn(follows ? warning(AlarmId::coupling_parameter, {}, parameter)
                 : warning(AlarmId::axis_not_changed, {}, std::string_view(m.axis_names[axis.axis])));
}

/// Sets the position of an axis whose master is in another channel. Axes of this channel that follow this axis move too.
void Nct::move_linked_axis(Emitter& m, std::size_t axis, double machine) {
  Axes& now = m.position.machine;
  now[axis] = machine;
  for (const Follower& f : couplings.followers) now[f.axis] = couplings.offset[f.axis] + f.sign * now[f.master];
  m.stand_at(Axes(now));
}

bool Nct::may_exchange(const BlockContext& m, std::size_t axis) const { return may_be_exchanged(m, axis); }

void Nct::exchange_cross_channel(std::size_t axis, double machine, bool on) {
  drives.requests.push_back({axis, AxisLink::exchanged, on, machine});
}

Status not_following(const BlockContext& m, AxisMask named) {
  const AxisMask wrong = named & fanuc_of(m).following;
  if (wrong == 0) [[likely]]
    return {};
  const auto axis = static_cast<std::size_t>(__builtin_ctz(wrong));
  const char letter = m.letters.axis_letter[axis];
  return fail(
      alarm(AlarmId::axis_follows, letter != 0 && m.has(letter) ? m.where(letter) : m.block->where, std::string_view(m.axis_names[axis])));
}

void follow(BlockContext& m, Motion& motion) {
  const Couplings& c = nct_of(m).couplings;
  MotionDetail& detail = detail_of(m, motion);
  detail.followers = c.followers;
  Axes& machine = m.position.machine;
  for (const Follower& follower : c.followers) {
    const AxisMask master = AxisMask{1} << follower.master;
    if ((motion.named & master) != 0) motion.named |= AxisMask{1} << follower.axis;
    if ((detail.rolled & master) != 0) {
      roll(m, follower, detail);
      continue;
    }
    machine[follower.axis] = c.offset[follower.axis] + follower.sign * machine[follower.master];
    m.position.work[follower.axis] = machine[follower.axis] - m.frames.origin[follower.axis] - m.frames.length[follower.axis];
  }
  if (!m.frames.is_plain()) m.position.work = m.frames.work_of(machine);
  const Axes programmed = m.transform.to_programmed(m.position.work);
  for (const Follower& follower : c.followers) m.position.programmed[follower.axis] = programmed[follower.axis];
  motion.to = m.position.work;
  motion.machine = machine;
  if (detail.rolled != 0) follow_from_here(m);
}

void follow_from_here(BlockContext& m) {
  Couplings& c = nct_of(m).couplings;
  for (const Follower& f : c.followers) c.offset[f.axis] = m.position.machine[f.axis] - f.sign * m.position.machine[f.master];
}

}  // namespace kadr::nct
