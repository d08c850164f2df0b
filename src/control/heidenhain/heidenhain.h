#pragma once
// Heidenhain: the dialect of HEIDENHAIN controls that read conversational blocks (spec/heidenhain): iTNC 530, TNC 640, 620, 320. A straight
// line with plain numbers comes as words (lang/klartext); every other block is compiled once and executed here. Only
// src/control/heidenhain includes this file.

#include <memory>
#include <optional>
#include <set>
#include <string>
#include <unordered_map>
#include <vector>

#include "control/block/arc.h"
#include "control/dialect.h"
#include "control/heidenhain/loop_lines.h"
#include "control/heidenhain/memory.h"
#include "control/heidenhain/program_index.h"
#include "control/interpreter.h"
#include "kinematics/five_axis.h"
#include "lang/klartext/klartext_block.h"

namespace kadr::heidenhain {

/// Greatest difference of the radii at the start and the end of a circle, mm (spec/heidenhain 4.1).
inline constexpr double circle_deviation = 0.016;

inline Vec2 in_plane(const Axes& point, PlaneAxes p) { return {point[p.first], point[p.second]}; }
inline AxisMask mask_of(PlaneAxes p) { return AxisMask{1} << p.first | AxisMask{1} << p.second; }

/// A value that a block has replaced, for the case that the block fails.
struct WrittenValue {
  ParameterFamily family = ParameterFamily::q;
  std::uint16_t index = 0;
  double value = 0;
};

class Heidenhain final : public Dialect {
 public:
  Heidenhain(const Setup& setup, const RunLimits& limits);

  // ---- program
  std::shared_ptr<const DialectState> snapshot() const override;
  Status restore(BlockContext& m, const DialectState& from) override;
  void take_setup(Emitter& m, const Setup& setup) override;
  bool end_program(Interpreter& m) override;
  bool reads_outlines() const override { return true; }
  Result<bool> end_of_file(BlockContext& m) override;

  // ---- blocks
  bool has_unfinished() const override { return loops_ || !memory.calls.empty() || memory.probing; }
  Result<bool> finish(Interpreter& m) override;
  Result<bool> statement(Interpreter&) override { return false; }
  Result<bool> takes_block(Interpreter& m) override;
  BlockChanges changes_of(const BlockContext& m, const Plan& plan) const override;
  void after_code(Interpreter& m, const CodeRow& row, std::int32_t code) override;
  void undo_block(BlockContext& m) override;
  bool skips_unread() const override { return true; }

  // ---- motion, frames, variables
  void note_motion(Emitter& m, Motion& motion) override;
  bool lines_follow(const BlockContext& m) const override { return !needs_text(m); }
  void note_line(BlockContext& m) override;
  AxisMask rolling_axes(const BlockContext& m) const override;
  void refresh_frames(Emitter& m) override;
  std::map<std::string, AxisValues> programming_frame(const BlockContext& m) const override;
  Status accept_answer(Emitter& m, const ProbeAnswer& answer) override;
  void add_variables(Emitter& m, FinalState& ending, const std::vector<std::string>& watch) override;

  // ---- used by the parts in this folder
  Memory memory;
  FiveAxis five_axis;              // the rotary axes of the machine, if the set-up or the machine names them
  Axes most{};                     // upper ends of travel of the set-up, machine coordinates
  std::string assumed_axes;        // axes that only the program names, for the note at the first block; empty: noted, or none
  std::uint64_t missing_axes = 0;  // letters of axes that the machine does not have
  double corner_rounding = 0, corner_chamfer = 0;  // RND, CHF behind the block, mm
  double corner_feed = 0;                          // F of RND, CHF, mm/min; 0: that of the element
  CornerJoin corner = CornerJoin::arc;             // M97 in the block

