#pragma once
// The dialect of LinuxCNC (spec/linuxcnc; LinuxCNC's source is src/emc/rs274ngc): the behaviour that no row of the control file can
// express. Where LinuxCNC's manual and its source differ, the source decides.

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "action/plane_spline.h"
#include "base/code_literals.h"
#include "control/dialect.h"
#include "control/linuxcnc/block_codes.h"
#include "control/linuxcnc/files/machine_file.h"
#include "control/linuxcnc/files/parameter_file.h"
#include "control/linuxcnc/files/written_program_files.h"
#include "control/linuxcnc/flow_table.h"
#include "control/linuxcnc/modal_groups.h"
#include "control/linuxcnc/turning/turning_cycles.h"
#include "control/state/control_state.h"

namespace kadr {
class BlockContext;
class Emitter;
class Interpreter;
struct Call;
}  // namespace kadr

namespace kadr::linuxcnc {

/// Numbers of parameters (spec/linuxcnc 4.1). shift_on_number: 1 while the shift of G92 is in force; first_shift: first of the parameters
/// with the shift, one per axis; system_number: the number of the work system.
inline constexpr std::uint32_t shift_on_number = 5210, first_shift = 5211, system_number = 5220;

inline constexpr std::size_t max_arguments = 30;  // greatest number of arguments of a call: #1 … #30
inline constexpr std::size_t max_spindles = 8;
inline constexpr double whole_within = 1e-4;  // tolerance within which a value counts as a whole number (spec/linuxcnc 2.3)
inline constexpr std::string_view axis_letters = "XYZABCUVW";  // axis letters, in the order of tables and of the control's axes
inline constexpr std::size_t axes_of_tables = axis_letters.size(), usual_axes = 6, axis_u = 6;
inline bool is_rotary_place(std::size_t axis) { return axis >= 3 && axis < axis_u; }  // true for the indices of the rotary axes A, B and C

/// A tool of the tool table (spec/linuxcnc 9). Lengths are in mm, angles in degrees.
struct Tool {
  Axes offset{};
  double diameter = 0;
  double front = 0, back = 0;  // front and back angle of a lathe tool, degrees; words I and J of the table
  double orientation = 0;      // orientation of a lathe tool, word Q of the table
  int pocket = 0;
  std::string remark;  // text after `;` in the tool table file
};

/// The parameters of one call: the numbered ones #1 … #30, and the named ones.
struct Level {
  std::array<double, max_arguments + 1> arguments{};
  std::map<double, double> named;
};

/// Modes that M70 or M73 has saved (spec/linuxcnc 8).
struct SavedModes {
  Modal modal;
  bool restore_at_end = false;  // M73 has saved the modes, so they are restored when the subprogram ends
};

/// A spindle other than the first one.
struct OtherSpindle {
  SpindleDir dir = SpindleDir::stop;
  double rpm = 0;
  bool surface = false;  // constant surface speed (G96) is on
};

/// The state that a block changes. An alarm in the block restores it.
struct State {
  Axes system{};          // offset of the work system in force, machine coordinates, mm or degrees
  double rotation = 0;    // rotation of the work system about Z, degrees
  Axes shift{};           // shift by G92 or G52, mm or degrees, in coordinates that rotate with the work system
  bool shift_on = false;  // value of #5210: the shift of G92 is in force
  Axes length{};          // tool lengths that G43 has applied, by axis, mm or degrees
  std::uint32_t system_number = 1;
  int active_spindle = 0;  // number of the spindle with which G33 and G76 synchronise the feed
  // Spindles by number; entry 0 is unused, because Modal has the data of the first spindle.
  std::array<OtherSpindle, max_spindles> others{};
  double max_css_speed = 0;    // word D of G96: greatest spindle speed, rev/min; 0: no limit
  bool cycle_began = false;    // a canned cycle was executed, so the next block may continue it
  double old_z = 0;            // initial level of a canned cycle, mm (spec/linuxcnc 7.6)
  std::int32_t motion = 80_g;  // motion code in force, in tenths; -1: none is in force, because G5.3 was executed
  bool polar_step = false;     // the block has @ or ^ in G91, so each repetition of a canned cycle adds the polar words
  double polar_radius = 0, polar_angle = 0;
  bool arc_not_allowed = false;  // cutter compensation has ended, so the next motion must be straight (spec/linuxcnc 7.3)
  std::array<bool, 2> spindle_known{};
  std::vector<ControlPoint> nurbs;  // control points of G5.2, collected until G5.3
  std::size_t nurbs_order = 3;      // order of the spline of G5.2, its degree + 1
  double value = 0;                 // value that the last `O… return` or `O… endsub` has returned (spec/linuxcnc 6.3)
  bool value_returned = false;
  bool percent = false;  // the file starts with a % line
  bool began = false;    // a line that is not blank has been read, so the program has begun
};

class LinuxCnc final : public Dialect {
 public:
  LinuxCnc(BlockContext& m, const Setup& setup, const RunLimits& limits);

