#pragma once
// Stock: the part that is being cut, and the interface of the room `stock` for all code that cuts. The input is the blank and the sweeps
// (straight tool paths) in order of time; the output is the remaining material.
//
//   Stock stock(blank, cell, threads);
//   const std::uint16_t tool = stock.add_tool(shape);
//   stock.add({.from = from, .to = to, .tool = tool});     // and further sweeps
//   const std::vector<Touch> touches = stock.cut();        // executes the added sweeps
//   const Surface surface = surface_of(stock);             // stock/surface/surface.h
//
// The stock is a lattice of bricks (stock/brick/brick.h). For each brick, Stock lists the sweeps that can reach it. One thread cuts a whole
// brick, in order of time, so the result is the same, bit for bit, for any number of threads. Lengths are in mm, in the work coordinates of
// the blank.

#include <atomic>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "base/stop_token.h"
#include "stock/blank/blank.h"
#include "stock/brick/brick.h"
#include "stock/brick/brick_past.h"
#include "stock/brick/lattice.h"
#include "stock/cut/brick_cut.h"
#include "stock/cut/swept_body.h"
#include "stock/cut/tilted_body.h"
#include "stock/cut/tilted_cut.h"
#include "stock/cut/tilted_path.h"
#include "stock/kept_sweeps.h"
#include "stock/tool/round_solid.h"

namespace kadr {

/// A straight path of a tool. A tilted tool turns evenly from one direction to the other, along the shortest arc. The path of a turning
/// tool lies in the half plane of a part that spins about the axis X0 Y0: x is the signed radius, y is 0.
struct Sweep {
  Vec3 from, to;           // start and end position of the tip, mm
  std::uint16_t tool = 0;  // number of the tool, as Stock::add_tool() returned it
  // True if removals by the cutting part must be reported too, because the motion is a rapid or the spindle does not turn.
  bool watched = false;
  Vec3 from_direction{0, 0, 1}, to_direction{0, 0, 1};  // unit vectors from the tip into the tool, at the start and the end of the path
};

/// Directions of a tilted tool at the start and the end of a sweep, as unit vectors.
struct TiltedEnds {
  std::uint32_t sweep;
  float from[3], to[3];
};

/// Returns the path of a stored sweep of a tilted tool. Positions are in mm, relative to the lattice's corner.
TiltedPath tilted_path_of(const KeptSweep& sweep, const TiltedEnds& ends);

/// A sweep of a tilted tool, in the coordinates of one brick.
struct TiltedSweepInBrick {
  TiltedPath path;  // path of the sweep, relative to the brick's corner
  AroundTip around;
  TiltedSweep sweep;
  LocalSweep tip;
};

/// What a sweep removed: the length from lattice lines along Z, in units of Stock::cut()'s count, the greatest height above the tip and the
/// longest interval of any line, mm.
struct SweepRemoval {
  std::uint32_t sweep;
  float depth, longest;
  std::int64_t length;
};

/// A removal of material that must be reported: a part of the tool removed material that this part must not remove.
struct Touch {
  std::uint32_t sweep;
  ToolPart part;
  Box3 around;         // box around the removed material; for a turning tool x is the range of radii and y is 0
  double volume;       // volume of the removed material, mm³
  bool rings = false;  // true if a turning tool removed the material
};

/// What the bricks of a portion contribute to one call of Stock::cut().
struct PortionCut {
  std::vector<SweepRemoval> removed;  // in the order of the sweeps
  std::vector<Touch> touches;         // one for each brick, sweep and tool part
};

class Stock {
 public:
  enum class State : std::uint8_t { empty, full, mixed };

  /// `threads` is the number of threads that cut in parallel, at least 1. `own`: the bricks of a portion (stock/portion/portion.h), of
  /// which the stock holds these and their neighbours; nullopt: all bricks.
  Stock(std::shared_ptr<const Blank> blank, double cell, int threads, const std::optional<BrickBox>& own = std::nullopt);

