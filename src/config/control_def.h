#pragma once
// A control, as its file says: rows for every code, address, group, cycle, variable (design.md 3).
// Rows refer to each other by index; strings are for people and are not looked at while a program runs.

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "base/alarm.h"
#include "base/vec.h"
#include "config/function.h"
#include "lang/block/grammar.h"
#include "lang/text/written_letters.h"

namespace kadr {

/// A text for people in both languages.
struct Text {
  std::string en;
  std::string ru;
};

/// One G or M code.
struct CodeRow {
  std::string code;  // "G43.4"
  char letter = 'G';
  std::int32_t tenth = 0;  // ten times the number: base/code_literals
  Function function = Function::count;
  Phase phase = Phase::none;
  int arg = 0;
  std::uint8_t group = 0;          // index in ControlDef::groups; 0 = none: any number of them
  bool modal = false;              // stays in force (its group is a modal one)
  bool own_block = false;          // must stand alone (with the words it takes)
  bool needs_axis = false;         // at least one axis word
  std::uint64_t takes = 0;         // letters of the words it uses
  std::uint64_t needs = 0;         // letters that must be there
  std::vector<std::int32_t> with;  // tenths of codes of its group that may stand beside it (M7 and M8)
  Text text;
  std::string manual;
  std::uint16_t cycle = 0;      // index in ControlDef::cycles + 1
  bool takes_all_axes = false;  // `*` in takes: every axis of the channel
  bool works = true;            // Kadr does it
  bool in_part = false;         // not all of it: the notes say what
  bool told = false;            // the control does it, and tells the machine of it (nct 13.1)
};

enum class WordUnit : std::uint8_t { none, length, angle };

/// One address.
struct AddressRow {
  char letter = 0;
  Function function = Function::count;  // count: the control has no such address
  Phase phase = Phase::none;
  std::uint8_t axis = 0;    // of `axis` and `center`: index in ControlDef::axes
  std::uint8_t number = 0;  // of a spindle; of an auxiliary function 1 to 3
  WordUnit unit = WordUnit::none;
  double scale = 1;       // the word's value times this is in mm, degrees, s, …
  bool whole = false;     // must be a whole number
  double least = -1e300;  // value_out_of_range beyond
  double most = 1e300;
  Text text;
  std::string manual;
  std::string format;  // as written in the file, for people
};

struct GroupRow {
  std::string name;
  bool modal = true;
  std::int32_t power_on = -1;  // row of the code in force at power-on, -1: none
  Text text;
};

/// One step of a drilling cycle (control/cycles).
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
  peck_break,  // down by Q: all the way out, or back a little, between the passes
  shift_out,
  shift_back,
  feed_face,            // G87: by I, J in the plane and back; up to K
  passes_by_parameter,  // L83 of the 2С42: pass levels from R1, R2, R3
  count
};

std::string_view name_of(CycleStep step);

struct CycleRow {
  std::string name;                              // "G81", "L81"
  std::uint32_t call_number = 0;                 // 81 of L81; 0: called by its code
  std::vector<CycleStep> steps;                  // by steps …
  std::string body;                              // … or as a program in the control's own language
  std::string printed;                           // of one by steps: the body as the manual prints it, for people
  std::vector<std::pair<char, int>> parameters;  // of a permanent subprogram: which word sets which formal parameter
  std::uint64_t needs = 0;                       // letters that must be known (given or sticky)
  std::uint64_t left_out = 0;                    // … of them R and Q, where the manual's own example has none: a warning
  bool needs_spindle_cw = false;
  bool needs_spindle = false;
  bool needs_override_off = false;  // L84 of the 2С42: G23
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

/// From here on no program can write the number: bits of a variable, variables that have only a symbol.
inline constexpr std::uint32_t first_unwritten_variable = 1'000'000;

/// Numbers of a system variable: `count` from `from`, again every `stride`, `repeat` times.
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
  std::vector<VariableRange> ranges;  // the short numbers, the long ones; the symbol means the last
  std::string symbol;                 // "ABSIO" of #_ABSIO[n]; of a family (#_WZP7[n]) "WZP"
  std::uint32_t first_index = 1;      // n of the first number
  int arg = 0;                        // which of its kind: the head of [[variables]] in controls/nct.toml says what it means
  int bit = -1;                       // one bit of another variable (`of`)
  std::uint32_t of = 0;
  bool read = true, write = true;
  bool works = true;  // Kadr does it
  Text text;
  std::string manual;
};