  // ---- overrides of Dialect, defined in dialect.cpp, files_read.cpp and others
  bool start(Interpreter& m, const Setup& setup) override;
  void note_motion(Emitter& m, Motion& motion) override;
  void take_setup(Emitter& m, const Setup& setup) override;
  bool add_tables(const BlockContext& m, Setup& tables) const override;
  std::string start_words() const override { return machine.startup; }
  std::pair<double, double> limits_by_file(std::size_t axis) const override;
  void started(Emitter& m) override;
  Status target(const BlockContext& m, Axes& to, AxisMask& named) const override;
  bool end_program(Interpreter& m) override;
  void failed(Emitter& m) override;
  void add_variables(Emitter& m, FinalState& ending, const std::vector<std::string>& watch) override;
  std::shared_ptr<const DialectState> snapshot() const override;
  Status restore(BlockContext& m, const DialectState& from) override;
  bool skips_unread() const override { return true; }
  bool units_may_change() const override { return true; }
  Result<bool> statement(Interpreter& m) override;
  Result<bool> takes_block(Interpreter& m) override;
  std::int16_t motion_row(const BlockContext& m) const override;
  BlockChanges changes_of(const BlockContext& m, const Plan& plan) const override;
  void begin_block(Emitter& m) override;
  void after_code(Interpreter& m, const CodeRow& row, std::int32_t code) override;
  Status after_block(Interpreter& m) override;
  void undo_block(BlockContext& m) override;
  bool lines_follow(const BlockContext& m) const override;
  bool contour_follows(const BlockContext& m) const override;
  // Words of axes that the machine lacks are an alarm, so their blocks are executed with all checks.
  AxisMask rolling_axes(const BlockContext&) const override { return ~axes; }
  void note_line(BlockContext& m) override;
  ArcRule arc_rule(const BlockContext& m) const override;
  Result<PlaneArc> arc_of_center(Emitter& m, const ArcRule& rule, const ArcEnds& ends, Vec2 center) const override;
  Result<PlaneArc> arc_of_radius(Emitter& m, const ArcRule& rule, const ArcEnds& ends, double radius) const override;
  Status arc(Emitter& m, const Call& call, Turn turn) override;
  bool shapes_lines(const BlockContext& m) const override;
  Status straight(Emitter& m, const Call& call, MotionKind kind) override;
  Result<bool> turns_spindle(Emitter& m, SpindleDir dir, Span where) override;
  SurfaceSpeed surface_speed(const BlockContext& m) const override;
  const WrittenFiles& files_written() const override { return outputs.written(); }
  void refresh_frames(Emitter& m) override;
  double machine_unit() const override { return machine.unit; }
  Axes shift_of_origin(const BlockContext&) const override { return state.rotation == 0 ? state.shift : Axes{}; }
  Status machine_code(Interpreter& m, const Call& call) override;
  Status accept_answer(Emitter& m, const ProbeAnswer& answer) override;
  Result<bool> end_of_file(BlockContext& m) override;
  void note_fault(Interpreter& m, bool may_have_steered) override;
  Result<bool> sign_of_file(Interpreter& m) override;
  Status comments(Emitter& m) override;
  void reword(const BlockContext& m, AlarmReport& report) const override;
  Result<double> read_variable(Emitter& m, double number, Span where) const override;
  Status write_variable(BlockContext& m, double number, double value, Span where) override;
  Result<double> number_of_element(const BlockContext& m, double symbol, double index, Span where) const override;

  // ---- faults
  /// Returns an alarm with LinuxCNC's own text, and stores the text for the report.
  tl::unexpected<Alarm> fault(AlarmId id, Span where, std::string text) const;

