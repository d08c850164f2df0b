#pragma once
// Stock: the part that is being cut. The one door of this room for whoever cuts: the blank, sweeps of tools in the order of time, what is
// left.
//
//   Stock stock(blank, cell, threads);
//   const std::uint16_t tool = stock.add_tool(shape);
//   stock.add({.from = from, .to = to, .tool = tool});     // and so on
//   const std::vector<Touch> touches = stock.cut();        // carries out what was added
//   const Surface surface = surface_of(stock);             // stock/surface/surface.h
//
// Sweeps are binned by the bricks that they can reach; a brick is the work of one thread, in the order of time. So the answer is the same,
// bit by bit, for any number of threads. Lengths mm, in the work system of the blank.

#include <atomic>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <vector>

#include "base/stop.h"
#include "stock/blank/blank.h"
#include "stock/brick/brick.h"
#include "stock/brick/brick_past.h"
#include "stock/brick/lattice.h"
#include "stock/cut/brick_cut.h"
#include "stock/cut/lean_body.h"
#include "stock/cut/lean_cut.h"
#include "stock/cut/lean_way.h"
#include "stock/cut/swept_body.h"
#include "stock/kept_sweeps.h"
#include "stock/tool/round_solid.h"

namespace kadr {

/// A straight way of a tool. One that leans turns evenly from one direction to the other, the shortest way. Of a turning tool: in the half
/// plane of a part that spins about X0 Y0, x the signed radius, y 0.
struct Sweep {
  Vec3 from, to;                                        // of the tip
  std::uint16_t tool = 0;                               // of Stock::add_tool
  bool watched = false;                                 // whatever its cutting part takes away is told: a rapid, a spindle that stands …
  Vec3 from_direction{0, 0, 1}, to_direction{0, 0, 1};  // from the tip into the tool, of length 1
};

/// Directions of a tool that leans, at both ends of a sweep.
struct LeanEnds {
  std::uint32_t sweep;
  float from[3], to[3];
};

/// From the lattice's corner.
LeanWay lean_way_of(const KeptSweep& sweep, const LeanEnds& ends);

/// A sweep of a tool that leans as a brick sees it.
struct LeanHere {
  LeanWay way;  // from the brick's corner
  AroundTip around;
  LeanSweep sweep;
  LocalSweep tip;
};

/// A part of the tool took material away that is to be told.
struct Touch {
  std::uint32_t sweep;
  ToolPart part;
  Box3 around;         // what was taken; rings: x radii, y 0
  double volume;       // mm³
  bool rings = false;  // by a turning tool
};

class Stock {
 public:
  enum class State : std::uint8_t { empty, full, mixed };

  /// `threads`: that cut at once, at least 1.
  Stock(std::shared_ptr<const Blank> blank, double cell, int threads);

  std::uint16_t add_tool(const ToolShape& shape);
  /// Carried out by the next cut(). A tool that turns much on its way is kept as several sweeps.
  void add(const Sweep& sweep);
  /// Sweeps that have been added.
  std::size_t sweeps() const { return sweeps_.size(); }
  /// What was added since the last time. `least_piece`: shorter pieces on a line are no touch, mm.
  ///   returns  what is to be told, in the order of the sweeps
  std::vector<Touch> cut(const StopToken& stop = {});
  /// Ways of tools that lean are divided as in a stock of this cell, so that several keep the same sweeps. Before the first add().
  void divide_as(double cell) { bend_cell_ = cell; }
  /// From now on each brick's past is kept, so that at() can be asked. Before the first add().
  ///   most_bytes  of copies of bricks: the fewer, the longer at() takes. The list of what cut each brick comes on top, 4 bytes a cut
  void keep_past(std::size_t most_bytes);
  /// As it was when the first `count` sweeps were carried out, and `share` of the next: without that the same bits as of a stock that they
  /// alone have cut.
  ///   share  of the way of that sweep, 0 to 1
  ///   pre    keep_past() before the first add(); count is at most what has been cut
  Stock at(std::size_t count, double share = 0) const;
  /// Of the past; 0: none is kept.
  std::size_t bytes_of_past() const;
  /// mm³ that a sweep of the last cut() took away, by the upright lines.
  double removed_by(std::size_t sweep) const;
  /// … the greatest height above the tip of what its cutting part took off upright lines: of the tip as it stood lowest over the line, mm.
  double depth_of(std::size_t sweep) const;
  /// … whether it took away a piece of a line, in any direction, that is no touch.
  bool cuts_anything(std::size_t sweep) const;

