#pragma once
// ChannelAxes is the axes of one channel at an operator panel. It passes the planned motion of these axes to the channel's servo clock, leg
// by leg. A leg is the motion from one stop of the axes to the next stop. After a leg the channel waits for other channels, or its motion
// is over. Only the machine's thread uses a ChannelAxes; the servo clock has its own thread.
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

/// The overrides that the operator selects, as factors of the programmed speeds.
struct PanelOverrides {
  static constexpr double least_spindle = 0.5, max_spindle = 1.2, max_feed = 2;
  double feed = 1, rapid = 1;  // factor of the programmed feed, 0 to 2, and of the planned rapid speed, 0 to 1
  double spindle = 1;          // factor of the programmed spindle speed
  // Dry run: the feed in mm/min that replaces all feeds except thread feeds, from the next start of motion; 0: the dry run is off.
  double dry_feed = 0;
  /// The factor of the programmed feed with which motion is planned. An override up to 1 needs no other plan: the plan is played slower.
  double planned() const { return feed > 1 ? feed : 1; }
  friend bool operator==(const PanelOverrides&, const PanelOverrides&) = default;
};

/// Several channels that wait for each other at a waiting code (nct 14.5).
struct PanelMeeting {
  std::uint32_t code = 0;
  std::set<int> channels;  // numbers of all channels that must arrive at the waiting code
  std::set<int> here;      // numbers of the channels whose axes have arrived at the waiting code
  bool is_met = false;     // True if the controls of all these channels have reached the code. The controls are ahead of the axes.
  bool is_over() const { return is_met && here == channels; }
};

/// The limit that determines the speed of the axes.
struct PanelLimit {
  LimitedBy by;
  bool rapid = false;  // true if the speed of a rapid motion is limited
  double until = 0;    // time since the start of the leg until which this limit applies, s
};

class ChannelAxes {
 public:
  /// `stand` is the position of the axes at the start, in machine coordinates.
  ChannelAxes(int its_number, std::vector<std::string> names, const AxisRoles& its_roles, double rate, const Axes& stand)
      : number(its_number), axes(std::move(names)), roles(its_roles), rate_(rate), clock(rate, stand, its_roles) {}

  const int number;  // channel number
  const std::vector<std::string> axes;
  const AxisRoles roles;

 private:
  const double rate_;

 public:
  ServoClock clock;
  PanelBlock pending;            // the motion on which the planner is working
  PanelBlock on;                 // the block that the axes are executing, or executed last
  Placement placement;           // position of the work coordinate system in machine coordinates
  std::uint32_t modes_of = ~0u;  // Origin::number of the block to which the modes in `pending` belong
  // `holds_next` is true if the control must hold before the next block. `holds_again` is true if the control will call is_held() once more
  // for the same block and must then continue.
  bool holds_next = false, holds_again = false;
  bool has_ended = false;  // True if the channel's program has ended, so that nothing is left to plan.
  bool enters = false;     // True if this channel, which is not the program's own channel, is executing a line that the operator entered.
  std::uint64_t entered = 0;  // number of blocks executed in lines that the operator entered in this channel

