#pragma once
// Sinumerik: the dialect of Sinumerik 840D sl and 828D (spec/sinumerik). A block with names is read by lang/named when it is executed; its
// assignments act from left to right, and what remains are words, which the table of the control's file executes like those of any other
// control. Only src/control/sinumerik includes this file.

#include <array>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "control/dialect.h"
#include "control/interpreter.h"
#include "control/sinumerik/calculation.h"
#include "control/sinumerik/memory.h"
#include "control/sinumerik/program_index.h"
#include "control/sinumerik/word_lines.h"
#include "lang/named/named_block.h"

namespace kadr::sinumerik {

/// A step of a smooth approach or retraction, in programmed coordinates; an arc if `turns` is not 0.
struct ApproachStep {
  Vec2 to{};
  double height = 0;
  double feed = 0;  // mm/min; 0: rapid
  Vec2 centre{};
  double turns = 0;
  bool ccw = false;
};

/// An arc in space of CIP, in the coordinates of the programmable frame.
struct SpaceArc {
  Matrix turn = unit_matrix;  // from the plane of the arc, whose axes are those of the plane in force, to the frame
  Vec3 through, to;
  Span where;
};

/// The motion in force before a block that executes another one.
struct MotionBefore {
  MotionMode motion = MotionMode::none;
  std::int16_t motion_row = -1;
  decltype(Modal::rows) rows{};
};

/// What the words of the block say besides the words of the table.
struct BlockWords {
  std::array<WordForm, 26> forms{};       // of axis words and centres, by letter
  std::map<std::string, double> numbers;  // CR, AR, AP, RP, TURN, CHR, RND …
  std::map<std::string, WordForm> number_forms;
  std::map<std::string, Span> places;
  std::optional<std::uint32_t> edge;  // D
  Span edge_where;
  bool machine = false;              // G53, G153, SUPA
  bool basic_off = false;            // G153, SUPA
  bool returns = false;              // M17, RET
  std::string return_label;          // RET("LABEL")
  std::optional<Modal> chuck;        // G63: the modes before its block
  std::optional<double> block_feed;  // FB: the feed after its block
  bool block_feed_known = false;
  double corner_feed = 0;                     // FRC: of the chamfer or rounding of the block; 0: FRCM, or the feed of the block
  std::optional<MotionBefore> motion_before;  // G147 to G348
  std::vector<ApproachStep> retraction;       // after the block's own motion
  std::optional<SpaceArc> space_arc;          // after the block's other words
  bool moved = false;                         // the block has moved an axis
  int probe = 0;                              // MEAS: number of the probe that ends the motion of the block; 0: none
  bool has(const std::string& name) const { return numbers.contains(name); }
  double number(const std::string& name) const { return numbers.at(name); }
  Span where(const std::string& name) const { return places.at(name); }
};

/// Returns the folders in which the control looks for something besides the folder of the main program: `names` below that folder, below
/// the one around it, and below the next one, as archives have them (spec/sinumerik 1).
std::vector<std::string> folders_near(const std::string& main_file, std::initializer_list<const char*> names);

/// The value that a block has replaced, for the case that the block fails.
struct WrittenValue {
  std::shared_ptr<Variable> variable;  // nullptr: an R parameter, or a settable frame if `value` is a frame
  std::size_t place = 0;
  Value value;
};

class Sinumerik final : public Dialect {
 public:
  explicit Sinumerik(const RunLimits& limits) : folder_(limits.files), door_(limits.door) {}

  // ---- program
  std::shared_ptr<const DialectState> snapshot() const override;
  Status restore(BlockContext& m, const DialectState& from) override;
  void take_setup(Emitter& m, const Setup& setup) override;
  bool end_program(Interpreter& m) override;
  bool reads_outlines() const override { return true; }
  void reword(const BlockContext& m, AlarmReport& report) const override;
  Result<bool> end_of_file(BlockContext& m) override;

