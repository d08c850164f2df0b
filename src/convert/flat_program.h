#pragma once
// FlatProgram: writes what a control does, action by action, as flat blocks of another one: without calls, loops, canned cycles and
// variables. It writes what that control can express and nothing else; the proof checks that both do the same (convert/conversion).

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "action/action.h"
#include "action/tool_position.h"
#include "compare/path_modes.h"
#include "convert/block_maker.h"

namespace kadr {

/// How the path is expressed.
enum class FlatWay : std::uint8_t {
  contours,  // as programmed: radius compensation, tool lengths and work offsets as codes of their own
  lengths,   // radius compensation is applied to the coordinates; tool lengths and work offsets are codes
  plain,     // all offsets are applied: machine coordinates
  places,    // as contours, between rewritten blocks that have put shifts in force: coordinates as programmed
  centres,   // as places, with radius compensation applied to the coordinates
};

/// The offsets of the tables that are in force.
struct OffsetsInForce {
  std::int8_t length_sign = 0;      // +1, -1; 0: none
  std::uint32_t length_number = 0;  // H, or the word that the control has for it
  std::uint32_t radius_number = 0;  // D
  friend bool operator==(const OffsetsInForce&, const OffsetsInForce&) = default;
};

/// Modes that the rewritten blocks before have put in force.
struct FlatBefore {
  bool incremental = false, inch = false;
  bool exact = false;  // exact stop mode
  CornerSpeed corners = CornerSpeed::limited;
};

/// What is known of the program that is converted.
struct FlatSource {
  std::vector<std::string> axes;  // names
  std::map<int, Axes> zeros;      // of its set-up, by number of the work system
  bool has_systems = true;        // its control has work systems
  bool same_messages = true;  // the other control shows messages in the same way, for which no code exists; false: messages become comments
  std::map<std::uint32_t, std::uint32_t> machine_codes{};  // M functions with another number there, by the tables of both controls
  std::array<std::optional<std::uint32_t>, 3> coolants{};  // the M codes that switch the coolant there, if the tables state them
  std::vector<std::string> systems{};                      // of the other control, by number: "G54", "G54.1 P1"
};

class FlatProgram {
 public:
  FlatProgram(BlockMaker& blocks, FlatSource source, FlatWay way)
      : blocks_(blocks), source_(std::move(source)), axes_(source_.axes), way_(way), modes_(path_modes_of(blocks.def())) {}

  ///   stand  where the axes are at the beginning; `placement` has the work offset in force
  Status begin(const ToolPosition& stand, const Placement& placement);
  /// Writes an action.
  ///   alarms  function_has_no_code  the control has no code for it
  ///           word_has_no_room
  Status take(const Action& action, const OffsetsInForce& now);
  /// Ends what was written for one block of the source; the next one begins.
  Status end_block();
  Status finish();

  /// Records an action that is written by other blocks: only follows the state after it.
  void pass(const Action& action);
  /// Begins flat blocks after rewritten ones.
  ///   before, now  what those have put in force
  Status open(const FlatBefore& before, const OffsetsInForce& now);
  /// From here on these blocks, and no others, select the work system.
  void system_changes() { system_is_said_ = false; }
  /// Ends flat blocks before rewritten ones, which rely on what the program has put in force by then.
  Status close(const FlatBefore& after);
  /// Allows motions after a probe motion: the caller checks whether their figures depend on the probing.
  void allow_after_probe() { after_probe_allowed_ = true; }
  bool has_probed() const { return has_probed_; }
  /// Returns the one work system that all motions to work coordinates refer to; nullopt if there are several or none.
  std::optional<std::uint16_t> counts_from() const { return counts_from_several_ ? std::nullopt : counts_from_; }
  /// Number of motions written so far.
  std::size_t motions() const { return motions_; }