  /// Discards all motion and state, for a restart of the program from its beginning.
  void start_over();
  /// Starts a new leg at the end of the last leg. The planner `planned` plans the leg and numbers its motions; it must be unused.
  void plan(Planned& planned, const PanelOverrides& shares);
  /// Ends the leg that is being planned. The axes stop at the end of this leg.
  ///   meeting  the meeting at which the channel waits after the leg; nullptr: nothing follows the leg
  ///   at       the block with the waiting code of this meeting
  void end_leg(std::shared_ptr<PanelMeeting> meeting = {}, const Origin& at = {});
  /// Replaces the meeting (the waiting code with its channels) at the end of the leg that was planned last.
  void meet(const std::shared_ptr<PanelMeeting>& meeting) {
    if (!legs_.empty()) legs_.back().meeting = meeting;
  }
  /// True if the control waits at a waiting code for other channels. Nothing can be planned for this channel then.
  bool waits() const { return !legs_.empty() && legs_.back().meeting != nullptr && !legs_.back().meeting->is_met; }
  /// The waiting code at the end of the planned motion; nullptr if the motion does not end at a waiting code.
  const PanelMeeting* meeting() const { return legs_.empty() ? nullptr : legs_.back().meeting.get(); }
  /// Returns true if the control must hold before the next block. The control calls is_held() before each block of this channel.
  bool is_held();
  bool is_planned() const { return planned_ != nullptr; }
  /// True if less than `enough` seconds are planned ahead of the clock. Planning should then continue.
  bool wants_more() const { return planned_ != nullptr && ahead() < enough; }
  /// True if the memory for planned motion is full.
  bool is_full() const { return cells_ > max_cells; }

  /// Offers planned cells to the playback. When the clock has finished a leg, the function starts the next leg.
  void go_on();
  /// Sets `on` to the block that the axes are executing.
  void note_block();
  /// Sets the override of the axes from the operator's overrides. The override is 0 if `stands` is true, that is, if a feed hold is active.
  /// An override above 1 applies to motion that is planned from now on.
  void apply_overrides(const PanelOverrides& shares, bool stands);
  /// Returns the limit that determines the speed of the axes at present; nullopt if the axes are at rest.
  std::optional<PanelLimit> limit();
  /// True if all planned motion has been played and the channel need not continue, because it waits at a meeting or nothing follows.
  bool is_over() const;
  /// True if the axes are at rest at present. Planned motion may follow.
  bool stands() const;
  /// The meeting at which the axes are waiting at present, after their motion; nullptr if the axes are not waiting.
  const PanelMeeting* waits_for() const;
  /// The block with the waiting code if the channel is waiting; otherwise the block that the axes are executing.
  const Origin& block() const { return waits_for() != nullptr ? legs_.front().waits_in : on.origin; }
  /// Discards the finished legs (motions up to a stop), unless the control waits at a meeting. Call it when the motion of all channels is
  /// over.
  void settle();
  /// Discards all planned motion of the channel. The axes stop at their current position.
  void drop();

 private:
  /// The motion from one stop of the axes to the next stop.
  struct Leg {
    Leg(const MotionLimits& of_axes, double rate) : playback(of_axes, rate) {}
    Playback playback;
    PanelBlocks blocks;
    std::deque<PanelLimit> limits;   // limits of the motion that is not played yet, in the order of time
    std::deque<TimedCells> to_come;  // cells of the plan that are not yet offered to the playback
    std::size_t offered = 0;         // number of cells in the first element of to_come that are already offered
    double seconds = 0;              // planned duration of the leg (the motion up to the next stop), s
    bool planned_all = false;
    std::shared_ptr<PanelMeeting> meeting;  // the waiting code, with its channels, at the end of the leg; nullptr: there is none
    Origin waits_in;                        // the block with the waiting code at the end of the leg
  };
  static constexpr double enough = 3 * Playback::reserve;  // Planning continues while less than this time is planned ahead of the clock, s.
  // Limit of stored cells, about 40 MB. It is reached only if another channel needs much more planning than this channel.
  static constexpr std::size_t max_cells = 100'000;

  double ahead() const;
  bool is_through(const Leg& leg) const;
  bool offer_first(Leg& leg);
  void offer(Leg& leg);
  void take(Leg& leg, const TimedCells& cells, const MotionLimits& limits);

  Planned* planned_ = nullptr;  // The planner of the leg that was started last; nullptr when this leg is completely planned.
  std::deque<Leg> legs_;
  std::size_t cells_ = 0;         // number of cells in all legs that are not yet offered to a playback
  const Leg* playing_ = nullptr;  // the first of the stored legs while the clock plays its motion; otherwise nullptr
  double share_ = 1;              // the last requested override, as a factor of the planned speed
};

}  // namespace kadr