  // ---- blocks
  bool has_unfinished() const override { return loops_ || has_open_parts(); }
  Result<bool> finish(Interpreter& m) override;
  Result<bool> statement(Interpreter&) override { return false; }
  Result<bool> takes_block(Interpreter& m) override;
  BlockChanges changes_of(const BlockContext&, const Plan&) const override { return BlockChanges::anything; }
  void after_code(Interpreter& m, const CodeRow& row, std::int32_t code) override;
  Status after_block(Interpreter& m) override;
  void keep(BlockContext& m) override;
  void undo_block(BlockContext& m) override;
  bool skips_unread() const override { return true; }

  // ---- motion, frames, variables
  Status target(const BlockContext& m, Axes& to, AxisMask& named) const override;
  Status arc(Emitter& m, const Call& call, Turn turn) override;
  void note_motion(Emitter& m, Motion& motion) override;
  bool lines_follow(const BlockContext& m) const override;
  void note_line(BlockContext& m) override;
  AxisMask rolling_axes(const BlockContext& m) const override;
  ArcRule arc_rule(const BlockContext& m) const override;
  SurfaceSpeed surface_speed(const BlockContext& m) const override;
  void refresh_frames(Emitter& m) override;
  Status accept_answer(Emitter& m, const ProbeAnswer& answer) override;
  void add_variables(Emitter& m, FinalState& ending, const std::vector<std::string>& watch) override;

  // ---- used by the parts in this folder
  Memory memory;
  BlockWords words;
  FiveAxis rotary;                 // the rotary axes of the machine; group none: CYCLE800 turns the frame alone
  std::string assumed_axes;        // axes that only the program names, for the note at the first block; empty: noted, or none
  std::uint64_t missing_axes = 0;  // letters of axes that the machine does not have

  Result<Value> evaluate(BlockContext& m, const NamedBlock& block, NamedExpression expression);
  /// Returns the values that remain on the stack, such as the operands of SET(…), whose last step is left out.
  Result<std::vector<Value>> evaluate_all(BlockContext& m, const NamedBlock& block, NamedExpression expression);
  Result<double> number(BlockContext& m, const NamedBlock& block, NamedExpression expression, Span where);
  std::shared_ptr<Variable> variable(const std::string& name);
  Result<std::size_t> element(BlockContext& m, const NamedBlock& block, const std::string& name, const Variable& variable,
                              const std::vector<NamedExpression>& indices, Span where);
  const ProgramIndex& index(const BlockContext& m, std::uint16_t reader);
  const ProgramIndex& index(const BlockContext& m) { return index(m, m.program().reader()); }
  Level& level() { return memory.levels.back(); }

  Status set_programmable(Emitter& m, const Frame& frame, Span where);
  void place_in_space(Emitter& m);
  Status emit_in_space(Emitter& m, const SpaceArc& arc);
  Status approach_step(Emitter& m, const ApproachStep& step);
  /// Returns the radius of the tool in force with its wear, without OFFN, mm.
  double tool_radius(const BlockContext& m) const;
  /// Returns the radius that a milling cycle needs, mm, and notes for `kadr setup` that it is needed.
  ///   alarms  cycle_tool_radius
  Result<double> cutter_radius(BlockContext& m, Span where) const;
  /// Puts OFFN in force: the radius of the tool and OFFN are the offset of G41, G42.
  void set_normal_offset(BlockContext& m) const;
  Status within_area(const BlockContext& m, const Axes& to, AxisMask named) const;
  Status activate_edge(Emitter& m, std::uint32_t edge, Span where);
  /// Returns false if the tool table has tools, and this one is not among them (spec/sinumerik 5).
  bool knows_tool(const BlockContext& m, double tool) const;
  std::optional<std::size_t> axis_named(const BlockContext& m, std::string_view name) const;

