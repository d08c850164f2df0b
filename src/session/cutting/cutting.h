#pragma once
// Cutting: simulates the removal of material by the steps of a run. It computes the path of each tool, the volume that the tool removes,
// and collisions with what the tool must not touch.
//
//   Step ─ ToolPath ─▶ straight segments ─▶ Stock (in batches) ─▶ Touch ─▶ CutFinding
//
// The segments are cut in batches, so a finding is reported when its batch is complete. The work coordinates of the blank become known at
// the first motion at feed. Earlier segments are stored until then. A sweep of the stock is the movement of a tool along one straight
// segment.

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

/// The time at which the machine really executes a step: its begin, s since the start of the program, and its duration, s. Accelerations or
/// limits of the machine may delay the begin compared with the programmed time.
struct MachineTime {
  double begins = 0, seconds = 0;
};

struct CutJob {
  std::shared_ptr<const Blank> blank;
  std::vector<std::shared_ptr<const Blank>> fixtures;  // bodies that hold the part and must never be cut
  ToolLibrary tools;
  /// Actual length of each tool, mm, by tool number. The entry exists if the control's offset table states the length in the row with the
  /// tool's own number. A tool without an entry is assumed to have the length that the control applies.
  std::map<std::uint32_t, double> lengths;
  std::shared_ptr<const MachineTree> machine;  // kinematics of the machine; nullptr: the machine's file does not describe the kinematics
  double cell = 0.5;                           // cell size of the stock's lattice, mm
  // the part of the blank that is cut again with finer cells, see blank_within(); nullptr: no window
  std::shared_ptr<const Blank> window;
  // The bricks of a portion, if other processes cut the other bricks (stock/portion/portion.h); no_bricks: of a process that joins the
  // portions; nullopt: this process cuts all bricks. Only a process without a portion, or one that joins, reports figures and findings.
  std::optional<BrickBox> bricks;
  std::function<void(const PortionCut&)> on_portion_cut;  // receives what the portion's bricks contribute to each batch
  std::function<std::vector<PortionCut>()>
      portion_cuts;            // returns what the portions contribute to the next batch, for a process that joins
  double window_cell = 0;      // cell size of the window's lattice, mm
  double seen_cell = 0;        // cell size of the coarser stock that can be displayed at any instant, mm; 0: no coarser stock
  std::size_t past_bytes = 0;  // memory, bytes, for earlier states of the coarser stock; see Stock::keep_past()
  int threads = 1;
  // Number of the work offset in whose work coordinates the path of the tool is computed (see ToolPath); nullopt: the one in force at the
  // first motion at feed.
  std::optional<std::uint16_t> system;
  // rapid rates of the axes, if in a rapid each axis moves at its own rate (see DogLeg); nullopt: rapids are straight lines
  std::optional<Axes> apart;
  bool wants_coolant = false;     // true: cutting without coolant is reported as a warning
  std::vector<AlarmId> disabled;  // warnings that the user has disabled, so that they are not reported
  std::uint32_t tool = 0;         // number of the tool in the spindle at the start
  SpindleDir spindle = SpindleDir::stop;
  double rpm = 0;            // spindle speed at the start, rev/min
  bool keeps_rates = false;  // true: the removal rates are recorded for Cutting::rates()
  // true: the set-up states the start position; false: the position is known after X, Y and Z have each been programmed
  bool starts_known = false;
  double until = 1e300;  // time since the start of the program, s, after which motions no longer cut
  StopToken stop;
};

/// Returns the alarm to report if this part of a tool, which is not its cutting part, removes material.
AlarmId fault_of_part(ToolPart part);

class Cutting {
 public:
  Cutting(const CutJob& job, const AxisRoles& roles);

  /// A function of the caller that receives the findings, batch by batch, in the order of the program.
  std::function<void(const CutFinding&)> on_finding;
  /// A function of the caller that receives what each block has removed at feed, in the order of the program. It is called only after the
  /// batch with the motions of the block has been cut and some further blocks have followed.
  std::function<void(const BlockLoad&)> on_block;