enum class ParameterScope : std::uint8_t { global, channel, axis, spindle };
enum class ParameterType : std::uint8_t { bits, whole, real, text };
enum class ParameterClass : std::uint8_t { run_time, restart, emergency };

/// A parameter of the control (nct 24).
struct ParameterRow {
  std::string name;  // "0107"; "CLRG" where the manual gives no number
  std::int32_t number = -1;
  ParameterScope scope = ParameterScope::channel;
  ParameterType type = ParameterType::real;
  ParameterClass when = ParameterClass::run_time;
  double least = -1e300, most = 1e300;
  double initial = 0;
  std::vector<std::string> bits;   // names by number; "" unknown; a name without a known number stands after the eighth
  bool used = false;               // Kadr obeys it
  std::vector<std::string> means;  // what the engine calls it ("1500", "1300#7", "calculator"): of bits one a bit
  Text text;                       // en: the manual's own name first
  std::string manual;
};

/// What I J K of an arc mean: from the start point; as G90, G91 say, and that of a third axis is the lead of a helix (2С42 6.6.4, 6.6.6);
/// by G90.1, G91.1.
enum class ArcCenters : std::uint8_t { incremental, as_distance, by_code };
/// Whether an arc may have R: no; in place of I J K; beside I J K, which then mean nothing (spec/fanuc 3.2).
enum class ArcRadius : std::uint8_t { none, alone, before_centre };
enum class LengthOffset : std::uint8_t { at_once, next_motion };
/// How the first motion behind G41, G42 goes: to the normal of the next block's start; touching the line to its first point (Mach3); held
/// back until the next one moves its end (LinuxCNC: path/contour/queued_compensation).
enum class CompensationEntry : std::uint8_t { normal, tangent, queued };
/// What P of a dwell counts: s; ms; ms without a point, s with one (spec/haas 4.1).
enum class DwellUnit : std::uint8_t { seconds, milliseconds, milliseconds_without_point };
/// Of two words for the same thing the later counts: nowhere, it is an alarm; among the arguments of a macro call (spec/fanuc 9.3), where
/// G, L, N, O, P are none; of addresses and of the codes of a group too (1.2, 2.1).
enum class LaterWord : std::uint8_t { nowhere, arguments, everywhere };
/// What the words of a drilling cycle mean. shift_by_ijk: I J K are the shift of G76, G87, I of G85, G89 and of taps is a percentage, R
/// alone drills nothing (nct 18). shift_by_q: Q is the shift, its direction a parameter, R alone drills (spec/fanuc 10.1, 10.5).
/// pecks_by_ijk: so too, and I J K of G73, G83 are the first cut, how much less each next one is, and the least (spec/haas 8.3).
enum class CycleWords : std::uint8_t { shift_by_ijk, shift_by_q, pecks_by_ijk };

