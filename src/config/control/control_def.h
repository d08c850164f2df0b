#pragma once
// ControlDef: a control as its file describes it, with a row for every code, address, group, cycle and variable (docs/architecture.md, "A
// control is a file"). Rows refer to each other by index. The texts are for people and are not used while a program runs.

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "base/alarm.h"
#include "base/vec.h"
#include "config/control/code_system.h"
#include "config/control/function.h"
#include "lang/block/grammar.h"
#include "lang/text/written_letters.h"

namespace kadr {

/// A text for people, in English and Russian.
struct Text {
  std::string en;
  std::string ru;
};

/// One G or M code.
struct CodeRow {
  std::string code;  // the code as messages print it: "G43.4"
  char letter = 'G';
  std::int32_t tenth = 0;  // number of the code times ten, see base/code_literals
  Function function = Function::count;
  Phase phase = Phase::none;
  int arg = 0;
  std::uint8_t group = 0;   // index in ControlDef::groups; 0: the code is in no group, so a block may have several codes without a group
  bool modal = false;       // true if the code stays in force until another code of the same modal group replaces it
  bool own_block = false;   // true if a block with this code may have no other code; the words that the code uses (`takes`) are permitted
  bool needs_axis = false;  // true if a block with this code must have at least one axis word
  std::uint64_t takes = 0;  // letters (one bit each) of the words that the code uses
  std::uint64_t needs = 0;  // letters (one bit each) of the words that a block with this code must have
  std::vector<std::int32_t> with;  // other codes of the same group, in tenths, that may be in the same block as this code (M7 with M8)
  Text text;
  std::string manual;
  std::uint16_t cycle = 0;      // index in ControlDef::cycles plus 1; 0: the code calls no cycle
  bool takes_all_axes = false;  // true if `takes` is `*` in the control's file: the code uses every axis word of the channel
  bool works = true;            // true if Kadr implements the code
  bool in_part = false;         // true if Kadr implements only a part of the code; the notes in the control's file say what is missing
  bool reported = false;        // true if the control reports the code to the machine although it executes the code itself (nct 13.1)
};

enum class WordUnit : std::uint8_t { none, length, angle };

/// One address.
struct AddressRow {
  char letter = 0;
  Function function = Function::count;  // function of the address; Function::count: the control has no such address
  Phase phase = Phase::none;
  std::uint8_t axis = 0;    // only for the functions `axis` and `center`: index of the axis in ControlDef::axes
  std::uint8_t number = 0;  // number of the spindle or of the auxiliary function (1 to 3) that the word commands
  WordUnit unit = WordUnit::none;
  double scale = 1;       // factor that converts the word's value to mm, degrees, s, …
  bool whole = false;     // true if the value of the word must be a whole number
  double least = -1e300;  // least permitted value of the word; a value outside least…most raises the alarm value_out_of_range
  double most = 1e300;
  Text text;
  std::string manual;
  std::string format;  // number format as the file states it, for people
};

struct GroupRow {
  std::string name;
  bool modal = true;
  std::int32_t power_on = -1;  // index of the row of the group's code that is in force at power-on; -1: no code of the group is in force
  Text text;
};

/// A step of a drilling cycle (control/cycles).
enum class CycleStep : std::uint8_t {
  feed_bottom,
  rapid_bottom,
  retract,
  feed_retract,
  dwell,
  spindle_stop,
  spindle_reverse,
  spindle_restore,
  orient,
  stop,
  peck_full,
  peck_break,  // pecks to the bottom; between the pecks the tool retracts only a little, where with peck_full it retracts to the R level
  shift_out,
  shift_back,
  feed_face,            // G87: feeds along the drilling axis to the level that K states
  passes_by_parameter,  // L83 of the 2С42: drills in pecks whose depths are in the parameters R1, R2, R3
  count
};

std::string_view name_of(CycleStep step);

struct CycleRow {
  std::string name;               // name of the cycle: "G81", "L81"
  std::uint32_t call_number = 0;  // number after L in the call: 81 for L81; 0: the cycle is called by its code
  std::vector<CycleStep> steps;   // steps of the cycle; empty if the cycle has a `body`
  std::string body;               // program of the cycle, as text in the form that the control reads; empty if the cycle has `steps`
  std::string printed;            // program that the manual prints for the cycle, for people to read; only for a cycle that has `steps`
  // For a cycle that is a permanent subprogram of the control: address letter of a word in the call, and number of the formal parameter
  // that this word sets
  std::vector<std::pair<char, int>> parameters;
  // Letters (one bit each) of the words that a call of the cycle needs, in its block or modal from an earlier block
  std::uint64_t needs = 0;
  // Words that the cycle needs (R, Q) but that the manual omits in its own example. If one of them is missing, Kadr reports a warning
  // instead of an alarm.
  std::uint64_t left_out = 0;
  bool needs_spindle_cw = false;
  bool needs_spindle = false;
  bool needs_override_off = false;  // true if a call of the cycle requires that the overrides are off (G23), as L84 of the 2С42 does
  Text text;
  std::string manual;
};

// clang-format off
#define KADR_VARIABLE_KINDS(X)                                                                              \
  X(free) X(probe_point) X(home) X(home_second) X(set_position) X(fixture_number) X(fixture)                \
  /* nct 23.1 */                                                                                            \
  X(empty) X(constant_pi) X(constant_e) X(plc_in) X(plc_in_word) X(plc_out) X(plc_out_word)                               \
  X(alarm_text) X(stop_text) X(message_text) X(message_box)                                                 \
  X(clock) X(cutting_clock) X(date) X(time) X(parts_done) X(parts_required)                                 \
  X(single_block_lock) X(override_lock) X(search_state) X(mirror_state) X(main_program)                     \
  X(modal_group) X(modal_word)                                                                              \
  X(end_position) X(machine_position) X(work_position) X(probe_position) X(length_in_force)                 \
  X(servo_lag) X(handwheel_shift) X(distance_to_go)                                                         \
  X(offset_length) X(offset_length_wear) X(offset_radius) X(offset_radius_wear)                             \
  X(offset_corner) X(offset_corner_wear) X(offset_tip)                                                      \
  X(offset_x) X(offset_y) X(offset_x_wear) X(offset_y_wear)                                                 \
  X(zero_common) X(zero) X(rotation) X(zero_extended) X(rotation_extended)                                  \
  X(zero_dynamic_number) X(zero_dynamic_value) X(zero_dynamic)                                              \
  /* spec/fanuc 5.1, spec/haas 2.4 */                                                                         \
  X(common_further) X(common_again) X(timer) X(tool_in_spindle) X(spindle_speed) X(operator_switch)        \
  X(tool_magazine) X(tool_data) X(pallet_place) X(pallet_data) X(probe_position_5d) X(zero_local)
// clang-format on
enum class VariableKind : std::uint8_t {
#define KADR_VARIABLE_ENUM(name) name,
  KADR_VARIABLE_KINDS(KADR_VARIABLE_ENUM)
#undef KADR_VARIABLE_ENUM
      count
};

/// The first of the variable numbers that a program cannot contain. Kadr gives them to bits of a variable, and to variables that have only
/// a symbol.
inline constexpr std::uint32_t first_unwritten_variable = 1'000'000;

/// A range of numbers of a system variable: `count` numbers starting at `from`, repeated `repeat` times at intervals of `stride`.
struct VariableRange {
  std::uint32_t from = 0;
  std::uint32_t count = 1;
  std::uint32_t stride = 0;
  std::uint32_t repeat = 1;
};

inline bool is_clock(VariableKind kind) {
  return kind == VariableKind::clock || kind == VariableKind::cutting_clock || kind == VariableKind::time || kind == VariableKind::timer;
}
struct VariableRow {
  VariableKind kind = VariableKind::free;
  // Numbers of the system variable. Some data have two ranges of numbers: the short numbers are first, then the long ones. The name in
  // `symbol` refers to the last range.
  std::vector<VariableRange> ranges;
  std::string symbol;  // name of the system variable without #_ and index: "ABSIO" for #_ABSIO[n]; for a family (#_WZP7[n]) "WZP"
  std::uint32_t first_index = 1;  // index n (of #_ABSIO[n]) that belongs to the variable's first number
  // Number that distinguishes system variables of the same kind; comments at [[variables]] in controls/nct.toml explain its values
  int arg = 0;
  int bit = -1;  // number of the bit if the row is one bit of the variable `of`; -1: the row is a whole variable
  std::uint32_t of = 0;
  bool read = true, write = true;
  bool works = true;  // true if Kadr implements the variable
  Text text;
  std::string manual;
};

enum class ParameterScope : std::uint8_t { global, channel, axis, spindle };
enum class ParameterType : std::uint8_t { bits, whole, real, text };
enum class ParameterClass : std::uint8_t { run_time, restart, emergency };

/// A parameter of the control (nct 24).
struct ParameterRow {
  std::string name;  // number of the parameter as text: "0107"; if the manual gives no number, the name: "CLRG"
  std::int32_t number = -1;
  ParameterScope scope = ParameterScope::channel;
  ParameterType type = ParameterType::real;
  ParameterClass when = ParameterClass::run_time;
  double least = -1e300, most = 1e300;
  double initial = 0;
  // Names of the parameter's bits, by bit number; "" if the name of a bit is unknown. From the ninth element on: names of bits whose
  // numbers are unknown.
  std::vector<std::string> bits;
  bool used = false;  // true if the parameter has an effect in Kadr
  // Names under which the engine uses the parameter ("1500", "1300#7", "calculator"). A parameter of bits has one name per bit.
  std::vector<std::string> means;
  Text text;  // name and meaning of the parameter; `en` begins with the manual's own name
  std::string manual;
};

/// How I J K give the centre of an arc. incremental: relative to the start point. as_distance: absolute after G90, incremental after G91;
/// the word of the third axis is the lead of a helix (2С42 6.6.4, 6.6.6). by_code: absolute after G90.1, incremental after G91.1.
enum class ArcCenters : std::uint8_t { incremental, as_distance, by_code };
/// How a block gives the radius R of an arc. none: R is no word of an arc. alone: R may replace I J K. before_centre: R may also be in a
/// block with I J K, and then takes precedence (spec/fanuc 3.2).
enum class ArcRadius : std::uint8_t { none, alone, before_centre };
enum class LengthOffset : std::uint8_t { at_once, next_motion };
/// Where the first motion after G41, G42 ends. normal: on the normal at the start of the next block. tangent: where the tool touches the
/// line to the programmed point (Mach3). queued: the motion waits until the next motion determines its end (LinuxCNC:
/// path/compensation/queued_compensation).
enum class CompensationEntry : std::uint8_t { normal, tangent, queued };
/// The unit of P in a dwell: s; ms; or ms if P has no decimal point and s if it has one (spec/haas 4.1).
enum class DwellUnit : std::uint8_t { seconds, milliseconds, milliseconds_without_point };
/// Where a block may have two words of one address, of which the later takes effect. nowhere: two such words are an alarm. arguments: among
/// the arguments of a macro call (spec/fanuc 9.3), except G, L, N, O, P, which are no arguments. everywhere: also for other addresses, and
/// for codes of one group (spec/fanuc 1.2, 2.1).
enum class LaterWord : std::uint8_t { nowhere, arguments, everywhere };
/// The meaning of words in a drilling cycle. shift_by_ijk: I J K are the shift of G76, G87; I of G85, G89 and of tapping is a percentage; a
/// block with R alone does not drill (nct 18). shift_by_q: Q is the shift, a parameter gives its direction, and a block with R alone drills
/// (spec/fanuc 10.1, 10.5). pecks_by_ijk: like shift_by_q; in addition, I J K of G73, G83 are the first peck, the reduction of each further
/// peck, and the least peck (spec/haas 8.3).
enum class CycleWords : std::uint8_t { shift_by_ijk, shift_by_q, pecks_by_ijk };

/// Behaviour of the engine's functions in which controls differ.
struct Behaviour {
  ArcCenters arc_centers = ArcCenters::incremental;
  ArcRadius arc_radius_word = ArcRadius::none;
  double arc_radius_difference = 0.01;  // greatest difference of an arc's radii at start and end, mm
  // Greatest difference of an arc's radii at start and end, in mm, for programs in inches (G20); 0: as for programs in mm
  double arc_difference_inch = 0;
  // True: on an arc with changing radius, the angle advances evenly (nct 4.3). False: the length of its path advances evenly.
  bool arc_angle_even = false;
  LengthOffset length_offset = LengthOffset::next_motion;
  CompensationEntry compensation_entry = CompensationEntry::normal;
  // True if each axis moves at its own rate in a rapid. Used if the control has no parameter that decides this
  // (config/machine/rapid_path.h).
  bool rapids_apart = false;
  bool feed_required = true;  // true if a feed motion before any F word is an alarm; if false, it is a warning (F0 is always an alarm)
  double result_most = 0;     // greatest absolute value that may be assigned to a variable (spec/fanuc 5.3); 0: no limit
  // Values of the machine. If the control has a parameter for a value (named in `as` of its table), the parameter takes precedence; a value
  // of the set-up takes precedence over both (config/machine/machine_axes).
  double feed_most = 0;             // greatest feed, mm/min; 0: no limit
  double reference_feed = 2000;     // feed, in mm/min, that G25 of the 2С42 uses
  double return_chip_break = 1;     // distance by which G73 retracts to break the chip, mm
  double return_near = 1;           // distance above the previous bottom of the hole at which the rapid of G83 ends, mm
  double probe_least_distance = 0;  // least distance of a probe motion, mm
  double probe_retract = 0;         // distance by which the probe retracts along its path after contact, mm (Mach3 10.7.12.1)
  // True on Grbl: a probe motion (G38) is permitted under G93. Its F word, 1/min, then states the reciprocal of the time for the
  // whole path to the programmed end point, not for the path to the contact (docs/controls/grbl-notes.md).
  bool probe_in_inverse_time = false;
  bool speed_needs_direction = false;  // true on the 2С42: an S word in a block without M3 or M4 does not change the speed
  bool skip_asks = false;  // true if the set-up may state that the control asks the operator before it skips a block (spec/gost 2)
  // True if the last two digits of a T word with more than two digits are the offset number, as in T0404
  bool tool_and_corrector = false;
  bool end_required = false;  // true if Kadr warns of a program without M2 or M30
  bool ends_reading = true;   // true if the control reads nothing after the end of the program (GOST)
  // True on Mach3: an assignment takes effect only after its block, so in `#1=5 X#1`, X has the old value of #1
  bool delayed_assignment = false;
  // True if an F word directly after an axis word, with further axis words after it, is the feed of that axis (GOST 20999-83)
  bool feed_of_axis = false;
  bool label_is_number = false;  // true if O0001 directly after % is the program number (spec/gost 1)
  // The members from here to the end of the struct are for controls with custom macros (spec/fanuc).
  LaterWord later_word_counts = LaterWord::nowhere;
  Lathe lathe = Lathe::none;
  CycleWords cycle_words = CycleWords::shift_by_ijk;
  // The unit of P in a dwell. If it is not s, the dwell words X and U are still in s, and G4 alone is an exact stop (spec/fanuc 4.1).
  DwellUnit dwell_unit = DwellUnit::seconds;
  // True if cycles drill along Z and G43 acts on Z in every plane, unless a parameter selects another axis (spec/fanuc 7.1, 10.1).
  bool tool_along_third = false;
  // True if P of M98 contains repetitions and program number: M98 P51002 calls O1002 five times (spec/fanuc 9.1)
  bool repeats_in_program_number = false;
  bool machine_move_absolute = false;  // true if G53 has no effect under G91 (spec/fanuc 6.5)
  bool repeats_by_k = false;           // true: the word K is the repeat count of a drilling cycle; false: the word L (spec/fanuc 10.1)
  bool reference_all_axes = false;     // true if G28 without axis words moves all axes directly to the reference point (spec/haas 5.1)
  bool returns_to_own_block = false;   // true if M99 P jumps to a block of the program that contains the M99 (spec/haas 3.3)
  bool repeats_keep_locals = false;    // true if a macro call with repetitions sets the arguments for the first one only (spec/haas 3.4)
  bool words_passed_over = false;      // true if a word that no code of the block uses gets a warning instead of an alarm (spec/fanuc 1.2)
  // The assignment #3000=n in a program raises the alarm with the number alarm_base + n (spec/fanuc 5.5)
  std::uint32_t alarm_base = 4000;
  std::uint32_t call_depth = 16;
  // Number of digits after O in programs that Kadr writes, and in names of called files (spec/haas 1.1)
  std::uint32_t program_digits = 1;
  std::uint32_t m_codes_of_block = 8;  // greatest number of M codes in one block (nct 13.1, spec/fanuc 2.4, spec/haas 10)
  std::uint32_t offsets = 99;          // highest offset number
  std::uint32_t fixtures = 6;
  std::uint32_t further_systems = 99;  // highest P of G54.1, the number of an additional work offset (nct 10.2.2, spec/fanuc 6.1)