  /// Processes a step. Returns the alarm tool_without_shape if the shape of the tool is unknown, so that the step cannot be cut.
  Status consume(const Step& step, const MachineTime& time);
  /// Adds a finding of another check, e.g. of the machine's bodies. It is reported together with the findings of the current batch of
  /// motions.
  void also(const CutFinding& finding) { others_.push_back(finding); }
  /// Cuts the motions that have not been cut yet. To be called after the last step.
  void finish();
  /// Returns the results; to be called after finish(). `left`: volume that the surface of the remaining stock encloses, mm³. `error_bound`:
  /// greatest error of that volume, mm³.
  CutResult result(double left, double error_bound) const;
  /// Returns the file number (Origin::file) and the program line of a sweep of the stock. The line is 0 if `sweep` is of_blank, that is, if
  /// no sweep has cut the surface there.
  SweepLines::Line line_of(std::int32_t sweep) const { return sweep < 0 ? SweepLines::Line() : lines_.of(std::size_t(sweep)); }
  /// Returns the removal rate, mm³/s, of the block to which each sweep belongs, by number of the sweep. A rate of 0 means that the sweep is
  /// a rapid or that its rate is unknown. The last sweeps may be missing.
  const std::vector<float>& rates() const { return rate_of_sweep_; }
  const Stock& stock() const { return stock_; }
  /// True if a turning tool has cut a thread. The crest of a thread is measured in the whole stock, which no portion has.
  bool has_threads() const { return !threads_.empty(); }
  /// Returns the stock of the window, whose sweeps have the same numbers; nullptr if there is no window.
  const Stock* window() const { return window_.get(); }
  /// Returns the coarser stock (CutJob::seen_cell), which can display its past and whose sweeps have the same numbers; nullptr if there is
  /// none.
  const Stock* seen() const { return seen_.get(); }
  /// Returns how many sweeps the machine has executed at an instant of its real time, s since the start of the program.
  SweepProgress sweeps_at(double instant) const { return times_.at(instant); }
  /// Returns the zero point of the blank's work coordinates, in machine coordinates, mm. To be called after finish().
  Vec3 zero() const { return zero_; }
  /// Returns the memory of all stocks and of the data about sweeps, bytes.
  std::size_t bytes() const;

 private:
  /// A motion whose straight segments are in the current batch.
  struct Moved {
    Origin origin;
    std::size_t first_sweep = 0;
    std::uint32_t tool = 0;
    std::size_t use = 0;       // index of the tool in result_.tools
    AlarmId fault = no_alarm;  // the alarm to report if the cutting edges of the tool remove material on this motion
    bool cuts = false, lacks_coolant = false;
    double begins = 0, seconds = 0, length = 0, flat = 0;
    double whole = 0;  // duration of the whole motion, s; the member `seconds` counts only the time until CutJob::until
    // diameter of the tool, mm, and number of teeth that pass a point of the material per second, as in CutMotion
    double diameter = 0, teeth = 0;
    Vec3 at;
    Vec2 radius;  // unit vector from the axis of rotation towards a turning tool; 0 for other tools
    // Two flags for turning tools. in_groove: the motion cuts a thread, or is the rapid directly after such a motion, in which the insert
    // leaves the thread groove. threads: the motion cuts a thread.
    bool in_groove = false, threads = false;
    double lead = 0;  // thread lead, mm; 0: the program states no lead
  };
  struct WaitingMotion {
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
  /// Calls the function `visit` with each stock except that of the whole blank: with the stocks of the window, of the coarser cells and of
  /// the fixtures.
  template <class Visit>
  void each_other(const Visit& visit) const;
  void add(const Moved& moved, const std::vector<PathSegment>& pieces, std::uint16_t shape);
  void shift_by_length();
  void release_waiting();
  void cut();
  void count_removed();
  void report_touches(const std::vector<Touch>& touches, bool of_fixture);
  double least_depth(const Box3& around) const;
  static AlarmId fault_of_touch(const Moved& moved, ToolPart part, bool of_fixture);
  void keep(const CutFinding& finding);
  void notify_others();
  std::size_t use_of(std::uint32_t tool);

  CutJob job_;
  ToolPath tool_path_;
  Stock stock_;
  std::unique_ptr<Stock> window_, seen_;
  std::vector<std::unique_ptr<Stock>> fixtures_;
  std::set<std::uint32_t> without_coolant_;                      // lines at which cutting without coolant has been reported
  std::vector<std::pair<std::uint32_t, std::uint16_t>> shapes_;  // tool number → index from Stock::add_tool()
  AxisMask unknown_ = 0;                                         // which of the axes X, Y, Z have an unknown position
  AxisMask across_ = 0;                                          // mask of the axes X and Y
  std::uint32_t tool_;
  SpindleDir spindle_;
  std::uint32_t spinning_ = 0;  // bit mask of the rotating spindles; any of them may rotate the part
  bool in_thread_ = false;      // true: the last motion of a turning tool was a pass of a thread
  double rpm_;
  std::uint32_t speedless_ = 0;  // bit mask of the spindles whose programmed speed is 0
  Coolant coolant_ = Coolant::off;
  std::vector<PathSegment> pieces_;
  std::vector<WaitingMotion> waiting_;
  std::vector<Moved> batch_;
  std::vector<CutFinding> others_;
  SweepLines lines_;
  SweepTimes times_;  // times of the sweeps; empty unless there is a coarser stock for display
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
