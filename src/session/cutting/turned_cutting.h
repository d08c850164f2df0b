#pragma once
// TurnedCutting: cuts a spinning part exactly. It computes what each tool removes, and collisions. It is used by
// session/cutting/turned_run.
//
//   Step ─ LathePath ─▶ corners in the half plane ─ InsertSweep ─▶ swept areas ─▶ TurnedStock ─▶ findings, volumes
//
// The work coordinates of the blank become known at the first motion at feed. Earlier motions are stored until then. A thread is a helix:
// the insert removes nothing there, and the thread is reported separately (session/cutting/thread_cuts).

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <vector>

#include "config/setup/setup.h"
#include "session/cutting/air_lines.h"
#include "session/cutting/block_load.h"
#include "session/cutting/cutting.h"
#include "session/cutting/lathe_path.h"
#include "session/cutting/offset_insert.h"
#include "session/cutting/spindles.h"
#include "session/cutting/thread_cuts.h"
#include "session/cutting/turned_past.h"
#include "session/cutting/turning/work_holding.h"
#include "stock/turned/turned_picture.h"
#include "stock/turned/turned_stock.h"

namespace kadr {

/// Additional input for a lathe; the rest is in a CutJob, of which blank, fixtures, window and cells are not used.
struct TurnedJob {
  TurnedRegion blank;
  std::vector<TurnedRegion> fixtures;  // bodies of revolution that must never be cut
  std::vector<HeldBody> holding;       // chuck and tailstock of the machine, which findings name
  /// Returns the row of the control's offset table as it is now.
  std::function<ToolOffset(std::uint32_t row)> offset_now;
  TipNumbers tips = TipNumbers::fanuc;  // how this table numbers the tips of turning tools
  bool keeps_areas = false;             // true: the areas of all sweeps are kept, for TurnedCutting::last_at()
  bool keeps_stages = false;            // true: the part before the work of each tool and the threads are kept, for stages() and grooves()
};

class TurnedCutting {
 public:
  TurnedCutting(const CutJob& job, TurnedJob turned, const AxisRoles& roles);

  /// Functions of the caller that receive the findings, and what each block has removed at feed, in the order of the program.
  std::function<void(const CutFinding&)> on_finding;
  std::function<void(const BlockLoad&)> on_block;
  /// Functions of the caller that receive what is removed, and each pass of a thread, in the order of time. `body` of a removal lives as
  /// long as this object.
  std::function<void(const TurnedRemoval&)> on_removal;
  std::function<void(const TurnedThread&)> on_thread;

  /// Processes a step. Returns the alarm turning_tool_without_shape if neither the tools file nor the offset table tells the form of the
  /// tool.
  Status consume(const Step& step, const MachineTime& time);
  /// Adds a finding of another check, of the machine's bodies.
  void also(const CutFinding& finding) { keep(finding); }
  /// Declares that no step follows.
  void finish();
  /// Returns the results; to be called after finish().
  CutResult result() const;
  const TurnedStock& stock() const { return stock_; }
  /// Returns the machine position of Z0 of the blank's work coordinates, mm; nullopt as long as it is unknown.
  std::optional<double> zero() const { return zero_; }
  /// Returns the part before the work of each tool, in the order of the work. `maker` is the index of the tool in CutResult::tools.
  const std::vector<TurnedStage>& stages() const { return stages_; }
  /// Returns the grooves of the threads, one for each pass, in the order of the work. `maker` as that of stages().
  const std::vector<ThreadGroove>& grooves() const { return grooves_; }
  /// Returns the block of the last sweep whose edge passes this point of the part's surface (radius, Z); nullopt if there is none.
  std::optional<Origin> last_at(Vec2 at) const;

  /// A tool as it cuts with one row of the offset table.
  struct Tool {
    ToolShape shape;
    std::vector<InsertSweep> sweeps;
  };
  /// Returns the tools that have been used, in the order of their first use.
  const std::vector<std::unique_ptr<Tool>>& tools() const { return tools_; }