  // ---- tables
  const Tool* tool(double number) const;
  /// Returns the table row of a tool, so that the caller can change it. The old values of the row are recorded first, so that an alarm can
  /// restore them.
  Tool& tool_to_write(BlockContext& m, int number);
  void retain_length(Emitter& m);
  Axes system_offset(const BlockContext& m, std::uint32_t number) const;
  /// Returns a position that parameters store, in mm and degrees. The parameter with the number `first` has the coordinate of the first
  /// axis; the next parameters have those of the other axes. The parameters are in the machine's unit (spec/linuxcnc 1.1).
  Axes stored_axes(const BlockContext& m, std::uint32_t first) const;
  void store_axis(BlockContext& m, std::uint32_t first, std::size_t axis, double value) const;
  double table_unit(std::size_t axis) const { return is_rotary_place(axis) ? 1 : machine.unit; }
  void take_system(Emitter& m, std::uint32_t number);
  void store_shift(BlockContext& m);

  /// Returns the G code in force of the modal group `group`, in tenths; -1 if no code of this group is in force.
  std::int32_t code_in_force(const BlockContext& m, std::size_t group) const;

  // ---- parameters
  Level& level() { return levels_.back(); }
  const Level& level() const { return levels_.back(); }
  std::vector<Level>& levels() { return levels_; }

  const ModalGroups groups;
  State state;
  BlockCodes codes;  // G and M codes of the block being executed, by modal group
  FlowTable flow;
  MachineFile machine;                  // contents of the ini file
  std::optional<TurningCycle> turning;  // cycle G70 to G72 whose profile is being read; nullopt: no profile is being read
  ProgramFiles outputs;
  char spindle_address = 0;  // the block reader's one-letter code of the address `$`
  AxisMask axes = 0;         // axes that the machine has (spec/linuxcnc 1.1)
  std::map<int, Tool> tools;
  std::vector<Word> written_words;  // words of the block as written; not empty while X and Y replace the polar words @ and ^ in the block
  bool tools_changed = false;       // G10 has changed the tool table, so its file must be written
  bool table_is_known = false;      // a tool table is given; if not, every tool number is valid, but its tool has no data
  std::vector<std::vector<SavedModes>> saved_modes{1};  // modes that M70 and M73 have saved, by depth of the calls
  Axes probed{};                                        // probed position, mm or degrees; read as #5061 …
  bool probe_tripped = false;
  int probe_kind = 2;  // digit n of the last G38.n

 private:
  void forget_shift(Emitter& m);
  Status take_polar_words(BlockContext& m);
  void forget_polar_words(BlockContext& m);
  Status write_probed(const BlockContext& m);
  void read_parameter_file(BlockContext& m, const RunLimits& limits);
  void take_parameters(BlockContext& m);
  void take_tables(BlockContext& m, const Setup& setup);
  void save_parameters(Emitter& m, bool program_ends);
  void save_tools(Emitter& m);
  void read_tool_file(const RunLimits& limits);
  void read_machine_file(BlockContext& m, const Setup& setup, const RunLimits& limits);
  struct Remembered;
  /// Kinds of named parameters. own: parameters that LinuxCNC defines (spec/linuxcnc 4.3); common: #<_name>, valid in all calls; local:
  /// #<name>, valid in one call.
  enum class NameKind : std::uint8_t { unknown, own, common, local };
  NameKind kind_of(const BlockContext& m, double number) const;
  std::string parameters_before_, tools_before_;  // contents of the parameter file and of the tool table file when they were read
  StoredParameters stored_;
  bool writes_parameters_ = false, writes_tools_ = false;
  std::vector<Level> levels_{1};
  std::map<double, double> globals_;  // common parameters #<_name>: {number of the name; value}
  State before_;
  mutable std::vector<NameKind> name_kinds_;  // kind of each named parameter, by number of the name
  mutable std::string fault_text_;
  friend class Parameters;

 public:
  std::map<double, double>& globals() { return globals_; }
  const std::map<double, double>& globals() const { return globals_; }
};

LinuxCnc& linuxcnc_of(const BlockContext& m);

/// Returns true if the plane in force is one of U, V, W (G17.1, G18.1, G19.1).
bool is_plane_of_uvw(const BlockContext& m);

}  // namespace kadr::linuxcnc
