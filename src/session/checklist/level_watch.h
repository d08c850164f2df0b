#pragma once
// LevelWatch: finds rapids below the zero of the part, tool changes at a low Z, coordinates far from all others, and changes between inch
// and mm.

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
  /// Location of the last motion if it was a cut, sideways or down, to a Z below the highest Z that rapids have reached; nullopt otherwise.
  /// A program that ends there is probably incomplete.
  const std::optional<Origin>& ends_in_cut() const { return in_cut_; }

 private:
  /// A rapid motion at a low Z. The motion is reported only if it ends inside the region that is cut; outside that region the tool is next
  /// to the part.
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

  bool turned_ = false;       // a rotary axis or the coordinate system has rotated: the watch no longer compares heights
  double lowest_ = 1e300;     // lowest Z of all cuts so far, work coordinates
  double approach_ = -1e300;  // highest Z to which rapids have moved, work coordinates
  double z_ = 0;              // present Z, work coordinates
  bool z_by_machine_ = true;  // z_ is unknown: after a return to a machine position, or before the first motion
  bool cuts_ = false;         // the tool in the spindle has cut
  std::uint16_t system_ = 0;
  std::optional<bool> inch_;
  /// The outermost coordinates of all cuts along one axis, at both of its ends: the extreme one, and the next one inwards that another
  /// block has.
  struct Span {
    std::array<double, 2> least{1e300, 1e300}, most{-1e300, -1e300};
    std::array<Origin, 2> at_least, at_most;
  };
  std::size_t feeds_down_ = 0;     // number of motions at feed straight down into the part
  std::set<long long> heights_;    // heights above the part where rapids end, µm
  std::size_t below_ = 0;          // number of rapids straight down that end below the part's zero
  std::optional<Low> only_below_;  // the first rapid counted in below_
  // the previous motion if it was a rapid: a canned cycle may start after it, in the same block
  std::optional<std::pair<Ends, Origin>> to_hole_;
  std::optional<Low> sideways_;   // a sideways rapid at a low Z since the last cut
  std::optional<Low> plunge_;     // the previous motion if it was a rapid below the part's zero
  bool was_cut_ = false;          // the previous motion was a cut
  std::optional<Origin> in_cut_;  // the value of ends_in_cut()
  std::vector<Low> lows_;
  std::vector<Vec3> drilled_;  // bottoms of the holes that canned cycles have drilled
  std::array<Span, 3> spans_;
  std::size_t cuts_made_ = 0;
};

}  // namespace kadr
