#pragma once
// PanelLane: the axes of one channel at a panel: their planned motion, leg by leg, in the time of their servo clock. After a leg they
// wait for other channels, or the motion is over. Used by the machine's thread only, except for its clock.
//
//   plan() ──▶ Planned ──cells──▶ the last leg … the first ──▶ Playback ──▶ ServoClock

#include <deque>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "motion/look_ahead/limited_by.h"
#include "panel/panel_blocks.h"
#include "panel/servo_clock.h"
#include "session/planned.h"

namespace kadr {

/// Speeds as set by the operator's switches.
struct PanelShares {
  static constexpr double least_spindle = 0.5, most_spindle = 1.2;
  double feed = 1, rapid = 1;  // 0 … 1 of the planned speed
  double spindle = 1;          // share of the spindle speed
  double dry_feed = 0;         // mm/min for all feeds but threads, from the next stretch on; 0: as programmed
  friend bool operator==(const PanelShares&, const PanelShares&) = default;
};

/// Channels that wait for each other at a waiting code (nct 14.5).
struct PanelMeeting {
  std::uint32_t code = 0;
  std::set<int> channels;  // all that must arrive
  std::set<int> here;      // those whose axes have arrived
  bool is_met = false;     // their controls, which are ahead of the machine, have met
  bool is_over() const { return is_met && here == channels; }
};

/// What limits the speed of the axes.
struct PanelLimit {
  LimitedBy by;
  bool rapid = false;  // the motion is rapid
  double until = 0;    // s on the plan
};

class PanelLane {
 public:
  /// `stand`: machine coordinates at the start.
  PanelLane(int its_number, std::vector<std::string> names, const AxisRoles& its_roles, double rate, const Axes& stand)
      : number(its_number), axes(std::move(names)), roles(its_roles), rate_(rate), clock(rate, stand, its_roles) {}

  const int number;  // of the channel
  const std::vector<std::string> axes;
  const AxisRoles roles;

 private:
  const double rate_;

 public:
  ServoClock clock;
  PanelBlock pending;                            // the motion being planned
  PanelBlock on;                                 // the block that the axes are on, or were on last
  Placement placement;                           // of the work coordinate system
  std::uint32_t modes_of = ~0u;                  // Origin::number of pending.modes
  bool holds_next = false, holds_again = false;  // hold before the next block; the control asks about that block once more
  bool has_ended = false;                        // its program has ended: nothing is left to plan
  bool enters = false;                           // a line of the operator is executed in a channel other than the program's own
  std::uint64_t entered = 0;                     // number of blocks in such lines

  /// Resets the lane: the program is at its beginning.
  void start_over();
  /// Starts another leg at the end of the last one; `planned` is not in use yet. Motions continue to be numbered by it.
  void plan(Planned& planned, double dry_feed);
  /// Ends the leg being planned: the axes stop, and then wait for other channels in the block `at`. `meeting` nullptr: nothing follows.
  void end_leg(std::shared_ptr<PanelMeeting> meeting = {}, const Origin& at = {});
  /// From now on the leg planned last ends with this meeting.
  void meet(const std::shared_ptr<PanelMeeting>& meeting) {
    if (!legs_.empty()) legs_.back().meeting = meeting;
  }
  /// True if the control waits at a waiting code for other channels: nothing can be planned.
  bool waits() const { return !legs_.empty() && legs_.back().meeting != nullptr && !legs_.back().meeting->is_met; }
  /// The waiting code at the end of the planned motion; nullptr if there is none.
  const PanelMeeting* meeting() const { return legs_.empty() ? nullptr : legs_.back().meeting.get(); }
  /// Called before each block of this channel. Returns true if it is to be held.
  bool is_held();
  bool is_planned() const { return planned_ != nullptr; }
  /// True if more should be planned.
  bool wants_more() const { return planned_ != nullptr && ahead() < enough; }
  /// True if so much is planned that no more can be stored.
  bool is_full() const { return cells_ > most_cells; }

  /// Passes planned motion to the clock, and the next leg when the clock has finished one.
  void go_on();
  /// Updates the block that the axes are on.
  void note_block();
  /// `stands`: true during a feed hold.
  void set_share(const PanelShares& shares, bool stands);
  /// What limits the axes now; nullopt if they are at rest.
  std::optional<PanelLimit> limit();
  /// True if nothing moves, now or later.
  bool is_over() const;
  /// True if nothing moves now.
  bool stands() const;
  /// The meeting that the axes wait for after their motion; nullptr if there is none.
  const PanelMeeting* waits_for() const;
  /// The block in which it waits, or which it is on.
  const Origin& block() const { return waits_for() != nullptr ? legs_.front().waits_in : on.origin; }
  /// All motion is over: forgets it, except for a meeting that it waits for.
  void settle();
  /// Drops all motion; the axes stay where they are.
  void drop();

 private:
  /// Motion from one stop of the axes to the next.
  struct Leg {
    Leg(const MotionLimits& of_axes, double rate) : playback(of_axes, rate) {}
    Playback playback;
    PanelBlocks blocks;
    std::deque<PanelLimit> limits;   // for the part not played yet
    std::deque<TimedCells> to_come;  // planned and not offered yet …
    std::size_t offered = 0;         // … except for this many cells of the first
    double seconds = 0;              // planned duration
    bool planned_all = false;
    std::shared_ptr<PanelMeeting> meeting;  // at the end of the leg, in block:
    Origin waits_in;
  };
  static constexpr double enough = 3 * Playback::reserve;  // s ahead of the clock
  static constexpr std::size_t most_cells = 100'000;       // stored if another channel needs more: some 40 MB

  double ahead() const;
  bool is_through(const Leg& leg) const;
  bool offer_first(Leg& leg);
  void offer(Leg& leg);
  void take(Leg& leg, const TimedCells& cells, const MotionLimits& limits);

  Planned* planned_ = nullptr;  // of the last leg, until it is planned
  std::deque<Leg> legs_;
  std::size_t cells_ = 0;         // number of cells still to come in all legs
  const Leg* playing_ = nullptr;  // the first leg, once the clock has it
  double share_ = 1;              // requested share of the planned speed
};

}  // namespace kadr