  // ---- what is left
  const Lattice& lattice() const { return lattice_; }
  const Blank& blank() const { return *blank_; }
  State state(std::size_t brick) const { return states_[brick]; }
  /// nullptr: it is empty or full.
  const Brick* brick(std::size_t i) const { return bricks_[i].get(); }
  KeptSweep sweep(std::size_t i) const { return sweeps_[i]; }
  /// Visits (number, sweep) of all.
  template <class Visit>
  void each_sweep(const Visit& visit) const {
    sweeps_.each(0, sweeps_.size(), visit);
  }
  /// Of a sweep that leans.
  const LeanEnds& lean_ends(std::size_t sweep) const;
  /// mm by which lines of the three directions may put the same surface apart.
  float families_agree() const;
  const ToolShape& tool(std::size_t i) const { return tools_[i]; }
  std::size_t tools() const { return tools_.size(); }
  int threads() const { return threads_; }
  std::size_t bytes() const;
  /// Pieces of a line shorter than this are no touch, mm.
  double least_piece() const;

 private:
  /// What a sweep took away in all bricks: sums and maxima that the order does not change.
  struct Removed {
    std::atomic<std::int64_t> length{0};  // of upright lines, in units of `removed_unit`
    std::atomic<float> depth{0}, longest{0};
  };
  struct Worker {
    std::vector<Touch> touches;
    std::vector<Removed>* removed;
    std::size_t first;  // of the sweeps in `removed`

    /// Of what a sweep took away: mm of upright lines, the longest piece of any line, the greatest height above the tip.
    void count(std::int32_t sweep, double length, float longest, float depth);
  };
  struct BrickNow {
    std::unique_ptr<Brick>& brick;
    State& state;
  };
  /// Of a sweep only this part of its way is kept: the rest reaches nothing.
  struct Shortened {
    std::uint32_t sweep;
    float first, last;
  };
  Stock(const Stock& later, std::size_t count);
  void keep(const KeptSweep& sweep, WayPart part);
  WayPart kept_part(std::size_t sweep) const;
  void begin_sweep(const Stock& later, double share);
  std::unique_ptr<Brick> fresh(std::size_t i) const;
  void fill_in(std::size_t i);
  void fill_evenly(std::size_t i);
  void bin(std::size_t first, std::size_t last);
  void put_in_bin(std::size_t brick, std::size_t sweep);
  // Of tools that lean: stock_leaning.cpp.
  double most_bend() const;
  void add_leaning(const Sweep& sweep);
  void bin_leaning(std::size_t sweep);
  LeanHere lean_here(std::size_t sweep, std::size_t brick) const;
  bool may_reach(std::size_t sweep, const LeanHere& here, float top) const;
  void cut_leaning(std::size_t sweep, std::size_t body, const LeanHere& here, Brick& material, CutOutcome& outcome) const;
  // Of turning tools: stock_turned.cpp.
  void add_turned(const Sweep& sweep);
  void bin_turned(std::size_t sweep);
  bool turn(std::int32_t sweep, std::size_t brick, Brick& material, Worker* worker) const;
  void cut_in(std::size_t brick, Worker& worker);
  bool carry_out(std::int32_t sweep, std::size_t brick, BrickNow now, Worker* worker) const;
  void settle(BrickNow now) const;
  void go_back(const Stock& later, std::size_t brick);

  std::shared_ptr<const Blank> blank_;
  Lattice lattice_;
  BrickScale scale_;
  double bend_cell_;  // mm: of divide_as()
  int threads_;
  std::vector<std::unique_ptr<Brick>> bricks_;
  std::vector<State> states_;
  std::vector<ToolShape> tools_;
  std::vector<std::vector<SweptBody>> swept_;  // for each body of each tool
  std::vector<std::vector<LeanBody>> leaning_;
  KeptSweeps sweeps_;
  std::deque<LeanEnds> lean_ends_;   // in the order of the sweeps; a million grow without being moved
  std::deque<Shortened> shortened_;  // in the order of the sweeps; where a past is kept
  std::size_t done_ = 0;             // of sweeps_
  std::size_t first_ = 0;            // of the last cut()
  std::vector<std::vector<std::int32_t>> bins_;
  std::vector<std::size_t> touched_;
  std::unique_ptr<Past> past_;
  std::vector<Removed> removed_;  // of the last cut()
};

}  // namespace kadr
