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
  /// Creates the plan of a channel. `stand`: position of the axes at the start. `stop`: a request to end planning; the observers still
  /// receive what has been planned before the request.
  Planned(const Channel& channel, const MachineProfile& profile, const ToolPosition& stand, StopToken stop = {});
  Planned(const Planned&) = delete;  // not copyable: the planner has a pointer to this object
  Planned& operator=(const Planned&) = delete;

  /// Writes samples (axis positions at regular instants) to a file. The caller remains the owner of the file and closes it.
  void write_samples(std::FILE* file, SampleOptions options);

  /// Writes the position of the tool tip at the instants of the samples. The caller remains the owner of the file and closes it. Call this
  /// function after write_samples().
  void write_tips(std::FILE* file);

  /// Ends planning when all requested samples are written. A caller without other observers needs no more of the plan. Call this function
  /// after write_samples().
  void end_with_samples() { ends_with_samples_ = true; }

  /// Starts the recording of the lines of the program that lose the most time. why() prints the record.
  void record_lost_time() { lost_time_.emplace(limits_); }

  /// Starts the recording of the speeds that draw_speed() draws.
  void record_speed() { record_.emplace(limits_); }

  /// Colours the motions of a picture. The caller must pass each step to the picture before passing it to consume(), and the picture must
  /// outlive this object.
  void colour(Plot& plot);

  /// receives the cells (short parts) of the plan when they have been computed, see session/player
  std::function<void(const TimedCells&)> on_cells{};

  /// Sets a function that is called before each motion is planned. Its argument is the number that Playback::motion() returns later for
  /// positions of this motion.
  void number_motions(std::function<void(std::uint64_t motion)> on_motion) {
    motion_.on_motion = [tell = std::move(on_motion)](std::uint64_t motion, double) { tell(motion); };
  }

  /// Starts a new plan after each `seconds` s of motion, so that the first cells are available early; see Planner::plan_each().
  void plan_each(double seconds) { motion_.plan_each(seconds); }
  /// Runs the planner in a separate thread, see Planner::work_in_background().
  void work_in_background() { motion_.work_in_background(); }
  /// Replaces all feeds, except thread feeds, by `feed`, mm/min, as in a dry run; see AxisMotion::run_dry().
  void run_dry(double feed) { motion_.run_dry(feed); }
  /// Scales the feeds of the motions that are consumed from now on; see AxisMotion::scale_feed().
  void scale_feed(double factor) { motion_.scale_feed(factor); }

  /// Changes the position at which the plan starts. To be called before the first step.
  void begin_at(const ToolPosition& stand) { motion_.begin_at(stand); }
  void consume(const Step& step) { motion_.consume(step); }
  const MotionLimits& limits() const { return limits_; }

  /// The state between two steps. It does not include the data that record_lost_time(), record_speed() and colour() collect.
  struct Memory {
    AxisMotion::Snapshot motion;
    PlannedTime time;
    std::optional<SampleWriter::Memory> samples;
  };
  Memory memory();
  void resume_from(const Memory& memory);

  /// True if all samples so far have been written. If the result is false, error() returns the errno of the failure.
  bool ok() const { return !writer_ || writer_->ok(); }
  int error() const { return writer_ ? writer_->error() : 0; }

  /// Plans the remaining motion until the axes stop. Returns false if some output could not be written.
  bool finish();

  /// True if a stop was requested before the end of the program.
  bool stopped() const;
  /// Returns the problems of the plan and of its samples. Call this function after finish(). `control`: the control that executed the
  /// program.
  std::vector<AlarmReport> reports(const Control& control) const;

  /// Returns the planned time; nullptr if the planner failed by an internal error, or if only the requested samples were planned.
  const PlannedTime* time() const { return motion_.ended() == PlanEnd::too_slow || motion_.ended() == PlanEnd::enough ? nullptr : &time_; }
  /// Returns a table of the lines that lose the most time. Call this function after record_lost_time() and finish(). `control`: the control
  /// that executed the program.
  std::string why(const Control& control, Lang lang) const;
  /// Draws the speed over time. Call this function after record_speed() and finish(). Returns an error sentence if it fails.
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
  double max_time_ = 0;  // instant up to which samples are requested, s
  bool ends_with_samples_ = false;
  std::optional<LostTime> lost_time_;
  std::optional<SpeedRecord> record_;
  Plot* coloured_ = nullptr;
  AxisMotion motion_;
};

}  // namespace kadr
