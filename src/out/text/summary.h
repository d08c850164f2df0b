#pragma once
// Statistics: collects the totals of a run for the summary on stdout (docs/commands/run.md, "Summary").

#include <string>
#include <vector>

#include "motion/time/estimate.h"
#include "motion/time/planned_time.h"
#include "out/text/extents.h"

namespace kadr {

/// What the machining time is computed from.
enum class TimeBasis : std::uint8_t {
  programmed,   // feeds and rapid rates
  limited,      // also what the control slows down
  accelerated,  // also the accelerations of the axes
};

/// Consumes Steps in order; cheap per step, and its memory grows only with the number of tools and work systems.
class Statistics {
 public:
  Statistics(const std::vector<std::string>& axes, AxisMask rotary, const Rates& rates);

  /// Reads the set-up's spindles and tool, before the first action.
  void start_with(const Setup& setup);

  /// The clock that times the steps of the run before anybody receives them; its sums are part of the summary.
  TimeEstimate& clock() { return estimate_; }
  /// Counts a step that the clock has timed. A run whose summary nobody reads needs the clock only.
  void consume(const Step& step);
  /// Sets what the times are computed from, if not from programmed feeds; lengthen() then adds the differences.
  void count_by(TimeBasis basis) { basis_ = basis; }
  ///   longer  s by which the motion, already consumed, takes longer than it was counted. Call it for all motions before an action that
  ///           changes the tool.
  void lengthen(const Motion& motion, double longer);
  void count(Severity severity) {
    if (severity == Severity::alarm || severity == Severity::warning) ++(severity == Severity::alarm ? alarms_ : warnings_);
  }

  /// Sets the names of the work systems, by Motion::system; needed if the run has used several.
  void name_systems(std::vector<std::string> names) { system_names_ = std::move(names); }
  /// Returns "cutting X 0 … 20   Y …, mm": the summary's extents as a caption; empty if nothing was cut.
  std::string caption(Lang lang) const;

  /// Returns the summary, lines ending in '\n'.
  ///   planned  the time by the planner of least time, if it ran
  ///   counts   whether that time is shown next to the control's time, or counts as the machine's time instead of it
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
  std::uint64_t rapids_ = 0, feeds_ = 0, arcs_ = 0, others_ = 0;  // others: probe, home
  std::uint64_t alarms_ = 0, warnings_ = 0;
  TimeBasis basis_ = TimeBasis::programmed;
  double cutting_mm_ = 0, rapid_mm_ = 0;
  RunExtents extents_;
  std::vector<std::string> system_names_;
  std::vector<ToolUse> tools_;  // in order of first use
  std::size_t in_spindle_ = 0;  // index in tools_; tools_.size(): no tool known
};

/// For programs of several channels: how long a channel worked and how long it waited for others, in s (nct 14.5).
struct ChannelTime {
  int channel = 1;
  double busy = 0, waited = 0;
};
/// Returns "channel 2", the line above the channel's summary.
std::string channel_heading(int channel, Lang lang);
/// Returns the time of all channels: the longest is the machining time.
std::string channels_text(const std::vector<ChannelTime>& times, Lang lang);

/// 3725.4 s → "1:02:05", 65.3 s → "1:05.3".
std::string duration_text(double seconds);

}  // namespace kadr
