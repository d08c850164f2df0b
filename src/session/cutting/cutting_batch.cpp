// Cuts a batch of motions, counts what each of them has removed, and reports contacts (class Cutting).

#include <algorithm>
#include <cmath>
#include <map>

#include "session/cutting/cutting.h"
#include "session/cutting/window_touches.h"

namespace kadr {
namespace {

constexpr std::size_t max_findings = 1000;  // greatest number of findings that are listed; further findings are only counted

double least_side(const Box3& box) {
  const Vec3 size = box.most - box.least;
  return std::min({size.x, size.y, size.z});
}

}  // namespace

void Cutting::cut() {
  if (batch_.empty()) return;
  std::vector<Touch> touches = stock_.cut(job_.stop);
  if (job_.on_portion_cut) job_.on_portion_cut(stock_.portion_cut());
  if (job_.portion_cuts) touches = stock_.add_portions(job_.portion_cuts());
  if (seen_) (void)seen_->cut(job_.stop);
  if (window_) touches = finer_touches(job_.window->box(), touches, window_->cut(job_.stop));
  report_touches(touches, false);
  for (const auto& fixture : fixtures_) report_touches(fixture->cut(job_.stop), true);
  count_removed();
  batch_.clear();
  notify_others();
}

void Cutting::notify_others() {
  for (const CutFinding& finding : others_) keep(finding);
  others_.clear();
}

void Cutting::count_removed() {
  for (std::size_t i = 0; i < batch_.size(); ++i) {
    const Moved& m = batch_[i];
    const std::size_t end = i + 1 < batch_.size() ? batch_[i + 1].first_sweep : stock_.sweeps();
    double volume = 0, depth = 0;
    for (std::size_t s = m.first_sweep; s < end; ++s) volume += stock_.removed_by(s), depth = std::max(depth, stock_.depth_of(s));
    ToolRemoval& tool = result_.tools[m.use];
    tool.removed += volume;
    if (!m.cuts) continue;
    tool.seconds += m.seconds;
    if (end == m.first_sweep || m.in_groove) continue;
    loads_.add({m.origin, m.tool, m.diameter, m.teeth, m.begins, m.seconds, m.length, m.flat, volume, depth, m.first_sweep, end, m.at});
    const double share = 1.0 / double(end - m.first_sweep);
    for (std::size_t s = m.first_sweep; s < end; ++s)
      air_.add({m.origin, m.tool, m.seconds * share, m.length * share, stock_.cuts_anything(s)});
    if (rate_.use != m.use) rate_ = {};
    rate_.use = m.use;
    rate_.volume += volume, rate_.seconds += m.seconds, rate_.length += m.length;
    if (rate_.length < 2 * job_.cell || !(rate_.seconds > 0)) continue;
    tool.greatest_rate = std::max(tool.greatest_rate, rate_.volume / rate_.seconds);
    rate_ = {};
    rate_.use = m.use;
  }
}

/// Reports the contacts of the tool as findings, one finding per motion and kind of fault. `of_fixture`: contacts with a fixture.
void Cutting::report_touches(const std::vector<Touch>& touches, bool of_fixture) {
  std::map<std::pair<std::size_t, AlarmId>, std::pair<Box3, double>> around;  // (motion in batch_, fault) → contacts (box, volume)
  for (const Touch& t : touches) {
    const auto after = std::upper_bound(batch_.begin(), batch_.end(), std::size_t(t.sweep),
                                        [](std::size_t s, const Moved& m) { return s < m.first_sweep; });
    const auto motion = std::size_t(after - batch_.begin()) - 1;
    const auto [found, is_new] = around.try_emplace({motion, fault_of_touch(batch_[motion], t.part, of_fixture)}, t.around, 0);
    auto& [box, volume] = found->second;
    volume += t.volume;
    if (!is_new) box.include(t.around);
  }
  for (const auto& [what, taken] : around) {
    const Moved& m = batch_[what.first];
    const Box3& box = taken.first;
    const bool turned = m.radius != Vec2{};
    const Vec3 middle = 0.5 * (box.least + box.most), at = turned ? Vec3{middle.x * m.radius.x, middle.x * m.radius.y, middle.z} : middle;
    const double depth = turned ? std::min(box.most.x - box.least.x, box.most.z - box.least.z) : least_side(box);
    const CutFinding finding{what.second, m.origin, {}, {}, m.tool, at, depth, taken.second, m.begins};
    if (finding.depth >= (turned ? stock_.least_piece() : least_depth(box))) keep(finding);
  }
}

/// Returns the least depth that the stock can resolve, mm. Inside the window the finer cells of the window determine the depth.
double Cutting::least_depth(const Box3& around) const {
  return window_ && is_within(around, job_.window->box()) ? window_->least_piece() : stock_.least_piece();
}

AlarmId Cutting::fault_of_touch(const Moved& moved, ToolPart part, bool of_fixture) {
  if (of_fixture) return AlarmId::fixture;
  if (part != ToolPart::cutting) return fault_of_part(part);
  return moved.fault != no_alarm ? moved.fault : AlarmId::no_coolant;
}

void Cutting::keep(const CutFinding& finding) {
  const bool is_warning = finding.id == AlarmId::no_coolant;
  if (is_warning && std::find(job_.disabled.begin(), job_.disabled.end(), finding.id) != job_.disabled.end()) return;
  if (is_warning && !without_coolant_.insert(finding.origin.line).second) return;  // only one warning per program line is reported
  auto& list = is_warning ? result_.warnings : result_.collisions;
  if (list.size() >= max_findings) {
    ++result_.not_listed;
    return;
  }
  list.push_back(finding);
  if (on_finding) on_finding(finding);
}

}  // namespace kadr
