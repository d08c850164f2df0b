#pragma once
// ToolWatch: finds what one tool of a program lacks and the others have: offsets, spindle, coolant, work offset.

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
  /// `systems`: names of the work offsets, by Motion::system.
  void finish(const std::vector<std::string>& systems, Advices& to);

 private:
  using Rows = std::map<std::uint32_t, Origin>;  // of an offset table, each with its first motion
  /// The use of a tool from one tool change to the next.
  struct Stint {
    std::uint32_t tool = 0;
    double highest = -1e300;                 // highest Z reached, mm
    std::optional<Origin> cuts, cuts_still;  // its first cut; the first one with the spindle stopped
    std::optional<Origin> counter_clockwise;
    bool mills = false;  // it mills or drills, and is no tap
    bool clockwise = false, turned = false, started = false, wet = false;
    std::optional<Origin> without_length;  // set if its first cut had no length offset
    Rows lengths, radii, systems;
  };
  void take_motion(const Step& step, const Motion& motion);
  void take_spindle(const Spindle& spindle, const Origin& origin);
  Stint& now() { return stints_.back(); }
  void judge_spindles(Advices& to) const;
  void judge_coolant(Advices& to) const;
  void judge_lengths(Advices& to) const;
  void judge_rows(Rows Stint::*rows, AlarmId id, char address, Advices& to) const;
  void judge_systems(const std::vector<std::string>& names, Advices& to) const;
  void judge_selections(Advices& to) const;

  std::vector<Stint> stints_ = std::vector<Stint>(1);
  SpindleDir turns_ = SpindleDir::stop;
  double rpm_ = 0;
  bool coolant_ = false;
  bool started_since_cut_ = false;  // the spindle has started since the last cut
  bool taps_rigidly_ = false;
  std::optional<std::uint32_t> cycle_block_;  // Origin::number of the last block with a motion of a canned cycle
  bool asks_speed_ = false;                   // an S word has been programmed
  std::size_t starts_ = 0;                    // number of spindle starts
  std::size_t zero_speeds_ = 0;               // number of S0: a laser travels with it
  std::map<std::uint32_t, Origin> selected_;  // selected by T, not yet changed to
  std::uint32_t first_tool_ = 0;
  bool changes_ = false;
};

}  // namespace kadr
