#pragma once
// Cutting: simulates the removal of material by the steps of a run: the path of each tool, the volume it removes, and collisions with
// what it must not touch.
//
//   Step ─ ToolPath ─▶ straight pieces ─▶ Stock (in batches) ─▶ Touch ─▶ CutFinding
//
// The pieces are cut in batches, so a finding is reported when its batch is complete. Until the work system of the blank is known, at the
// first motion at feed, the pieces are kept. A sweep of the stock is the movement of a tool along one straight piece.

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "base/result.h"
#include "config/tools/tool_library.h"
#include "session/cutting/air_lines.h"
#include "session/cutting/block_load.h"
#include "session/cutting/sweep_lines.h"
#include "session/cutting/sweep_times.h"
#include "session/cutting/thread_cuts.h"
#include "session/cutting/tool_path.h"
#include "stock/cut_result.h"
#include "stock/stock.h"

namespace kadr {

/// The real time at which the machine executes a step, s since the start of the program. It is later than the programmed time if
/// accelerations or limits slow the machine down.
struct MachineTime {
  double begins = 0, seconds = 0;
};

struct CutJob {
  std::shared_ptr<const Blank> blank;
  std::vector<std::shared_ptr<const Blank>> fixtures;  // clamping bodies, which must never be cut
  ToolLibrary tools;
  /// Actual length of each tool, by number, if the control's table states the length under the tool's own number. Any other tool is
  /// assumed to be as long as the control applies it.
  std::map<std::uint32_t, double> lengths;
  std::shared_ptr<const MachineTree> machine;  // the kinematics from the machine's file; nullptr: the file does not describe them
  double cell = 0.5;                           // cell size of the stock, mm
  // the part of the blank that is cut again with finer cells, from blank_within(); nullptr: no window
  std::shared_ptr<const Blank> window;
  double window_cell = 0;      // cell size of the window, mm
  double seen_cell = 0;        // cell size, mm, of the coarser stock that can be displayed at any instant; 0: no such stock
  std::size_t past_bytes = 0;  // memory of the coarser stock for its past: Stock::keep_past()
  int threads = 1;
  std::optional<std::uint16_t> system;  // number of the work system for the path, see ToolPath
  std::optional<Axes> apart;            // rapid rates, if each axis moves at its own rate, see ToolPath
  bool wants_coolant = false;           // warn of cutting without coolant
  std::vector<AlarmId> disabled;        // warnings that are not to be reported
  std::uint32_t tool = 0;               // number of the tool in the spindle at the start
  SpindleDir spindle = SpindleDir::stop;
  double rpm = 0;            // spindle speed at the start, rev/min
  bool keeps_rates = false;  // Cutting::rates() will be used
  // the set-up states the start position; false: the position is known when X, Y and Z have each been programmed
  bool starts_known = false;
  double until = 1e300;  // motions after this time of the program, s, are not cut
  StopToken stop;
};

class Cutting {
 public:
  Cutting(const CutJob& job, const AxisRoles& roles);

  /// Receives the findings, batch by batch, in the order of the program.
  std::function<void(const CutFinding&)> on_finding;
  /// Receives what each block has removed at feed, in the order of the program; the function is called a batch and some blocks later.
  std::function<void(const BlockLoad&)> on_block;

  /// Processes a step. Returns the alarm tool_without_shape if the step cannot be cut.
  Status consume(const Step& step, const MachineTime& time);
  /// Adds a finding that another check made in an earlier step; it is reported together with the findings of the stock.
  void also(const CutFinding& finding) { others_.push_back(finding); }
  /// Cuts everything that is still pending.
  void finish();
  /// Call after finish(). `left`: volume enclosed by the surface of the remaining stock.
  CutResult result(double left, double error_bound) const;
  /// Returns the program line of a sweep of the stock, with Origin::file; line 0 if `sweep` is of_blank.
  SweepLines::Line line_of(std::int32_t sweep) const { return sweep < 0 ? SweepLines::Line() : lines_.of(std::size_t(sweep)); }
  /// By number of the sweep: removal rate of the block to which the sweep belongs, mm³/s; 0: the sweep is a rapid, or its rate is unknown.
  /// The last sweeps may be missing.
  const std::vector<float>& rates() const { return rate_of_sweep_; }
  const Stock& stock() const { return stock_; }
  /// The stock of the window, with the same numbers of sweeps; nullptr if there is no window.
  const Stock* window() const { return window_.get(); }
  /// The coarser stock (CutJob::seen_cell), which can display its past, with the same numbers of sweeps; nullptr if there is none.
  const Stock* seen() const { return seen_.get(); }
  /// Returns which sweeps have been executed at an instant of the machine's time.
  SweepProgress sweeps_at(double instant) const { return times_.at(instant); }
  /// The zero point of the blank's work system in machine coordinates. Call after finish().
  Vec3 zero() const { return zero_; }
  /// Memory of all stocks and of the data about sweeps, bytes.
  std::size_t bytes() const;

