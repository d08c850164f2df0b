#pragma once
// Cutting: the steps of a run, carried out on the part: which tool goes where, what it takes away, what it must not have touched.
//
//   Step ─ ToolWay ─▶ pieces ─▶ Stock (in batches) ─▶ Touch ─▶ CutFinding
//
// Pieces are cut in batches: findings come when their batch is done. Until the work system of the blank is known (the first motion at feed)
// pieces are kept.

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

/// When the machine carries a step out, s since the start of the program: later than the programmed time where accelerations or limits slow
/// it down.
struct MachineTime {
  double begins = 0, seconds = 0;
};

struct CutJob {
  std::shared_ptr<const Blank> blank;
  std::vector<std::shared_ptr<const Blank>> fixtures;  // never to be cut
  ToolLibrary tools;
  /// By tool: how long it really is, where the control's table says so under its own number. Others are as long as the control believes.
  std::map<std::uint32_t, double> lengths;
  std::shared_ptr<const MachineTree> machine;  // as its file describes it; nullptr: it does not
  double cell = 0.5;                           // mm
  std::shared_ptr<const Blank> window;         // blank_within() of what is cut once more, finer; nullptr: nothing
  double window_cell = 0;                      // mm
  double seen_cell = 0;                        // mm: of what is cut once more, coarser, to be shown as it was at any instant; 0: nothing is
  std::size_t past_bytes = 0;                  // of Stock::keep_past() for that
  int threads = 1;
  std::optional<std::uint16_t> system;  // of ToolWay
  std::optional<Axes> apart;            // of ToolWay
  bool wants_coolant = false;           // cutting without it is a warning
  std::vector<AlarmId> disabled;        // warnings that are not told
  std::uint32_t tool = 0;               // in the spindle at the start
  SpindleDir spindle = SpindleDir::stop;
  double rpm = 0;             // at which it turns then
  bool keeps_rates = false;   // Cutting::rates() is wanted
  bool starts_known = false;  // the set-up says where the tool stands at the start; else it is known when each of X, Y, Z has been named
  double until = 1e300;       // s of the program: what comes later is not cut
  StopToken stop;
};

class Cutting {
 public:
  Cutting(const CutJob& job, const AxisRoles& roles);

  /// Called with each finding of a batch, in the order of the program.
  std::function<void(const CutFinding&)> on_finding;
  /// Called with what each block that moves at feed took away, in the order of the program: a batch later, and some blocks more.
  std::function<void(const BlockLoad&)> on_block;

  /// returns  alarm tool_without_shape: nothing of the step is cut
  Status consume(const Step& step, const MachineTime& time);
  /// What others found in a step that has come: told with what is found in cutting.
  void also(const CutFinding& finding) { others_.push_back(finding); }
  /// All that has come is cut.
  void finish();
  /// After finish(), with the volume of the surface of what is left.
  CutResult result(double left, double error_bound) const;
  /// Where a sweep of the stock comes from: line, and file as Origin::file; line 0 for of_blank.
  SweepLines::Line line_of(std::int32_t sweep) const { return sweep < 0 ? SweepLines::Line() : lines_.of(std::size_t(sweep)); }
  /// By sweep: mm³/s that its block took away; 0: at rapid, or none is told. Shorter than the sweeps where the last ones have none.
  const std::vector<float>& rates() const { return rate_of_sweep_; }
  const Stock& stock() const { return stock_; }
  /// nullptr: there is none. Its sweeps have the same numbers.
  const Stock* window() const { return window_.get(); }
  /// That of CutJob::seen_cell, which can be asked for its past; nullptr: there is none. Its sweeps have the same numbers.
  const Stock* seen() const { return seen_.get(); }
  /// Which sweeps are carried out at an instant of the machine's time.
  SweepPlace sweeps_at(double instant) const { return times_.at(instant); }
  /// Zero of the work system of the blank, in coordinates of the machine; after finish().
  Vec3 zero() const { return zero_; }
  /// Of memory, all stocks and what is remembered of sweeps.
  std::size_t bytes() const;

 private:
  /// A motion whose pieces are in the batch.
  struct Moved {
    Origin origin;
    std::size_t first_sweep = 0;
    std::uint32_t tool = 0;
    std::size_t use = 0;       // of result_.tools
    AlarmId fault = no_alarm;  // of its cutting part, if that takes anything away
    bool cuts = false, lacks_coolant = false;
    double begins = 0, seconds = 0, length = 0, flat = 0;
    double whole = 0;                // s of the motion, all of it
    double diameter = 0, teeth = 0;  // of CutMotion
    Vec3 at;
    Vec2 radius;                              // of a turning tool: along its radius, towards it; else 0
    bool in_groove = false, threads = false;  // of a turning tool: its insert is in a thread; it cuts that
    double lead = 0;                          // of the thread, mm; 0: the program does not say
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
  /// Visits the stocks beside that of the whole.
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
  std::set<std::uint32_t> without_coolant_;                      // lines
  std::vector<std::pair<std::uint32_t, std::uint16_t>> shapes_;  // tool → Stock::add_tool
  AxisMask unknown_ = 0;                                         // of X, Y, Z: where the tool stands along them nobody has said
  AxisMask across_ = 0;                                          // X and Y
  std::uint32_t tool_;
  SpindleDir spindle_;
  std::uint32_t spinning_ = 0;  // spindles that turn, a bit each: any may turn the part
  bool in_thread_ = false;      // the last motion of a turning tool was a pass of a thread
  double rpm_;
  std::uint32_t speedless_ = 0;  // spindles whose speed the program has made 0, a bit each
  Coolant coolant_ = Coolant::off;
  std::vector<WayPiece> pieces_;
  std::vector<Kept> kept_;
  std::vector<Moved> batch_;
  std::vector<CutFinding> others_;
  SweepLines lines_;
  SweepTimes times_;  // where there is a stock to be shown
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
