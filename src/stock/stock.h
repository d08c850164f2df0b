#pragma once
// Stock: the part that is being cut, and the interface of this room for everyone who cuts. The input is the blank and the sweeps of
// tools in order of time, the output the remaining material.
//
//   Stock stock(blank, cell, threads);
//   const std::uint16_t tool = stock.add_tool(shape);
// and so on
// executes the added sweeps
//   const Surface surface = surface_of(stock);             // stock/surface/surface.h
//
// Sweeps are binned by the bricks that they can reach. One thread cuts a whole brick, in order of time, so the result is the same,
// bit for bit, for any number of threads. Lengths are in mm, in the work system of the blank.

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

/// A straight path of a tool. A tilted tool turns evenly from one direction to the other, along the shortest arc. The path of a
/// turning tool lies in the half plane of a part that spins about X0 Y0: x is the signed radius, y is 0.
struct Sweep {
  Vec3 from, to;                                        // of the tip
  std::uint16_t tool = 0;                               // number from Stock::add_tool
  bool watched = false;                                 // everything the cutting part removes is reported: a rapid, a stopped spindle …
  Vec3 from_direction{0, 0, 1}, to_direction{0, 0, 1};  // from the tip into the tool, unit length
};

/// Directions of a tilted tool at both ends of a sweep.
struct LeanEnds {
  std::uint32_t sweep;
  float from[3], to[3];
};

/// Positions are from the lattice's corner.
LeanWay lean_way_of(const KeptSweep& sweep, const LeanEnds& ends);

/// A sweep of a tilted tool, seen from one brick.
struct LeanHere {
  LeanWay way;  // from the brick's corner
  AroundTip around;
  LeanSweep sweep;
  LocalSweep tip;
};

/// A removal of material that has to be reported.
struct Touch {
  std::uint32_t sweep;
  ToolPart part;
  Box3 around;         // box of the removed material; for rings x holds the radii and y is 0
  double volume;       // mm³
  bool rings = false;  // removed by a turning tool
};

class Stock {
 public:
  enum class State : std::uint8_t { empty, full, mixed };

  /// `threads` is the number of threads that cut in parallel, at least 1.
  Stock(std::shared_ptr<const Blank> blank, double cell, int threads);

  std::uint16_t add_tool(const ToolShape& shape);
  /// Adds a sweep, which the next cut() executes. A sweep in which the tool turns far is stored as several sweeps.
  void add(const Sweep& sweep);
  /// Number of sweeps added so far; a divided sweep counts as several.
  std::size_t sweeps() const { return sweeps_.size(); }
  /// Executes the sweeps added since the last call. Removed pieces shorter than least_piece() are not reported.
  ///   returns  the touches to report, in the order of the sweeps
  std::vector<Touch> cut(const StopToken& stop = {});
  /// Divides the paths of tilted tools as a stock with this cell would, so that several stocks hold the same sweeps. Call it before
  /// the first add().
  void divide_as(double cell) { bend_cell_ = cell; }
  /// Keeps each brick's past from now on, so that at() can be called. Call it before the first add().
  ///   most_bytes  limit for the copies of bricks: the fewer copies, the slower at(). The list of what cut each brick comes on top, 4
  ///               bytes a cut
  void keep_past(std::size_t most_bytes);
  /// Returns the stock as it was after the first `count` sweeps and `share` of the next. With a share of 0 it equals, bit for bit, a
  /// stock that only these sweeps have cut.
  ///   share  of the path of that next sweep, 0 to 1
  ///   pre    keep_past() was called before the first add(); count is at most the number of executed sweeps
  Stock at(std::size_t count, double share = 0) const;
  /// Memory of the kept past; 0 if none is kept.
  std::size_t bytes_of_past() const;
  /// Volume that a sweep of the last cut() removed, in mm³, measured on the upright lines.
  double removed_by(std::size_t sweep) const;
  /// Likewise: the greatest height above the tip, in mm, at which the cutting part removed material from upright lines. For each line
  /// the tip counts where it was lowest over that line.
  double depth_of(std::size_t sweep) const;
  /// Likewise: true if the sweep removed a piece of a line, in any direction, of at least least_piece().
  bool cuts_anything(std::size_t sweep) const;

  // ---- remaining stock
  const Lattice& lattice() const { return lattice_; }
  const Blank& blank() const { return *blank_; }
  State state(std::size_t brick) const { return states_[brick]; }
  /// Returns nullptr if the brick is empty or full.
  const Brick* brick(std::size_t i) const { return bricks_[i].get(); }
  KeptSweep sweep(std::size_t i) const { return sweeps_[i]; }
  /// Calls visit(number, sweep) for all sweeps.
  template <class Visit>
  void each_sweep(const Visit& visit) const {
    sweeps_.each(0, sweeps_.size(), visit);
  }
  /// Returns the directions of a sweep with a tilted tool.
  const LeanEnds& lean_ends(std::size_t sweep) const;
  /// mm by which lines of the three directions may disagree about the position of the same surface.
  float families_agree() const;
  const ToolShape& tool(std::size_t i) const { return tools_[i]; }
  std::size_t tools() const { return tools_.size(); }
  int threads() const { return threads_; }
  std::size_t bytes() const;
  /// Removed pieces of a line shorter than this do not count as touches, mm.
  double least_piece() const;

 private:
  /// What a sweep removed in all bricks: sums and maxima, which do not depend on the order of the bricks.
  struct Removed {
    std::atomic<std::int64_t> length{0};  // of upright lines, in units of `removed_unit`
    std::atomic<float> depth{0}, longest{0};
  };
  struct Worker {
    std::vector<Touch> touches;
    std::vector<Removed>* removed;
    std::size_t first;  // the first sweep in `removed`

    /// Adds what a sweep removed: mm of upright lines, the longest piece of any line, and the greatest height above the tip.
    void count(std::int32_t sweep, double length, float longest, float depth);
  };
  struct BrickNow {
    std::unique_ptr<Brick>& brick;
    State& state;
  };
  /// The part of a sweep's path that is kept, as shares of the path; the rest reaches no material.
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
  // Tilted tools: stock_leaning.cpp.
  double most_bend() const;
  void add_leaning(const Sweep& sweep);
  void bin_leaning(std::size_t sweep);
  LeanHere lean_here(std::size_t sweep, std::size_t brick) const;
  bool may_reach(std::size_t sweep, const LeanHere& here, float top) const;
  void cut_leaning(std::size_t sweep, std::size_t body, const LeanHere& here, Brick& material, CutOutcome& outcome) const;
  // Turning tools: stock_turned.cpp.
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
  double bend_cell_;  // mm, from divide_as()
  int threads_;
  std::vector<std::unique_ptr<Brick>> bricks_;
  std::vector<State> states_;
  std::vector<ToolShape> tools_;
  std::vector<std::vector<SweptBody>> swept_;  // for each body of each tool
  std::vector<std::vector<LeanBody>> leaning_;
  KeptSweeps sweeps_;
  std::deque<LeanEnds> lean_ends_;   // in the order of the sweeps; a deque grows to a million without moving its elements
  std::deque<Shortened> shortened_;  // in the order of the sweeps; only where a past is kept
  std::size_t done_ = 0;             // number of sweeps executed
  std::size_t first_ = 0;            // first sweep of the last cut()
  std::vector<std::vector<std::int32_t>> bins_;
  std::vector<std::size_t> touched_;
  std::unique_ptr<Past> past_;
  std::vector<Removed> removed_;  // of the last cut()
};

}  // namespace kadr
