#pragma once
// ToolWatch: finds what one tool of a program lacks although the other tools have it: a length offset, a rotating spindle, coolant, the
// common work offset.

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "action/step.h"
#include "session/checklist/advice.h"

namespace kadr {

class ToolWatch {
 public:
  void take(const Step& step, Advices& to);
  /// Reports the findings after the run. `systems`: names of the work offsets; the index of a name is Motion::system.
  void finish(const std::vector<std::string>& systems, Advices& to);

 private:
  using Rows = std::map<std::uint32_t, Origin>;  // row number of an offset table → location of the first motion that uses the row
  /// The use of one tool, from one tool change to the next.
  struct ToolPeriod {
    std::uint32_t tool = 0;
    double highest = -1e300;                 // highest Z that the tool has reached, mm
    std::optional<Origin> cuts, cuts_still;  // locations of the tool's first cut, and of its first cut with the spindle stopped
    std::optional<Origin> counter_clockwise;
    bool mills = false;  // true: the tool mills or drills; false: the tool is a tap
    bool clockwise = false, turned = false, started = false, wet = false;
    std::optional<Origin> without_length;  // location of the tool's first cut, if no length offset was in force there
    Rows lengths, radii, systems;
  };
  void take_motion(const Step& step, const Motion& motion);
  void take_spindle(const Spindle& spindle, const Origin& origin);
  ToolPeriod& now() { return stints_.back(); }
  void judge_spindles(Advices& to) const;
  void judge_coolant(Advices& to) const;
  void judge_lengths(Advices& to) const;
  void judge_rows(Rows ToolPeriod::*rows, AlarmId id, char address, Advices& to) const;
  void judge_systems(const std::vector<std::string>& names, Advices& to) const;
  void judge_selections(Advices& to) const;

  std::vector<ToolPeriod> stints_ = std::vector<ToolPeriod>(1);
  SpindleDir turns_ = SpindleDir::stop;
  double rpm_ = 0;
  bool coolant_ = false;
  bool started_since_cut_ = false;  // true: the spindle has started since the last cut
  bool taps_rigidly_ = false;
  // block number in the run (Origin::number) of the last block in which a canned cycle has moved the tool
  std::optional<std::uint32_t> cycle_block_;
  bool asks_speed_ = false;                   // true: a spindle speed above 0 has been programmed
  std::size_t starts_ = 0;                    // number of spindle starts
  std::size_t zero_speeds_ = 0;               // number of spindle speeds of 0; the program of a laser states S0 for travel without cutting
  std::map<std::uint32_t, Origin> selected_;  // tools that a T word has selected, but no tool change has put into the spindle yet
  std::uint32_t first_tool_ = 0;
  bool changes_ = false;
};

}  // namespace kadr
