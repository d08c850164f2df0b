// Placement: converts between work and machine coordinates. Tested by tests/action/frame_test.cpp.

#include "action/placement.h"

namespace kadr {
namespace {

Vec3 of_main(const FrameTurn& r, const Axes& axes) {
  const auto value = [&](std::size_t i) { return r.main[i] < 0 ? 0.0 : axes[static_cast<std::size_t>(r.main[i])]; };
  return {value(0), value(1), value(2)};
}

void set_main(const FrameTurn& r, Axes& axes, Vec3 v) {
  const double values[] = {v.x, v.y, v.z};
  for (std::size_t i = 0; i < 3; ++i)
    if (r.main[i] >= 0) axes[static_cast<std::size_t>(r.main[i])] = values[i];
}

Vec3 turned(const FrameTurn& r, Vec3 v) {
  const auto row = [&](const Vec3& m) { return m.x * v.x + m.y * v.y + m.z * v.z; };
  return {row(r.rows[0]), row(r.rows[1]), row(r.rows[2])};
}

/// Rotates a vector by the inverse of the frame's rotation: the inverse of a rotation matrix is its transpose.
Vec3 turned_back(const FrameTurn& r, Vec3 v) { return v.x * r.rows[0] + v.y * r.rows[1] + v.z * r.rows[2]; }

Axes as_driven(const AxisDrives& drives, const Axes& programmed) { return drives.is_own ? programmed : drives.driven(programmed); }
Axes as_programmed(const AxisDrives& drives, const Axes& driven) { return drives.is_own ? driven : drives.programmed(driven); }

}  // namespace

AxisDrives::AxisDrives() {
  for (std::size_t a = 0; a < max_axes; ++a) axis[a] = static_cast<std::int8_t>(a);
}

Axes AxisDrives::driven(const Axes& programmed) const {
  Axes all{};
  for (std::size_t a = 0; a < max_axes; ++a) all[of(a)] = sense(a) * programmed[a];
  return all;
}

Axes AxisDrives::programmed(const Axes& driven) const {
  Axes all{};
  for (std::size_t a = 0; a < max_axes; ++a) all[a] = sense(a) * driven[of(a)];
  return all;
}

Axes turned_axes(const FrameTurn& turn, const Axes& work) {
  Axes all = work;
  set_main(turn, all, turned(turn, of_main(turn, work)));
  return as_driven(turn.drives, all);
}

Axes turned_back_axes(const FrameTurn& turn, const Axes& travel) {
  Axes all = as_programmed(turn.drives, travel);
  set_main(turn, all, turned_back(turn, of_main(turn, all)));
  return all;
}

Axes Placement::machine_of(const Axes& work) const {
  Axes machine;
  for (std::size_t a = 0; a < max_axes; ++a) machine[a] = work[a] + origin[a] + length[a];
  if (space && !space->is_plain()) {
    machine = space->machine_of(work, machine);
  } else if (turn) {
    const FrameTurn& r = *turn;
    set_main(r, machine, of_main(r, origin) + of_main(r, length) + turned(r, of_main(r, shift) + of_main(r, work)));
  }
  return turn ? as_driven(turn->drives, machine) : machine;
}

Axes Placement::work_of(const Axes& driven) const {
  const Axes machine = turn ? as_programmed(turn->drives, driven) : driven;
  Axes work;
  for (std::size_t a = 0; a < max_axes; ++a) work[a] = machine[a] - origin[a] - length[a];
  if (space && !space->is_plain()) return space->work_of(machine, work);
  if (!turn) return work;
  const FrameTurn& r = *turn;
  set_main(r, work, turned_back(r, of_main(r, machine) - of_main(r, origin) - of_main(r, length)) - of_main(r, shift));
  return work;
}

AxisMask Placement::moved_with(AxisMask named) const {
  if (space && !space->is_plain()) named = space->moved_with(named);
  if (!turn) return named;
  AxisMask main = 0;
  for (const std::int8_t axis : turn->main)
    if (axis >= 0) main |= 1u << static_cast<unsigned>(axis);
  if ((named & main) != 0) named |= main;
  AxisMask moved = 0;
  for (; named != 0; named &= named - 1) moved |= AxisMask{1} << turn->drives.of(static_cast<std::size_t>(__builtin_ctz(named)));
  return moved;
}

}  // namespace kadr
