#pragma once
// Cutting: executes the steps of a run on the part: where which tool goes, what it removes, and what it must not touch.
//
//   Step ─ ToolWay ─▶ pieces ─▶ Stock (in batches) ─▶ Touch ─▶ CutFinding
//
// Pieces are cut in batches, so findings come when their batch is complete. Pieces are kept until the work system of the blank is known,
// which is at the first motion at feed.

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "base/result.h"
#include "config/tool_library.h"
#include "session/cutting/air_lines.h"
#include "session/cutting/block_load.h"
#include "session/cutting/sweep_lines.h"
#include "session/cutting/sweep_times.h"
#include "session/cutting/thread_cuts.h"
#include "session/cutting/tool_way.h"
#include "stock/cut_result.h"
#include "stock/stock.h"

namespace kadr {

/// When the machine executes a step, s since the start of the program: later than the programmed time if accelerations or limits slow the
/// machine down.
struct MachineTime {
  double begins = 0, seconds = 0;
};

struct CutJob {
  std::shared_ptr<const Blank> blank;
  std::vector<std::shared_ptr<const Blank>> fixtures;  // must never be cut
  ToolLibrary tools;
  /// By tool: its actual length, if the control's table states it under the tool's own number. Other tools are as long as the control
  /// assumes.
  std::map<std::uint32_t, double> lengths;
  std::shared_ptr<const MachineTree> machine;  // as its file describes it; nullptr if it does not
  double cell = 0.5;                           // mm
  std::shared_ptr<const Blank> window;         // blank_within() of the window that is cut again, finer; nullptr: no window
  double window_cell = 0;                      // mm
  double seen_cell = 0;                        // mm: cells of the coarser stock that can be shown at any instant; 0: no such stock
  std::size_t past_bytes = 0;                  // memory that Stock::keep_past() gets for it
  int threads = 1;
  std::optional<std::uint16_t> system;  // of ToolWay
  std::optional<Axes> apart;            // of ToolWay
  bool wants_coolant = false;           // cutting without coolant is a warning
  std::vector<AlarmId> disabled;        // warnings that are not reported
  std::uint32_t tool = 0;               // in the spindle at the start
  SpindleDir spindle = SpindleDir::stop;
  double rpm = 0;             // spindle speed at the start
  bool keeps_rates = false;   // Cutting::rates() is needed
  bool starts_known = false;  // the set-up states the start position; else it is known once X, Y and Z have each been named
  double until = 1e300;       // s of the program: later motions are not cut
  StopToken stop;
};

class Cutting {
 public:
  Cutting(const CutJob& job, const AxisRoles& roles);

  /// Receives each finding of a batch, in the order of the program.
  std::function<void(const CutFinding&)> on_finding;
  /// Receives what each block that moves at feed has removed, in the order of the program, delayed by a batch and some blocks.
  std::function<void(const BlockLoad&)> on_block;

  /// returns  alarm tool_without_shape: the step is not cut
  Status consume(const Step& step, const MachineTime& time);
  /// Adds a finding that another check made in a step already consumed; it is reported together with those of the cut.
  void also(const CutFinding& finding) { others_.push_back(finding); }
  /// Cuts everything that is still pending.
  void finish();
  /// Call after finish(). `left`: volume of the surface of the remaining stock.
  CutResult result(double left, double error_bound) const;
  /// The program line of a sweep of the stock, with the file as Origin::file; line 0 for of_blank.
  SweepLines::Line line_of(std::int32_t sweep) const { return sweep < 0 ? SweepLines::Line() : lines_.of(std::size_t(sweep)); }
  /// By sweep: removal rate of its block, mm³/s; 0: at rapid, or not known. Shorter than the list of sweeps if the last ones have no rate.
  const std::vector<float>& rates() const { return rate_of_sweep_; }
  const Stock& stock() const { return stock_; }
  /// The stock of the window; nullptr if there is none. Its sweeps have the same numbers.
  const Stock* window() const { return window_.get(); }
  /// The stock with CutJob::seen_cell, which can show its past; nullptr if there is none. Its sweeps have the same numbers.
  const Stock* seen() const { return seen_.get(); }
  /// The sweeps that are executed at an instant of the machine's time.
  SweepPlace sweeps_at(double instant) const { return times_.at(instant); }
  /// Zero of the blank's work system in machine coordinates; after finish().
  Vec3 zero() const { return zero_; }
  /// Memory of all stocks and of the data kept about sweeps.
  std::size_t bytes() const;

