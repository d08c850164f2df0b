// Extents of a run: for each of the work coordinates in use, the range of each axis while cutting and over all motions. This file is used
// by out/picture/plot/plot_path and out/text/summary.

#include "out/text/extents.h"

#include <fmt/format.h>

#include "base/extremes.h"
#include "kinematics/chain.h"
#include "texts/out_units.h"

namespace kadr {
namespace {

std::string range_text(const std::string& axis, double least, double most, LengthUnit unit) {
  return fmt::format("{} {} … {}", axis, length_text(least, unit), length_text(most, unit));
}

}  // namespace

const char* unit_name(LengthUnit unit, Lang lang) {
  return plain_text(unit == LengthUnit::inch ? texts::out_units::inches : texts::out_units::mm, lang);
}

const char* speed_unit_name(LengthUnit unit, Lang lang) {
  return plain_text(unit == LengthUnit::inch ? texts::out_units::inches_per_minute : texts::out_units::mm_per_minute, lang);
}

std::string length_text(double mm, LengthUnit unit) { return number_text(mm / mm_of(unit), unit == LengthUnit::inch ? 4 : 3); }

void Reach::take(const AxisRoles& roles, const Axes& at) {
  for (std::size_t a = 0; roles.rotary != 0 && a < roles.count; ++a) {
    if (!roles.is_rotary(a)) continue;
    least[a] = box.empty ? at[a] : std::min(least[a], at[a]);
    most[a] = box.empty ? at[a] : std::max(most[a], at[a]);
  }
  box.take(Chain(roles).tip(at));
}

void Reach::take(const Reach& other) {
  if (other.box.empty) return;
  if (box.empty) {
    *this = other;
    return;
  }
  box.take(other.box);
  for (std::size_t a = 0; a < max_axes; ++a) {
    least[a] = std::min(least[a], other.least[a]);
    most[a] = std::max(most[a], other.most[a]);
  }
}

Reach SystemExtents::all() const {
  Reach reach = cutting;
  reach.take(other);
  return reach;
}

void RunExtents::enter(std::uint16_t system) {
  lift();
  const auto found = std::find_if(systems_.begin(), systems_.end(), [&](const SystemExtents& s) { return s.system == system; });
  now_ = static_cast<std::size_t>(found - systems_.begin());
  if (found == systems_.end()) systems_.push_back({system, {}, {}});
}

namespace {

/// Returns the bounding box of a motion along the axes of the work coordinates.
Extents in_system(const WorkTransform& space, const Curve& curve) {
  Extents box{space.in_system(curve.at(0)), space.in_system(curve.at(1))};
  for (std::size_t a = 0; a < max_axes; ++a) {
    const Range range = range_of([&](double part) { return space.in_system(curve.at(part))[a]; }, curve.samples());
    box.least[a] = range.least;
    box.most[a] = range.most;
  }
  return box;
}

}  // namespace

void RunExtents::take(const Motion& motion, const ToolPosition& at, const Curve& curve) {
  const Axes& from = at.work;
  const WorkTransform* const frame = at.space && at.space->has_frame() ? at.space.get() : nullptr;
  if (systems_.empty() || systems_[now_].system != motion.system) enter(motion.system);
  const bool cutting = cuts(motion);
  units_.take(motion);
  Reach& reach = cutting ? systems_[now_].cutting : systems_[now_].other;
  if (const std::size_t into = 2 * now_ + (cutting ? 1 : 0); stands_in_ != into) {
    reach.take(roles_, frame != nullptr ? frame->in_system(from) : from);
    stands_in_ = into;
  }
  reach.take(roles_, frame != nullptr ? frame->in_system(motion.to) : motion.to);
  if (!curve.straight()) {
    const Extents extents = frame != nullptr ? in_system(*frame, curve) : curve.extents();
    reach.take(roles_, extents.least);
    reach.take(roles_, extents.most);
  }
  for (std::size_t a = 0; roles_.rotary != 0 && a < roles_.count; ++a)
    if (roles_.is_rotary(a) && motion.to[a] != from[a]) turned_ |= AxisMask{1} << a;
}

void MotionUnits::take(const Motion& motion) {
  if (cuts(motion)) {
    (motion.inch ? cut_in_inches_ : cut_in_mm_) = true;
    cut_in_diameters_ &= motion.diameters;
  }
  moved_ = true, moved_in_inches_ = motion.inch, moved_in_diameters_ = motion.diameters;
}

LengthUnit MotionUnits::unit() const {
  if (cut_in_mm_ && cut_in_inches_) return LengthUnit::mixed;
  return cut_in_inches_ || (!cut_in_mm_ && moved_in_inches_) ? LengthUnit::inch : LengthUnit::mm;
}

Box RunExtents::cutting_box() const {
  Box box;
  for (const SystemExtents& system : systems_) box.take(system.cutting.box);
  return box;
}

Box RunExtents::box() const {
  Box box;
  for (const SystemExtents& system : systems_) box.take(system.all().box);
  return box;
}

std::vector<RunExtents::Row> RunExtents::rows(Of of, const std::vector<std::string>& names) const {
  std::vector<Row> rows;
  for (const SystemExtents& system : systems_) {
    const Reach reach = of == Of::cutting ? system.cutting : system.all();
    if (reach.box.empty) continue;
    const Vec3 &least = reach.box.least, &most = reach.box.most;
    const bool named = systems_.size() > 1 && system.system < names.size();
    rows.push_back({named ? names[system.system] : std::string(), {}});
    Row& row = rows.back();
    const double times = x_is_diameter() ? 2 : 1;
    row.axes = {{"X", times * least.x, times * most.x, false}};
    // an axis that the channel lacks is left out, unless the kinematics move the tool along it
    if (roles_.xyz[1] >= 0 || least.y != 0 || most.y != 0) row.axes.push_back({"Y", least.y, most.y, false});
    if (roles_.xyz[2] >= 0 || least.z != 0 || most.z != 0) row.axes.push_back({"Z", least.z, most.z, false});
    for (std::size_t a = 0; a < roles_.count; ++a)
      if ((turned_ >> a & 1U) != 0) row.axes.push_back({axes_[a], reach.least[a], reach.most[a], true});
  }
  return rows;
}

std::vector<std::string> RunExtents::texts(Of of, const std::vector<std::string>& names) const {
  std::vector<std::string> texts;
  for (const Row& row : rows(of, names)) {
    std::string& text = texts.emplace_back(row.system.empty() ? "" : row.system + "  ");
    for (const AxisRange& axis : row.axes)
      text += (&axis == &row.axes.front() ? "" : "   ") +
              range_text(axis.name, axis.least, axis.most, axis.rotary ? LengthUnit::mm : unit()) + (axis.rotary ? "°" : "");
  }
  return texts;
}

}  // namespace kadr
