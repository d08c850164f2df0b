#pragma once
// Planned: one channel's axes in time by the planner of least time (docs/planner.md), and whoever looks at it.

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
  /// `stand`: where the axes stand at the start. `stop`: what was planned until then is handed out, and then nothing more.
  Planned(const Channel& channel, const MachineProfile& profile, const ToolPosition& stand, StopToken stop = {});
  Planned(const Planned&) = delete;  // the planner calls it back
  Planned& operator=(const Planned&) = delete;

  /// The file stays the caller's.
  void write_samples(std::FILE* file, SampleOptions options);

  /// The tool's tip at the same instants; after write_samples(). The file stays the caller's.
  void write_tips(std::FILE* file);

  /// The plan ends with the samples: nobody looks at more of it. After write_samples().
  void end_with_samples() { ends_with_samples_ = true; }

  /// Finds the lines that lose most time.
  void ask_why() { lost_time_.emplace(limits_); }

  /// Keeps what draw_speed() draws.
  void record_speed() { record_.emplace(limits_); }

  /// Colours a picture that takes each step before consume(); it must outlive this.
  void colour(Plot& plot);

  /// Gets the cells as they are planned (session/player).
  std::function<void(const TimedCells&)> on_cells{};

  /// Called for each motion before it is planned: Playback::motion() of its positions.
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

  /// What it remembers from step to step; the tables of ask_why(), record_speed(), colour() are not in it.
  struct Memory {
    AxisMotion::Snapshot motion;
    PlannedTime time;
    std::optional<SampleWriter::Memory> samples;
  };
  Memory memory();
  void remember(const Memory& memory);

  /// All samples so far could be written; else the error of the system.
  bool ok() const { return !writer_ || writer_->ok(); }
  int error() const { return writer_ ? writer_->error() : 0; }

  /// The axes come to rest. False: not all could be written.
  bool finish();

  /// It was asked to stop before the end.
  bool stopped() const;
  /// After finish(): what is wrong with the plan or its samples. `control`: that carried the program out.
  std::vector<AlarmReport> reports(const Control& control) const;

  /// None, where the planner found no plan by an error of its own, or planned only so far as samples are wanted.
  const PlannedTime* time() const { return motion_.ended() == PlanEnd::too_slow || motion_.ended() == PlanEnd::enough ? nullptr : &time_; }
  /// Where ask_why() was called, after finish(): the table. `control`: that carried the program out.
  std::string why(const Control& control, Lang lang) const;
  /// Where record_speed() was called, after finish(). Returns an error sentence.
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