  // writing, so that a faulty block can be undone
  void assign(const std::shared_ptr<Variable>& to, std::size_t place, Value value) {
    written_.push_back({to, place, std::exchange(to->values[place], std::move(value))});
  }
  void assign_parameter(std::size_t index, double value) {
    written_.push_back({nullptr, index, real(std::exchange(memory.parameters[index], value))});
  }
  void assign_settable(std::size_t index, const Frame& frame) {
    written_.push_back({nullptr, index, frame_value(std::exchange(memory.settable[index], frame))});
  }
  // flow.cpp
  void jump_to(Interpreter& m, const Position& to);
  Status jump(Interpreter& m, const NamedBlock& block, const NamedItem& item);
  Result<bool> structure(Interpreter& m, const NamedBlock& block, Keyword keyword);
  Status choose(Interpreter& m, const NamedBlock& block);
  Status repeat_part(Interpreter& m, const NamedBlock& block);
  // calls.cpp
  std::optional<FoundProgram> find_program(Interpreter& m, std::string_view written);
  Status call(Interpreter& m, const FoundProgram& found, const std::string& name, std::vector<Value> arguments,
              std::vector<std::shared_ptr<Variable>> references, bool has_arguments, std::uint32_t times, Span where);
  Status procedure(Interpreter& m, const NamedBlock& block);
  Status leave(Interpreter& m, Span where);
  /// RET("LABEL"): the caller goes on at the label (spec/sinumerik 9.2).
  Status jump_in_caller(Interpreter& m, const std::string& label, Span where);
  /// CALL BLOCK A TO B: a part of the present program, as a subprogram (spec/sinumerik 9.1).
  Status call_part(Interpreter& m, const NamedBlock& block);
  /// Calls the part between two labels of the present program.
  ///   alarms  section_missing, call_too_deep
  Status call_section(Interpreter& m, const std::string& from, const std::string& to, Span where);
  /// EXECSTRING("…"): executes a text as a block (spec/sinumerik 9.4).
  Result<bool> execute_text(Interpreter& m, const std::string& text, Span where);
  Status call_item(Interpreter& m, const NamedBlock& block, const NamedItem& item, std::uint32_t times, bool modal);
  Status define(Interpreter& m, const NamedBlock& block);
  /// Makes the variable of a row of DEF, with its initial values (spec/sinumerik 6.1).
  Result<std::shared_ptr<Variable>> made_variable(BlockContext& m, const NamedBlock& block, const NamedDefinition& row);
  // global_data.cpp
  /// Reads the definition files (global data, macros) once, before the first block that may use them.
  void load_globals(BlockContext& m);
  Status begin_pass(Interpreter& m);
  /// Goes to the next position of a pattern, and calls the program of MCALL there. Returns false if no position is left.
  Result<bool> next_position(Interpreter& m);
  void emit_arc(Emitter& m, Turn turn, const PlaneArc& arc, const Axes& end, AxisMask named);
  // milling_cycles.cpp
  static bool is_milling_cycle(std::string_view name);
  Status start_milling(Interpreter& m, const std::string& name, const std::vector<Value>& arguments, Span where);
  // contour_cycle.cpp
  /// CYCLE72: mills along a contour that a subprogram, or a part of the program between two labels, describes (spec/sinumerik 14.5).
  Status mill_contour(Interpreter& m, const std::vector<Value>& arguments, Span where);
  // cycles.cpp: works out the steps; cycle_calls.cpp
  Status start_cycle(Interpreter& m, const std::string& name, const std::vector<Value>& arguments, Span where);
  /// TRAORI and TRAFOOF: control of the tool tip on a machine with two rotary axes (spec/sinumerik 15).
  ///   alarms  no_five_axes, compensation_active
  /// Returns the positions of the rotary axes for a direction of the tool in the programmed frame, of length 1.
  ///   alarms  direction_unreachable
  Result<RotaryPair> rotary_positions(const BlockContext& m, Vec3 direction, Span where) const;
  Status transform_orientation(Emitter& m, bool on, Span where);
  /// CYCLE800: swivels the frame, and turns the rotary axes of a machine that has them (spec/sinumerik 14.6).
  Status swivel(Interpreter& m, const std::vector<Value>& arguments, Span where);
  static bool is_cycle(std::string_view name);
  Status run_cycle(Interpreter& m, const std::string& name, const std::vector<Value>& arguments, Span where);
  // frames.cpp
  static bool is_frame_statement(std::string_view name);
  Status frame_statement(Interpreter& m, const NamedBlock& block);
  Result<Value> frame_function(const std::string& name, const std::vector<Value>& operands, const BlockContext& m, Span where);
  // system_variables.cpp
  Frame basic_frame(const BlockContext& m) const;
  Result<Value> read_system(BlockContext& m, const std::string& name, const std::vector<Value>& indices, Span where);
  Status write_system(Interpreter& m, const std::string& name, const std::vector<Value>& indices, const Value& value, Span where);