  std::uint16_t add_tool(const ToolShape& shape);
  /// Adds a sweep, which the next cut() executes. A sweep in which the tool turns far is stored as several sweeps.
  void add(const Sweep& sweep);
  /// Returns the number of sweeps added so far; a divided sweep counts as several.
  std::size_t sweeps() const { return sweeps_.size(); }
  /// Executes the sweeps added since the last call. A removal that is shorter than least_piece() on every lattice line is not reported.
  ///   returns  the touches to report, in the order of the sweeps
  std::vector<Touch> cut(const StopToken& stop = {});
  /// Returns what the own bricks of a portion contribute to the last cut().
  PortionCut portion_cut() const;
  /// Adds to the last cut() of a stock without bricks what the portions have removed.
  ///   returns  the touches to report, as cut() of a stock with all bricks
  std::vector<Touch> add_portions(const std::vector<PortionCut>& portions);
  /// Returns a number that depends on all sweeps and tools: processes with the same number have cut with the same paths.
  std::uint64_t fingerprint() const;
  /// Sets the cell size that decides how the paths of tilted tools are divided, so that stocks with different cells store the same sweeps.
  /// Must be called before the first add().
  void divide_as(double cell) { bend_cell_ = cell; }
  /// Starts to record the history of each brick, so that at() can be called. Must be called before the first add().
  ///   max_bytes  limit for the stored copies of bricks: with fewer copies, at() is slower. The list of the sweeps that cut each brick
  ///              needs additional memory, 4 bytes per cut
  void keep_past(std::size_t max_bytes);
  /// Returns the stock after the first `count` sweeps and a part of the next sweep. If `share` is 0, the result equals, bit for bit, a
  /// stock that only the first `count` sweeps have cut.
  ///   share  fraction of the path of the next sweep, 0 to 1
  ///   pre    keep_past() was called before the first add(); count is at most the number of executed sweeps
  Stock at(std::size_t count, double share = 0) const;
  /// Returns the memory of the recorded history in bytes; 0 if keep_past() was not called.
  std::size_t bytes_of_past() const;
  /// Returns the volume in mm³ that a sweep of the last cut() removed, measured on the lattice lines along Z.
  double removed_by(std::size_t sweep) const;
  /// Returns the greatest height above the tip, in mm, at which the cutting part removed material from lattice lines along Z in a sweep of
  /// the last cut(). On each line the height is measured from the lowest position of the tip over the line.
  double depth_of(std::size_t sweep) const;
  /// Returns true if a sweep of the last cut() removed an interval of at least least_piece() from a lattice line in any direction.
  bool cuts_anything(std::size_t sweep) const;

  // ---- the remaining stock
  const Lattice& lattice() const { return lattice_; }
  /// Returns the bricks of which the result is wanted: of a portion its own ones, else all.
  const BrickBox& own() const { return own_; }
  bool is_portion() const { return is_portion_; }
  const Blank& blank() const { return *blank_; }
  State state(std::size_t brick) const { return states_[brick]; }
  /// Returns a brick; nullptr if the brick is empty or full.
  const Brick* brick(std::size_t i) const { return bricks_[i].get(); }
  KeptSweep sweep(std::size_t i) const { return sweeps_[i]; }
  /// Calls visit(number, sweep) for all sweeps.
  template <class Visit>
  void each_sweep(const Visit& visit) const {
    sweeps_.each(0, sweeps_.size(), visit);
  }
  /// Returns the directions of a sweep with a tilted tool.
  const TiltedEnds& tilted_ends(std::size_t sweep) const;
  /// Returns the greatest difference, in mm, between the positions of the same surface on lattice lines of the three directions.
  float families_agree() const;
  const ToolShape& tool(std::size_t i) const { return tools_[i]; }
  std::size_t tools() const { return tools_.size(); }
  int threads() const { return threads_; }
  std::size_t bytes() const;
  /// Returns the length in mm below which a removed interval of a lattice line does not count as a touch.
  double least_piece() const;

