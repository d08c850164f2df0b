#pragma once
// LevelWatch: finds rapids below the zero point of the part, tool changes at a low Z, coordinates far from all others, and changes between
// inch and mm within a program.

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
  /// Returns the location of the last motion if it was a cut, sideways or down, that ended below the highest Z to which rapids have moved;
  /// nullopt otherwise. A program that ends with such a cut is probably incomplete.
  const std::optional<Origin>& ends_in_cut() const { return in_cut_; }

 private:
  /// A rapid motion that ends at a low Z. It is reported only if it ends inside the region that is cut, since the tool is next to the part
  /// elsewhere.
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

  // true: a rotary axis or the coordinate system has turned, or the machine is a lathe, so heights are no longer compared
  bool turned_ = false;
  double lowest_ = 1e300;     // lowest Z of all cuts so far, work coordinates, mm
  double approach_ = -1e300;  // highest Z to which rapids have moved, work coordinates, mm
  double z_ = 0;              // present Z, work coordinates, mm
  bool z_by_machine_ = true;  // true: z_ is unknown, as no motion has set it or the last one went to a machine position
  bool cuts_ = false;         // true: the tool in the spindle has cut
  std::uint16_t system_ = 0;
  std::optional<bool> inch_;
  /// The outermost coordinates of all cuts along one axis. At each of the two ends it stores the extreme coordinate, and the most extreme
  /// coordinate of any other block.
  struct Span {
    std::array<double, 2> least{1e300, 1e300}, most{-1e300, -1e300};
    std::array<Origin, 2> at_least, at_most;
  };
  std::size_t feeds_down_ = 0;     // number of motions straight down into the part at feed
  std::set<long long> heights_;    // heights, µm, at which rapids straight down end, if they end at or above the part's zero point
  std::size_t below_ = 0;          // number of rapids straight down that end below the part's zero point
  std::optional<Low> only_below_;  // the first rapid straight down that ends below the part's zero point
  // start and end of the previous motion, if it was a rapid; a canned cycle may start after it in the same block
  std::optional<std::pair<Ends, Origin>> to_hole_;
  std::optional<Low> sideways_;   // a sideways rapid at a low Z that no cut has followed yet
  std::optional<Low> plunge_;     // the previous motion, if it was a rapid straight down below the part's zero point
  bool was_cut_ = false;          // true: the previous motion was a cut
  std::optional<Origin> in_cut_;  // result of ends_in_cut()
  std::vector<Low> lows_;
  std::vector<Vec3> drilled_;  // positions of the bottoms of the holes that canned cycles have drilled
  std::array<Span, 3> spans_;
  std::size_t cuts_made_ = 0;
};

}  // namespace kadr
