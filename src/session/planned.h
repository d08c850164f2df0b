#pragma once
// Planned: plans the axes of one channel in time with the least-time planner (docs/planner.md), and passes the plan to its observers.

#include <cstdio>
#include <functional>

#include "motion/least_time/axis_motion.h"
#include "motion/time/lost_time.h"
#include "motion/time/planned_time.h"
#include "out/picture/speed_page.h"
#include "out/trace/samples.h"
#include "session/channels.h"

namespace kadr {

class Planned {
 public:
  /// `stand`: position of the axes at the start. `stop`: when requested, what is planned by then is passed on, and nothing after it.
  Planned(const Channel& channel, const MachineProfile& profile, const ToolPosition& stand, StopToken stop = {});
  Planned(const Planned&) = delete;  // the planner calls it back
  Planned& operator=(const Planned&) = delete;

  /// The caller keeps and closes the file.
  void write_samples(std::FILE* file, SampleOptions options);

  /// Writes the position of the tool tip at the same instants; call after write_samples(). The caller keeps and closes the file.
  void write_tips(std::FILE* file);

  /// Ends the plan with the samples, as nothing else observes it. Call after write_samples().
  void end_with_samples() { ends_with_samples_ = true; }

  /// Records which lines lose most time.
  void ask_why() { lost_time_.emplace(limits_); }

  /// Records what draw_speed() draws.
  void record_speed() { record_.emplace(limits_); }

  /// Colours a picture, which must receive each step before consume() does and must outlive this.
  void colour(Plot& plot);

  /// Receives the cells as they are planned (session/player).
  std::function<void(const TimedCells&)> on_cells{};

  /// Called for each motion before it is planned, with the number that Playback::motion() gives for its positions.
  void number_motions(std::function<void(std::uint64_t motion)> on_motion) {
    motion_.on_motion = [tell = std::move(on_motion)](std::uint64_t motion, double) { tell(motion); };
  }

  /// Planner::plan_each().
  void plan_each(double seconds) { motion_.plan_each(seconds); }
  /// Planner::work_side_by_side().
  void work_side_by_side() { motion_.work_side_by_side(); }
  /// AxisMotion::run_dry().
  void run_dry(double feed) { motion_.run_dry(feed); }

  void consume(const Step& step) { motion_.consume(step); }
  const MotionLimits& limits() const { return limits_; }

  /// The state between steps; the tables of ask_why(), record_speed(), colour() are not included.
  struct Memory {
    AxisMotion::Snapshot motion;
    PlannedTime time;
    std::optional<SampleWriter::Memory> samples;
  };
  Memory memory();
  void remember(const Memory& memory);

  /// True if all samples so far could be written; else error() is the errno of the failure.
  bool ok() const { return !writer_ || writer_->ok(); }
  int error() const { return writer_ ? writer_->error() : 0; }

  /// Plans the axes to a stop at the end. Returns false if not all output could be written.
  bool finish();

  /// True if a stop was requested before the end.
  bool stopped() const;
  /// After finish(): problems of the plan or its samples. `control`: the one that executed the program.
  std::vector<AlarmReport> reports(const Control& control) const;

  /// nullptr if the planner failed by an error of its own, or planned only as far as samples are requested.
  const PlannedTime* time() const { return motion_.ended() == PlanEnd::too_slow || motion_.ended() == PlanEnd::enough ? nullptr : &time_; }
  /// After ask_why() and finish(): the table of lost time. `control`: the one that executed the program.
  std::string why(const Control& control, Lang lang) const;
  /// After record_speed() and finish(). Returns an error as a sentence.
  tl::expected<void, std::string> draw_speed(const ResultFile& file, const PlotTitle& title) const {
    return draw_speed_page(file, *record_, axes_, title);
  }

 private:
  void see(const TimedCells& cells);
  static AlarmReport report(const Control& control, const Alarm& alarm, const Spent& at);

  StopToken stop_;
  std::vector<std::string> axes_;
  AxisRoles roles_;
  MotionLimits limits_;
  PlannedTime time_;
  std::optional<SampleWriter> writer_;
  double max_time_ = 0;  // s, of the samples
  bool ends_with_samples_ = false;
  std::optional<LostTime> lost_time_;
  std::optional<SpeedRecord> record_;
  Plot* coloured_ = nullptr;
  AxisMotion motion_;
};

}  // namespace kadr
