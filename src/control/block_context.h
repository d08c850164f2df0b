#pragma once
// BlockContext: the block that is being executed, the state that it meets, and what its words mean there. A function that reads words,
// modes, tables or variables takes one; it can neither emit an action nor change where the program goes on. Only src/control includes it.

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
#include "control/state/journal.h"
#include "control/state/run_memory.h"
#include "control/state/state.h"
#include "control/state/usage.h"
#include "control/variables/macro_variables.h"
#include "control/variables/variables.h"

namespace kadr {

inline constexpr double farthest = 1e7;  // mm, degrees: a coordinate beyond ten kilometres is a mistake

/// The state is its base: `m.modal` is that of the block being executed.
class BlockContext : public ControlState, public RunMemory {
 public:
  // ---- words of the block

  const Word* word(char letter) const { return block->find(letter); }
  bool has(char letter) const { return block->has(letter); }
  /// Value of a word with the scale of its address; 0 if it is not there.
  double value(char letter) const;
  /// The same as a length: mm.
  double length_value(char letter) const { return value(letter) * unit_scale(); }
  double unit_scale() const { return modal.inch ? mm_per_inch : 1.0; }
  /// A whole number between the two.
  ///   alarms  word_not_integer, value_out_of_range
  Result<std::uint32_t> whole(char letter, double least, double most) const;
  Span where(char letter) const;
  /// The block holds a code of one of these functions.
  bool has_code(std::initializer_list<Function> functions) const;
  /// What is known of blocks like this one; nullptr: it is no plain block, or words were taken away from it.
  ShapeFacts* shape() const { return block->altered ? nullptr : shape_; }
  /// Every value within the limits of its address.
  ///   alarms  value_out_of_range, word_not_integer
  Status check_ranges() const;
  bool has_axis_words() const { return (block->letters & letters.axes) != 0; }
  /// Collects the addresses of the block again, after words were taken away (address 0) or given back.
  void note_addresses();

  // ---- coordinates that the words mean

  /// End point by the block's axis words, programmed coordinates; `named`: axes that have a word.
  Status target(Axes& to, AxisMask& named) const;
  /// The same by the file's tables alone: a dialect may say otherwise.
  Status axis_words(Axes& to, AxisMask& named) const;
  /// One axis word as a programmed end coordinate.
  double axis_target(const Word& w, std::size_t axis) const;
  /// A point that a transformation has led to. alarms position_out_of_range
  Status within_reach(const Axes& work) const;
  double radius_in_force() const;
  /// The row of the offset table whose length is in force; 0: none.
  std::uint16_t length_row() const;
  ArcRule arc_rule() const { return dialect->arc_rule(*this); }
  ArcRule plain_arc_rule() const;
  double feed_limited(double feed) const;
  double feed_by_axes(const Motion& motion) const;
  bool axes_have_feeds() const;
  /// The axis that the block's word `index`, an F, belongs to: that of the axis word before it, where another axis word follows; else F
  /// is for all axes that have none of their own. Only where Behaviour::feed_of_axis is set (GOST 20999-83).
  std::optional<std::size_t> axis_of_feed(std::uint32_t index) const;
  /// What of their origin is a shift of the work system: G92 and what acts like it.
  Axes shift_by_tables() const;
  /// What G96, G97 make of the speed of the main spindle (nct 11.5); of controls but NCT by X as a radius (spec/gost 4; INFERRED: X).
  SurfaceSpeed surface_speed() const;
  SurfaceSpeed speed_by_x() const;
  FrameChange frame_change() const;

  /// The state as the block found it, where it is kept for an alarm.
  const ControlState& state_before() const { return before_; }
  bool keeps_state() const { return state_kept_; }
  bool keeps_flow_place() const { return flow_before_.has_value(); }
  /// What a block may change by its plan alone: a dialect may know better.
  BlockChanges changes_of_block(const Plan& plan) const;

  // ---- where the program is

  /// Files, calls that are open, limits of the run: to be read. Only the Interpreter changes where the program goes on.
  const Flow& program() const { return flow; }

  // ---- what the words are looked up in

  const std::unique_ptr<ControlDef> own_def;
  const ControlDef& def;
  const LetterSets letters;
  Journal journal;
  Tables tables;
  Variables variables;
  std::unique_ptr<Dialect> dialect = make_iso_dialect();  // never nullptr
  MacroVariables* macro_variables = nullptr;              // those of the dialect, where it has levels of locals
  std::vector<std::string> axis_names;
  std::size_t axis_count = 3;
  bool has_fixtures = false;  // its work systems are Modal::fixture, else Modal::work_zero
  bool probe_stated = false;  // the set-up says what a probe meets
  SetupFault start_fault;     // what the set-up names and the control has not

  // ---- of the block

  Block* block = nullptr;                  // being executed, never nullptr
  bool block_axes_taken = false;           // a code of this block has its axis words: a motion code in it only sets the mode
  bool block_exact = false;                // G9 in this block
  bool block_machine_coordinates = false;  // G53 with a motion (Mach3)
  bool needs_probe = false;
  Span probe_where;

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
  bool state_kept_ = false;
  std::optional<Flow::Place> flow_before_;  // where the program was, where a block has more than one item that jumps
  ShapeFacts* shape_ = nullptr;             // of the current block
};

}  // namespace kadr