 private:
  static Status no_code(const char* what);
  Status motion(const Motion& motion, const OffsetsInForce& now);
  Status said_before(const Motion& motion, const OffsetsInForce& now);
  Status said_with(const Motion& motion, const OffsetsInForce& now);
  Status straight(Function function, const Motion& motion);
  Status axis_words(const Motion& motion);
  Status arc(const Motion& motion);
  struct Arms {
    double begin = 0, end = 0;  // radii, mm
  };
  bool is_spiral(const Arms& arms) const;
  Status spiral(const Motion& motion, Vec2 centre, const Arms& arms);
  Status one_arc(Function function, const Motion& motion, Vec2 centre, const Axes& to, int turns);
  bool is_said_by_lead(const Motion& motion, int turns) const;
  double rise_of(std::size_t axis, const Axes& to) const;
  bool has_no_zeroless_system() const;
  bool is_in_machine(const Motion& motion) const;
  bool cuts_in_machine() const;
  Status machine_motion(Function function, const Motion& motion);
  bool is_without_zero(const Motion& motion) const;
  Status motion_without_zero(Function function, const Motion& motion);
  bool is_by_reference(const Motion& motion) const;
  Status reference_motion(const Motion& motion);
  void note_system(const Motion& motion);
  Status motion_code(Function function);
  Status feed(const Motion& motion);
  Status feed_unit(FeedUnit unit);
  bool has_stop_modes() const;
  Status stop_mode(bool exact);
  Status end_of_motion(bool exact);
  Status rounding(const Motion& motion);
  Status corners(const Motion& motion);
  Status corner_mode(CornerSpeed corners);
  Status smoothing(const Motion& motion);
  Status smoothing_mode(std::uint8_t smoothing);
  Status spindle(const Spindle& spindle);
  Status spindle_on();
  Status speed(const Speed& speed);
  Status tool(std::uint32_t number, std::uint32_t corrector, bool change);
  Status tool_by_hand(std::uint32_t number);
  Status coolant(Coolant what);
  bool is_length_by_word() const;
  Status length_by_word(const OffsetsInForce& now);
  Status dwell(double seconds);
  Status stop(const Stop& stop);
  Status message(const Message& message);
  Status machine_code(std::uint32_t code);
  std::optional<char> letter_of(std::size_t axis) const;

  Axes said_place(const Axes& zero) const;
  double word_of(std::size_t axis, double to, double zero) const { return relative_ ? to - at_[axis] : to - zero; }
  bool is_by_codes() const { return way_ == FlatWay::contours || way_ == FlatWay::places; }
  bool is_between() const { return way_ == FlatWay::places || way_ == FlatWay::centres; }
  /// Machine coordinates of the origin that the target's words refer to.
  Axes base() const;

  BlockMaker& blocks_;
  const FlatSource source_;
  const std::vector<std::string>& axes_;
  const FlatWay way_;
  const PathModes modes_;  // of the other control

  Axes at_{};  // machine coordinates
  Placement placement_;
  AxisMask known_ = 0;
  Function code_ = Function::count;
  std::optional<FeedUnit> unit_;                 // the unit in force in the text
  FeedUnit source_unit_ = FeedUnit::mm_per_min;  // the program's unit
  double feed_ = -1;
  int plane_ = 17;
  std::uint16_t system_ = 0;
  std::int8_t side_ = 0;
  OffsetsInForce said_;
  std::uint32_t selected_ = 0;
  std::size_t motions_ = 0;
  std::optional<std::uint16_t> counts_from_;
  bool counts_from_several_ = false;
  Axes said_origin_{};  // origin of the work system, with the shifts that the rewritten blocks have put in force
  bool after_probe_allowed_ = false;
  bool has_probed_ = false;  // what follows may depend on what was touched, so figures of this run would be wrong
  bool system_is_said_ = true;
  bool relative_ = false;  // incremental programming is in force
  double rpm_ = -1;
  SpindleDir turns_ = SpindleDir::stop;
  Coolant coolant_ = Coolant::off;
  double said_length_ = 0;  // mm, on a control with the length as a word
  bool surface_ = false, has_acts_ = false;
  bool is_exact_ = false;  // exact stop mode
  double tolerance_ = 0;   // mm by which corners may be rounded
  CornerSpeed corners_ = CornerSpeed::limited;
  std::uint8_t smoothing_ = 0, smoothing_before_ = 0;  // Q of G5.1; its value in the rewritten blocks
  bool wants_direction_ = false;                       // the block has an S, so it needs M3 or M4 too
};

}  // namespace kadr