/// How the engine's functions behave on this control, where controls differ.
struct Behaviour {
  ArcCenters arc_centers = ArcCenters::incremental;
  ArcRadius arc_radius_word = ArcRadius::none;
  double arc_radius_difference = 0.01;  // mm
  double arc_difference_inch = 0;       // mm, while the unit is inch (G20); 0: the same
  bool arc_angle_even = false;          // where an arc's radius changes its angle goes evenly (nct 4.3); else the path
  LengthOffset length_offset = LengthOffset::next_motion;
  CompensationEntry compensation_entry = CompensationEntry::normal;
  bool rapids_apart = false;  // each axis of a rapid motion at its own rate, of a control without such a parameter: config/rapid_way.h
  bool feed_required = true;  // a motion at feed before any F: an alarm; else a warning (F0 is an alarm)
  double result_most = 0;     // greatest value of an assignment, of either sign (spec/fanuc 5.3); 0: no limit
  // Figures of the machine. Where the control has a table of parameters with them (`as` is their name), its values count, and the
  // set-up's before those (config/machine_axes).
  double feed_most = 0;                // mm/min; 0 = no limit
  double reference_feed = 2000;        // mm/min, G25 of the 2С42
  double return_chip_break = 1;        // mm, G73
  double return_near = 1;              // mm, back to just above the bottom in G83
  double probe_least_distance = 0;     // mm
  double probe_retract = 0;            // mm, along its way back, when the probe has touched (Mach3 10.7.12.1)
  bool probe_in_inverse_time = false;  // Grbl: G38 in G93, its F is the time of the whole way
  bool speed_needs_direction = false;  // 2С42: S without M3/M4 changes nothing
  bool skip_asks = false;              // the set-up may say that the operator is asked before a block is skipped (spec/gost 2)
  bool tool_and_corrector = false;     // T0404: the last two of more than two digits are the corrector
  bool end_required = false;           // a program without M2 or M30 is warned of
  bool ends_reading = true;            // nothing after the end is read (GOST)
  bool delayed_assignment = false;     // Mach3: #1=5 X#1 uses the old #1
  bool feed_of_axis = false;           // F right after an axis' word, others follow: the feed of that axis (GOST 20999-83)
  bool label_is_number = false;        // O0001 right after % numbers the program (spec/gost 1)
  // Where controls with custom macros differ (spec/fanuc).
  LaterWord later_word_counts = LaterWord::nowhere;
  CycleWords cycle_words = CycleWords::shift_by_ijk;
  DwellUnit dwell_unit = DwellUnit::seconds;  // milliseconds: X, U are s; G4 alone is an exact stop (4.1)
  bool tool_along_third = false;  // cycles drill along Z, G43 acts on Z in any plane, unless a parameter says otherwise (7.1, 10.1)
  bool repeats_in_program_number = false;  // M98 P51002: O1002 five times (9.1)
  bool machine_move_absolute = false;      // G53 in G91 is ignored (6.5)
  bool repeats_by_k = false;               // K repeats a drilling cycle, else L (spec/fanuc 10.1)
  bool reference_all_axes = false;         // G28 alone: all axes, straight to the point (spec/haas 5.1)
  bool returns_to_own_block = false;       // M99 P goes to a block of the program in which it stands (spec/haas 3.3)
  bool repeats_keep_locals = false;        // G65 L: the arguments are set for the first pass only (spec/haas 3.4)
  bool words_passed_over = false;          // a word that nothing in the block takes is warned of, no alarm (spec/fanuc 1.2)
  std::uint32_t alarm_base = 4000;         // #3000=n is alarm base + n (5.5)
  std::uint32_t call_depth = 16;
  std::uint32_t program_digits = 1;    // of O, as a program for the control is written; of files that a call looks for (spec/haas 1.1)
  std::uint32_t m_codes_of_block = 8;  // most M codes of a block (nct 13.1, spec/fanuc 2.4, spec/haas 10)
  std::uint32_t offsets = 99;          // highest offset number
  std::uint32_t fixtures = 6;
  std::uint32_t further_systems = 99;  // highest P of G54.1 (nct 10.2.2, spec/fanuc 6.1)

  /// Z of a helix and its lead: whole turns (2С42 6.6.6).
  bool helix_by_lead() const { return arc_centers == ArcCenters::as_distance; }
  bool reads_arc_radius() const { return arc_radius_word != ArcRadius::none; }
  bool queues_contours() const { return compensation_entry == CompensationEntry::queued; }
  /// Q, not I J K, says how far G76 and G87 shift the tool, and R alone drills.
  bool shifts_by_q() const { return cycle_words != CycleWords::shift_by_ijk; }
};
inline constexpr std::uint32_t most_further_systems = 300;

struct AlarmText {
  std::string number;  // the control's own, may be empty
  Text text;
  Text hint;
};

/// Who does what no row of a control's file can say (`dialect = "…"`; control/dialect.h). iso: nobody.
enum class DialectId : std::uint8_t { iso, s2c42, correctors, nct, linuxcnc, grbl, mach3 };
inline constexpr std::array<std::string_view, 7> dialect_names = {"iso", "s2c42", "correctors", "nct", "linuxcnc", "grbl", "mach3"};

/// An M function of the machine that another control's machine has under another code.
struct MachineCodeRow {
  std::uint32_t code = 0;
  std::string control;      // id of the other one; "*": of all
  std::uint32_t there = 0;  // its M code
};

