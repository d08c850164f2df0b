#pragma once
// FlatProgram: writes the actions of a run of the source program as flat blocks of the target control: single motions and codes, without
// calls, loops, canned cycles and variables. The class does not check the result; the proof (convert/conversion) checks that both programs
// do the same.

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "action/action.h"
#include "action/tool_position.h"
#include "compare/path_modes.h"
#include "convert/block_maker.h"
#include "convert/flat/flat_writer.h"

namespace kadr {

/// The form in which flat blocks express the path.
enum class FlatForm : std::uint8_t {
  contours,  // the path as programmed: cutter compensation, tool lengths and work offsets are written as codes
  lengths,   // cutter compensation is applied to the coordinates; tool lengths and work offsets are written as codes
  plain,     // all offsets are applied to the coordinates: the words are machine coordinates
  places,    // the path as programmed (like `contours`), in ranges between rewritten blocks, which may have put shifts in force
  centres,   // ranges between rewritten blocks (like `places`), with cutter compensation applied to the coordinates
};

/// The rows of the offset tables that are in force.
struct OffsetsInForce {
  std::int8_t length_sign = 0;      // sense of the length compensation: +1 (G43), -1 (G44); 0: none
  std::uint32_t length_number = 0;  // number of the length offset: the number after H, or after the word that the control uses for it
  std::uint32_t radius_number = 0;  // number of the radius offset: the number after D
  friend bool operator==(const OffsetsInForce&, const OffsetsInForce&) = default;
};

/// The modes that the preceding rewritten blocks have put in force.
struct FlatBefore {
  bool incremental = false, inch = false;
  bool exact = false;  // exact stop mode is in force
  CornerSpeed corners = CornerSpeed::limited;
};

/// Properties of the source program that its actions do not state.
struct FlatSource {
  std::vector<std::string> axes;  // axis names
  std::map<int, Axes> zeros;      // work offsets of the set-up, mm, by number of the work system
  bool has_systems = true;        // true: the source control has work systems (G54 …)
  bool same_messages = true;      // true: both controls display messages in the same way, without a code; false: messages become comments
  // Number of each M function on the target control, by number on the source control, if the tables of both controls state another number.
  std::map<std::uint32_t, std::uint32_t> machine_codes{};
  // M codes of the target control for coolant off, mist and flood, by value of Coolant, if the tables state them
  std::array<std::optional<std::uint32_t>, 3> coolants{};
  // Codes of the target control that select a work system, by number of the work system: "G54", "G54.1 P1"
  std::vector<std::string> systems{};
  bool turns = false;  // one of the two controls is that of a lathe: the target text begins in the plane of X and Z
  // code of the target control for the lengths of a turning tool; nullptr: it has the same code for all tools, or T is the code
  const CodeRow* turning_length = nullptr;
  bool same_threads = false;  // both controls measure the lead of a taper thread along the same axis
  bool diameters = false;     // X words of the target text are diameters
};

class FlatProgram final : public FlatWriter {
 public:
  FlatProgram(BlockMaker& blocks, FlatSource source, FlatForm form)
      : blocks_(blocks), source_(std::move(source)), axes_(source_.axes), form_(form), modes_(path_modes_of(blocks.def())) {}

  ///   stand  position of the axes at the beginning; `placement` contains the work offset in force
  Status begin(const ToolPosition& stand, const Placement& placement) override;
  /// Writes one action of the run.
  ///   alarms  function_has_no_code  the target control has no code for the action
  ///           word_has_no_room
  Status take(const Action& action, const OffsetsInForce& now) override;
  /// Writes the T word of a lathe if the source block that has just been executed has put other offsets into force, without an action.
  Status note_offsets(const OffsetsInForce& now) override;
  /// Ends the flat blocks that together express one block of the source program.
  Status end_block() override;
  Status finish() override;

  /// Tracks the state after an action without writing it. The caller must call this function for an action that other blocks express.
  void pass(const Action& action);
  /// Begins flat blocks after rewritten blocks.
  ///   before, now  modes and offsets that the rewritten blocks have put in force
  Status open(const FlatBefore& before, const OffsetsInForce& now);
  /// Makes the flat blocks write the code of the work system again: from here on, only they, and no rewritten blocks, select it.
  void system_changes() { system_is_written_ = false; }
  /// Ends flat blocks. Restores the modes that the source program has in force here, because the rewritten blocks that follow rely on them.
  Status close(const FlatBefore& after);
  /// Allows motions after a probe motion. The caller must check whether the coordinates of these motions depend on what the probe touched.
  void allow_after_probe() { after_probe_allowed_ = true; }
  bool has_probed() const { return has_probed_; }
  /// Returns the number of the work system that all motions in work coordinates use; nullopt if they use several, or none.
  std::optional<std::uint16_t> counts_from() const override { return counts_from_several_ ? std::nullopt : counts_from_; }
  /// Returns the number of motions written so far.
  std::size_t motions() const { return motions_; }