 private:
  /// A motion whose pieces are in the batch.
  struct Moved {
    Origin origin;
    std::size_t first_sweep = 0;
    std::uint32_t tool = 0;
    std::size_t use = 0;       // index into result_.tools
    AlarmId fault = no_alarm;  // reported if its cutting part removes anything
    bool cuts = false, lacks_coolant = false;
    double begins = 0, seconds = 0, length = 0, flat = 0;
    double whole = 0;                // s of the whole motion
    double diameter = 0, teeth = 0;  // of CutMotion
    Vec3 at;
    Vec2 radius;                              // turning tools: unit vector from the axis towards the tool; else 0
    bool in_groove = false, threads = false;  // turning tools: its insert is in a thread; it cuts the thread
    double lead = 0;                          // of the thread, mm; 0: not stated by the program
  };
  struct Kept {
    Moved moved;
    std::vector<WayPiece> pieces;
    std::uint16_t shape;
  };
  void note(const Action& action);
  AxisMask unknown_now() const;
  bool place_known(const Motion& motion);
  bool is_in_groove(const Motion& motion);
  std::optional<std::uint16_t> shape_of_tool();
  AlarmId fault_of(const Motion& motion, const std::vector<WayPiece>& pieces, const ToolGeometry& tool) const;
  /// Visits the stocks other than that of the whole.
  template <class Visit>
  void each_other(const Visit& visit) const;
  void add(const Moved& moved, const std::vector<WayPiece>& pieces, std::uint16_t shape);
  void shift_by_length();
  void release_kept();
  void cut();
  void count_removed();
  void tell(const std::vector<Touch>& touches, bool of_fixture);
  double least_depth(const Box3& around) const;
  static AlarmId fault_of_touch(const Moved& moved, ToolPart part, bool of_fixture);
  void keep(const CutFinding& finding);
  void tell_others();
  std::size_t use_of(std::uint32_t tool);

  CutJob job_;
  ToolWay way_;
  Stock stock_;
  std::unique_ptr<Stock> window_, seen_;
  std::vector<std::unique_ptr<Stock>> fixtures_;
  std::set<std::uint32_t> without_coolant_;                      // lines reported
  std::vector<std::pair<std::uint32_t, std::uint16_t>> shapes_;  // tool → Stock::add_tool
  AxisMask unknown_ = 0;                                         // those of X, Y, Z along which the position of the tool is not known
  AxisMask across_ = 0;                                          // X and Y
  std::uint32_t tool_;
  SpindleDir spindle_;
  std::uint32_t spinning_ = 0;  // spindles that rotate, one bit each: any may rotate the part
  bool in_thread_ = false;      // the last motion of a turning tool was a pass of a thread
  double rpm_;
  std::uint32_t speedless_ = 0;  // spindles with a programmed speed of 0, one bit each
  Coolant coolant_ = Coolant::off;
  std::vector<WayPiece> pieces_;
  std::vector<Kept> kept_;
  std::vector<Moved> batch_;
  std::vector<CutFinding> others_;
  SweepLines lines_;
  SweepTimes times_;  // filled if there is a stock to be shown
  std::vector<float> rate_of_sweep_;
  Vec3 zero_;
  bool zero_known_ = false;
  struct Rate {
    double volume = 0, seconds = 0, length = 0;
    std::size_t use = 0;
  } rate_;
  BlockLoads loads_;
  AirLines air_;
  ThreadCuts threads_;
  CutResult result_;
};

}  // namespace kadr