struct ControlDef {
  std::string id;
  std::vector<std::string> aliases;  // other names for --control: "haas-vf"
  Text name;
  std::string spec;                  // where its rules stand
  std::vector<std::string> lineage;  // "gost" for a file that extends it
  std::string descriptor;            // the format string
  DialectId dialect = DialectId::iso;
  Grammar grammar;
  Behaviour behaviour;
  std::vector<std::string> axes;                      // names in order
  std::uint32_t rotary = 0;                           // bit per axis
  std::uint32_t diameter = 0;                         // axes programmed as diameters
  bool diameter_by_setup = false;                     // which they are, the set-up says (spec/gost 5)
  std::array<std::uint8_t, max_axes> axis_numbers{};  // control-wide, from 1 (nct 2.1)
  std::uint8_t channel = 1;
  std::vector<GroupRow> groups;  // [0] is no group
  std::vector<CodeRow> codes;    // in the file's order
  std::array<AddressRow, most_addresses> addresses{};
  std::vector<CycleRow> cycles;
  std::vector<VariableRow> variables;
  std::vector<ParameterRow> parameters;
  std::array<std::uint8_t, static_cast<std::size_t>(Phase::count)> order{};  // rank of each phase
  std::vector<Phase> order_list;
  std::vector<std::int32_t> end_codes;        // rows put in force by the end of the program
  std::map<AlarmId, AlarmText> alarms;        // the control's own wording
  std::map<std::int32_t, double> feed_codes;  // coded F and S (spec/gost 3), empty: direct
  std::map<std::int32_t, double> speed_codes;
  std::vector<MachineCodeRow> machine_codes;  // [convert]
  WrittenLetters letters;                     // that programs written for it hold

  static constexpr std::int32_t most_tenths = 100'000;       // G9999.9, M9999.9: codes with a row
  static constexpr std::int32_t most_codes = 1'000'000'000;  // M99999999: codes at all
  std::vector<std::int16_t> g_rows;                          // by tenth → row, -1: unknown; up to the last code
  std::vector<std::int16_t> m_rows;
  std::int32_t m_user_from = -1;  // other M codes that go to the machine (free functions, macros M100…)
  std::int32_t m_user_to = -1;
  std::int32_t m_user_row = -1;

  /// The axes and their names are the machine's: the set-up says them (nct 2).
  bool machine_axes() const { return dialect == DialectId::nct; }
  /// Some variables tell the time.
  bool has_clocks() const {
    return std::any_of(variables.begin(), variables.end(), [](const VariableRow& row) { return is_clock(row.kind); });
  }
  /// The machine's logic is told of the codes that call and end programs (nct 13.1).
  bool tells_of_ends() const {
    return std::any_of(codes.begin(), codes.end(), [](const CodeRow& row) { return row.told; });
  }
  /// It may give that alarm, because it has a row for it. Some checks are made only then: `[alarms]` in docs/own-control.md.
  bool gives(AlarmId which) const { return alarms.contains(which); }
  /// Some parameter of the control is called that by the engine (`as` of its row).
  bool has_parameter(std::string_view meaning) const {
    return std::any_of(parameters.begin(), parameters.end(),
                       [&](const ParameterRow& row) { return std::find(row.means.begin(), row.means.end(), meaning) != row.means.end(); });
  }
  /// Subprograms stand in sections of their own, with a zero of their own (2С42 6.3.5, last section).
  bool has_sections() const { return grammar.section_address != 0; }
  /// It has a zero that shifts all work systems (nct 10.2.3); else #5201 and G10 L2 P0 are G52 (spec/haas 2.4, 5.4).
  bool has_common_zero() const {
    return std::any_of(variables.begin(), variables.end(), [](const VariableRow& row) { return row.kind == VariableKind::zero_common; });
  }
  /// It has axis correctors (spec/correctors).
  bool has_correctors() const { return dialect == DialectId::correctors; }
  /// Its words and frames are those of RS274/NGC with parameters in files (spec/linuxcnc).
  bool has_parameter_file() const { return dialect == DialectId::linuxcnc; }
  /// Each line is checked as a whole and by itself (spec/grbl).
  bool has_lines_alone() const { return dialect == DialectId::grbl; }
  const AddressRow& address(char letter) const { return addresses[static_cast<std::size_t>(letter - 'A')]; }
  /// Row of a code word, or -1.
  std::int32_t row_of(char letter, std::int32_t tenth) const;
};

}  // namespace kadr
