// Cutting: simulates the removal of material by the steps of a run. It is used by cli/cut.

#include "session/cutting/cutting.h"

#include <algorithm>
#include <cmath>

#include "action/by_kind.h"
#include "session/cutting/turned_path.h"

namespace kadr {
namespace {

constexpr std::size_t batch_sweeps = 1 << 15;
constexpr std::size_t max_waiting = 100'000;  // greatest number of motions stored until the work coordinates of the blank are known
constexpr double sideways = 0.01;             // greatest travel of a drill across its axis while it cuts, mm
constexpr double chord_of_cell = 1.0 / 2000;  // greatest deviation of chords from their arc, as a fraction of the cell size
constexpr double greatest_chord = 2e-4;       // greatest deviation of chords from their arc, mm: below the least increment of controls

constexpr double seconds_a_minute = 60;
constexpr Vec3 upright{0, 0, 1};

double chord_for(double cell) { return std::min(cell * chord_of_cell, greatest_chord); }

/// Returns the travel of the tool along its axis on this segment, mm; negative if the tool moves into the material.
double climb_of(const PathSegment& p) {
  const Vec3 delta = p.to - p.from, k = p.from_direction;
  return delta.x * k.x + delta.y * k.y + delta.z * k.z;
}
double flat_length(const PathSegment& p) {
  if (is_upright(p.from_direction)) return length(Vec2{p.to.x - p.from.x, p.to.y - p.from.y});
  return length(p.to - p.from - climb_of(p) * p.from_direction);
}

}  // namespace

AlarmId fault_of_part(ToolPart part) {
  return part == ToolPart::holder ? AlarmId::holder_in_stock : part == ToolPart::shank ? AlarmId::shank_in_stock : AlarmId::beyond_flutes;
}

Cutting::Cutting(const CutJob& job, const AxisRoles& roles)
    : job_(job),
      tool_path_(roles, chord_for(job.cell), job.system, job.machine, job.apart),
      stock_(job.blank, job.cell, job.threads, job.bricks),
      tool_(job.tool),
      spindle_(job.spindle),
      spinning_(job.spindle == SpindleDir::cw || job.spindle == SpindleDir::ccw),
      rpm_(job.rpm),
      loads_(job.cell),
      air_(job.cell) {
  if (job.window) window_ = std::make_unique<Stock>(job.window, job.window_cell, job.threads);
  loads_.on_block = [this](const BlockLoad& load) {
    if (on_block) on_block(load);
  };
  if (job.keeps_rates)
    loads_.on_rate = [this](std::size_t first, std::size_t end, double rate) {
      rate_of_sweep_.resize(stock_.sweeps());
      std::fill(rate_of_sweep_.begin() + std::ptrdiff_t(first), rate_of_sweep_.begin() + std::ptrdiff_t(end), float(rate));
    };
  if (job.seen_cell > 0) {
    seen_ = std::make_unique<Stock>(job.blank, job.seen_cell, job.threads);
    seen_->keep_past(job.past_bytes);
  }
  for (const auto& body : job.fixtures) fixtures_.push_back(std::make_unique<Stock>(body, job.cell, job.threads));
  double finest = job.cell;  // least cell size of all stocks; all of them use its chords, so a sweep has the same number in each stock
  each_other([&](const Stock& other) { finest = std::min(finest, other.lattice().cell()); });
  stock_.divide_as(finest);
  each_other([&](Stock& other) { other.divide_as(finest); });
  if (!job.starts_known)
    for (const int axis : roles.xyz)
      if (axis >= 0) unknown_ |= AxisMask{1} << axis;
  for (const int axis : {roles.xyz[0], roles.xyz[1]})
    if (axis >= 0) across_ |= AxisMask{1} << axis;
  result_.stock = job.blank->volume();
  result_.cell = job.cell;
}

template <class Visit>
void Cutting::each_other(const Visit& visit) const {
  if (window_) visit(*window_);
  if (seen_) visit(*seen_);
  for (const auto& fixture : fixtures_) visit(*fixture);
}

/// Updates the tool in the spindle and the rotation of the spindles.
void Cutting::note(const Action& action) {
  const auto bit_of = [](int spindle) { return spindle >= 1 && spindle <= 32 ? std::uint32_t{1} << (spindle - 1) : 0; };
  by_kind(
      action,
      [&](const Spindle& turned) {
        const std::uint32_t bit = bit_of(turned.number);
        spinning_ = turned.dir == SpindleDir::cw || turned.dir == SpindleDir::ccw ? spinning_ | bit : spinning_ & ~bit;
        if (turned.rpm > 0) speedless_ &= ~bit;
        if (turned.number == 1) spindle_ = turned.dir, rpm_ = turned.rpm;
      },
      [&](const Speed& speed) {
        const std::uint32_t bit = bit_of(speed.number);
        speedless_ = speed.value > 0 ? speedless_ & ~bit : speedless_ | bit;
        if (speed.number == 1) rpm_ = speed.surface ? 0 : speed.value;
      },
      [&](const ToolChange& change) { tool_ = change.tool; },  //
      [&](const CoolantSwitch& coolant) { coolant_ = coolant.what; },
      ignores<Motion, Dwell, ToolSelect, MachineFunction, AuxiliaryFunction, Stop, Message, FrameChange, SurfaceSpeed, Sync, ZoneChange,
              Couple, Uncouple, CompensationBreak, CompensationCorner, CompensationCheck>);
}

std::size_t Cutting::use_of(std::uint32_t tool) {
  const auto found = std::find_if(result_.tools.begin(), result_.tools.end(), [&](const ToolRemoval& t) { return t.tool == tool; });
  if (found == result_.tools.end()) {
    result_.tools.push_back({tool, 0, 0, 0});
    return result_.tools.size() - 1;
  }
  return std::size_t(found - result_.tools.begin());
}

/// Returns the tool's index in the stock; nullopt if the tools file lacks the tool. Without tool calls, a single tool of the file is used.
std::optional<std::uint16_t> Cutting::shape_of_tool() {
  for (const auto& [number, shape] : shapes_)
    if (number == tool_) return shape;
  const ToolGeometry* geometry = job_.tools.find(tool_);
  if (geometry == nullptr && tool_ == 0 && job_.tools.tools.size() == 1) geometry = &job_.tools.tools.front();
  if (geometry == nullptr) return std::nullopt;
  const ToolShape shape = shape_of(*geometry);
  const std::uint16_t number = stock_.add_tool(shape);
  each_other([&](Stock& other) { (void)other.add_tool(shape); });
  if (shape.turns()) {  // a turning tool is added once more without its insert, for motions of the insert in a thread groove
    (void)stock_.add_tool(holder_of(shape));
    each_other([&](Stock& other) { (void)other.add_tool(holder_of(shape)); });
  }
  shapes_.emplace_back(tool_, number);
  return number;
}

/// Returns the alarm to report if the cutting edges of the tool remove material on this motion; no_alarm if the motion may cut.
AlarmId Cutting::fault_of(const Motion& motion, const std::vector<PathSegment>& pieces, const ToolGeometry& tool) const {
  if (motion.kind == MotionKind::rapid || motion.kind == MotionKind::home) return AlarmId::rapid_in_stock;
  if (motion.kind == MotionKind::thread) return no_alarm;  // on a thread the control itself drives the spindle
  // in a tapping cycle the control itself drives the spindle
  if (motion.in_hole == HoleWork::taps && motion.detail && motion.detail->turn) return no_alarm;
  if (tool.kind == ToolKind::turning) return (spinning_ & ~speedless_) == 0 ? AlarmId::spindle_stopped : no_alarm;  // the part must rotate
  if ((spindle_ != SpindleDir::cw && spindle_ != SpindleDir::ccw) || (speedless_ & 1U) != 0) return AlarmId::spindle_stopped;
  if (spindle_ == SpindleDir::ccw && motion.in_hole != HoleWork::taps) return AlarmId::spindle_wrong_way;
  double flat = 0, climb = 0;
  for (const PathSegment& p : pieces) flat += flat_length(p), climb += climb_of(p);
  if (tool.kind == ToolKind::drill && flat > sideways) return AlarmId::drill_sideways;
  const bool down = flat < sideways && climb < 0;
  return down && !tool.plunges ? AlarmId::plunge : no_alarm;
}

/// Returns which of the axes X, Y, Z have an unknown position. For a turning tool, X and Y count as known if one of them is known.
AxisMask Cutting::unknown_now() const {
  const ToolGeometry* const tool = job_.tools.find(tool_);
  const bool turns = tool != nullptr && tool->kind == ToolKind::turning;
  return turns && (unknown_ & across_) != across_ ? unknown_ & ~across_ : unknown_;
}

/// True if the start position of the motion is known. After the call, the position along the axes that the motion names is known.
bool Cutting::place_known(const Motion& motion) {
  const bool known = unknown_now() == 0;
  unknown_ &= ~motion.named;
  return known;
}

/// True if the insert of a turning tool moves in a thread groove, or leaves the groove by a rapid after the thread. On such a motion the
/// insert sweeps a helix, which the model of rings cannot represent, so no material is removed.
bool Cutting::is_in_groove(const Motion& motion) {
  const bool threads = motion.kind == MotionKind::thread, in_groove = threads || (in_thread_ && motion.kind == MotionKind::rapid);
  in_thread_ = threads;
  return in_groove;
}

/// Shifts the segments by the difference between the length that the control applies and the actual length of the tool. With a worn tool, a
/// wrong H or no H, the tip is lower or higher than the control assumes.
void Cutting::shift_by_length() {
  const auto real = job_.lengths.find(tool_);
  if (real == job_.lengths.end()) return;
  const double shift = tool_path_.length_in_force() - real->second;
  for (PathSegment& p : pieces_) p.from = p.from + shift * p.from_direction, p.to = p.to + shift * p.to_direction;
}

Status Cutting::consume(const Step& step, const MachineTime& time) {
  note(step.action);
  const Motion* const motion = step.motion();
  result_.seconds = std::max(result_.seconds, time.begins + time.seconds + step.pause);
  tool_path_.take(step, pieces_);
  if (motion != nullptr && pieces_.empty()) (void)place_known(*motion);  // without travel nothing is cut, but the position is known
  if (motion == nullptr || pieces_.empty() || motion->kind == MotionKind::probe || time.begins >= job_.until) return {};
  if (motion->in_hole == HoleWork::clear_of_wall) return {};  // the only cutting edge of the boring bar is off the hole's wall
  shift_by_length();
  if (!place_known(*motion) && !is_cutting(motion->kind)) {  // the start of this rapid is unknown, so only its end is used, if it is known
    if (unknown_now() != 0) return {};
    const PathSegment last = pieces_.back();
    pieces_.assign(1, {last.to, last.to, 0, 1, last.to_direction, last.to_direction});
  }
  const auto shape = shape_of_tool();
  if (!shape) return is_cutting(motion->kind) ? Status(fail(alarm(AlarmId::tool_without_shape, {}, double(tool_)))) : Status();
  const bool in_groove = stock_.tool(*shape).turns() && is_in_groove(*motion);
  const double most = time.seconds > 0 ? (job_.until - time.begins) / time.seconds : 1;
  while (!pieces_.empty() && pieces_.back().begins >= most) pieces_.pop_back();
  if (pieces_.empty()) return {};
  if (PathSegment& last = pieces_.back(); last.ends > most) {
    const double part = (most - last.begins) / (last.ends - last.begins);
    const TiltedPath shorter = TiltedPath{last.from, last.to, last.from_direction, last.to_direction}.between(0, part);
    last.to = shorter.to, last.to_direction = shorter.to_direction;
    last.ends = most;
  }
  Moved moved;
  moved.origin = step.action.origin;
  moved.tool = stock_.tool(*shape).geometry.number;
  moved.use = use_of(moved.tool);
  moved.fault = fault_of(*motion, pieces_, stock_.tool(*shape).geometry);
  moved.cuts = is_cutting(motion->kind);
  moved.diameter = stock_.tool(*shape).geometry.diameter;
  if (motion->kind != MotionKind::thread && spindle_ != SpindleDir::stop)
    moved.teeth = stock_.tool(*shape).geometry.teeth * rpm_ / seconds_a_minute;
  moved.lacks_coolant = job_.wants_coolant && coolant_ == Coolant::off && moved.cuts;
  moved.in_groove = in_groove, moved.threads = in_groove && motion->kind == MotionKind::thread;
  if (moved.threads && motion->detail) moved.lead = motion->detail->lead.value_or(0);
  moved.begins = time.begins;
  moved.whole = time.seconds;
  moved.seconds = time.seconds * std::min(most, 1.0);
  if (tool_path_.zero() && !zero_known_) release_waiting();
  if (zero_known_) {
    add(moved, pieces_, *shape);
  } else {
    waiting_.push_back({moved, pieces_, *shape});
    if (waiting_.size() >= max_waiting) release_waiting();
  }
  return {};
}

/// Cuts the stored motions. If the work coordinates of the blank are still unknown, the present work coordinates are used.
void Cutting::release_waiting() {
  zero_ = tool_path_.zero().value_or(tool_path_.present_origin());
  zero_known_ = true;
  for (const WaitingMotion& k : waiting_) add(k.moved, k.pieces, k.shape);
  waiting_ = std::vector<WaitingMotion>();
}

void Cutting::add(const Moved& moved, const std::vector<PathSegment>& pieces, std::uint16_t shape) {
  batch_.push_back(moved);
  Moved& in_batch = batch_.back();
  in_batch.first_sweep = stock_.sweeps();
  const bool watched = moved.fault != no_alarm || moved.lacks_coolant;
  const auto in_material = std::uint16_t(shape + (moved.in_groove ? 1 : 0));
  const auto carry = [&](Vec3 from, Vec3 to, Vec3 from_direction = upright, Vec3 to_direction = upright) {
    const Sweep sweep{from, to, in_material, watched, from_direction, to_direction};
    stock_.add(sweep);
    if (window_) window_->add(sweep);
    if (seen_) seen_->add(sweep);
    lines_.fill(stock_.sweeps(), {moved.origin.line, moved.origin.file});
    for (const auto& fixture : fixtures_) fixture->add({from, to, shape, true, from_direction, to_direction});
    in_batch.length += length(to - from);
  };
  const auto timed = [&](const PathSegment& p) {
    if (seen_) times_.fill(stock_.sweeps(), moved.begins + p.begins * moved.whole, moved.begins + p.ends * moved.whole);
  };
  if (stock_.tool(shape).turns()) {
    const Vec2 axis = radius_axis(pieces, zero_);
    const Vec3 end = pieces.back().to - zero_;
    in_batch.radius = std::copysign(1.0, dot(axis, Vec2{end.x, end.y})) * axis;
    for (const PathSegment& p : pieces) each_turned(p, zero_, axis, chord_for(job_.cell), carry), timed(p);
    const auto signed_radius = [&](Vec3 at) { return Vec3{dot(axis, Vec2{at.x - zero_.x, at.y - zero_.y}), 0, at.z - zero_.z}; };
    if (moved.threads)
      threads_.add({moved.origin, moved.lead, signed_radius(pieces.front().from), signed_radius(pieces.back().to)}, stock_.tool(shape));
  } else {
    for (const PathSegment& p : pieces) {
      carry(p.from - zero_, p.to - zero_, p.from_direction, p.to_direction);
      if (is_upright(p.from_direction)) in_batch.flat += flat_length(p);
      timed(p);
    }
  }
  const PathSegment& middle = pieces[pieces.size() / 2];
  in_batch.at = 0.5 * (middle.from + middle.to) - zero_;
  if (stock_.sweeps() - batch_.front().first_sweep >= batch_sweeps) cut();
}

void Cutting::finish() {
  if (!zero_known_) release_waiting();
  cut();
  loads_.finish();
  notify_others();
  batch_ = std::vector<Moved>();  // frees the memory of the batch
}

std::size_t Cutting::bytes() const {
  std::size_t sum = stock_.bytes() + times_.bytes();
  each_other([&](const Stock& other) { sum += other.bytes() + other.bytes_of_past(); });
  return sum;
}

CutResult Cutting::result(double left, double error_bound) const {
  CutResult result = result_;
  result.left = left;
  result.error_bound = error_bound;
  result.sweeps = stock_.sweeps();
  result.heaviest = loads_.heaviest();
  result.emptiest = air_.emptiest();
  result.threads = threads_.found_in(stock_);
  return result;
}

}  // namespace kadr