 private:
  struct Moved {
    LatheMotion path;
    Origin origin;
    const Tool* tool = nullptr;
    std::size_t use = 0;
    AlarmId fault = no_alarm;  // the alarm to report if the cutting edges remove material
    bool cuts = false, in_groove = false, threads = false, lacks_coolant = false;
    double lead = 0, begins = 0, seconds = 0;
    double start_angle = 0;  // angle of the spindle at the start of a thread, degrees
    bool reversed = false;   // the spindle turns counter-clockwise
  };
  /// A straight part of a motion, with its time.
  struct Segment {
    Vec2 from, to;
    double begins = 0, seconds = 0;
  };
  struct Met {
    Vec2 least, most;
    double volume = 0;
  };
  /// What a motion meets: the alarm, and of a contact with chuck or tailstock its number and the part of the tool.
  struct Contact {
    AlarmId id = AlarmId::fixture;
    std::size_t body = 0;
    ToolPart part = ToolPart::cutting;
    auto operator<=>(const Contact&) const = default;
  };
  using Findings = std::map<Contact, Met>;

  void note(const Action& action);
  bool is_place_known() const;
  bool place_known(const Motion& motion);
  const Tool* tool_for(const Motion& motion);
  const Tool* add_tool(const ToolGeometry& geometry);
  AlarmId fault_of(const Motion& motion) const;
  std::size_t use_of(std::uint32_t tool);
  bool is_left_out(const Motion& motion, const LatheMotion& path, const Tool* tool) const;
  void leave_out(const Step& step);
  void find_zero(const Motion& motion, double origin);
  void add(Moved&& moved);
  void release_waiting();
  void cut(const Moved& moved);
  double sweep(const Moved& moved, const Segment& segment, Findings& found);
  void note_thread(const Moved& moved, Vec2 from, Vec2 to);
  void count(const Moved& moved, double volume, double way);
  void keep(const CutFinding& finding);
  void keep_warning(const Moved& moved, Vec2 at);

  CutJob job_;
  std::function<ToolOffset(std::uint32_t)> offset_now_;
  TipNumbers tips_;
  LathePath path_;
  TurnedStock stock_;
  std::vector<TurnedStock> fixtures_;
  struct Holding {
    std::string name;
    TurnedStock body;
  };
  std::vector<Holding> holding_;
  std::vector<std::unique_ptr<Tool>> tools_;
  const Tool* tool_now_ = nullptr;
  std::uint32_t tool_, row_ = 0;
  bool tool_known_ = false;  // true: tool_now_ is the tool in force, with the row in force
  RunningSpindles spindles_;
  Coolant coolant_ = Coolant::off;
  std::set<std::uint32_t> without_coolant_;  // lines at which cutting without coolant has been reported
  AxisMask unknown_ = 0;                     // which of the axes X, Y, Z have an unknown position
  AxisMask across_ = 0, along_ = 0;          // masks of the axes X and Y, of the axis Z
  bool in_thread_ = false;
  bool reversed_ = false;                    // the spindle that was started last turns counter-clockwise
  std::optional<ThreadGroove> last_groove_;  // the last pass of a thread; a pass that continues it has the same helix
  std::optional<double> zero_;               // machine Z of the zero of the blank's work coordinates, mm
  std::vector<Moved> waiting_;
  BlockLoads loads_;
  AirLines air_;
  ThreadCuts threads_;
  struct Rate {
    double volume = 0, seconds = 0, length = 0;
    std::size_t use = 0;
  } rate_;
  std::size_t sweeps_ = 0;
  bool keeps_areas_, keeps_stages_;
  std::vector<std::pair<Origin, TurnedPolygon>> areas_;
  std::vector<TurnedStage> stages_;
  std::vector<ThreadGroove> grooves_;
  CutResult result_;
};

}  // namespace kadr
