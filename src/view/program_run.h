#pragma once
// ProgramRun: runs a program once from its beginning, for the page. It records the path, the marks on the time line, the statistics, and
// the snapshots with which the state at any instant can be computed.

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "motion/time/steps.h"
#include "out/text/summary.h"
#include "session/checklist/checklist.h"
#include "view/opening.h"
#include "view/path_record.h"
#include "view/progress_clock.h"

namespace kadr {

/// A mark on the time line of the page.
struct TimeMark {
  enum class Kind : std::uint8_t { tool, alarm, warning, stop, optional_stop, message, dwell, end };
  double at = 0;
  Kind kind = Kind::tool;
  std::uint32_t line = 0;
  std::string text;        // text of the mark; may contain text of the program, so the page must escape it
  std::uint16_t file = 0;  // number of the file that contains the line (Origin::file)
};

/// A snapshot of the session, and the number of blocks that were executed before this snapshot.
struct RunCheckpoint {
  std::uint64_t blocks;
  SessionSnapshot snapshot;
};

class ProgramRun {
 public:
  /// Opens a run. Returns an error sentence if the set-up has a key that the control does not support.
  static tl::expected<std::unique_ptr<ProgramRun>, std::string> make(const OpenedProgram& opened, const StopToken& stop);

  /// A function of the client that receives each segment of the path during the run. `channel` is 0 for the program's own channel; the
  /// other channels are counted from 1, sorted by number.
  std::function<void(const ViewPiece&, std::uint32_t channel)> on_piece;
  /// A function of the client that receives each step of the program's own channel during the run.
  std::function<void(const Step&)> on_step;
  /// A function of the client that receives, after the run, the segments of the contour without cutter compensation, where compensation was
  /// in force.
  std::function<void(const ViewPiece&)> on_contour;
  /// A function of the client that receives each alarm. `at` is the time of the alarm in s. `channel` is the number of the alarm's channel
  /// on the machine, 0 for the program's own channel.
  std::function<void(const AlarmReport&, double at, int channel)> on_alarm;
  /// A function of the client that receives the progress of the run; ProgramRun calls it several times per second.
  std::function<void(double part, std::uint64_t blocks, double seconds)> on_progress;

  /// Runs the program until its end, an alarm or a stop.
  void execute();

  enum class End : std::uint8_t { ended, stopped, cancelled };
  End end() const { return end_; }
  const PathRecord& path() const { return *record_; }
  const Statistics& statistics() const { return *statistics_; }
  const std::vector<TimeMark>& marks() const { return marks_; }
  const std::vector<RunCheckpoint>& checkpoints() const { return checkpoints_; }
  const OpenedProgram& opened() const { return opened_; }
  Session& session() { return *session_; }
  const Control& control() const { return session_->control(); }
  double seconds() const { return seconds_; }
  std::uint64_t blocks() const { return session_->blocks(); }

 private:
  ProgramRun(const OpenedProgram& opened, const StopToken& stop) : opened_(opened), stop_(stop) {}
  void attach();
  void attach_others();
  void publish_report(const AlarmReport& report, int channel);
  void take(const Step& step, double longer);
  void follow_programmed(const Action& action);
  void emit_contour();
  void report_final_findings();
  void mark(const Step& step, double at);
  void add_mark(TimeMark mark);
  void keep_checkpoint();
  void report_progress();

  OpenedProgram opened_;
  StopToken stop_;
  std::unique_ptr<Session> session_;
  /// Recorder of the path of one further channel. The path of the channel that runs the opened program is recorded in record_.
  struct Other {
    AxisRoles roles;
    std::unique_ptr<PathRecord> record;
    std::unique_ptr<TimeEstimate> clock;
  };
  std::vector<Other> others_;
  AxisRoles roles_;
  std::unique_ptr<PathRecord> record_;
  // Contour without compensation, where compensation was in force; the times of its vertices are set after the run.
  std::unique_ptr<PathRecord> contour_;
  std::unique_ptr<Steps> programmed_;  // computes the positions that the program states, without compensation
  std::unique_ptr<Checklist> checklist_;
  std::unique_ptr<Statistics> statistics_;
  std::vector<TimeMark> marks_;
  std::vector<RunCheckpoint> checkpoints_;
  std::uint64_t apart_ = 4096;  // number of blocks between two checkpoints
  double later_ = 0;            // delay of the machine at the present step, in s, compared with the time estimate
  double seconds_ = 0;
  ProgressClock progress_clock_;
  End end_ = End::ended;
};

/// Returns the kinematics of the program's machine, with which the path of the tool over the part is computed.
std::shared_ptr<const MachineTree> tree_of(const OpenedProgram& opened, const Control& control);
std::optional<Axes> apart_of(const OpenedProgram& opened, const Control& control);

}  // namespace kadr