 private:
  static Status no_code(const char* what);
  Status motion(const Motion& motion, const OffsetsInForce& now);
  Status write_before_motion(const Motion& motion, const OffsetsInForce& now);
  Status write_with_motion(const Motion& motion, const OffsetsInForce& now);
  Status straight(Function function, const Motion& motion);
  Status begin_turning();
  Status axis_words(const Motion& motion);
  Status axis_word(std::size_t axis, double value);
  double factor_of(std::size_t axis) const { return source_.diameters && axes_[axis] == "X" ? 2 : 1; }
  double rounded(std::size_t axis, double value) const;
  Status arc(const Motion& motion);
  struct Arms {
    double begin = 0, end = 0;  // radii of a spiral at its beginning and its end, mm
  };
  bool is_spiral(const Arms& arms) const;
  Status spiral(const Motion& motion, Vec2 centre, const Arms& arms);
  Status one_arc(Function function, const Motion& motion, Vec2 centre, const Axes& to, int turns);
  bool is_written_by_lead(const Motion& motion, int turns) const;
  double rise_of(std::size_t axis, const Axes& to) const;
  bool has_no_zeroless_system() const;
  bool is_in_machine(const Motion& motion) const;
  bool cuts_in_machine() const;
  Status machine_motion(Function function, const Motion& motion);
  bool is_without_zero(const Motion& motion) const;
  Status motion_without_zero(Function function, const Motion& motion);
  bool is_by_reference(const Motion& motion) const;
  Status reference_motion(const Motion& motion);
  Status increments_of_zero(const Motion& motion);
  Status thread(const Motion& motion);
  bool has_turret() const { return blocks_.def().behaviour.lathe != Lathe::none; }
  Status turret(std::uint32_t number, const OffsetsInForce& now);
  Status turret_offset(const OffsetsInForce& now);
  Status turning_length(const OffsetsInForce& now);
  bool hold(const Motion& motion, const OffsetsInForce& now);
  Status write_held(const Action* next = nullptr);
  Status side_of_turret(const OffsetsInForce& now) const;
  Status surface_limit(const SurfaceSpeed& law);
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
  Status constant_speed();
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

  Axes written_position(const Axes& zero) const;
  double word_of(std::size_t axis, double to, double zero) const { return relative_ ? to - at_[axis] : to - zero; }
  bool is_by_codes() const { return form_ == FlatForm::contours || form_ == FlatForm::places; }
  bool is_between() const { return form_ == FlatForm::places || form_ == FlatForm::centres; }
  /// Returns the origin, in machine coordinates, from which the words of the target text count.
  Axes base() const;

  BlockMaker& blocks_;
  const FlatSource source_;
  const std::vector<std::string>& axes_;
  const FlatForm form_;
  const PathModes modes_;  // path modes of the target control

  Axes at_{};  // position of the axes in machine coordinates
  Placement placement_;
  AxisMask known_ = 0;
  Function code_ = Function::count;
  std::optional<FeedUnit> unit_;                 // feed unit in force in the target text
  FeedUnit source_unit_ = FeedUnit::mm_per_min;  // feed unit in force in the source program
  double feed_ = -1;
  int plane_ = 17;
  std::uint16_t system_ = 0;
  std::int8_t side_ = 0;
  OffsetsInForce written_offsets_;
  std::uint32_t selected_ = 0;
  std::size_t motions_ = 0;
  std::optional<std::uint16_t> counts_from_;
  bool counts_from_several_ = false;
  Axes written_origin_{};  // origin of the work system in the target text, including the shifts that rewritten blocks have put in force
  bool after_probe_allowed_ = false;
  bool has_probed_ = false;  // a probe motion was written, so later coordinates may depend on what the probe touched in this run
  bool system_is_written_ = true;
  bool relative_ = false;  // incremental programming is in force in the target text
  double rpm_ = -1;
  SpindleDir turns_ = SpindleDir::stop;
  Coolant coolant_ = Coolant::off;
  double written_length_ = 0;  // tool length written last, mm; only for a control whose length code states the length itself
  bool surface_ = false, has_acts_ = false;
  bool is_exact_ = false;  // exact stop mode is in force in the target text
  double tolerance_ = 0;   // greatest rounding of corners, mm (G64 P)
  CornerSpeed corners_ = CornerSpeed::limited;
  // word Q of G5.1 (smoothing): smoothing_ in the flat blocks, smoothing_before_ in the rewritten blocks before them
  std::uint8_t smoothing_ = 0, smoothing_before_ = 0;
  // T word of a lathe, which belongs to the block of the next motion, or to a block of its own if the source block moves no axis
  std::string turret_word_;
  // A motion to where the axes are already, and the offsets in force in its block. The next action decides whether it is written.
  std::optional<Motion> held_;
  OffsetsInForce held_offsets_;
  double written_most_rpm_ = 0;   // highest spindle speed with constant surface speed in the target text, rev/min; 0: no limit
  bool wants_direction_ = false;  // the block has an S word, so it also needs M3 or M4
};

}  // namespace kadr
