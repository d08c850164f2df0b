// Cuts a spinning part by the steps of a lathe's program. Used by session/cutting/turned_run; tested by
// tests/run_cut.py.

#include "session/cutting/turned_cutting.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "action/by_kind.h"
#include "config/tools/tool_library.h"
#include "session/cutting/machine_watch.h"
#include "stock/turned/edge_distance.h"

namespace kadr {
namespace {

constexpr double path_chord = 2e-4;   // greatest deviation of chords from an arc of the path, mm: below the increment of controls
constexpr double nose_chord = 1e-3;   // the same for the nose, mm; it only shows where a path ends: walls are exact
constexpr double least_depth = 0.01;  // mm; contact that is shallower is not a finding
// mm; rings that are thinner are rounding to whole nanometres. Their box may be large nevertheless, since they lie along the way.
constexpr double least_ring = 1e-5;
constexpr double at_edge = 2e-3;              // mm; a point this near to the edge of a sweep is on it
constexpr double least_removal = 1e-7;        // mm³; what removes less is not noted in the past of the part
constexpr double on_axis = 1e-6;              // mm; a drill this near to the axis is on it
constexpr double load_reach = 0.05;           // mm; means of loads are taken over at least twice this length of path
constexpr std::size_t most_stored = 100'000;  // greatest number of motions stored until the work coordinates of the blank are known
constexpr std::size_t most_listed = 1000;     // greatest number of findings that are listed; further findings are only counted

/// Returns the mean thickness of the rings, mm: their volume divided by the way around the axis and by their extent in the half plane.
double mean_thickness(const TurnedTouch& touch) {
  const Vec2 middle = 0.5 * (touch.least + touch.most);
  const double around = 2 * std::numbers::pi * std::max(middle.x, least_depth),
               extent = std::max(length(touch.most - touch.least), least_ring);
  return touch.volume / (around * extent);
}

}  // namespace

TurnedCutting::TurnedCutting(const CutJob& job, TurnedJob turned, const AxisRoles& roles)
    : job_(job),
      offset_now_(std::move(turned.offset_now)),
      tips_(turned.tips),
      path_(roles, path_chord, job.apart),
      stock_(std::move(turned.blank)),
      tool_(job.tool),
      spindles_(job.spindle),
      reversed_(job.spindle == SpindleDir::ccw),
      loads_(load_reach),
      air_(load_reach),
      keeps_areas_(turned.keeps_areas),
      keeps_stages_(turned.keeps_stages) {
  for (TurnedRegion& fixture : turned.fixtures) fixtures_.emplace_back(std::move(fixture));
  for (HeldBody& held : turned.holding) holding_.push_back({held.name, TurnedStock(std::move(held.region))});
  loads_.on_block = [this](const BlockLoad& load) {
    if (on_block) on_block(load);
  };
  for (const int axis : {roles.xyz[0], roles.xyz[1]})
    if (axis >= 0) across_ |= AxisMask{1} << axis;
  if (roles.xyz[2] >= 0) along_ = AxisMask{1} << roles.xyz[2];
  if (!job.starts_known) unknown_ = across_ | along_;
  result_.stock = stock_.blank_volume();
  result_.cell = path_chord;
  result_.turned.emplace();
}

/// Updates the tool, its offset and the rotation of the spindles.
void TurnedCutting::note(const Action& action) {
  by_kind(
      action,
      [&](const Spindle& spindle) {
        spindles_.take(spindle);
        if (spindle.dir == SpindleDir::cw || spindle.dir == SpindleDir::ccw) reversed_ = spindle.dir == SpindleDir::ccw;
      },
      [&](const CoolantSwitch& change) { coolant_ = change.what; }, [&](const Speed& speed) { spindles_.take(speed); },
      [&](const ToolChange& change) { tool_ = change.tool, tool_known_ = false; }, [&](const FrameChange&) { tool_known_ = false; },
      ignores<Motion, Dwell, ToolSelect, MachineFunction, AuxiliaryFunction, Stop, Message, SurfaceSpeed, Sync, ZoneChange, Couple,
              Uncouple, CompensationBreak, CompensationCorner, CompensationCheck>);
}

const TurnedCutting::Tool* TurnedCutting::add_tool(const ToolGeometry& geometry) {
  const auto same = [&](const auto& t) {
    const ToolGeometry& g = t->shape.geometry;
    return g.number == geometry.number && g.corner == geometry.corner && g.insert.tip_x == geometry.insert.tip_x &&
           g.insert.tip_z == geometry.insert.tip_z;
  };
  if (const auto found = std::find_if(tools_.begin(), tools_.end(), same); found != tools_.end()) return found->get();
  ToolShape shape = shape_of(geometry);
  std::vector<InsertSweep> sweeps = insert_sweeps(shape, nose_chord);
  return tools_.emplace_back(std::make_unique<Tool>(Tool{std::move(shape), std::move(sweeps)})).get();
}

/// Returns the tool in force: as the tools file has it, else by the row of the offset table; nullptr if neither tells its form. Where no
/// offset is in force, the row with the number of the tool counts.
const TurnedCutting::Tool* TurnedCutting::tool_for(const Motion& motion) {
  const std::uint32_t row = motion.length_offset != 0 ? motion.length_offset : tool_;
  if (tool_known_ && row == row_) return tool_now_;
  tool_known_ = true, row_ = row, tool_now_ = nullptr;
  const ToolGeometry* geometry = job_.tools.find(tool_);
  if (geometry == nullptr && tool_ == 0 && job_.tools.tools.size() == 1) geometry = &job_.tools.tools.front();
  if (geometry != nullptr) return tool_now_ = add_tool(*geometry);
  const auto insert = insert_of_offset(offset_now_(row), tool_, tips_);
  return tool_now_ = insert && tool_fault_message(*insert).empty() ? add_tool(*insert) : nullptr;
}

/// Returns the alarm to report if the cutting edges remove material on this motion; no_alarm if the motion may cut.
AlarmId TurnedCutting::fault_of(const Motion& motion) const {
  if (motion.kind == MotionKind::rapid || motion.kind == MotionKind::home) return AlarmId::rapid_in_stock;
  if (motion.kind == MotionKind::thread || motion.in_hole == HoleWork::taps) return no_alarm;  // the control turns the spindle itself
  return spindles_.any() ? no_alarm : AlarmId::spindle_stopped;
}

/// True if Z is known, and X or Y: a program names only the one in which it turns.
bool TurnedCutting::is_place_known() const { return (unknown_ & along_) == 0 && (unknown_ & across_) != across_; }

/// True if the start position of the motion is known. After the call, the position along the axes that the motion names is known.
bool TurnedCutting::place_known(const Motion& motion) {
  const bool known = is_place_known();
  unknown_ &= ~motion.named;
  return known;
}

std::size_t TurnedCutting::use_of(std::uint32_t tool) {
  const auto found = std::find_if(result_.tools.begin(), result_.tools.end(), [&](const ToolRemoval& t) { return t.tool == tool; });
  if (found != result_.tools.end()) return std::size_t(found - result_.tools.begin());
  result_.tools.push_back({tool, 0, 0, 0});
  return result_.tools.size() - 1;
}

/// True if the motion cuts no body of revolution: it turns the part or leaves the plane, or its tool turns and is off the axis.
bool TurnedCutting::is_left_out(const Motion& motion, const LatheMotion& path, const Tool* tool) const {
  if (path.off_plane || motion.in_hole == HoleWork::clear_of_wall) return true;
  if (tool == nullptr || tool->shape.turns()) return false;
  return std::any_of(path.corners.begin(), path.corners.end(), [](Vec2 corner) { return std::fabs(corner.x) > on_axis; });
}

void TurnedCutting::leave_out(const Step& step) {
  if (!is_cutting(step.motion()->kind)) return;
  auto& list = result_.turned->left_out;
  const auto found = std::find_if(list.begin(), list.end(), [&](const auto& l) { return l.tool == tool_; });
  if (found == list.end()) list.push_back({step.action.origin, {}, tool_, 1});
  else ++found->motions;
}

/// Finds the zero of the blank: that of the stated work system, else that of the first motion at feed.
void TurnedCutting::find_zero(const Motion& motion, double origin) {
  if (zero_ || (job_.system ? motion.system != *job_.system : !is_cutting(motion.kind))) return;
  zero_ = origin;
  release_waiting();
}

Status TurnedCutting::consume(const Step& step, const MachineTime& time) {
  note(step.action);
  result_.seconds = std::max(result_.seconds, time.begins + time.seconds + step.pause);
  auto path = path_.take(step);
  if (!path) return {};
  const Motion& motion = *step.motion();
  const bool known = place_known(motion), cuts = is_cutting(motion.kind);
  find_zero(motion, path->origin);
  if (motion.kind == MotionKind::probe || time.begins >= job_.until) return {};
  if (!known && !cuts) {  // the start of this rapid is unknown, so only its end is used, if it is known
    if (!is_place_known() || path->corners.empty()) return {};
    path->corners.assign(2, path->corners.back());
    path->parts = {0, 1};
  }
  const bool was_in_thread = std::exchange(in_thread_, motion.kind == MotionKind::thread);
  if (path->corners.empty() && !path->off_plane) return {};
  const Tool* const tool = path->off_plane ? nullptr : tool_for(motion);
  if (is_left_out(motion, *path, tool)) {
    leave_out(step);
    return {};
  }
  if (tool == nullptr) return cuts ? Status(fail(alarm(AlarmId::turning_tool_without_shape, {}, double(tool_)))) : Status();
  Moved moved;
  moved.path = std::move(*path), moved.origin = step.action.origin, moved.tool = tool, moved.use = use_of(tool_);
  moved.fault = fault_of(motion), moved.cuts = cuts, moved.begins = time.begins, moved.seconds = time.seconds;
  moved.reversed = reversed_;
  moved.threads = motion.kind == MotionKind::thread && tool->shape.turns();
  moved.lacks_coolant = cuts && job_.wants_coolant && coolant_ == Coolant::off;
  moved.in_groove = moved.threads || (was_in_thread && motion.kind == MotionKind::rapid);
  if (moved.threads && motion.detail)
    moved.lead = motion.detail->lead.value_or(0), moved.start_angle = motion.detail->start_angle.value_or(0);
  add(std::move(moved));
  return {};
}

/// Cuts a motion, or stores it until the zero of the blank is known.
void TurnedCutting::add(Moved&& moved) {
  if (zero_) {
    cut(moved);
    return;
  }
  waiting_.push_back(std::move(moved));
  if (waiting_.size() < most_stored) return;
  zero_ = waiting_.back().path.origin;
  release_waiting();
}

void TurnedCutting::release_waiting() {
  for (const Moved& moved : std::exchange(waiting_, {})) cut(moved);
}

/// Removes what the tool sweeps between two corners. Returns the removed volume, mm³; `found` receives what must be reported.
double TurnedCutting::sweep(const Moved& moved, const Segment& segment, Findings& found) {
  const auto add = [&](const Contact& contact, const TurnedTouch& touch) {
    if (!(mean_thickness(touch) > least_ring)) return;
    const auto [entry, is_new] = found.try_emplace(contact, Met{touch.least, touch.most, 0});
    Met& met = entry->second;
    met.volume += touch.volume;
    if (is_new) return;
    met.least = {std::min(met.least.x, touch.least.x), std::min(met.least.y, touch.least.y)};
    met.most = {std::max(met.most.x, touch.most.x), std::max(met.most.y, touch.most.y)};
  };
  double removed = 0;
  for (const InsertSweep& body : moved.tool->sweeps) {
    const TurnedPolygon area = body.swept(segment.from, segment.to);
    for (const TurnedStock& fixture : fixtures_) add({AlarmId::fixture}, fixture.touch(area));
    for (std::size_t i = 0; i < holding_.size(); ++i) add({AlarmId::machine, i, body.part()}, holding_[i].body.touch(area));
    if (moved.in_groove && body.part() != ToolPart::holder) continue;
    const AlarmId fault = body.part() == ToolPart::cutting ? moved.fault : fault_of_part(body.part());
    const TurnedTouch touch = stock_.remove(area, fault != no_alarm);
    removed += touch.volume;
    if (on_removal && touch.volume > least_removal)
      on_removal({&body, segment.from, segment.to, segment.begins, segment.seconds, moved.origin, result_.tools[moved.use].tool});
    if (keeps_areas_ && touch.volume > 0) areas_.emplace_back(moved.origin, area);
    if (fault != no_alarm) add({fault}, touch);
  }
  ++sweeps_;
  return removed;
}

void TurnedCutting::cut(const Moved& moved) {
  const double shift = moved.path.origin - zero_.value_or(moved.path.origin);
  const auto place = [&](std::size_t i) { return moved.path.corners[i] + Vec2{0, shift}; };
  const std::size_t last = moved.path.corners.size() - 1;
  Findings found;
  const auto maker = std::int32_t(moved.use);
  if (keeps_stages_ && (stages_.empty() || stages_.back().maker != maker)) stages_.push_back({maker, stock_.region()});
  double volume = 0, way = 0;
  for (std::size_t i = 0; i < last; ++i) {
    const double begins = moved.begins + moved.path.parts[i] * moved.seconds;
    const double seconds = (moved.path.parts[i + 1] - moved.path.parts[i]) * moved.seconds;
    const double removed = sweep(moved, {place(i), place(i + 1), begins, seconds}, found), part = length(place(i + 1) - place(i));
    if (moved.cuts && !moved.in_groove) air_.add({moved.origin, result_.tools[moved.use].tool, seconds, part, removed > 0});
    volume += removed, way += part;
  }
  if (moved.threads) {
    threads_.add({moved.origin, moved.lead, {place(0).x, 0, place(0).y}, {place(last).x, 0, place(last).y}}, moved.tool->shape);
    if (on_thread || keeps_stages_) note_thread(moved, place(0), place(last));
  }
  count(moved, volume, way);
  if (moved.lacks_coolant && volume > 0) keep_warning(moved, place(last));
  const double side = std::copysign(1.0, place(last).x);
  for (const auto& [contact, met] : found) {
    const double depth = TurnedTouch{0, met.least, met.most}.depth();
    const Vec2 middle = 0.5 * (met.least + met.most);
    if (!(depth >= least_depth)) continue;
    const std::uint32_t tool = result_.tools[moved.use].tool;
    CutFinding finding{contact.id, moved.origin, {}, {}, tool, {side * middle.x, 0, middle.y}, depth, met.volume, moved.begins};
    if (contact.id == AlarmId::machine) finding.bodies = {tool_in_words(contact.part, tool), holding_[contact.body].name};
    keep(finding);
  }
}

/// Passes a pass of a thread to the caller and keeps its groove for the picture. Left- or right-handed: M3 turns the part clockwise, seen
/// from the headstock along +Z; a tool that travels towards -Z then cuts a right-handed thread.
void TurnedCutting::note_thread(const Moved& moved, Vec2 from, Vec2 to) {
  const double side = std::copysign(1.0, from.x), lead = std::fabs(moved.lead);
  if (!(lead > 0) || std::fabs(to.y - from.y) < std::fabs(to.x - from.x)) return;
  ThreadGroove groove;
  groove.outline = moved.tool->sweeps.front().swept({}, {});
  double outwards = 0;
  for (Vec2& p : groove.outline) p.x *= side, outwards += p.x;
  groove.from = {side * from.x, from.y}, groove.to = {side * to.x, to.y};
  groove.lead = lead, groove.is_outer = outwards >= 0;
  groove.left_handed = moved.reversed != (to.y > from.y);
  const bool continues = last_groove_ && last_groove_->to == groove.from && last_groove_->lead == lead;
  groove.start = continues ? last_groove_->start : from.y + lead * moved.start_angle / 360;
  groove.maker = std::int32_t(moved.use);
  last_groove_ = groove;
  if (keeps_stages_ && (grooves_.empty() || grooves_.back() != groove)) grooves_.push_back(groove);
  if (on_thread) on_thread({std::move(groove), moved.begins, moved.seconds, moved.origin, result_.tools[moved.use].tool});
}

/// Adds what a motion has removed to the figures of its tool and its block.
void TurnedCutting::count(const Moved& moved, double volume, double way) {
  ToolRemoval& tool = result_.tools[moved.use];
  tool.removed += volume;
  if (!moved.cuts) return;
  tool.seconds += moved.seconds;
  if (moved.in_groove) return;
  const Vec2 middle = moved.path.corners[moved.path.corners.size() / 2];
  CutMotion motion;
  motion.origin = moved.origin, motion.tool = tool.tool, motion.begins = moved.begins, motion.seconds = moved.seconds;
  motion.length = way, motion.volume = volume, motion.at = {middle.x, 0, middle.y};
  loads_.add(motion);
  if (rate_.use != moved.use) rate_ = {};
  rate_.use = moved.use;
  rate_.volume += volume, rate_.seconds += moved.seconds, rate_.length += way;
  if (rate_.length < 2 * load_reach || !(rate_.seconds > 0)) return;
  tool.greatest_rate = std::max(tool.greatest_rate, rate_.volume / rate_.seconds);
  rate_ = {0, 0, 0, moved.use};
}

/// Reports that a motion cuts without coolant, once for each line.
void TurnedCutting::keep_warning(const Moved& moved, Vec2 at) {
  const auto& off = job_.disabled;
  if (std::find(off.begin(), off.end(), AlarmId::no_coolant) != off.end() || !without_coolant_.insert(moved.origin.line).second) return;
  const CutFinding finding{AlarmId::no_coolant, moved.origin, {}, {}, result_.tools[moved.use].tool, {at.x, 0, at.y}, 0, 0, moved.begins};
  if (result_.warnings.size() >= most_listed) {
    ++result_.not_listed;
    return;
  }
  result_.warnings.push_back(finding);
  if (on_finding) on_finding(finding);
}

std::optional<Origin> TurnedCutting::last_at(Vec2 at) const {
  const Vec2 mirrored{-at.x, at.y};
  for (auto area = areas_.rbegin(); area != areas_.rend(); ++area)
    for (std::size_t i = 0; i < area->second.size(); ++i) {
      const Vec2 a = area->second[i], b = area->second[(i + 1) % area->second.size()];
      if (std::min(distance_to_edge(at, a, b), distance_to_edge(mirrored, a, b)) < at_edge) return area->first;
    }
  return std::nullopt;
}

void TurnedCutting::keep(const CutFinding& finding) {
  if (result_.collisions.size() >= most_listed) {
    ++result_.not_listed;
    return;
  }
  result_.collisions.push_back(finding);
  if (on_finding) on_finding(finding);
}

void TurnedCutting::finish() {
  if (!zero_ && !waiting_.empty()) zero_ = waiting_.back().path.origin;
  release_waiting();
  loads_.finish();
}

CutResult TurnedCutting::result() const {
  CutResult result = result_;
  const TurnedStock::Area area = stock_.area();
  result.left = stock_.volume();
  result.error_bound = path_chord * area.machined;
  result.sweeps = sweeps_;
  result.turned->surface = area.whole, result.turned->machined = area.machined;
  result.heaviest = loads_.heaviest();
  result.emptiest = air_.emptiest();
  result.threads = threads_.found([&](double z) { return stock_.radii_at(z); });
  return result;
}

}  // namespace kadr
