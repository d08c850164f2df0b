#pragma once
// Statistics: collects the totals of a run (times, paths, tools, extents) for the summary on stdout (docs/commands/run.md, "Summary").

#include <string>
#include <vector>

#include "motion/time/estimate.h"
#include "motion/time/planned_time.h"
#include "out/text/extents.h"

namespace kadr {

/// What the machining time is computed from. Each value includes those above it.
enum class TimeBasis : std::uint8_t {
  programmed,   // programmed feeds and rapid rates
  limited,      // also the slow-downs of the control
  accelerated,  // also the accelerations of the axes
};

/// Consumes Steps in order; cheap per step, and its memory grows only with the number of tools and work systems.
class Statistics {
 public:
  Statistics(const std::vector<std::string>& axes, AxisMask rotary, const Rates& rates);

  /// Reads the spindles and the tool in the spindle from the set-up. Call it before the first action.
  void start_with(const Setup& setup);

  /// The clock that times each step of the run before consume() receives it; the summary prints its totals.
  TimeEstimate& clock() { return estimate_; }
  /// Counts a step that the clock has timed. Without a summary only the clock is needed.
  void consume(const Step& step);
  /// Sets what the times are computed from, if not from programmed feeds; lengthen() then adds the time differences.
  void count_by(TimeBasis basis) { basis_ = basis; }
  ///   longer  s by which the motion, already consumed, takes longer than counted. Call it for all motions before an action that changes
  ///           the tool.
  void lengthen(const Motion& motion, double longer);
  void count(Severity severity) {
    if (severity == Severity::alarm || severity == Severity::warning) ++(severity == Severity::alarm ? alarms_ : warnings_);
  }

  /// Sets the names of the work systems, by Motion::system; required if the run has used several.
  void name_systems(std::vector<std::string> names) { system_names_ = std::move(names); }
  /// Returns "cutting X 0 … 20   Y …, mm", the extents of the cutting as a caption; empty if nothing was cut.
  std::string caption(Lang lang) const;

  /// Returns the summary, lines ending in '\n'.
  ///   planned  time computed by the planner of least time, if it was used
  ///   counts   true: that time replaces the machine's time; false: it is printed in addition to the control's time
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
  const TimeSplit& time() const { return estimate_.split(); }
  const std::vector<ToolUse>& tools() const { return tools_; }

 private:
  void take_motion(const Step& step, const Motion& motion);
  void count_cutting();
  void use(std::uint32_t tool);

  TimeEstimate estimate_;
  double cutting_then_ = 0;                                       // s, the clock's cutting time when count_cutting() was last called
  std::uint64_t rapids_ = 0, feeds_ = 0, arcs_ = 0, others_ = 0;  // numbers of motions; others_: probe, home
  std::uint64_t alarms_ = 0, warnings_ = 0;
  TimeBasis basis_ = TimeBasis::programmed;
  double cutting_mm_ = 0, rapid_mm_ = 0;
  RunExtents extents_;
  std::vector<std::string> system_names_;
  std::vector<ToolUse> tools_;  // in order of first use
  std::size_t in_spindle_ = 0;  // index in tools_ of the tool in the spindle; tools_.size(): not known
};

/// For programs of several channels: how long a channel worked and how long it waited for others, in s (nct 14.5).
struct ChannelTime {
  int channel = 1;
  double busy = 0, waited = 0;
};
/// Returns "channel 2", the line above the channel's summary.
std::string channel_heading(int channel, Lang lang);
/// Returns the times of all channels; the longest one is the machining time.
std::string channels_text(const std::vector<ChannelTime>& times, Lang lang);

/// 3725.4 s → "1:02:05", 65.3 s → "1:05.3".
std::string duration_text(double seconds);

}  // namespace kadr
