#pragma once
// PanelLane: the axes of one channel at a panel: what was planned of their motion, leg by leg, in the time of their servo clock. After a
// leg they wait for other channels, or all of it is over. Of the machine's thread, but for its clock.
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

/// How fast, by the operator's switches.
struct PanelShares {
  static constexpr double least_spindle = 0.5, most_spindle = 1.2;
  double feed = 1, rapid = 1;  // 0 … 1 of the planned speed
  double spindle = 1;          // of the speed of the spindle
  double dry_feed = 0;         // mm/min of all feeds but threads, from the next stretch on; 0: as programmed
  friend bool operator==(const PanelShares&, const PanelShares&) = default;
};

/// Channels that wait for each other at a waiting code (nct 14.5).
struct PanelMeeting {
  std::uint32_t code = 0;
  std::set<int> channels;  // all that have to come
  std::set<int> here;      // whose axes have come
  bool is_met = false;     // by their controls, which are ahead of the machine
  bool is_over() const { return is_met && here == channels; }
};

/// What keeps the axes from being faster.
struct PanelLimit {
  LimitedBy by;
  bool rapid = false;  // at rapid
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
  PanelBlock pending;                            // the motion that is being planned
  PanelBlock on;                                 // that the axes are on, or were on last
  Placement placement;                           // of the work coordinates
  std::uint32_t modes_of = ~0u;                  // Origin::number of pending.modes
  bool holds_next = false, holds_again = false;  // before the block that comes next; that block is asked for once more
  bool has_ended = false;                        // its program: nothing of it is to be planned
  bool enters = false;                           // a line of the operator, in a channel beside the program's own
  std::uint64_t entered = 0;                     // blocks of such lines

  /// The program is at its beginning.
  void start_over();
  /// One more leg, from where the last one ends: `planned` is not planned with yet. Numbers of motions go on with it.
  void plan(Planned& planned, double dry_feed);
  /// What is being planned comes to rest; then it waits for others, in the block `at`. `meeting` nullptr: nothing follows.
  void end_leg(std::shared_ptr<PanelMeeting> meeting = {}, const Origin& at = {});
  /// The leg that is planned last waits for this from now on.
  void meet(const std::shared_ptr<PanelMeeting>& meeting) {
    if (!legs_.empty()) legs_.back().meeting = meeting;
  }
  /// It has come to a waiting code that others have not come to: nothing to be planned.
  bool waits() const { return !legs_.empty() && legs_.back().meeting != nullptr && !legs_.back().meeting->is_met; }
  /// The waiting code at the end of what is planned; nullptr: none.
  const PanelMeeting* meeting() const { return legs_.empty() ? nullptr : legs_.back().meeting.get(); }
  /// Asked before each of its blocks: is it to be held?
  bool is_held();
  bool is_planned() const { return planned_ != nullptr; }
  /// More should be planned.
  bool wants_more() const { return planned_ != nullptr && ahead() < enough; }
  /// So much is planned that nothing more can be taken.
  bool is_full() const { return cells_ > most_cells; }

  /// The clock gets what is planned, and the next leg when it has come to the end of one.
  void go_on();
  /// The block that the axes are on.
  void note_block();
  /// `stands`: by a feed hold.
  void set_share(const PanelShares& shares, bool stands);
  /// Where the axes are now; nothing: they stand.
  std::optional<PanelLimit> limit();
  /// Nothing moves, nor will.
  bool is_over() const;
  /// Nothing moves now.
  bool stands() const;
  /// What it waits for with its axes there; nullptr: nothing.
  const PanelMeeting* waits_for() const;
  /// The block that it waits in, or is on.
  const Origin& block() const { return waits_for() != nullptr ? legs_.front().waits_in : on.origin; }
  /// All of it is over: forgotten, but for what it waits for.
  void settle();
  /// The axes stay where they are.
  void drop();

 private:
  /// From where the axes stand to where they stand again.
  struct Leg {
    Leg(const MotionLimits& of_axes, double rate) : playback(of_axes, rate) {}
    Playback playback;
    PanelBlocks blocks;
    std::deque<PanelLimit> limits;   // of what is not played yet
    std::deque<TimedCells> to_come;  // planned and not offered yet, but for
    std::size_t offered = 0;         // so many of the first
    double seconds = 0;              // planned
    bool planned_all = false;
    std::shared_ptr<PanelMeeting> meeting;  // at its end, in
    Origin waits_in;
  };
  static constexpr double enough = 3 * Playback::reserve;  // s ahead of the clock
  static constexpr std::size_t most_cells = 100'000;       // kept because another channel needs more: some 40 MB

  double ahead() const;
  bool is_through(const Leg& leg) const;
  bool offer_first(Leg& leg);
  void offer(Leg& leg);
  void take(Leg& leg, const TimedCells& cells, const MotionLimits& limits);

  Planned* planned_ = nullptr;  // of the last leg, as long as it is planned
  std::deque<Leg> legs_;
  std::size_t cells_ = 0;         // in them, to come
  const Leg* playing_ = nullptr;  // the first one, when the clock has it
  double share_ = 1;              // of the planned speed, as it is asked for
};

}  // namespace kadr