 private:
  /// What a sweep removed in all bricks. Sums and maxima are stored, so that the order of the bricks does not matter.
  struct Removed {
    std::atomic<std::int64_t> length{0};  // length removed from the lattice lines along Z, in units of `removed_unit`
    std::atomic<float> depth{0}, longest{0};
  };
  struct Worker {
    std::vector<Touch> touches;
    std::vector<Removed>* removed;
    std::size_t first;  // number of the sweep to which the first element of `removed` belongs

    /// Adds what a sweep removed: the length in mm on lattice lines along Z, the longest interval of any line, and the greatest height
    /// above the tip.
    void count(std::int32_t sweep, double length, float longest, float depth);
  };
  struct BrickNow {
    std::unique_ptr<Brick>& brick;
    State& state;
  };
  /// The part of a sweep's path that is stored, from the fraction `first` to the fraction `last` of the path; the other parts reach no
  /// material.
  struct Shortened {
    std::uint32_t sweep;
    float first, last;
  };
  Stock(const Stock& later, std::size_t count);
  void keep(const KeptSweep& sweep, PathPart part);
  PathPart stored_part(std::size_t sweep) const;
  void begin_sweep(const Stock& later, double share);
  std::unique_ptr<Brick> fresh(std::size_t i) const;
  void fill_in(std::size_t i);
  void fill_evenly(std::size_t i);
  void bin(std::size_t first, std::size_t last);
  void put_in_bin(std::size_t brick, std::size_t sweep);
  // Functions for tilted tools; stock_tilted.cpp defines them.
  double most_bend() const;
  void add_tilted(const Sweep& sweep);
  void bin_tilted(std::size_t sweep);
  TiltedSweepInBrick tilted_sweep_in_brick(std::size_t sweep, std::size_t brick) const;
  bool may_reach(std::size_t sweep, const TiltedSweepInBrick& here, float top) const;
  void cut_tilted(std::size_t sweep, std::size_t body, const TiltedSweepInBrick& here, Brick& material, CutOutcome& outcome) const;
  // Functions for turning tools; stock_turned.cpp defines them.
  void add_turned(const Sweep& sweep);
  void bin_turned(std::size_t sweep);
  bool turn(std::int32_t sweep, std::size_t brick, Brick& material, Worker* worker) const;
  void cut_in(std::size_t brick, Worker& worker);
  bool execute(std::int32_t sweep, std::size_t brick, BrickNow now, Worker* worker) const;
  void settle(BrickNow now) const;
  void go_back(const Stock& later, std::size_t brick);

  std::shared_ptr<const Blank> blank_;
  Lattice lattice_;
  BrickBox own_;
  bool is_portion_ = false;
  BrickScale scale_;
  double bend_cell_;  // cell size in mm that decides how the paths of tilted tools are divided; see divide_as()
  int threads_;
  std::vector<std::unique_ptr<Brick>> bricks_;
  std::vector<State> states_;
  std::vector<ToolShape> tools_;
  std::vector<std::vector<SweptBody>> swept_;  // the bodies of each tool, one vector per tool
  std::vector<std::vector<TiltedBody>> tilted_;
  KeptSweeps sweeps_;
  // Directions of tilted tools in the order of the sweeps. A std::deque grows to a million elements without moving them.
  std::deque<TiltedEnds> tilted_ends_;
  // The stored part of the path, for each sweep of which only a part is stored; in the order of the sweeps, and used only after
  // keep_past().
  std::deque<Shortened> shortened_;
  std::size_t done_ = 0;   // number of executed sweeps
  std::size_t first_ = 0;  // number of the first sweep of the last cut()
  std::vector<std::vector<std::int32_t>> bins_;
  std::vector<std::size_t> touched_;
  std::unique_ptr<Past> past_;
  std::vector<Removed> removed_;  // what each sweep of the last cut() removed
  std::vector<Touch> touches_;    // touches of the last cut(), one for each brick; only of a portion
};

}  // namespace kadr