  // evaluate.cpp
  Result<double> evaluate(BlockContext& m, const KlartextBlock& block, KlartextExpression expression);
  Result<double> value(BlockContext& m, const KlartextBlock& block, const KlartextWord& word) {
    return word.value ? evaluate(m, block, word.value) : Result<double>(word.number);
  }
  Status set_parameter(const KlartextStep& to, double value);
  Result<std::string> text_value(BlockContext& m, const KlartextBlock& block);
  // system_values.cpp
  Result<double> parameter(const BlockContext& m, ParameterFamily family, std::uint16_t index, Span where) const;
  Result<double> system_value(BlockContext& m, double id, double number, double index, Span where) const;
  double tool_radius(const BlockContext& m) const;
  /// Returns the radius that a milling cycle needs, mm, and notes for `kadr setup` that it is needed.
  ///   alarms  cycle_tool_radius
  Result<double> cutter_radius(BlockContext& m, Span where) const;
  double tool_length(const BlockContext& m) const;
  /// Returns the feed per revolution of a feed per tooth.
  ///   alarms  not_available: the tool table does not have the number of teeth
  Result<double> feed_per_turn(const BlockContext& m, double per_tooth, Span where) const;
  // flow.cpp
  const ProgramIndex& index(const BlockContext& m, std::uint16_t reader);
  const ProgramIndex& index(const BlockContext& m) { return index(m, m.program().reader()); }
  Status call_label(Interpreter& m, const KlartextBlock& block);
  /// Calls the subprogram at a label, whose name is written as the index has it.
  ///   alarms  label_missing, label_twice, call_too_deep
  Status call_subprogram(Interpreter& m, const std::string& name, Span where);
  Status jump(Interpreter& m, const KlartextBlock& block);
  Status call_program(Interpreter& m, const std::string& path, Span where);
  Status leave(Interpreter& m, Span where);
  Result<std::string> read_table(const BlockContext& m, const std::string& path, Span where) const;
  Status end_of_program(Interpreter& m, Span where);
  // tools.cpp
  Status tool_call(Interpreter& m, const KlartextBlock& block);
  Status tool_definition(Interpreter& m, const KlartextBlock& block);
  bool knows_tool(const BlockContext& m, std::uint32_t tool) const;
  /// Notes G0 or G1 as the code in force, as a line of plain words does that the table executes.
  static void note_straight(BlockContext& m, bool rapid);
  // frames.cpp
  Status set_frame(Emitter& m);
  Status shift_datum(Emitter& m, const KlartextBlock& block);
  Status frame_cycle(Interpreter& m, const KlartextBlock& block);
  void reset_frames();
  // tilting.cpp
  Status plane(Interpreter& m, const KlartextBlock& block);
  Status set_axis_angles(BlockContext& m, const Mat3& to, const KlartextBlock& block);
  Status turn_axes(Interpreter& m, const KlartextBlock& block);
  Status retract_first(Interpreter& m, const KlartextBlock& block);
  Status take_axis_positions(BlockContext& m, const KlartextBlock& block, Mat3& to);
  void note_axis_angles(const BlockContext& m, RotaryPair pair);
  RotaryPair rotary_now(const BlockContext& m) const;
  Status tilt(Emitter& m, const Mat3& to);
  void untilt(Emitter& m);
  void place_in_space(Emitter& m);
  // cycles.cpp
  Status define_cycle(Interpreter& m, const KlartextBlock& block);
  Status call_cycle(Interpreter& m, Span where, double raised = 0);
  Status take_parameters(BlockContext& m, const KlartextBlock& block);
  // contour_cycles.cpp
  /// Returns true for the cycles 21 to 25, which work on the contours of cycle 14 (spec/heidenhain 12.12).
  static bool is_contour_cycle(int cycle) { return cycle >= 21 && cycle <= 25; }
  Status take_contours(const KlartextBlock& block, Span where);
  void take_contour_data();
  Status mill_contours(Interpreter& m, Span where);
  Status take_old_line(BlockContext& m, const KlartextBlock& block);
  Status call_pattern(Interpreter& m, const KlartextBlock& block);
  // tables.cpp
  void read_tool_table(BlockContext& m);
  Status take_datum_row(Emitter& m, double row, Span where);
  Status select_points(Emitter& m, const std::string& path, Span where);
  // probing.cpp
  Status define_probe(Interpreter& m, const KlartextBlock& block);
  Status continue_probing(Interpreter& m);
  Status finish_probing(Interpreter& m);
  // functions.cpp
  Status circle_data(Interpreter& m, const KlartextBlock& block);
  // motion.cpp
  void emit_arc(Emitter& m, Turn turn, const PlaneArc& arc, const Axes& end, AxisMask named, PlaneAxes plane);

  /// Reads a block of the file that is being executed; nullptr if it cannot be read.
  std::shared_ptr<const KlartextBlock> block_at(const BlockContext& m, Position at);
  void note_written(ParameterFamily family, std::uint16_t index, double before) { written_.push_back({family, index, before}); }

 private:
  friend class BlockRun;
  friend class LoopLines;
  struct Kept;
  bool needs_text(const BlockContext& m) const;
  Result<bool> run_text(Interpreter& m);
  std::vector<double>& family(ParameterFamily which) {
    return which == ParameterFamily::ql ? memory.ql : which == ParameterFamily::qr ? memory.qr : memory.q;
  }
  const std::vector<double>& family(ParameterFamily which) const { return const_cast<Heidenhain&>(*this).family(which); }  // NOLINT

  std::map<std::string, std::uint32_t> names_;                                    // tools that are called by their names
  std::map<std::uint32_t, double> teeth_;                                         // CUT of the tool table
  std::set<std::uint32_t> table_;                                                 // tools of the set-up, and of TOOL DEF
  std::unordered_map<std::uint64_t, std::shared_ptr<const KlartextBlock>> read_;  // blocks as read, by file and offset
  std::vector<std::unique_ptr<ProgramIndex>> indices_;                            // by file
  std::unique_ptr<Block> scratch_ = std::make_unique<Block>();
  std::vector<double> stack_;
  std::vector<WrittenValue> written_;
  LoopLines loop_lines_{*this};
  bool loops_ = false;  // the program has jumped or called, so that blocks are executed again
  Modes before_;
  bool kept_ = false;
  Axes previous_{};  // work coordinates before the motion that comes next
};

Heidenhain& heidenhain_of(const BlockContext& m);

}  // namespace kadr::heidenhain