  /// Returns true if a block for a helix states Z and a lead, and the helix makes whole revolutions (2С42 6.6.6).
  bool helix_by_lead() const { return arc_centers == ArcCenters::as_distance; }
  bool reads_arc_radius() const { return arc_radius_word != ArcRadius::none; }
  bool queues_compensation() const { return compensation_entry == CompensationEntry::queued; }
  /// Returns true if Q, not I J K, is the shift of G76 and G87, and a block with R alone drills.
  bool shifts_by_q() const { return cycle_words != CycleWords::shift_by_ijk; }
};
inline constexpr std::uint32_t max_further_systems = 300;

struct AlarmText {
  std::string number;  // alarm number of the control's manual; may be empty
  Text text;
  Text hint;
};

/// The part of the engine for behaviour that no row of a control's file can express (`dialect = "…"`; control/dialect.h). iso: the control
/// needs no such part.
enum class DialectId : std::uint8_t { iso, s2c42, correctors, nct, linuxcnc, grbl, mach3, sinumerik, heidenhain };
inline constexpr std::array<std::string_view, 9> dialect_names = {"iso",  "s2c42", "correctors", "nct",       "linuxcnc",
                                                                  "grbl", "mach3", "sinumerik",  "heidenhain"};

/// An M function of the machine that has another code on the machine of another control.
struct MachineCodeRow {
  std::uint32_t code = 0;
  std::string control;      // id of the other control; "*": all other controls
  std::uint32_t there = 0;  // number of the M code on the other control
};

struct ControlDef {
  std::string id;
  std::vector<std::string> aliases;  // further names of the control that the option --control accepts: "haas-vf"
  std::vector<CodeSystem> systems;
  Text name;
  std::string spec;                  // the document that describes the control
  std::vector<std::string> lineage;  // ids of the controls that this control extends: "gost"
  std::string descriptor;            // format string that describes the words of the control
  DialectId dialect = DialectId::iso;
  Grammar grammar;
  Behaviour behaviour;
  std::vector<std::string> axes;                      // names of the axes, in order
  std::uint32_t rotary = 0;                           // mask of rotary axes
  std::uint32_t diameter = 0;                         // mask of axes programmed as diameters
  bool diameter_by_setup = false;                     // true if the set-up states which axes are programmed as diameters (spec/gost 5)
  std::array<std::uint8_t, max_axes> axis_numbers{};  // numbers of the axes, counted from 1 across all channels of the control (nct 2.1)
  std::uint8_t channel = 1;
  std::vector<GroupRow> groups;  // groups of codes; groups[0] is for codes without group
  std::vector<CodeRow> codes;    // rows of G and M codes, in the file's order
  std::array<AddressRow, max_addresses> addresses{};
  std::vector<CycleRow> cycles;
  std::vector<VariableRow> variables;
  std::vector<ParameterRow> parameters;
  std::array<std::uint8_t, static_cast<std::size_t>(Phase::count)> order{};  // position of each phase in the order of execution
  std::vector<Phase> order_list;
  std::vector<std::int32_t> end_codes;  // rows of the codes that are put in force at the end of the program
  std::map<AlarmId, AlarmText> alarms;  // texts of the alarms for which the control has its own number or wording
  // Values of F by code, for a control with coded feeds (spec/gost 3)
  std::map<std::int32_t, double> feed_codes;
  std::map<std::int32_t, double> speed_codes;
  std::vector<MachineCodeRow> machine_codes;  // rows of [convert]
  WrittenLetters letters;                     // letters and encoding of programs that are written for this control

