#pragma once
// Heights: rapids below the part's zero, tool changes at a low Z; coordinates far outside the others; units that change.

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <set>
#include <vector>

#include "action/step.h"
#include "session/checklist/advice.h"

namespace kadr {

class LevelWatch {
 public:
  void take(const Step& step, Advices& to);
  void finish(Advices& to);
  /// The last motion was a cut, sideways or down, below a height at which the tool has been: there a program hardly ends.
  const std::optional<Origin>& ends_in_cut() const { return in_cut_; }

 private:
  /// A rapid at a low Z: it matters only within the region that is cut, not beside the part.
  struct Low {
    Origin origin;
    AlarmId id;
    double x, y, z;
  };
  void take_motion(const Step& step, const Motion& motion, Advices& to);
  void take_change(const Origin& origin, Advices& to);
  void note_low(const Low& low) {
    constexpr std::size_t most = 1000;
    const bool is_known =
        std::any_of(lows_.begin(), lows_.end(), [&](const Low& l) { return l.id == low.id && l.origin.line == low.origin.line; });
    if (!is_known && lows_.size() < most) lows_.push_back(low);
  }
  bool is_drilled(const Low& low) const;
  void judge_lows(Advices& to) const;
  void take_point(const Ends& ends, const Origin& origin);

  bool turned_ = false;       // a rotary axis has moved, or the frame has: heights mean nothing
  double lowest_ = 1e300;     // Z of any cut so far, work coordinates
  double approach_ = -1e300;  // greatest Z that it has been at by rapids, work coordinates
  double z_ = 0;              // where it stands
  bool z_by_machine_ = true;  // … by a return to a place of the machine, or not yet anywhere
  bool cuts_ = false;         // the tool in the spindle has
  std::uint16_t system_ = 0;
  std::optional<bool> inch_;
  /// Of an axis: the outermost points of cuts and the next ones towards the middle that other blocks have.
  struct Span {
    std::array<double, 2> least{1e300, 1e300}, most{-1e300, -1e300};
    std::array<Origin, 2> at_least, at_most;
  };
  std::size_t feeds_down_ = 0;                      // straight down into the part, at feed
  std::set<long long> heights_;                     // of rapids that end above the part, µm
  std::size_t below_ = 0;                           // rapids straight down that end below its zero
  std::optional<Low> only_below_;                   // the first of them
  std::optional<std::pair<Ends, Origin>> to_hole_;  // the rapid before
  std::optional<Low> sideways_;                     // since the last cut
  std::optional<Low> plunge_;                       // by the motion before
  bool was_cut_ = false;                            // the motion before
  std::optional<Origin> in_cut_;                    // see ends_in_cut()
  std::vector<Low> lows_;
  std::vector<Vec3> drilled_;  // bottoms of holes that cycles have made
  std::array<Span, 3> spans_;
  std::size_t cuts_made_ = 0;
};

}  // namespace kadr
