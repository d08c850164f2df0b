#pragma once
// Planned: plans the motion of one channel's axes in time with the least-time planner (docs/planner.md), and passes the plan to its
// observers.

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
  /// `stand`: position of the axes at the start. `stop`: when a stop is requested, what is already planned is passed on, and planning
  /// ends.
  Planned(const Channel& channel, const MachineProfile& profile, const ToolPosition& stand, StopToken stop = {});
  Planned(const Planned&) = delete;  // the planner calls back this object
  Planned& operator=(const Planned&) = delete;

  /// Writes samples (axis positions at regular instants) to a file, which the caller keeps and closes.
  void write_samples(std::FILE* file, SampleOptions options);

  /// Writes the position of the tool tip at the instants of the samples. Call after write_samples(). The caller keeps and closes the
  /// file.
  void write_tips(std::FILE* file);

  /// Ends planning as soon as no more samples are requested; for callers without other observers. Call after write_samples().
  void end_with_samples() { ends_with_samples_ = true; }

  /// Records which lines of the program lose the most time, for why().
  void record_lost_time() { lost_time_.emplace(limits_); }

  /// Records the data for draw_speed().
  void record_speed() { record_.emplace(limits_); }

  /// Colours a picture. The picture must receive each step before consume() does, and must outlive this object.
  void colour(Plot& plot);

  /// receives the plan in cells (short parts of it) as they are computed, see session/player
  std::function<void(const TimedCells&)> on_cells{};

  /// Sets a function that is called before each motion is planned, with the number that Playback::motion() returns for the motion's
  /// positions.
  void number_motions(std::function<void(std::uint64_t motion)> on_motion) {
    motion_.on_motion = [tell = std::move(on_motion)](std::uint64_t motion, double) { tell(motion); };
  }

  /// Makes the planner start a plan after each `seconds` of motion, so that the first cells come early; see Planner::plan_each().
  void plan_each(double seconds) { motion_.plan_each(seconds); }
  /// Makes the planner work in a separate thread, see Planner::work_in_background().
  void work_in_background() { motion_.work_in_background(); }
  /// Dry run: replaces all feeds, except thread feeds, by `feed`, mm/min, see AxisMotion::run_dry().
  void run_dry(double feed) { motion_.run_dry(feed); }

  void consume(const Step& step) { motion_.consume(step); }
  const MotionLimits& limits() const { return limits_; }

  /// The state between two steps, without the data recorded for record_lost_time(), record_speed() and colour().
  struct Memory {
    AxisMotion::Snapshot motion;
    PlannedTime time;
    std::optional<SampleWriter::Memory> samples;
  };
  Memory memory();
  void resume_from(const Memory& memory);

  /// True if all samples so far have been written. Otherwise error() is the errno of the failure.
  bool ok() const { return !writer_ || writer_->ok(); }
  int error() const { return writer_ ? writer_->error() : 0; }

  /// Plans the rest of the motion to a stop of the axes. Returns false if some output could not be written.
  bool finish();

  /// True if a stop was requested before the end.
  bool stopped() const;
  /// Call after finish(). Returns the problems of the plan and of its samples. `control`: the control that executed the program.
  std::vector<AlarmReport> reports(const Control& control) const;

  /// The planned time; nullptr if the planner failed by an error of its own, or planned only as far as samples are requested.
  const PlannedTime* time() const { return motion_.ended() == PlanEnd::too_slow || motion_.ended() == PlanEnd::enough ? nullptr : &time_; }
  /// Returns the table of lost time. Call after record_lost_time() and finish(). `control`: the control that executed the program.
  std::string why(const Control& control, Lang lang) const;
  /// Draws the speed over time. Call after record_speed() and finish(). Returns an error as a sentence.
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
  double max_time_ = 0;  // time up to which samples are requested, s
  bool ends_with_samples_ = false;
  std::optional<LostTime> lost_time_;
  std::optional<SpeedRecord> record_;
  Plot* coloured_ = nullptr;
  AxisMotion motion_;
};

}  // namespace kadr