  /// Returns empty lists for the arguments of a call, in the memory of those of a call that has ended.
  CallArguments empty_arguments();

 private:
  friend class BlockRun;
  struct State;
  bool has_open_parts() const {
    return memory.levels.size() > 1 || memory.pattern || !memory.repeated.empty() || !memory.levels.front().name.empty();
  }
  Result<bool> end_part(Interpreter& m);
  bool needs_names(const BlockContext& m) const;
  bool takes_kept_words(BlockContext& m);
  /// Returns true if no mode changes what plain words mean.
  bool words_are_plain() const { return memory.motion == NamedMotion::none && !memory.feed_in_mm && memory.override_percent == 100; }
  Result<bool> run_named(Interpreter& m);
  Result<bool> run_statement(Interpreter& m);
  bool put_macros(Block& block);
  void keep_memory(Level& ended);
  Variable& new_variable(Level& own, const std::string& name, Type type);

  void take_axes(Emitter& m, const Setup& setup);
  void load_definitions(BlockContext& m, const std::string& path);

  std::set<int> table_;  // tools of the set-up
  std::string folder_;
  const FileAccess* door_;
  std::string expanded_;                                                     // text of the block after its macros were replaced
  std::vector<std::unique_ptr<ProgramIndex>> indices_;                       // by file
  std::unordered_map<std::string, std::shared_ptr<const NamedBlock>> read_;  // blocks as read, by their text
  std::map<std::string, std::optional<FoundProgram>> found_;
  // Memory of the variables and arguments of calls that have ended, which the next calls use again.
  std::vector<Variables::node_type> spare_variables_;
  CallArguments spare_arguments_;
  std::unique_ptr<Block> scratch_ = std::make_unique<Block>();
  Modes before_;
  std::vector<WrittenValue> written_;  // values that the block has replaced, in their order
  bool kept_ = false;
  bool loops_ = false;  // the program has jumped back, so that lines are executed again
  Calculation calculation_{*this};
  WordLines word_lines_{*this, calculation_};
  Axes previous_{};              // work coordinates before the motion that comes next
  bool executes_text_ = false;   // within EXECSTRING
  std::string executed_;         // its text, in the place of the block
  bool circle_by_name_ = false;  // the block is CIP or CT, executed as an arc
};

/// Returns a component of a frame: TR, FI, RT, SC, MI of an axis (spec/sinumerik 11.4).
///   alarms  frame_component
Result<double> component_of(const Frame& frame, std::size_t axis, const std::string& name, Span where);
Status set_component_of(Frame& frame, std::size_t axis, const std::string& name, double value, Span where);

/// Returns true for a G code that the words of the table do not describe completely.
bool is_own_code(double code);

/// Returns the G code at a place of its group, as G[8]=2 names G54 (spec/sinumerik 3.1, 4.1); nullopt if Kadr does not list it.
std::optional<int> code_at_place(double group, double place);

Sinumerik& sinumerik_of(const BlockContext& m);

}  // namespace kadr::sinumerik
