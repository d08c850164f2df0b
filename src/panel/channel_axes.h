#pragma once
// ChannelAxes: the axes of one channel at an operator panel. It passes their planned motion to the channel's servo clock, leg by leg. A leg
// is the motion from one stop of the axes to the next; after a leg, the channel waits for other channels, or its motion is over. Only the
// machine's thread uses a ChannelAxes; the servo clock has a thread of its own.
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

/// The overrides that the operator selects, as shares of the programmed speeds.
struct PanelOverrides {
  static constexpr double least_spindle = 0.5, max_spindle = 1.2;
  double feed = 1, rapid = 1;  // share of the planned feed or rapid speed, 0 … 1
  double spindle = 1;          // share of the programmed spindle speed
  double dry_feed = 0;         // dry run: mm/min for all feeds except threads, from the next start of motion on; 0: off
  friend bool operator==(const PanelOverrides&, const PanelOverrides&) = default;
};

/// Some channels that wait for each other at a waiting code (nct 14.5).
struct PanelMeeting {
  std::uint32_t code = 0;
  std::set<int> channels;  // numbers of all channels that must arrive
  std::set<int> here;      // numbers of the channels whose axes have arrived
  bool is_met = false;     // all these channels' controls, which are ahead of the axes, have reached the code
  bool is_over() const { return is_met && here == channels; }
};

/// What limits the speed of the axes.
struct PanelLimit {
  LimitedBy by;
  bool rapid = false;  // the motion is rapid
  double until = 0;    // the limit applies until this time of the plan, s
};

class ChannelAxes {
 public:
  /// `stand`: machine coordinates of the axes at the start.
  ChannelAxes(int its_number, std::vector<std::string> names, const AxisRoles& its_roles, double rate, const Axes& stand)
      : number(its_number), axes(std::move(names)), roles(its_roles), rate_(rate), clock(rate, stand, its_roles) {}

  const int number;  // channel number
  const std::vector<std::string> axes;
  const AxisRoles roles;

 private:
  const double rate_;

 public:
  ServoClock clock;
  PanelBlock pending;                            // the motion that the planner is working on
  PanelBlock on;                                 // the block that the axes are executing, or executed last
  Placement placement;                           // position of the work coordinate system
  std::uint32_t modes_of = ~0u;                  // Origin::number of the block to which pending.modes belongs
  bool holds_next = false, holds_again = false;  // the control must hold before the next block; it will ask once more before that block
  bool has_ended = false;                        // the channel's program has ended: nothing is left to plan
  bool enters = false;        // this channel, which is not the program's own, is executing a line that the operator entered
  std::uint64_t entered = 0;  // number of blocks executed in lines that the operator entered in this channel

  /// Drops all motion and state, for a restart of the program from its beginning.
  void start_over();
  /// Starts a new leg where the last leg ends. The planner `planned`, which must be unused, plans the leg and numbers its motions.
  void plan(Planned& planned, double dry_feed);
  /// Ends the leg that is being planned: the axes stop at its end.
  ///   meeting  where the channel waits after the leg; nullptr: nothing follows the leg
  ///   at       the block of that waiting code
  void end_leg(std::shared_ptr<PanelMeeting> meeting = {}, const Origin& at = {});
  /// Replaces the meeting at the end of the leg that was planned last.
  void meet(const std::shared_ptr<PanelMeeting>& meeting) {
    if (!legs_.empty()) legs_.back().meeting = meeting;
  }
  /// True if the control waits at a waiting code for other channels, so that nothing can be planned.
  bool waits() const { return !legs_.empty() && legs_.back().meeting != nullptr && !legs_.back().meeting->is_met; }
  /// The waiting code at the end of the planned motion; nullptr if there is none.
  const PanelMeeting* meeting() const { return legs_.empty() ? nullptr : legs_.back().meeting.get(); }
  /// Called before each block of this channel. Returns true if the control must hold before that block.
  bool is_held();
  bool is_planned() const { return planned_ != nullptr; }
  /// True if less than `enough` seconds are planned ahead of the clock, so that planning should continue.
  bool wants_more() const { return planned_ != nullptr && ahead() < enough; }
  /// True if the memory for planned motion is full.
  bool is_full() const { return cells_ > max_cells; }

  /// Offers planned cells to the playback, and starts the next leg when the clock has finished one.
  void go_on();
  /// Sets `on` to the block that the axes are executing.
  void note_block();
  /// Sets the share of the planned speed from the operator's overrides; 0 if `stands`, that is, if a feed hold is active.
  void apply_overrides(const PanelOverrides& shares, bool stands);
  /// Returns what limits the speed of the axes now; nullopt if they are at rest.
  std::optional<PanelLimit> limit();
  /// True if all planned motion has been played, and the channel need not continue: it waits at a meeting, or nothing follows.
  bool is_over() const;
  /// True if the axes are at rest now; planned motion may follow.
  bool stands() const;
  /// The meeting at which the axes are waiting now, after their motion; nullptr if they are not waiting.
  const PanelMeeting* waits_for() const;
  /// The block of the waiting code if the channel is waiting, else the block that the axes are executing.
  const Origin& block() const { return waits_for() != nullptr ? legs_.front().waits_in : on.origin; }
  /// Called when the motion of all channels is over: drops the finished legs. Keeps them if the control waits at a meeting.
  void settle();
  /// Drops all motion. The axes stop where they are.
  void drop();

 private:
  /// Motion from one stop of the axes to the next.
  struct Leg {
    Leg(const MotionLimits& of_axes, double rate) : playback(of_axes, rate) {}
    Playback playback;
    PanelBlocks blocks;
    std::deque<PanelLimit> limits;   // limits of the motion not played yet, by time
    std::deque<TimedCells> to_come;  // cells of the plan that are not yet offered to the playback
    std::size_t offered = 0;         // number of cells of the first element of to_come that are offered
    double seconds = 0;              // planned duration
    bool planned_all = false;
    std::shared_ptr<PanelMeeting> meeting;  // the meeting at the end of the leg
    Origin waits_in;                        // the block of that meeting's waiting code
  };
  static constexpr double enough = 3 * Playback::reserve;  // planning continues while less than this is planned ahead of the clock, s
  // limit of stored cells, some 40 MB; reached only if another channel needs much more planning than this one
  static constexpr std::size_t max_cells = 100'000;

  double ahead() const;
  bool is_through(const Leg& leg) const;
  bool offer_first(Leg& leg);
  void offer(Leg& leg);
  void take(Leg& leg, const TimedCells& cells, const MotionLimits& limits);

  Planned* planned_ = nullptr;  // plans the last leg; nullptr when that leg is completely planned
  std::deque<Leg> legs_;
  std::size_t cells_ = 0;         // number of cells in all legs that are not yet offered to a playback
  const Leg* playing_ = nullptr;  // the first leg, while the clock plays it; else nullptr
  double share_ = 1;              // share of the planned speed that was requested last
};

}  // namespace kadr
