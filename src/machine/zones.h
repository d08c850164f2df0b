#pragma once
// Zones: the regions of an NCT machine that its axes must not enter (nct 22), in machine coordinates after all offsets.
//
//   zone 1: limited by the end positions of the axes; its outside is forbidden.
//   zone 2: working area, from the parameters or from G22; its outside, or its inside, is forbidden.
//   zone 3: from the parameters; its inside is forbidden.
//   limit switches at the ends of an axis (nct 22.1): positions beyond them are forbidden; checked during the motion only.
//
// With CBM (N1001 #2) the control checks a motion before it starts: first the end point, then whether the path crosses a zone that is
// forbidden inside. Without CBM, and for a curve whose middle exceeds a limit, the motion runs until it meets a zone, and the alarm names
// the first zone that it meets. Boundaries are INFERRED except for zone 3. The limit value itself is permitted. A zone 2 that is forbidden
// inside starts just within its faces, so a zone 2 without depth forbids nothing (nct 22.2: X = I, P0). Zone 3 includes its faces (nct
// 22.3). For a rotary axis that rolls over, limits apply to the end of the motion only.

#include <string>
#include <vector>

#include "action/action.h"
#include "base/result.h"
#include "config/setup/setup.h"
#include "machine/machine_parameters.h"
#include "machine/zone_box.h"

namespace kadr {

class Zones {
 public:
  /// Creates the zones. `ends` states the end positions of the axes, which limit zone 1.
  Zones(const std::vector<std::string>& names, const AxisRoles& roles, const Extents& ends, const Setup& setup);

  /// Applies G22 or G23. A change marked `of_parameters` sets the parameters of zone 2. If the change names no axes, it switches the check
  /// before a motion on or off (N1001 #2 CBM).
  void change(const ZoneChange& zone);

  /// Exchanges an axis with an axis of another channel (nct 20.3): each axis keeps its name, its end positions and its limit switches.
  void exchange(std::size_t axis, Zones& with, std::size_t other);

  /// Suspends or resumes the check of zone 2 or 3 when a signal of the machine's logic changes (CP_LIM2DIS, CP_LIM3DIS; 22.2, 22.3).
  void suspend(int zone, bool on) { (zone == 2 ? suspended2_ : suspended3_) = on; }

  /// Returns true if end positions, limit switches, zone 2 or zone 3 are active. The machine may refuse a motion only in this case.
  bool in_force() const { return ends_.axes != 0 || switches_.axes != 0 || zone2_.on || zone3_.axes != 0; }
  bool checks_before() const { return checks_before_; }

  // ---- for display
  bool outside2() const { return zone2_.on && !suspended2_ && zone2_.outside_forbidden; }
  bool inside2() const { return zone2_.on && !suspended2_ && !zone2_.outside_forbidden; }
  bool inside3() const { return zone3_.axes != 0 && !suspended3_; }
  const ZoneBox& box2() const { return zone2_.box; }
  const ZoneBox& box3() const { return zone3_; }

  struct Memory;
  Memory memory() const;
  void resume_from(const Memory& memory);

  /// Checks a motion against all zones and switches.
  ///   alarms  with CBM zone1_positive, zone1_negative, zone2_positive, zone2_negative (axis), zone2_inside, zone3_inside,
  ///           zone2_entry, zone3_entry; else zone1_reached_positive, zone1_reached_negative, zone2_reached_positive,
  ///           zone2_reached_negative (axis, limit), zone2_reached_inside, zone3_reached_inside; always switch_positive,
  ///           switch_negative (axis, switch)
  ///   law     without CBM an axis beyond a limit may move back inwards; with CBM an end point beyond a limit is never permitted
  Status check(const ToolPosition& from, const Motion& motion) const;

 private:
  struct Zone2 {
    bool on = false;
    bool outside_forbidden = false;
    bool nothing_allowed = false;  // true after G22 with X = I, Y = J, Z = K and P1 (nct 22.2): the axes must not move
    ZoneBox box;
  };
  /// The alarm ids for a limit: one for its positive side, one for its negative side.
  struct Ids {
    AlarmId positive, negative;
  };
  /// The first limit or zone that a motion meets. `part` is the fraction (0 to 1) of the motion before the limit; 2 if the motion meets
  /// none.
  struct Reached {
    double part = 2;
    Alarm alarm;
  };

  static void swap_ends(ZoneBox& a, std::size_t axis, ZoneBox& b, std::size_t other);
  Zone2 zone_of(const ZoneChange& zone) const;
  ZoneBox open2() const;
  ZoneBox closed3() const;
  Status end_within(const ZoneBox& box, const Axes& end, Ids ids) const;
  Status before_start(const MachinePath& path, const Axes& end) const;
  Status during_motion(const MachinePath& path) const;
  void limits_reached(const MachinePath& path, const ZoneBox& box, Ids ids, Reached& first) const;

  std::vector<std::string> names_;
  AxisRoles roles_;
  ZoneBox ends_, switches_;
  Zone2 of_parameters_, zone2_;
  ZoneBox zone3_;
  bool checks_before_ = false;
  bool suspended2_ = false, suspended3_ = false;
};

/// The part of the zones' state that a program can change.
struct Zones::Memory {
  Zone2 zone2, of_parameters;
  bool checks_before = false;
  bool suspended2 = false, suspended3 = false;
};
inline Zones::Memory Zones::memory() const { return {zone2_, of_parameters_, checks_before_, suspended2_, suspended3_}; }
inline void Zones::resume_from(const Memory& memory) {
  zone2_ = memory.zone2;
  of_parameters_ = memory.of_parameters;
  checks_before_ = memory.checks_before;
  suspended2_ = memory.suspended2;
  suspended3_ = memory.suspended3;
}

}  // namespace kadr
