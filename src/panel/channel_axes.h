#pragma once
// ChannelAxes is the axes of one channel at an operator panel, and what moves them: Kadr's virtual machine (VirtualAxes) or a real one
// (GrblAxes). The axes move leg by leg. A leg is the motion from one stop of the axes to the next stop. After a leg the channel waits for
// other channels, or its motion is over. Only the machine's thread uses a ChannelAxes, except where a function says that any thread may.
//
//   PanelMachine ──begin_leg(), take(), end_leg()──▶ ChannelAxes ──▶ sample(): where the axes are, and how old that is

#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "motion/look_ahead/limited_by.h"
#include "panel/panel_blocks.h"
#include "panel/servo_clock.h"
#include "session/session.h"

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

/// What a real machine reports, besides the position of its axes.
struct RealMachine {
  std::string port;
  std::string controller;  // the version that it states
  std::string state;       // in its own words: "Idle", "Hold:0", "Alarm"
  std::string inputs;      // letters of its active inputs
  double age = 0;          // age of the position, s
  double pending = 0;      // how long the axes would go on moving if the connection broke now, s
  bool is_lost = false;    // there is no connection
  bool is_locked = false;  // it has to be homed or unlocked before it moves
};

class ChannelAxes {
 public:
  ChannelAxes(int its_number, std::vector<std::string> names, const AxisRoles& its_roles)
      : number(its_number), axes(std::move(names)), roles(its_roles) {}
  virtual ~ChannelAxes() = default;
  ChannelAxes(const ChannelAxes&) = delete;
  ChannelAxes& operator=(const ChannelAxes&) = delete;

  const int number;  // channel number
  const std::vector<std::string> axes;
  const AxisRoles roles;

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

  // ---- where the axes are; any thread may call these functions
  virtual ServoSample sample() const = 0;
  /// Stops the axes as fast as they can, even in the middle of a motion, and keeps them until release().
  virtual void stop_at_once() = 0;
  virtual void release() = 0;
  virtual bool was_stopped() const = 0;
  virtual bool is_real() const { return false; }
  /// What a real machine reports; nullopt: the machine is virtual.
  virtual std::optional<RealMachine> real() const { return std::nullopt; }

  /// Sets the position of the axes while nothing moves, as only a virtual machine can. A real one ignores it.
  virtual void stand_at(const Axes& machine) = 0;
  /// Axes that are nearer to a position than this, mm or degrees, have reached it.
  virtual double nearly_there() const = 0;
  /// Returns the overrides that the machine has instead of `wanted`.
  virtual PanelOverrides possible(PanelOverrides wanted) const { return wanted; }
  /// Returns why the machine cannot move on, or can no longer be relied on; an empty text if it can.
  virtual std::string fault() { return {}; }
  /// Returns why the axes cannot begin to move; an empty text if they can.
  virtual std::string not_ready() const { return {}; }
  /// The operator has reset the panel: a real machine forgets its fault, and its connection is made again if it was lost.
  virtual void recover() {}
  /// Homes the axes, or unlocks a controller in an alarm. Returns false if the machine does not have it.
  virtual bool home() { return false; }
  virtual bool unlock() { return false; }

  // ---- a leg
  /// Discards all motion and state, for a restart of the program from its beginning.
  void start_over();
  /// Starts a new leg at the end of the last leg, in which the session moves the axes. take() follows for each of its actions.
  virtual void begin_leg(Session& session, std::size_t channel, const PanelOverrides& shares) = 0;
  /// Takes an action of the session. If it is a motion, `pending` describes it.
  virtual void take(const Step& step) = 0;
  /// Starts a new leg, in which the operator moves the axes. take_by_hand() follows for each motion, and end_leg().
  virtual void begin_by_hand(const Channel& channel, const MachineProfile& machine, const ToolPosition& stand,
                             const PanelOverrides& shares) = 0;
  virtual void take_by_hand(const Step& step) = 0;
  /// Moves one axis towards `end`, machine coordinates, as long as a key is held: until keep_jogging() is not called for a while, or until
  /// apply_overrides() stops the axes. Returns false if the machine moves by take_by_hand() in this case too.
  virtual bool begin_jog(std::size_t /*axis*/, double /*end*/, double /*feed*/) { return false; }
  virtual void keep_jogging() {}
  /// Moves one axis of a real machine towards `end`, machine coordinates, mm, until its probe touches. Returns false if there is no probe.
  virtual bool begin_probe(std::size_t /*axis*/, double /*end*/, double /*feed*/) { return false; }
  /// Where the last begin_probe() has touched, machine coordinates; nullopt: it has not.
  virtual std::optional<Axes> touched() const { return std::nullopt; }
  /// Ends the leg that is being planned. The axes stop at the end of this leg.
  ///   meeting  the meeting at which the channel waits after the leg; nullptr: nothing follows the leg
  ///   at       the block with the waiting code of this meeting
  virtual void end_leg(std::shared_ptr<PanelMeeting> meeting = {}, const Origin& at = {}) = 0;
  /// Replaces the meeting (the waiting code with its channels) at the end of the leg that was planned last.
  virtual void meet(const std::shared_ptr<PanelMeeting>& /*meeting*/) {}
  /// The waiting code at the end of the planned motion; nullptr if the motion does not end at a waiting code.
  virtual const PanelMeeting* meeting() const { return nullptr; }
  /// True if the control waits at a waiting code for other channels. Nothing can be planned for this channel then.
  bool waits() const { return meeting() != nullptr && !meeting()->is_met; }
  /// The meeting at which the axes are waiting at present, after their motion; nullptr if the axes are not waiting.
  virtual const PanelMeeting* waits_for() const { return nullptr; }
  /// The block with the waiting code if the channel is waiting; otherwise the block that the axes are executing.
  virtual const Origin& block() const { return on.origin; }
  /// Returns true if the control must hold before the next block. The control calls is_held() before each block of this channel.
  bool is_held();
  /// True if a leg has begun and has not ended: actions of the session may follow.
  virtual bool is_planned() const = 0;
  /// True if little motion is left that was planned ahead of the axes. Planning should then continue.
  virtual bool wants_more() const = 0;
  /// True if the memory for planned motion is full.
  virtual bool is_full() const = 0;

  /// Passes planned motion to the axes. When they have finished a leg, the function starts the next leg.
  virtual void go_on() = 0;
  /// Sets `on` to the block that the axes are executing.
  virtual void note_block() = 0;
  /// Sets the override of the axes from the operator's overrides. The override is 0 if `stands` is true, that is, if a feed hold is active.
  /// An override above 1 may apply only to motion that is planned from now on.
  virtual void apply_overrides(const PanelOverrides& shares, bool stands) = 0;
  /// Returns the limit that determines the speed of the axes at present; nullopt if the axes are at rest, or if it is not known.
  virtual std::optional<PanelLimit> limit() { return std::nullopt; }
  /// True if all planned motion is executed and the channel need not continue, because it waits at a meeting or nothing follows.
  virtual bool is_over() const = 0;
  /// True if the axes are at rest at present. Planned motion may follow.
  virtual bool stands() const = 0;
  /// Discards the finished legs (motions up to a stop), unless the control waits at a meeting. Call it when the motion of all channels is
  /// over.
  virtual void settle() = 0;
  /// Discards all planned motion of the channel. The axes stop at their current position.
  virtual void drop() = 0;
};

/// Makes the axes of a channel.
///   stand  their position at the start, in machine coordinates
using AxesMaker =
    std::function<std::unique_ptr<ChannelAxes>(int number, std::vector<std::string> names, const AxisRoles& roles, const Axes& stand)>;

}  // namespace kadr
