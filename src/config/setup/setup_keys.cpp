// The keys of a set-up (--setup FILE.json): one table, one row per key. Used by config/setup/setup_names; tested by
// tests/config/setup_keys_test.cpp.

#include "config/setup/setup_keys.h"

#include <algorithm>
#include <array>

#include "config/range.h"
#include "texts/setup_keys_logic.h"
#include "texts/setup_keys_machine.h"
#include "texts/setup_keys_other.h"
#include "texts/setup_keys_start.h"
#include "texts/setup_keys_tables.h"
#include "texts/setup_page.h"

namespace kadr {
namespace {

using F = SetupForm;
using N = SetupNames;
using U = SetupUnit;
using H = SetupNeeds;

namespace keys_start = texts::setup_keys_start;
namespace keys_tables = texts::setup_keys_tables;
namespace keys_machine = texts::setup_keys_machine;
namespace keys_logic = texts::setup_keys_logic;
namespace keys_other = texts::setup_keys_other;

constexpr SetupRange any{};
constexpr SetupRange position{ranges::position.least, ranges::position.most};
constexpr SetupRange checked_by_reader(const NumberRange& range) { return {range.least, range.most, true}; }
constexpr SetupRange checked_position = checked_by_reader(ranges::position), rate = checked_by_reader(ranges::rate),
                     feed = checked_by_reader(ranges::feed);
constexpr SetupRange acceleration = checked_by_reader(ranges::acceleration), seconds = checked_by_reader(ranges::seconds);
constexpr SetupRange speed = checked_by_reader(ranges::speed), percent = checked_by_reader(ranges::percent),
                     singular = checked_by_reader(ranges::singular);
constexpr SetupRange distance = checked_by_reader(ranges::distance), diameter = checked_by_reader(ranges::diameter);
constexpr SetupRange count{0, 99'999'999};
constexpr SetupRange bits{0, 4'294'967'295};
constexpr SetupRange channels{1, 8};
constexpr SetupRange spindles{1, 16};

constexpr bool null = true, stated = false;

// clang-format off
// Order: as a person fills in the file; after the row of a table come the rows of the keys in that table. Columns: path, form, names,
// range, unit, null, needs, words, example, instead, about.
constexpr SetupKey keys[] = {
  {"axes", F::texts, N::any, any, U::none, stated, H::nothing, "", R"(["X", "Y", "Z"])", "", keys_start::axes},
  {"start", F::table, N::axis, any, U::none, stated, H::nothing, "", R"({"X": 0, "Y": 150, "Z": -20})", "", keys_start::start},
  {"start.*", F::number, N::fixed, position, U::axis, stated, H::nothing, "", "150", "", keys_start::of_one_axis},
  {"start_frame", F::one_of, N::fixed, any, U::none, stated, H::nothing, "machine work", R"("work")", "", keys_start::start_frame},
  {"modal", F::texts, N::any, any, U::none, stated, H::nothing, "", R"(["G90"])", "", keys_start::modal},
  {"feed", F::number, N::fixed, feed, U::mm_min, null, H::nothing, "", "300", "", keys_start::feed},
  {"plane", F::text, N::fixed, any, U::none, null, H::machine_axes, "", R"("XY")", "", keys_start::plane},
  {"diameter", F::table, N::axis, any, U::none, null, H::diameters, "", R"({"X": true})", "", keys_start::diameter},
  {"diameter.*", F::flag, N::fixed, any, U::none, stated, H::diameters, "", "true", "", keys_start::of_one_axis},

  {"offsets", F::table, N::offset, any, U::none, stated, H::nothing, "", R"({"1": {"length": 112.5, "radius": 8}})", "correctors", keys_tables::offsets},
  {"offsets.*", F::table, N::fixed, any, U::none, stated, H::nothing, "", R"({"length": 112.5, "radius": 8})", "", keys_tables::offsets_row},
  {"offsets.*.length", F::number, N::fixed, position, U::mm, null, H::nothing, "", "112.5", "", keys_tables::offsets_length},
  {"offsets.*.length_wear", F::number, N::fixed, position, U::mm, null, H::nothing, "", "-0.05", "", keys_tables::offsets_length_wear},
  {"offsets.*.radius", F::number, N::fixed, position, U::mm, null, H::nothing, "", "8", "", keys_tables::offsets_radius},
  {"offsets.*.radius_wear", F::number, N::fixed, position, U::mm, null, H::nothing, "", "-0.02", "", keys_tables::offsets_radius_wear},
  {"offsets.*.corner_radius", F::number, N::fixed, position, U::mm, null, H::corner_radius, "", "0.8", "", keys_tables::offsets_corner_radius},
  {"offsets.*.corner_radius_wear", F::number, N::fixed, position, U::mm, null, H::corner_radius, "", "0.01", "", keys_tables::offsets_corner_radius_wear},
  {"offsets.*.length_x", F::number, N::fixed, position, U::mm, null, H::turning_lengths, "", "40", "", keys_tables::offsets_length_x},
  {"offsets.*.length_x_wear", F::number, N::fixed, position, U::mm, null, H::turning_lengths, "", "0.1", "", keys_tables::offsets_length_x_wear},
  {"offsets.*.length_y", F::number, N::fixed, position, U::mm, null, H::turning_lengths, "", "0", "", keys_tables::offsets_length_y},
  {"offsets.*.length_y_wear", F::number, N::fixed, position, U::mm, null, H::turning_lengths, "", "0", "", keys_tables::offsets_length_y_wear},
  {"offsets.*.tip_position", F::number, N::fixed, {0, 9}, U::none, null, H::turning_lengths, "", "3", "", keys_tables::offsets_tip_position},
  {"offsets.*.X", F::number, N::fixed, position, U::mm, null, H::lathe_offsets, "", "-40", "", keys_tables::offsets_x},
  {"offsets.*.X_wear", F::number, N::fixed, position, U::mm, null, H::lathe_offsets, "", "0.1", "", keys_tables::offsets_x_wear},
  {"offsets.*.Y", F::number, N::fixed, position, U::mm, null, H::lathe_offsets, "", "0", "", keys_tables::offsets_y},
  {"offsets.*.Y_wear", F::number, N::fixed, position, U::mm, null, H::lathe_offsets, "", "0.1", "", keys_tables::offsets_y_wear},
  {"offsets.*.Z", F::number, N::fixed, position, U::mm, null, H::lathe_offsets, "", "-120", "", keys_tables::offsets_z},
  {"offsets.*.Z_wear", F::number, N::fixed, position, U::mm, null, H::lathe_offsets, "", "0.1", "", keys_tables::offsets_z_wear},
  {"offsets.*.tip", F::number, N::fixed, {0, 9}, U::none, null, H::lathe_offsets, "", "3", "", keys_tables::offsets_tip_position},
  {"work_offsets", F::table, N::work_offset, any, U::none, stated, H::work_offsets, "", R"({"G54": {"X": -400, "Y": -250, "Z": -300}})", "zeros", keys_tables::work_offsets},
  {"work_offsets.*", F::table, N::axis_or_plane, any, U::none, stated, H::work_offsets, "", R"({"X": -400, "Z": -300})", "", keys_tables::work_offsets_row},
  {"work_offsets.*.*", F::number, N::fixed, position, U::axis, null, H::work_offsets, "", "-400", "", keys_tables::work_offsets_axis},
  {"zeros", F::table, N::zero, any, U::none, stated, H::zeros, "", R"({"1": {"X": 40, "Y": -10, "Z": -350}})", "work_offsets", keys_tables::zeros},
  {"zeros.*", F::table, N::axis, any, U::none, stated, H::zeros, "", R"({"X": 40})", "", keys_tables::zeros_row},
  {"zeros.*.*", F::number, N::fixed, position, U::axis, null, H::zeros, "", "40", "", keys_start::of_one_axis},
  {"correctors", F::table, N::corrector, any, U::none, stated, H::correctors, "", R"({"17": -0.35})", "offsets", keys_tables::correctors},
  {"correctors.*", F::number, N::fixed, position, U::mm, null, H::correctors, "", "-0.35", "", keys_tables::correctors_row},
  {"tool", F::whole, N::fixed, count, U::none, stated, H::nothing, "", "4", "", keys_tables::tool},
  {"tool_table", F::table, N::tool_row, any, U::none, null, H::tool_management, "", R"({"1": {"T": 16, "info": "SENCV", "H": 1}})", "", keys_tables::tool_table},
  {"tool_table.*", F::table, N::fixed, any, U::none, stated, H::tool_management, "", R"({"T": 16})", "", keys_tables::tool_table_row},
  {"tool_table.*.T", F::whole, N::fixed, count, U::none, stated, H::tool_management, "", "16", "", keys_tables::tool_table_t},
  {"tool_table.*.info", F::info, N::fixed, bits, U::none, stated, H::tool_management, "", R"("SENCV")", "", keys_tables::tool_table_info},
  {"tool_table.*.form", F::whole, N::fixed, bits, U::none, stated, H::tool_management, "", "2", "", keys_tables::tool_table_form},
  {"tool_table.*.status", F::whole, N::fixed, bits, U::none, stated, H::tool_management, "", "2", "", keys_tables::tool_table_status},
  {"tool_table.*.counter", F::number, N::fixed, any, U::none, stated, H::tool_management, "", "1", "", keys_tables::tool_table_counter},
  {"tool_table.*.life", F::number, N::fixed, any, U::none, stated, H::tool_management, "", "3", "", keys_tables::tool_table_life},
  {"tool_table.*.warn", F::number, N::fixed, any, U::none, stated, H::tool_management, "", "2", "", keys_tables::tool_table_warn},
  {"tool_table.*.H", F::whole, N::fixed, count, U::none, stated, H::tool_management, "", "1", "", keys_tables::tool_table_h},
  {"tool_table.*.D", F::whole, N::fixed, count, U::none, stated, H::tool_management, "", "1", "", keys_tables::tool_table_d},
  {"tool_table.*.G", F::whole, N::fixed, count, U::none, stated, H::tool_management, "", "0", "", keys_tables::tool_table_g},
  {"tool_table.*.W", F::whole, N::fixed, count, U::none, stated, H::tool_management, "", "0", "", keys_tables::tool_table_w},
  {"tool_table.*.S", F::number, N::fixed, any, U::rev_min, stated, H::tool_management, "", "2400", "", keys_tables::tool_table_s},
  {"tool_table.*.F", F::number, N::fixed, any, U::mm_min, stated, H::tool_management, "", "600", "", keys_tables::tool_table_f},
  {"tool_table.*.user_bits", F::whole, N::fixed, bits, U::none, stated, H::tool_management, "", "0", "", keys_tables::tool_table_user_bits},
  {"tool_table.*.user", F::numbers, N::fixed, any, U::none, stated, H::tool_management, "", "[0, 1.5]", "", keys_tables::tool_table_user},
  {"place_table", F::table, N::place, any, U::none, null, H::tool_management, "", R"({"1/8": 2})", "", keys_tables::place_table},
  {"place_table.*", F::whole, N::fixed, {0, 999'999'999}, U::none, stated, H::tool_management, "", "2", "", keys_tables::place_table_row},
  {"form_table", F::table, N::tool_form, any, U::none, null, H::tool_management, "", R"({"2": {"left": 1}})", "", keys_tables::form_table},
  {"form_table.*", F::table, N::fixed, any, U::none, stated, H::tool_management, "", R"({"left": 1})", "", keys_tables::form_table_row},
  {"form_table.*.left", F::whole, N::fixed, count, U::none, stated, H::tool_management, "", "1", "", keys_tables::form_table_left},
  {"form_table.*.right", F::whole, N::fixed, count, U::none, stated, H::tool_management, "", "1", "", keys_tables::form_table_right},
  {"form_table.*.up", F::whole, N::fixed, count, U::none, stated, H::tool_management, "", "0", "", keys_tables::form_table_up},
  {"form_table.*.down", F::whole, N::fixed, count, U::none, stated, H::tool_management, "", "0", "", keys_tables::form_table_down},
  {"form_table.*.geometry", F::whole, N::fixed, count, U::none, stated, H::tool_management, "", "1", "", keys_tables::form_table_geometry},
  {"variables", F::table, N::variable, any, U::none, stated, H::variables, "", R"({"#100": 2})", "", keys_tables::variables},
  {"variables.*", F::number, N::fixed, any, U::none, null, H::variables, "", "2", "", keys_tables::variables_row},
  {"parameters", F::table, N::parameter, any, U::none, null, H::parameters, "", R"({"N1501": 0.5, "N0306#0": 1})", "", keys_tables::parameters},
  {"parameters.*", F::number_or_text, N::fixed, any, U::none, stated, H::parameters, "", "0.5", "", keys_tables::parameters_row},

  {"skip", F::wholes, N::fixed, {0, 9}, U::none, stated, H::nothing, "", "[1]", "", keys_start::skip},
  {"skip_answers", F::texts, N::any, any, U::none, stated, H::skip_question, "yes no", R"(["yes", "no"])", "", keys_start::skip_answers},
  {"disable", F::texts, N::any, any, U::none, stated, H::nothing, "", R"(["word_passed_over"])", "", keys_start::disable},
  {"optional_stop", F::flag, N::fixed, any, U::none, stated, H::nothing, "", "true", "", keys_start::optional_stop},
  {"single_block", F::flag, N::fixed, any, U::none, null, H::machine_axes, "", "true", "", keys_start::single_block},
  {"mirror", F::texts, N::axis, any, U::none, stated, H::nothing, "", R"(["X"])", "", keys_start::mirror},
  {"override", F::table, N::fixed, any, U::none, stated, H::nothing, "", R"({"feed": 80})", "", keys_start::override},
  {"override.feed", F::number, N::fixed, percent, U::percent, stated, H::nothing, "", "80", "", keys_start::override_feed},
  {"override.rapid", F::number, N::fixed, percent, U::percent, stated, H::nothing, "", "50", "", keys_start::override_rapid},
  {"override.spindle", F::number, N::fixed, percent, U::percent, stated, H::nothing, "", "110", "", keys_start::override_spindle},
  {"reference_points", F::table, N::reference_point, any, U::none, stated, H::nothing, "", R"({"1": {"X": 0, "Y": 0, "Z": 0}})", "", keys_start::reference_points},
  {"reference_points.*", F::table, N::axis, any, U::none, stated, H::nothing, "", R"({"Z": 0})", "", keys_start::reference_points_row},
  {"reference_points.*.*", F::number, N::fixed, position, U::axis, stated, H::nothing, "", "0", "", keys_start::of_one_axis},

  {"machine", F::table, N::axis_or_all, any, U::none, stated, H::nothing, "", R"({"*": {"rapid": 8000}, "Z": {"limits": [-400, 0]}})", "", keys_machine::machine},
  {"machine.*", F::table, N::fixed, any, U::none, stated, H::nothing, "", R"({"rapid": 8000})", "", keys_machine::machine_row},
  {"machine.*.rapid", F::number, N::fixed, rate, U::mm_min, null, H::nothing, "", "8000", "", keys_machine::machine_rapid},
  {"machine.*.acceleration", F::number, N::fixed, acceleration, U::mm_s2, null, H::nothing, "", "1000", "", keys_machine::machine_acceleration},
  {"machine.*.jerk_time", F::number, N::fixed, seconds, U::seconds, null, H::nothing, "", "0.04", "", keys_machine::machine_jerk_time},
  {"machine.*.limits", F::span, N::fixed, checked_position, U::axis, null, H::nothing, "", "[-400, 0]", "", keys_machine::machine_limits},
  {"machine.*.zone3", F::span, N::fixed, checked_position, U::axis, null, H::machine_axes, "", "[0, 100]", "", keys_machine::machine_zone3},
  {"machine.*.switches", F::span, N::fixed, checked_position, U::axis, null, H::machine_axes, "", "[-405, 5]", "", keys_machine::machine_switches},
  {"machine.*.apart", F::number, N::fixed, distance, U::axis, null, H::machine_axes, "", "0.05", "", keys_machine::machine_apart},
  {"machine.*.position_error", F::number, N::fixed, distance, U::axis, null, H::machine_axes, "", "0.1", "", keys_machine::machine_position_error},
  {"spindle", F::table, N::spindle, any, U::none, stated, H::nothing, "", R"({"1": {"rpm": 600, "dir": "cw"}})", "", keys_machine::spindle},
  {"spindle.*", F::table, N::fixed, any, U::none, stated, H::nothing, "", R"({"rpm": 600})", "", keys_machine::spindle_row},
  {"spindle.*.rpm", F::number, N::fixed, speed, U::rev_min, stated, H::nothing, "", "600", "", keys_machine::spindle_rpm},
  {"spindle.*.dir", F::one_of, N::fixed, any, U::none, stated, H::nothing, "cw ccw stop", R"("cw")", "", keys_machine::spindle_dir},
  {"spindle.*.angle", F::number, N::fixed, any, U::degrees, null, H::nothing, "", "0", "", keys_machine::spindle_angle},
  {"spindle.*.name", F::text, N::fixed, any, U::none, null, H::machine_axes, "", R"("S")", "", keys_machine::spindle_name},
  {"spindle.*.channel", F::whole, N::fixed, channels, U::none, null, H::machine_axes, "", "1", "", keys_machine::spindle_channel},
  {"spindle.*.ranges", F::spans, N::fixed, any, U::rev_min, null, H::machine_axes, "", "[[50, 1000], [800, 4000]]", "", keys_machine::spindle_ranges},
  {"spindle.*.loop", F::one_of, N::fixed, any, U::none, stated, H::machine_axes, "open closed", R"("open")", "", keys_machine::spindle_loop},
  {"spindle.*.surface_speed", F::number, N::fixed, speed, U::m_min, stated, H::machine_axes, "", "100", "", keys_machine::spindle_surface_speed},
  {"spindle.*.css_axis", F::whole, N::fixed, {0, 999'999'999}, U::none, null, H::machine_axes, "", "1", "", keys_machine::spindle_css_axis},
  {"spindle.*.master", F::whole, N::fixed, {0, 16}, U::none, null, H::machine_axes, "", "1", "", keys_machine::spindle_master},
  {"probe", F::table, N::probe_input, any, U::none, stated, H::probe, "", R"({"1": {"Z": -10}})", "", keys_machine::probe},
  {"probe.*", F::table, N::axis, any, U::none, null, H::probe, "", R"({"Z": -10})", "", keys_machine::probe_row},
  {"probe.*.*", F::number, N::fixed, position, U::axis, stated, H::probe, "", "-10", "", keys_start::of_one_axis},
  {"probe_workpiece", F::table, N::fixed, any, U::none, null, H::probe, "", R"({"tip_radius": 2, "hole": {"center": {"X": 50, "Y": 24}, "diameter": 40, "top": 0, "depth": 30}})", "", keys_machine::probe_workpiece},
  {"probe_workpiece.tip_radius", F::number, N::fixed, distance, U::mm, stated, H::probe, "", "2", "", keys_machine::probe_workpiece_tip_radius},
  {"probe_workpiece.hole", F::table, N::fixed, any, U::none, stated, H::probe, "", R"({"center": {"X": 50, "Y": 24}, "diameter": 40, "top": 0, "depth": 30})", "", keys_machine::probe_workpiece_hole},
  {"probe_workpiece.hole.center", F::table, N::fixed, any, U::none, stated, H::probe, "", R"({"X": 50, "Y": 24})", "", keys_machine::probe_workpiece_hole_center},
  {"probe_workpiece.hole.center.X", F::number, N::fixed, checked_position, U::mm, stated, H::probe, "", "50", "", keys_machine::probe_workpiece_hole_center_x},
  {"probe_workpiece.hole.center.Y", F::number, N::fixed, checked_position, U::mm, stated, H::probe, "", "24", "", keys_machine::probe_workpiece_hole_center_y},
  {"probe_workpiece.hole.diameter", F::number, N::fixed, diameter, U::mm, stated, H::probe, "", "40", "", keys_machine::probe_workpiece_hole_diameter},
  {"probe_workpiece.hole.top", F::number, N::fixed, checked_position, U::mm, stated, H::probe, "", "0", "", keys_machine::probe_workpiece_hole_top},
  {"probe_workpiece.hole.depth", F::number, N::fixed, distance, U::mm, stated, H::probe, "", "30", "", keys_machine::probe_workpiece_hole_depth},
  {"chuck_face", F::number, N::fixed, checked_position, U::mm, null, H::turning, "", "-62", "", keys_machine::chuck_face},
  {"tailstock", F::number, N::fixed, checked_position, U::mm, null, H::turning, "", "0", "", keys_machine::tailstock},
  {"stock", F::text, N::fixed, any, U::none, null, H::nothing, "", R"("box:-60,-40,-25,60,40,0")", "", keys_machine::stock},
  {"fixtures", F::texts, N::any, any, U::none, null, H::nothing, "", R"(["box:60,-40,-25,80,40,10"])", "", keys_machine::fixtures},

  {"clock", F::text, N::fixed, any, U::none, null, H::clock, "", R"("2014-05-18T15:32:41")", "", keys_logic::clock},
  {"ini", F::text, N::fixed, any, U::none, null, H::ini, "", R"("machine.ini")", "", keys_logic::ini},
  {"signals", F::table, N::signal, any, U::none, null, H::machine_axes, "", R"({"CP_NOWT": 1})", "", keys_logic::signals},
  {"signals.*", F::number, N::fixed, any, U::none, stated, H::machine_axes, "", "1", "", keys_logic::signals_row},
  {"events", F::tables, N::fixed, any, U::none, null, H::machine_axes, "", R"([{"when": {"code": "M90"}, "do": "skip", "switch": 2, "on": true}])", "", keys_logic::events},
  {"events.when", F::table, N::fixed, any, U::none, stated, H::machine_axes, "", R"({"block": "N30", "at": "end"})", "", keys_logic::events_when},
  {"events.when.block", F::text, N::fixed, any, U::none, stated, H::machine_axes, "", R"("N30")", "", keys_logic::events_when_block},
  {"events.when.at", F::one_of, N::fixed, any, U::none, stated, H::machine_axes, "start end", R"("end")", "", keys_logic::events_when_at},
  {"events.when.code", F::text, N::fixed, any, U::none, stated, H::machine_axes, "", R"("M90")", "", keys_logic::events_when_code},
  {"events.when.count", F::whole, N::fixed, {1, 999'999'999}, U::none, stated, H::machine_axes, "", "3", "", keys_logic::events_when_count},
  {"events.when.action", F::one_of, N::fixed, any, U::none, stated, H::machine_axes, "stop message", R"("message")", "", keys_logic::events_when_action},
  {"events.when.program", F::one_of, N::fixed, any, U::none, stated, H::machine_axes, "end", R"("end")", "", keys_logic::events_when_program},
  {"events.do", F::one_of, N::fixed, any, U::none, stated, H::machine_axes, "set skip start answer power_cycle synchronise release spindle_to_axis axis_to_spindle exchange reverse park", R"("skip")", "", keys_logic::events_do},
  {"events.signal", F::text, N::signal, any, U::none, stated, H::machine_axes, "", R"("CP_MINT")", "", keys_logic::events_signal},
  {"events.value", F::number, N::fixed, any, U::none, stated, H::machine_axes, "", "1", "", keys_logic::events_value},
  {"events.switch", F::whole, N::fixed, {1, 9}, U::none, stated, H::machine_axes, "", "2", "", keys_logic::events_switch},
  {"events.on", F::flag, N::fixed, any, U::none, stated, H::machine_axes, "", "true", "", keys_logic::events_on},
  {"events.answer", F::one_of, N::fixed, any, U::none, stated, H::machine_axes, "ok yes no cancel", R"("no")", "", keys_logic::events_answer},
  {"events.spindle", F::whole, N::fixed, spindles, U::none, stated, H::machine_axes, "", "2", "", keys_logic::events_spindle},
  {"events.master", F::whole, N::fixed, spindles, U::none, stated, H::machine_axes, "", "1", "", keys_logic::events_master},
  {"events.axis", F::text, N::axis_of_any, any, U::none, stated, H::machine_axes, "", R"("X")", "", keys_logic::events_axis},
  {"events.axes", F::texts, N::axis_of_any, any, U::none, stated, H::machine_axes, "", R"(["X", "Y"])", "", keys_logic::events_axes},
  {"channel", F::whole, N::fixed, channels, U::none, null, H::machine_axes, "", "1", "", keys_logic::channel},
  {"channels", F::table, N::channel, any, U::none, null, H::machine_axes, "", R"({"2": {"axes": ["X", "Z"], "program": "M30"}})", "", keys_logic::channels},
  {"channels.*", F::table, N::fixed, any, U::none, stated, H::machine_axes, "", R"({"program": "M30"})", "", keys_logic::channels_row},
  {"channels.*.program", F::text, N::fixed, any, U::none, stated, H::machine_axes, "", R"("M30")", "", keys_logic::channels_program},
  {"channels.*.axes", F::texts, N::any, any, U::none, stated, H::machine_axes, "", R"(["X", "Z"])", "", keys_logic::channels_axes},

  {"points", F::numbers, N::fixed, {0, 1}, U::none, stated, H::nothing, "", "[0.5]", "", keys_other::points},
  {"watch", F::texts, N::any, any, U::none, stated, H::nothing, "", R"(["#100"])", "", keys_other::watch},
  {"shifts", F::table, N::shift, any, U::none, null, H::machine_axes, "", R"({"G92": {"X": 60}})", "", keys_other::shifts},
  {"shifts.*", F::table, N::axis, any, U::none, stated, H::machine_axes, "", R"({"X": 60})", "", keys_other::shifts_row},
  {"shifts.*.*", F::number, N::fixed, position, U::axis, stated, H::machine_axes, "", "60", "", keys_start::of_one_axis},
  {"files", F::table, N::any, any, U::none, null, H::nothing, "", R"({"sub.nct": "M99"})", "", keys_other::files},
  {"main_file", F::text, N::fixed, any, U::none, null, H::nothing, "", R"("main.nct")", "", keys_other::main_file},
  {"notes", F::texts, N::any, any, U::none, null, H::nothing, "", R"(["G54: measured on the vice"])", "", keys_other::notes},
  {"search", F::text, N::fixed, any, U::none, null, H::machine_axes, "", R"("N50")", "", keys_other::search},
  {"kinematics", F::table, N::fixed, any, U::none, null, H::kinematics, "", R"({"type": "table-table", "axes": "AC", "reversed": "AC", "T1": [300, -200, -450], "T2": [0, 4, -60]})", "", keys_other::kinematics},
  {"kinematics.type", F::one_of, N::fixed, any, U::none, stated, H::kinematics, "head-head table-table head-table", R"("table-table")", "", keys_other::kinematics_type},
  {"kinematics.axes", F::one_of, N::fixed, any, U::none, stated, H::kinematics, "CA CB AB BA AC BC", R"("AC")", "", keys_other::kinematics_axes},
  {"kinematics.reversed", F::text, N::fixed, any, U::none, stated, H::kinematics, "", R"("AC")", "", keys_other::kinematics_reversed},
  {"kinematics.T1", F::numbers, N::fixed, checked_position, U::mm, stated, H::kinematics, "", "[300, -200, -450]", "", keys_other::kinematics_t1},
  {"kinematics.T2", F::numbers, N::fixed, checked_position, U::mm, stated, H::kinematics, "", "[0, 4, -60]", "", keys_other::kinematics_t2},
  {"kinematics.E", F::numbers, N::fixed, checked_position, U::mm, stated, H::kinematics, "", "[5, -3, 200]", "", keys_other::kinematics_e},
  {"kinematics.D", F::numbers, N::fixed, checked_position, U::mm, stated, H::kinematics, "", "[20, 8, 50]", "", keys_other::kinematics_d},
  {"kinematics.singular", F::number, N::fixed, singular, U::degrees, stated, H::kinematics, "", "0.05", "", keys_other::kinematics_singular},
  {"frame", F::table, N::any, any, U::none, null, H::machine_axes, "", "{}", "", keys_other::frame},
};

constexpr SetupSignal signals[] = {
  {"CP_MINT", keys_logic::signal_cp_mint, "23.4"},
  {"CP_NOWT", keys_logic::signal_cp_nowt, "14.5"},
  {"CP_LIM2DIS", keys_logic::signal_cp_lim2dis, "22.2"},
  {"CP_LIM3DIS", keys_logic::signal_cp_lim3dis, "22.3"},
  {"AP_SYNCR", keys_logic::signal_ap_syncr, "20.2", true},
  {"AP_PARKR", keys_logic::signal_ap_parkr, "20.2", true},
  {"AP_MIXR", keys_logic::signal_ap_mixr, "20.3", true},
  {"AP_MIRR", keys_logic::signal_ap_mirr, "20.4", true},
};
// clang-format on

/// Checks, at compile time, that each path occurs once, and after the path of the table that contains it.
constexpr bool paths_in_order() {
  for (std::size_t i = 0; i < std::size(keys); ++i) {
    const std::string_view path = keys[i].path;
    const std::size_t point = path.rfind('.');
    bool parent = point == std::string_view::npos;
    for (std::size_t j = 0; j < i; ++j) {
      if (keys[j].path == path) return false;
      if (!parent && keys[j].path == path.substr(0, point)) parent = keys[j].form == F::table || keys[j].form == F::tables;
    }
    if (!parent) return false;
  }
  return true;
}
static_assert(paths_in_order());

}  // namespace

std::span<const SetupKey> setup_keys() { return keys; }

const SetupKey* setup_key(std::string_view path) {
  const auto* const found = std::find_if(std::begin(keys), std::end(keys), [&](const SetupKey& row) { return row.path == path; });
  return found == std::end(keys) ? nullptr : found;
}

std::span<const SetupSignal> setup_signals() { return signals; }

AxisSignal axis_signal(std::string_view name) {
  constexpr std::pair<std::string_view, AxisLink> links[] = {{"AP_SYNCR.", AxisLink::follows},
                                                             {"AP_PARKR.", AxisLink::parked},
                                                             {"AP_MIXR.", AxisLink::exchanged},
                                                             {"AP_MIRR.", AxisLink::reversed}};
  for (const auto& [front, link] : links)
    if (name.starts_with(front)) return {link, name.substr(front.size())};
  return {};
}

const char* name_of(SetupUnit unit, Lang lang) {
  namespace id = texts::setup_page;
  constexpr PlainText names[] = {id::mm,      id::mm_or_degrees, id::mm_min, id::mm_s2,  id::seconds,
                                 id::degrees, id::rev_min,       id::m_min,  id::percent};
  return unit == SetupUnit::none ? "" : plain_text(names[static_cast<std::size_t>(unit) - 1], lang);
}

}  // namespace kadr