  static constexpr std::int32_t max_tenths = 100'000;        // greatest code, in tenths, for which a file may have a row: G9999.9, M9999.9
  static constexpr std::int32_t most_codes = 1'000'000'000;  // greatest code, in tenths, that a program may contain: M99999999
  // Index of each G code's row, by ten times the number of the code; -1: the control has no such code. The vector ends at the last known
  // code.
  std::vector<std::int16_t> g_rows;
  std::vector<std::int16_t> m_rows;
  // First code, in tenths, of the M codes that have no rows of their own and go to the machine (such as macros M100…)
  std::int32_t m_user_from = -1;
  std::int32_t m_user_to = -1;
  std::int32_t m_user_row = -1;

  /// Returns true if the axes and their names depend on the machine and come from the set-up (nct 2).
  bool machine_axes() const { return dialect == DialectId::nct; }
  /// Returns true if the control has variables that are clocks.
  bool has_clocks() const {
    return std::any_of(variables.begin(), variables.end(), [](const VariableRow& row) { return is_clock(row.kind); });
  }
  /// Returns true if the control reports the codes that call and end programs (such as M2, M98) to the machine's logic (nct 13.1).
  bool reports_program_ends() const {
    return std::any_of(codes.begin(), codes.end(), [](const CodeRow& row) { return row.reported; });
  }
  /// Returns true if the control may raise this alarm, because its file has a row for it. Some checks are made only in this case, see
  /// `[alarms]` in docs/own-control.md.
  bool gives(AlarmId which) const { return alarms.contains(which); }
  /// Returns true if the control has a parameter that the engine uses under this name (`as` of the parameter's row).
  bool has_parameter(std::string_view meaning) const {
    return std::any_of(parameters.begin(), parameters.end(),
                       [&](const ParameterRow& row) { return std::find(row.means.begin(), row.means.end(), meaning) != row.means.end(); });
  }
  /// Returns true if the control has subprograms that are sections of the program's own file. Such a section has a work offset of its own
  /// (2С42 6.3.5, last section).
  bool has_sections() const { return grammar.section_address != 0; }
  /// Returns true if the control has a common work offset, which shifts all work systems (nct 10.2.3). On a control without it, #5201 and
  /// G10 L2 P0 refer to the shift of G52 (spec/haas 2.4, 5.4).
  bool has_common_zero() const {
    return std::any_of(variables.begin(), variables.end(), [](const VariableRow& row) { return row.kind == VariableKind::zero_common; });
  }
  /// Returns true if the control has correctors that shift axes (spec/correctors).
  bool has_correctors() const { return dialect == DialectId::correctors; }
  /// Returns true if words and frames of the control follow RS274/NGC, with parameters in a file (spec/linuxcnc).
  bool has_parameter_file() const { return dialect == DialectId::linuxcnc; }
  /// Returns true if the control checks each line by itself, independently of other lines (spec/grbl).
  bool has_lines_alone() const { return dialect == DialectId::grbl; }
  const AddressRow& address(char letter) const { return addresses[static_cast<std::size_t>(letter - 'A')]; }
  /// Returns the index of the row for a code; -1 if the control does not have the code.
  std::int32_t row_of(char letter, std::int32_t tenth) const;
};

}  // namespace kadr