 private:
  /// A motion whose straight pieces are in the current batch.
  struct Moved {
    Origin origin;
    std::size_t first_sweep = 0;
    std::uint32_t tool = 0;
    std::size_t use = 0;       // index of the tool's row in result_.tools
    AlarmId fault = no_alarm;  // the fault to report if the cutting part of the tool removes material on this motion
    bool cuts = false, lacks_coolant = false;
    double begins = 0, seconds = 0, length = 0, flat = 0;
    double whole = 0;                // time of the whole motion, s
    double diameter = 0, teeth = 0;  // as in CutMotion
    Vec3 at;
    Vec2 radius;                              // turning tools: unit vector from the axis of rotation towards the tool; else 0
    bool in_groove = false, threads = false;  // turning tools: the insert moves in a thread groove; the motion itself cuts the thread
    double lead = 0;                          // thread lead, mm; 0: the program does not state it
  };
  struct Kept {
    Moved moved;
    std::vector<PathSegment> pieces;
    std::uint16_t shape;
  };
  void note(const Action& action);
  AxisMask unknown_now() const;
  bool place_known(const Motion& motion);
  bool is_in_groove(const Motion& motion);
  std::optional<std::uint16_t> shape_of_tool();
  AlarmId fault_of(const Motion& motion, const std::vector<PathSegment>& pieces, const ToolGeometry& tool) const;
  /// Calls `visit` with each stock except the main one: window, coarser stock, fixtures.
  template <class Visit>
  void each_other(const Visit& visit) const;
  void add(const Moved& moved, const std::vector<PathSegment>& pieces, std::uint16_t shape);
  void shift_by_length();
  void release_kept();
  void cut();
  void count_removed();
  void tell(const std::vector<Touch>& touches, bool of_fixture);
  double least_depth(const Box3& around) const;
  static AlarmId fault_of_touch(const Moved& moved, ToolPart part, bool of_fixture);
  void keep(const CutFinding& finding);
  void notify_others();
  std::size_t use_of(std::uint32_t tool);

  CutJob job_;
  ToolPath way_;
  Stock stock_;
  std::unique_ptr<Stock> window_, seen_;
  std::vector<std::unique_ptr<Stock>> fixtures_;
  std::set<std::uint32_t> without_coolant_;                      // lines whose lack of coolant has been reported
  std::vector<std::pair<std::uint32_t, std::uint16_t>> shapes_;  // tool number → index from Stock::add_tool()
  AxisMask unknown_ = 0;                                         // axes of X, Y, Z along which the tool's position is unknown
  AxisMask across_ = 0;                                          // mask of the axes X and Y
  std::uint32_t tool_;
  SpindleDir spindle_;
  std::uint32_t spinning_ = 0;  // bit mask of the rotating spindles; any of them may rotate the part
  bool in_thread_ = false;      // the last motion of a turning tool was a pass of a thread
  double rpm_;
  std::uint32_t speedless_ = 0;  // bit mask of the spindles whose programmed speed is 0
  Coolant coolant_ = Coolant::off;
  std::vector<PathSegment> pieces_;
  std::vector<Kept> kept_;
  std::vector<Moved> batch_;
  std::vector<CutFinding> others_;
  SweepLines lines_;
  SweepTimes times_;  // filled if there is a stock to be displayed at any instant
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
