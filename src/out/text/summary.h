#pragma once
// Statistics: collects the totals of a run (times, paths, tools, extents) for the summary on stdout (docs/commands/run.md, "Summary").

#include <optional>
#include <string>
#include <vector>

#include "base/extremes.h"
#include "motion/time/estimate.h"
#include "motion/time/planned_time.h"
#include "out/text/extents.h"

namespace kadr {

/// The data from which the machining time is computed. Each enum value uses, in addition, all data of the values before it.
enum class TimeBasis : std::uint8_t {
  programmed,   // programmed feeds and rapid rates
  limited,      // in addition to `programmed`: the limits at which the control slows down
  accelerated,  // in addition to `limited`: the accelerations of the axes
};

/// Processes steps in order. Each step takes little time. The memory depends only on the number of tools and work offsets.
class Statistics {
 public:
  Statistics(const std::vector<std::string>& axes, AxisMask rotary, const Rates& rates);

  /// Reads the spindles and the tool in the spindle from the set-up. Call this function before the first action.
  void start_with(const Setup& setup);

  /// Returns the clock, which must time each step of the run before consume() receives the step. The summary contains the totals of the
  /// clock.
  TimeEstimate& clock() { return estimate_; }
  /// Adds a step to the totals. The clock must have computed the time of the step before. A caller that prints no summary needs only the
  /// clock.
  void consume(const Step& step);
  /// Sets the data from which the times are computed; the default is programmed feeds and rapid rates. With other data the caller must pass
  /// the additional time of each motion to lengthen().
  void count_by(TimeBasis basis) { basis_ = basis; }
  /// Adds time to a motion that consume() has already received. Before an action that changes the tool, call this function for all earlier
  /// motions.
  ///   longer  additional time of the motion, s
  void lengthen(const Motion& motion, double longer);
  void count(Severity severity) {
    if (severity == Severity::alarm || severity == Severity::warning) ++(severity == Severity::alarm ? alarms_ : warnings_);
  }

  /// Sets the names of the work offsets; the index of a name is Motion::system. The names are needed if the run has used several work
  /// offsets.
  void name_systems(std::vector<std::string> names) { system_names_ = std::move(names); }
  /// Returns the extents of the cutting as a caption, e.g. "cutting X 0 … 20   Y …, mm"; empty if the program has cut nothing.
  std::string caption(Lang lang) const;

  /// Returns the summary, whose lines end in '\n'.
  ///   planned  time that the least-time planner has computed; nullptr: the planner was not used
  ///   counts   PlannerMode::optimal: the time of the planner replaces that of the control; any other mode: both times are printed
  std::string text(std::uint64_t blocks, Lang lang, const PlannedTime* planned = nullptr,
                   PlannerMode counts = PlannerMode::programmed) const;

  struct ToolUse {
    std::uint32_t tool;
    double cutting_s;
  };

  std::uint64_t rapids() const { return rapids_; }
  std::uint64_t feeds() const { return feeds_; }
  std::uint64_t arcs() const { return arcs_; }
  std::uint64_t others() const { return others_; }
  std::uint64_t alarms() const { return alarms_; }
  std::uint64_t warnings() const { return warnings_; }
  TimeBasis basis() const { return basis_; }
  std::vector<RunExtents::Row> extent_rows(RunExtents::Of of) const { return extents_.rows(of, system_names_); }
  double cutting_mm() const { return cutting_mm_; }
  double rapid_mm() const { return rapid_mm_; }
  Box cutting_box() const { return extents_.cutting_box(); }
  Box box() const { return extents_.box(); }
  const RunExtents& extents() const { return extents_; }
  /// Returns the least and the greatest spindle speed, rev/min, of the cuts at constant surface speed; nullopt if there are none. The
  /// greatest is SpindleTurning::fastest if nothing limits it.
  const std::optional<Range>& surface_speeds() const { return surface_speeds_; }
  const TimeSplit& time() const { return estimate_.split(); }
  const std::vector<ToolUse>& tools() const { return tools_; }

 private:
  void take_motion(const Step& step, const Motion& motion);
  void count_cutting();
  void count_spindle(const Motion& motion, const Curve& curve);
  void use(std::uint32_t tool);

  TimeEstimate estimate_;
  double cutting_then_ = 0;                                       // cutting time on the clock when count_cutting() was last called, s
  std::uint64_t rapids_ = 0, feeds_ = 0, arcs_ = 0, others_ = 0;  // numbers of motions by type; others_: probing and homing
  std::uint64_t alarms_ = 0, warnings_ = 0;
  TimeBasis basis_ = TimeBasis::programmed;
  double cutting_mm_ = 0, rapid_mm_ = 0;
  RunExtents extents_;
  std::optional<Range> surface_speeds_;
  std::vector<std::string> system_names_;
  std::vector<ToolUse> tools_;  // tools in the order of their first use
  std::size_t in_spindle_ = 0;  // index in tools_ of the tool in the spindle; tools_.size(): the tool is unknown
};

/// Working time of a channel and time that it waited for others, s, for programs with several channels (nct 14.5).
struct ChannelTime {
  int channel = 1;
  double busy = 0, waited = 0;
};
/// Returns the heading of a channel's summary, e.g. "channel 2".
std::string channel_heading(int channel, Lang lang);
/// Returns a text with the times of all channels. The longest time is the machining time.
std::string channels_text(const std::vector<ChannelTime>& times, Lang lang);

/// Formats a time: "1:02:05" for 3725.4 s, "1:05.3" for 65.3 s.
std::string duration_text(double seconds);

}  // namespace kadr
