// Fills bricks with material from the blank, lists the sweeps for each brick, and cuts bricks in parallel (class Stock).

#include "stock/stock.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/thread.h"
#include "stock/portion/portion.h"
#include "stock/portion/sweep_touches.h"

namespace kadr {
namespace {

constexpr double removed_unit = 1.0 / (1 << 20);  // unit in mm; the removed lengths of lattice lines are counted as integers in this unit

/// Number of sweeps after which old copies in the recorded history are deleted, so that it stays within its memory limit.
constexpr std::size_t between_room = 4096;

double part_of_cell(double cell) { return cell / 50; }

/// Clips an interval of a lattice line to the brick, and returns the interval relative to the brick's corner. An interval that spans the
/// brick ends exactly on the faces of the brick.
FurtherInterval within_brick(const LineRange& range, double corner, float edge, std::int32_t line) {
  const double from = std::max(range.from - corner, 0.0), to = std::min(range.to - corner, double(edge));
  return {line, float(from), float(to), of_blank, of_blank};
}

std::unique_ptr<Brick> whole_brick(float edge) {
  std::unique_ptr<Brick> brick(new Brick);  // not filled with zeros first
  for (BrickLines& lines : brick->family)
    for (int i = 0; i < brick_lines; ++i) {
      lines.from[i] = 0, lines.to[i] = edge;
      lines.from_by[i] = lines.to_by[i] = of_blank;
    }
  brick->top_of_square.fill(edge);
  brick->top = edge;
  return brick;
}

bool is_full(const Brick& brick, float edge) {
  for (const BrickLines& lines : brick.family)
    for (int i = 0; i < brick_lines; ++i)
      if (lines.from[i] > 0 || lines.to[i] < edge) return false;
  return true;
}

bool is_empty(const Brick& brick) {
  for (const BrickLines& lines : brick.family)
    for (int i = 0; i < brick_lines; ++i)
      if (lines.from[i] < lines.to[i]) return false;
  return true;
}

void raise_to(std::atomic<float>& most, float value) {
  float now = most.load(std::memory_order_relaxed);
  while (now < value && !most.compare_exchange_weak(now, value, std::memory_order_relaxed)) {
  }
}

/// Returns the distances by which all bodies of a tool together extend around the tip.
AroundTip around_tip(const ToolShape& tool) {
  AroundTip all{0, 0, 0};
  for (const ConvexBody& body : tool.bodies) {
    const AroundTip one = kadr::around_tip(body);
    all = {std::max(all.sideways, one.sideways), std::max(all.below, one.below), std::max(all.above, one.above)};
  }
  return all;
}

}  // namespace

Stock::Stock(std::shared_ptr<const Blank> blank, double cell, int threads, const std::optional<BrickBox>& own)
    : blank_(std::move(blank)),
      lattice_(blank_->box(), cell),
      own_(own.value_or(lattice_.held())),
      is_portion_(own.has_value()),
      scale_(cell),
      bend_cell_(cell),
      threads_(std::max(threads, 1)) {
  if (own) lattice_ = lattice_.held_only(with_neighbours(*own, lattice_.held()));
  bricks_.resize(lattice_.size());
  states_.resize(lattice_.size());
  bins_.resize(lattice_.size());
  const std::vector<bool> at_surface = blank_->bricks_at_surface(lattice_);
  std::atomic<std::size_t> next{0};
  run_parallel(threads_, [&](int) {
    for (std::size_t i; (i = next++) < bricks_.size();) {
      if (at_surface.empty() || at_surface[i]) fill_in(i);
      else fill_evenly(i);
    }
  });
}

/// Fills a brick that the blank's surface does not cross: either with material or not at all.
void Stock::fill_evenly(std::size_t i) {
  const Vec3 middle = lattice_.corner(i) + 0.5 * lattice_.edge() * Vec3{1, 1, 1};
  std::vector<LineRange> ranges;
  blank_->cross(2, middle.x, middle.y, ranges);
  const bool inside = std::any_of(ranges.begin(), ranges.end(), [&](const LineRange& r) { return r.from < middle.z && r.to > middle.z; });
  states_[i] = inside ? State::full : State::empty;
}

std::unique_ptr<Brick> Stock::fresh(std::size_t i) const {
  std::unique_ptr<Brick> brick(new Brick);  // not filled with zeros first
  const Vec3 corner = lattice_.corner(i);
  std::vector<LineRange> ranges;
  for (int family = 0; family < 3; ++family) {
    const int u = (family + 1) % 3, v = (family + 2) % 3;
    BrickLines& lines = brick->family[std::size_t(family)];
    for (int line = 0; line < brick_lines; ++line) {
      lines.from[line] = lines.to[line] = -1;
      lines.from_by[line] = lines.to_by[line] = of_blank;
      ranges.clear();
      blank_->cross(family, along(corner, u) + (line % brick_edge + 0.5) * lattice_.cell(),
                    along(corner, v) + (line / brick_edge + 0.5) * lattice_.cell(), ranges);
      bool first = true;
      for (const LineRange& range : ranges) {
        const FurtherInterval piece = within_brick(range, along(corner, family), scale_.edge, line);
        if (piece.from >= piece.to) continue;
        if (!first) lines.further.push_back(piece);
        else lines.from[line] = piece.from, lines.to[line] = piece.to;
        first = false;
      }
    }
  }
  refresh_tops(*brick, scale_.cell);
  return brick;
}

void Stock::fill_in(std::size_t i) {
  auto brick = fresh(i);
  const bool full = is_full(*brick, scale_.edge);
  states_[i] = full ? State::full : is_empty(*brick) ? State::empty : State::mixed;
  if (states_[i] == State::mixed) bricks_[i] = std::move(brick);
}

std::uint16_t Stock::add_tool(const ToolShape& shape) {
  tools_.push_back(shape);
  std::vector<SweptBody>& swept = swept_.emplace_back();
  std::vector<TiltedBody>& leaning = tilted_.emplace_back();
  for (const ConvexBody& body : shape.bodies) swept.push_back(swept_body(body)), leaning.push_back(tilted_body(body));
  return std::uint16_t(tools_.size() - 1);
}

void Stock::add(const Sweep& sweep) {
  if (tools_[sweep.tool].turns()) return add_turned(sweep);
  if (!is_upright(sweep.from_direction) || !is_upright(sweep.to_direction)) return add_tilted(sweep);
  const Vec3 start = sweep.from - lattice_.origin(), delta = sweep.to - sweep.from;
  const double edge = lattice_.edge();
  const Vec3 most{lattice_.bricks(0) * edge, lattice_.bricks(1) * edge, lattice_.bricks(2) * edge};
  const PathPart part = part_that_reaches(start, delta, around_tip(tools_[sweep.tool]), most);
  const Vec3 from = start + part.first * delta, to = part.last == 1 ? sweep.to - lattice_.origin() : start + part.last * delta;
  KeptSweep stored{};
  for (int d = 0; d < 3; ++d) stored.from[d] = float(along(from, d)), stored.to[d] = float(along(to, d));
  stored.tool = sweep.tool;
  stored.watched = sweep.watched;
  keep(stored, part);
}

/// Adds the sweeps `first` to `last` - 1 to the lists of the bricks that they may reach.
void Stock::bin(std::size_t first, std::size_t last) {
  for (std::size_t i = first; i < last; ++i) {
    const KeptSweep s = sweeps_[i];
    if (s.leans || tools_[s.tool].turns()) {
      s.leans ? bin_tilted(i) : bin_turned(i);
      continue;
    }
    for (const ConvexBody& body : tools_[s.tool].bodies) {
      int low[3], high[3];
      for (int d = 0; d < 3; ++d) {
        const double below = d == 2 ? body.bottom() : -body.widest(), above = d == 2 ? body.top() : body.widest();
        const double least = double(std::min(s.from[d], s.to[d])) + below, most = double(std::max(s.from[d], s.to[d])) + above;
        low[d] = int(std::floor(std::max(least / lattice_.edge(), double(lattice_.first(d)))));
        high[d] = int(std::floor(std::min(most / lattice_.edge(), double(lattice_.last(d)))));
      }
      for (int z = low[2]; z <= high[2]; ++z)
        for (int y = low[1]; y <= high[1]; ++y)
          for (int x = low[0]; x <= high[0]; ++x) put_in_bin(lattice_.at({x, y, z}), i);
    }
  }
}

void Stock::put_in_bin(std::size_t b, std::size_t sweep) {
  if (states_[b] == State::empty) return;
  if (bins_[b].empty()) touched_.push_back(b);
  if (bins_[b].empty() || bins_[b].back() != std::int32_t(sweep)) bins_[b].push_back(std::int32_t(sweep));
}

void Stock::Worker::count(std::int32_t sweep, double length, float longest, float depth) {
  Removed& of_sweep = (*removed)[std::size_t(sweep) - first];
  of_sweep.length.fetch_add(std::llround(length / removed_unit), std::memory_order_relaxed);
  raise_to(of_sweep.longest, longest);
  raise_to(of_sweep.depth, depth);
}

/// Executes one sweep in one brick. `worker` records what the sweep removed; it is nullptr if nothing is to be recorded.
///   returns  true if the brick changed
bool Stock::execute(std::int32_t number, std::size_t b, BrickNow now, Worker* worker) const {
  const Vec3 corner = lattice_.corner(b) - lattice_.origin();
  const KeptSweep s = sweeps_[std::size_t(number)];
  const bool was_full = now.state == State::full;
  std::optional<TiltedSweepInBrick> lean;
  if (s.leans) lean = tilted_sweep_in_brick(std::size_t(number), b);
  if (lean && !may_reach(std::size_t(number), *lean, was_full ? scale_.edge : now.brick->top)) return false;
  if (was_full) now.brick = whole_brick(scale_.edge);
  const Vec3 from{double(s.from[0]) - corner.x, double(s.from[1]) - corner.y, double(s.from[2]) - corner.z};
  const Vec3 to{double(s.to[0]) - corner.x, double(s.to[1]) - corner.y, double(s.to[2]) - corner.z};
  bool changed = tools_[s.tool].turns() && turn(number, b, *now.brick, worker);
  for (std::size_t i = 0; i < swept_[s.tool].size(); ++i) {
    const ConvexBody& body = tools_[s.tool].bodies[i];
    RemovedBox box;
    CutOutcome outcome;
    const bool is_watched = worker != nullptr && (s.watched || body.part != ToolPart::cutting);
    if (is_watched) outcome.watched = &box, outcome.least_piece = float(least_piece());
    if (lean) cut_tilted(std::size_t(number), i, *lean, *now.brick, outcome);
    else cut_brick(*now.brick, scale_, local_sweep(from, to, around_tip(body), lattice_.edge()), swept_[s.tool][i], number, outcome);
    changed = changed || outcome.changed;
    if (worker != nullptr && outcome.changed)
      worker->count(number, outcome.length, outcome.longest, body.part == ToolPart::cutting ? outcome.depth : 0.f);
    if (!is_watched || !box.any()) continue;
    const Vec3 at = lattice_.corner(b);
    const Box3 around{at + Vec3{double(box.least[0]), double(box.least[1]), double(box.least[2])},
                      at + Vec3{double(box.most[0]), double(box.most[1]), double(box.most[2])}};
    worker->touches.push_back({std::uint32_t(number), body.part, around, outcome.length * lattice_.cell() * lattice_.cell()});
  }
  if (changed) now.state = State::mixed;
  else if (was_full) now.brick.reset();
  if (changed && now.brick->top <= 0) now.state = State::empty, now.brick.reset();
  return changed;
}

/// Recomputes the height bounds of the brick, and deletes the brick if no material remains.
void Stock::settle(BrickNow now) const {
  if (!now.brick || now.brick->cuts_since == 0) return;
  refresh_tops(*now.brick, scale_.cell);
  if (now.brick->top <= 0) now.state = State::empty, now.brick.reset();
}

void Stock::cut_in(std::size_t b, Worker& worker) {
  const BrickNow now{bricks_[b], states_[b]};
  Worker* const counting = own_.holds(lattice_.place(b)) ? &worker : nullptr;  // the neighbours of a portion count in their own portions
  for (const std::int32_t number : bins_[b]) {
    if (now.state == State::empty) break;
    const bool was_full = now.state == State::full;
    if (!execute(number, b, now, counting) || !past_) continue;
    if (was_full) past_->of_brick[b].was_full = true;
    past_->add(b, number, now.brick.get());
  }
  settle(now);
}

std::vector<Touch> Stock::cut(const StopToken& stop) {
  first_ = done_;
  removed_ = std::vector<Removed>(sweeps_.size() - first_);
  std::vector<Worker> workers(static_cast<std::size_t>(threads_), Worker{{}, &removed_, first_});
  while (done_ < sweeps_.size() && !stop.requested()) {
    const std::size_t last = past_ ? std::min(done_ + between_room, sweeps_.size()) : sweeps_.size();
    bin(done_, last);
    std::atomic<std::size_t> next{0};
    run_parallel(threads_, [&](int thread) {
      for (std::size_t i; !stop.requested() && (i = next++) < touched_.size();) cut_in(touched_[i], workers[std::size_t(thread)]);
    });
    for (const std::size_t b : touched_) bins_[b] = std::vector<std::int32_t>();  // frees the memory of the brick's list of sweeps at once
    touched_.clear();
    done_ = last;
    if (past_) past_->make_room();
  }
  done_ = sweeps_.size();
  std::vector<Touch> touches;
  for (Worker& w : workers) touches.insert(touches.end(), w.touches.begin(), w.touches.end());
  if (is_portion_) touches_ = touches;
  return one_for_each_sweep(std::move(touches));
}

double Stock::removed_by(std::size_t sweep) const {
  return double(removed_[sweep - first_].length.load(std::memory_order_relaxed)) * removed_unit * lattice_.cell() * lattice_.cell();
}

double Stock::depth_of(std::size_t sweep) const { return double(removed_[sweep - first_].depth.load(std::memory_order_relaxed)); }

bool Stock::cuts_anything(std::size_t sweep) const {
  return double(removed_[sweep - first_].longest.load(std::memory_order_relaxed)) >= least_piece();
}

double Stock::least_piece() const { return part_of_cell(lattice_.cell()); }

std::size_t Stock::bytes() const {
  std::size_t sum = sweeps_.bytes() + tilted_ends_.size() * sizeof(TiltedEnds) + shortened_.size() * sizeof(Shortened) +
                    bricks_.capacity() * (sizeof(void*) + sizeof(State) + sizeof(bins_[0]));
  for (const auto& b : bricks_)
    if (b) sum += bytes_of(*b);
  return sum;
}

}  // namespace kadr
