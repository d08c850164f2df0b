#pragma once
// TurnedCutting: cuts a spinning part on a lathe's control, exactly. It computes what each tool removes, and collisions. It is used by
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
#include <vector>

#include "config/setup/setup.h"
#include "session/cutting/air_lines.h"
#include "session/cutting/block_load.h"
#include "session/cutting/cutting.h"
#include "session/cutting/lathe_path.h"
#include "session/cutting/spindles.h"
#include "session/cutting/thread_cuts.h"
#include "session/cutting/turned_past.h"
#include "stock/turned/turned_stock.h"

namespace kadr {

/// Additional input for a lathe; the rest is in a CutJob, of which blank, fixtures, window and cells are not used.
struct TurnedJob {
  TurnedRegion blank;
  std::vector<TurnedRegion> fixtures;  // chuck, tailstock: bodies of revolution that must never be cut
  /// Returns the row of the control's offset table as it is now.
  std::function<ToolOffset(std::uint32_t row)> offset_now;
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
  /// Declares that no step follows.
  void finish();
  /// Returns the results; to be called after finish().
  CutResult result() const;
  const TurnedStock& stock() const { return stock_; }
  /// Returns the machine position of Z0 of the blank's work coordinates, mm; nullopt as long as it is unknown.
  std::optional<double> zero() const { return zero_; }

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
    bool cuts = false, in_groove = false, threads = false;
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
  using Findings = std::map<AlarmId, Met>;

  void note(const Action& action);
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

  CutJob job_;
  std::function<ToolOffset(std::uint32_t)> offset_now_;
  LathePath path_;
  TurnedStock stock_;
  std::vector<TurnedStock> fixtures_;
  std::vector<std::unique_ptr<Tool>> tools_;
  const Tool* tool_now_ = nullptr;
  std::uint32_t tool_, row_ = 0;
  bool tool_known_ = false;  // true: tool_now_ is the tool in force, with the row in force
  RunningSpindles spindles_;
  AxisMask unknown_ = 0;  // which of the axes X and Z have an unknown position
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
  CutResult result_;
};

}  // namespace kadr
