#pragma once
// FlatProgram: what a control does, action by action, as blocks of another one: without calls, loops, cycles and variables. It says what it
// can and nothing else; whether that is the same, the proof says (convert/conversion).

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

/// How the path is said.
enum class FlatWay : std::uint8_t {
  contours,  // as programmed: radius compensation, tool lengths and work zeros as codes of their own
  lengths,   // radius compensation is calculated in; tool lengths and work zeros are codes
  plain,     // all of it is calculated in: machine coordinates
  places,    // as contours, between blocks that are said otherwise and have put shifts in force: coordinates as programmed
  centres,   // as places, radius compensation calculated in
};

/// What of the tables is in force.
struct OffsetsInForce {
  std::int8_t length_sign = 0;      // +1, -1; 0: none
  std::uint32_t length_number = 0;  // H, or what stands for it
  std::uint32_t radius_number = 0;  // D
  friend bool operator==(const OffsetsInForce&, const OffsetsInForce&) = default;
};

/// Modes that blocks which are said otherwise have put in force.
struct FlatBefore {
  bool incremental = false, inch = false;
  bool exact = false;  // exact stop mode
  CornerSpeed corners = CornerSpeed::limited;
};

/// What is known of the program that is converted.
struct FlatSource {
  std::vector<std::string> axes;  // names
  std::map<int, Axes> zeros;      // of its set-up, by number of the work system
  bool has_systems = true;        // its control has work systems at all
  bool same_messages = true;      // the other control shows messages in the same way: they cannot be said by codes; else they are comments
  std::map<std::uint32_t, std::uint32_t> machine_codes{};  // M functions that are others there, by the tables of both controls
  std::array<std::optional<std::uint32_t>, 3> coolants{};  // M codes there that switch it, where the tables say so
  std::vector<std::string> systems{};                      // of the other control, by number: "G54", "G54.1 P1"
};

class FlatProgram {
 public:
  FlatProgram(BlockMaker& blocks, FlatSource source, FlatWay way)
      : blocks_(blocks), source_(std::move(source)), axes_(source_.axes), way_(way), modes_(path_modes_of(blocks.def())) {}

  /// Where the axes stand at the beginning, and the zero in force.
  Status begin(const ToolPosition& stand, const Placement& placement);
  ///   alarms  function_has_no_code  the control has nothing that does it
  ///           word_has_no_room
  Status take(const Action& action, const OffsetsInForce& now);
  /// What was said in a block is over: the next one begins.
  Status end_block();
  Status finish();

  /// An action that is said otherwise: how things stand behind it.
  void pass(const Action& action);
  /// Blocks begin behind some that were said otherwise.
  ///   before, now  what those have put in force
  Status open(const FlatBefore& before, const OffsetsInForce& now);
  /// From here on the work system is said by these blocks, no more by others.
  void system_changes() { system_is_said_ = false; }
  /// … and end before such, which take for granted what the program has put in force by then.
  Status close(const FlatBefore& after);
  /// Motions behind a probe motion may be said: whoever asks looks whether their figures depend on it.
  void allow_after_probe() { after_probe_allowed_ = true; }
  bool has_probed() const { return has_probed_; }
  /// The one work system that all motions to work coordinates count from; nullopt: there are several, or none is said.
  std::optional<std::uint16_t> counts_from() const { return counts_from_several_ ? std::nullopt : counts_from_; }
  /// Motions that have been said.
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
  /// Machine coordinates of the zero that the target counts from.
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
  std::optional<FeedUnit> unit_;                 // that is said
  FeedUnit source_unit_ = FeedUnit::mm_per_min;  // of the program
  double feed_ = -1;
  int plane_ = 17;
  std::uint16_t system_ = 0;
  std::int8_t side_ = 0;
  OffsetsInForce said_;
  std::uint32_t selected_ = 0;
  std::size_t motions_ = 0;
  std::optional<std::uint16_t> counts_from_;
  bool counts_from_several_ = false;
  Axes said_origin_{};  // of the work system, with the shifts that the other blocks have put in force
  bool after_probe_allowed_ = false;
  bool has_probed_ = false;  // what follows may depend on what was touched: figures of this run would not
  bool system_is_said_ = true;
  bool relative_ = false;  // increments are programmed
  double rpm_ = -1;
  SpindleDir turns_ = SpindleDir::stop;
  Coolant coolant_ = Coolant::off;
  double said_length_ = 0;  // mm, by word
  bool surface_ = false, has_acts_ = false;
  bool is_exact_ = false;  // exact stop mode
  double tolerance_ = 0;   // mm that corners may be rounded by
  CornerSpeed corners_ = CornerSpeed::limited;
  std::uint8_t smoothing_ = 0, smoothing_before_ = 0;  // Q of G5.1; in the blocks that are said otherwise
  bool wants_direction_ = false;                       // S stands in the block, and M3 or M4 must beside it
};

}  // namespace kadr
