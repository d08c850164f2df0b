#pragma once
// BlockContext: the block that is being executed, the state of the control before the block, and the meaning of the block's words in this
// state. A function that only reads words, modes, tables or variables receives a BlockContext, through which it can neither emit an action
// nor change the program flow. Only src/control includes this file.

#include <initializer_list>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/units.h"
#include "control/block/shapes.h"
#include "control/control.h"
#include "control/dialect.h"
#include "control/flow/flow.h"
#include "control/state/control_state.h"
#include "control/state/journal.h"
#include "control/state/run_memory.h"
#include "control/state/usage.h"
#include "control/variables/macro_variables.h"
#include "control/variables/variables.h"

namespace kadr {

// Greatest coordinate, mm or degrees; a coordinate beyond ten kilometres is a mistake in the program.
inline constexpr double farthest = 1e7;

/// The block being executed and the modal state in which it is executed (`m.modal`, of the base class ControlState).
class BlockContext : public ControlState, public RunMemory {
 public:
  // ---- words of the block

  const Word* word(char letter) const { return block->find(letter); }
  bool has(char letter) const { return block->has(letter); }
  /// Returns the value of the word with this letter, multiplied by the scale of the address; 0 if the block has no such word.
  double value(char letter) const;
  /// Returns the value of the word with this letter as a length in mm.
  double length_value(char letter) const { return value(letter) * unit_scale(); }
  double unit_scale() const { return modal.inch ? mm_per_inch : 1.0; }
  /// Returns the value of the word with this letter as a whole number between `least` and `most`.
  ///   alarms  word_not_integer, value_out_of_range
  Result<std::uint32_t> whole(char letter, double least, double most) const;
  Span where(char letter) const;
  /// Returns true if the block has a code of one of these functions.
  bool has_code(std::initializer_list<Function> functions) const;
  /// Returns the facts that all blocks of the same shape share; nullptr if the block has no shape, or if words were removed from the block.
  ShapeFacts* shape() const { return block->altered ? nullptr : shape_; }
  /// Checks that every value is within the limits of its address.
  ///   alarms  value_out_of_range, word_not_integer
  Status check_ranges() const;
  bool has_axis_words() const { return (block->letters & letters.axes) != 0; }
  /// Rebuilds the set of addresses that the block has, after words were removed from the block (their address is 0) or restored.
  void note_addresses();

  // ---- coordinates that the words mean

  /// Computes the end point, in programmed coordinates, from the axis words. `named` receives the axes that have a word.
  Status target(Axes& to, AxisMask& named) const;
  /// Computes the end point by the tables of the control's file, without the rules of a dialect. target() computes the end point by the
  /// dialect's rules.
  Status axis_words(Axes& to, AxisMask& named) const;
  /// Returns the end coordinate that one axis word gives, in programmed coordinates.
  double axis_target(const Word& w, std::size_t axis) const;
  /// Checks that no coordinate of a point that a transformation has computed, in work coordinates, is beyond `farthest`.
  ///   alarms  position_out_of_range
  Status within_reach(const Axes& work) const;
  double radius_in_force() const;
  /// Returns the row of the tool offset table whose length compensation is in force; 0 if no length compensation is in force.
  std::uint16_t length_row() const;
  ArcRule arc_rule() const { return dialect->arc_rule(*this); }
  ArcRule plain_arc_rule() const;
  double feed_limited(double feed) const;
  double feed_by_axes(const Motion& motion) const;
  bool axes_have_feeds() const;
  /// Returns the axis that the feed in the block's word number `index` belongs to. A word F between two axis words is the feed of the axis
  /// before the F. Any other F is the feed of all axes that have no feed of their own; then the result is nullopt. Used only if
  /// Behaviour::feed_of_axis is set (GOST 20999-83).
  std::optional<std::size_t> axis_of_feed(std::uint32_t index) const;
  /// Returns the part of the origin by which G92, and codes that act like G92, shift the work system. The part is read from the
  /// interpreter's own tables.
  Axes shift_by_tables() const;
  /// Returns the speed of the main spindle as G96 and G97 define it (nct 11.5). On controls other than the NCT the X coordinate counts as a
  /// radius (spec/gost 4; INFERRED: X).
  SurfaceSpeed surface_speed() const;
  SurfaceSpeed speed_by_x() const;
  FrameChange frame_change() const;

  /// Returns the state before the block. The state is valid only if keeps_state() is true, that is, if the state was saved so that an alarm
  /// can restore it.
  const ControlState& state_before() const { return before_; }
  bool keeps_state() const { return state_saved_; }
  bool keeps_flow_place() const { return flow_before_.has_value(); }
  /// Returns which parts of the state a block with this plan may change. Only the plan decides here; a dialect may override the decision.
  BlockChanges changes_of_block(const Plan& plan) const;

  // ---- program flow

  /// Returns the program flow (files, open calls, limits of the run) for reading. Only the Interpreter changes it.
  const Flow& program() const { return flow; }

  // ---- tables that the words refer to

  const std::unique_ptr<ControlDef> own_def;
  const ControlDef& def;
  const LetterSets letters;
  Journal journal;
  Tables tables;
  Variables variables;
  std::unique_ptr<Dialect> dialect = make_iso_dialect();  // never nullptr
  MacroVariables* macro_variables = nullptr;  // the dialect's variables if they have levels of local variables; nullptr on other controls
  std::vector<std::string> axis_names;
  std::size_t axis_count = 3;
  bool has_fixtures = false;  // true: the number of the work system is in Modal::fixture; false: it is in Modal::work_zero
  bool probe_stated = false;  // the set-up defines which surfaces a probe touches
  SetupFault start_fault;     // the set-up names an axis or table row that this control lacks. The fault is reported when the run starts.

  // ---- the current block

  Block* block = nullptr;         // the block being executed; never nullptr
  bool block_axes_taken = false;  // A code (G28, G92 …) uses the block's axis words, so a motion code in the block only sets the mode
  bool block_exact = false;       // the block has G9
  bool block_machine_coordinates = false;  // the block has G53 and a motion (Mach3), so its axis words are machine coordinates
  bool needs_probe = false;
  Span probe_where;
  /// A block of the program with its text.
  struct BlockPlace {
    Origin origin;
    std::string text;
  };
  // The block that the alarm of the current block is about, if it is another one: a block of the figure that a turning cycle has read.
  std::optional<BlockPlace> fault_place;

 protected:
  BlockContext(const ControlDef& control, std::unique_ptr<ControlDef> own, Program program, const RunLimits& limits)
      : own_def(std::move(own)),
        def(own_def ? *own_def : control),
        letters(def),
        variables(def, journal),
        flow(def, std::move(program), limits) {}
  ~BlockContext() = default;

  Flow flow;
  ControlState before_;
  bool state_saved_ = false;
  // The state of the program flow before the block. It is set if a function of the block changes the flow while the block may still fail,
  // and is restored if the block fails.
  std::optional<Flow::Place> flow_before_;
  ShapeFacts* shape_ = nullptr;  // facts about the shape of the current block; nullptr if the block has no shape
};

}  // namespace kadr
