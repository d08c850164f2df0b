// Checks the rows of [address], [g] and [m]: the function of a row, what this function needs of the control, and `arg`. A row that the
// engine could not execute is rejected by name when the file is loaded, before a program runs. Tested by
// tests/config/control_rules_test.cpp, tests/own_control.py and fuzz/own_control_fuzz.cpp.

#include <algorithm>
#include <array>
#include <cmath>

#include "base/code_literals.h"
#include "config/control/control_loader.h"
#include "config/control/drill_steps.h"
#include "texts/control_file_behaviour.h"
#include "texts/control_file_codes.h"
#include "texts/control_file_words.h"

namespace kadr {

using toml_tools::place;

namespace {

/// The permitted range of a function's `arg`. A function without a row here has no `arg`.
struct ArgRow {
  Function function;
  int least, most;
};
constexpr ArgRow args[] = {
    {Function::work_zero, 0, 99},
    {Function::fixture, 1, 1000},
    {Function::home_through, 1, 2},
    {Function::circular_pocket, 2, 3},
    {Function::override_permission, 0, 3},
    {Function::select_plane, 17, 19},
    {Function::reference_return, 1, 2},
    {Function::radius_side, 0, 2},
    {Function::length_comp, 0, 2},
    {Function::length_comp, 437, 437},
    {Function::transform_off, 512, 512},
    {Function::tool_orientation, 531, 531},
    {Function::tool_orientation, 536, 536},
    {Function::tool_lead, 431, 431},
    {Function::tool_lead, 434, 435},
    {Function::tool_lead, 438, 439},
    {Function::work_system, 1, 26},
    {Function::feed_control, 62, 64},
    {Function::diameter_switch, 0, 0},
    {Function::diameter_switch, 171, 172},
    {Function::new_system, 0, 0},
    {Function::new_system, 503, 503},
    {Function::thread, 0, 0},
    {Function::thread, 34, 34},
    {Function::macro_modal, 660, 661},
    {Function::turning_cycle, 707, 707},
    {Function::turning_cycle, 717, 717},
    {Function::turning_cycle, 727, 727},
    {Function::turning_cycle, 737, 737},
    {Function::turning_cycle, 747, 747},
    {Function::turning_cycle, 757, 757},
    {Function::turning_cycle, 767, 767},
    {Function::turning_simple, 777, 777},
    {Function::turning_simple, 787, 787},
    {Function::turning_simple, 797, 797},
    {Function::drilling, 0, 0},
    {Function::drilling, 73_g, 73_g},
    {Function::drilling, 74_g, 74_g},
    {Function::drilling, 76_g, 76_g},
    {Function::drilling, 81_g, 83_g},
    {Function::drilling, 84.2_g, 84.3_g},
    {Function::drilling, 85_g, 86_g},
    {Function::drilling, 89_g, 89_g},
    {Function::drilling, bored_by_hand, bored_by_hand},
    {Function::drilling, only_back, only_back},
    {Function::spindle_code, 3, 5},
    {Function::spindle_code, 19, 19},
    {Function::gear_range, 1, 8},
    {Function::probe_move, 2, 5},
    {Function::thread_by_spindle, 0, 1},
    {Function::coordinate_shift, 0, 1},
    {Function::coordinate_shift_off, 1, 3},
    {Function::table_system, 1, 9},
    {Function::reference_move, 1, 2},
    {Function::reference_store, 1, 2},
    {Function::tool_length, 0, 1},
    {Function::tool_side, 41, 42},
    {Function::tool_side, 411, 411},
    {Function::tool_side, 421, 421},
    {Function::digital_output, 62, 65},
    {Function::analog_output, 67, 68},
    {Function::override_switch, 50, 53},
    {Function::modes_kept, 70, 73},
    {Function::diameter_mode, 0, 1},
    {Function::stored_move, 1, 2},
    {Function::stored_position, 1, 2},
};

/// Functions for modes that use no words. If a row with one of these functions lists words in `takes`, the row is rejected: the list would
/// only hide that the word has no effect in a program.
constexpr Function wordless[] = {
    Function::plane_xy,
    Function::plane_zx,
    Function::plane_yz,
    Function::absolute,
    Function::incremental,
    Function::centers_absolute,
    Function::centers_incremental,
    Function::inch,
    Function::millimetre,
    Function::exact_stop_block,
    Function::exact_stop_mode,
    Function::corner_arc,
    Function::corner_line,
    Function::polar_off,
    Function::rotation_off,
    Function::scale_off,
    Function::retract_initial,
    Function::retract_level,
    Function::length_off,
    Function::work_zero,
    Function::polar_surface_off,
    Function::scaling_off,
    Function::plane_rotation_off,
    Function::drilling_off,
    Function::feed_control,
    Function::work_area_off,
    Function::polar_data_on,
    Function::tool_length_off,
};

/// Functions that work only with certain address letters, which are fixed in the engine. For example, only G and M can be letters of codes.
struct LetterRow {
  Function function;
  std::string_view letters;
};
constexpr LetterRow letters_of[] = {
    {Function::block_number, "N"},         {Function::code, "GM"},         {Function::feed_word, "F"},
    {Function::speed_word, "S"},           {Function::tool_word, "T"},     {Function::offset_word, "D"},
    {Function::repeat_word, "H"},          {Function::call_word, "L"},     {Function::label, "O"},
    {Function::corrector_word, "L"},       {Function::spindle_word, "S"},  {Function::tool_call, "T"},
    {Function::length_number, "H"},        {Function::radius_number, "D"}, {Function::formal_parameter, "R"},
    {Function::machine_axis, "XYZUVWABC"}, {Function::tool_of_table, "T"}, {Function::speed_of_spindle, "S"},
};

/// Returns true for functions of addresses (P, Q …) whose words belong to a code. For such a word, the engine searches the block for the
/// code that uses the word.
bool names_word_of(Function function) { return function == Function::word_of_code || function == Function::dwell_word; }

constexpr std::int32_t drilling_tenths[] = {73_g, 74_g, 76_g, 81_g, 82_g, 83_g, 84_g, 84.2_g, 84.3_g, 85_g, 86_g, 87_g, 88_g, 89_g};

std::string quoted(Function function) { return "'" + std::string(traits_of(function).name) + "'"; }

std::string written(Needs needs) {
  switch (needs) {
    case Needs::nct: return translated(texts::control_file_words::machine_of_nct);
    case Needs::correctors: return "dialect = \"correctors\"";
    case Needs::sections: return "[grammar] section";
    case Needs::rs274: return "dialect = \"linuxcnc\"";
    case Needs::lines: return "dialect = \"grbl\"";
    case Needs::labels: return "[grammar] label";
    default: return "";
  }
}

}  // namespace

bool ControlLoader::has(Needs needs) const {
  switch (needs) {
    case Needs::nct: return def_.machine_axes();
    case Needs::no_nct: return !def_.machine_axes();
    case Needs::correctors: return def_.has_correctors();
    case Needs::sections: return def_.has_sections();
    case Needs::rs274: return def_.has_parameter_file();
    case Needs::lines: return def_.has_lines_alone();
    case Needs::labels: return def_.grammar.label_address != 0;
    default: return true;
  }
}

tl::expected<Function, std::string> ControlLoader::function_of(const toml::table& row, CalledBy by, const std::string& name_of_row) {
  const std::string name = text(row, "does");
  const Function function = function_named(name);
  const auto refused = [&](const std::string& why) { return Failed(place(name_, row, "does") + name_of_row + ": " + why); };
  if (function == Function::count) {
    return refused(name.empty() ? translated(texts::control_file_words::no_function)
                                : translated(texts::control_file_words::unknown_function, name) + nearest_hint(nearest_function(name, by)));
  }
  if (traits_of(function).by != by)
    return refused(by == CalledBy::word ? translated(texts::control_file_words::belongs_to_code, quoted(function))
                                        : translated(texts::control_file_words::belongs_to_word, quoted(function)));
  if (has(traits_of(function).needs)) return function;
  if (traits_of(function).needs == Needs::no_nct)
    return refused(translated(texts::control_file_behaviour::does_not_work_with_nct, quoted(function)));
  return refused(translated(texts::control_file_words::needs, quoted(function), written(traits_of(function).needs)));
}

std::string ControlLoader::nearest_function(std::string_view name, CalledBy by) const {
  std::vector<std::string_view> names;
  for (std::size_t i = 0; i < static_cast<std::size_t>(Function::count); ++i) {
    const auto function = static_cast<Function>(i);
    if (traits_of(function).by == by && has(traits_of(function).needs)) names.push_back(traits_of(function).name);
  }
  return std::string(toml_tools::nearest(name, names));
}

/// Checks letter, axis, unit and limits of an address.
Done ControlLoader::check_address(char letter, const toml::table& row, const AddressRow& a) const {
  const std::string who = address_written(letter) + ": ";
  for (const LetterRow& fixed : letters_of)
    if (fixed.function == a.function && fixed.letters.find(letter) == std::string_view::npos)
      return Failed(place(name_, row, "does") + who + translated(texts::control_file_words::is_word_of, quoted(a.function), fixed.letters));
  const Grammar& g = def_.grammar;
  if (a.function == Function::label && g.label_address != letter)
    return Failed(place(name_, row, "does") + who + translated(texts::control_file_words::label_is_another_letter));
  if (a.function == Function::formal_parameter && g.parameter_address != letter)
    return Failed(place(name_, row, "does") + who + translated(texts::control_file_words::formal_parameter_of_grammar, letter));
  const bool has_axis = a.function == Function::axis || a.function == Function::center;
  if (has_axis && !row.contains("axis"))
    return Failed(place(name_, row, "does") + who + translated(texts::control_file_words::needs_axis, quoted(a.function)));
  if (!has_axis) KADR_LOAD(no_effect(row, "axis", who + translated(texts::control_file_words::axis_has_no_effect, quoted(a.function))));
  for (const AddressRow& other : def_.addresses) {
    if (!has_axis || &other == &a || other.letter == 0 || other.function != a.function || other.axis != a.axis) continue;
    const toml::table* const second = file_["address"][address_written(other.letter)].as_table();
    const toml::node* const theirs = second == nullptr ? nullptr : second->get("axis");
    const bool blames_other = !is_own(*row.get("axis")) && theirs != nullptr && is_own(*theirs);
    return Failed((blames_other ? place(name_, *theirs) : place(name_, row, "axis")) + who +
                  translated(texts::control_file_words::axis_has_word, def_.axes[a.axis], address_written(other.letter)));
  }
  const bool acts = a.function != Function::word_of_code && a.function != Function::center && a.function != Function::axis;
  const bool is_number = a.function != Function::code && a.function != Function::block_number && a.function != Function::label;
  if (!acts || !is_number)
    KADR_LOAD(no_effect(row, "phase", who + translated(texts::control_file_words::phase_has_no_effect, quoted(a.function))));
  if (!is_number) KADR_LOAD(no_effect(row, "scale", who + translated(texts::control_file_words::scale_has_no_effect, quoted(a.function))));
  if (a.function != Function::corrector_word && row["second"].value_or(false))
    return Failed(place(name_, row, "second") + who + translated(texts::control_file_words::second_needs_corrector_word));
  const bool of_nct = def_.machine_axes();
  if (!of_nct && (a.function == Function::block_number || a.function == Function::label))
    for (const char* key : {"least", "most", "whole"})
      KADR_LOAD(no_effect(row, key, who + translated(texts::control_file_words::limit_has_no_effect, key, quoted(a.function))));
  if (!(std::isfinite(a.scale) && a.scale != 0))
    return Failed(place(name_, row, "scale") + who + translated(texts::control_file_words::scale_is_zero));
  if (!(a.least <= a.most)) return Failed(place(name_, row, "least") + who + translated(texts::control_file_words::least_above_most));
  return {};
}

/// Checks `arg` of a row of [g] or [m], and the words that the row needs.
Done ControlLoader::check_code(const toml::table& row, const CodeRow& c) const {
  const std::string who = c.code + ": ";
  const auto of_function = [&](const ArgRow& a) { return a.function == c.function; };
  const bool has_arg = std::any_of(std::begin(args), std::end(args), of_function);
  if (!has_arg) KADR_LOAD(no_effect(row, "arg", who + translated(texts::control_file_codes::arg_has_no_effect, quoted(c.function))));
  if ((c.takes != 0 || c.takes_all_axes) && std::find(std::begin(wordless), std::end(wordless), c.function) != std::end(wordless))
    KADR_LOAD(no_effect(row, "takes", who + translated(texts::control_file_codes::takes_has_no_effect, quoted(c.function))));
  const auto fits = [&](const ArgRow& a) { return of_function(a) && c.arg >= a.least && c.arg <= a.most; };
  if (has_arg && !std::any_of(std::begin(args), std::end(args), fits)) {
    std::string numbers;
    for (const ArgRow& a : args)
      if (of_function(a))
        numbers += (numbers.empty() ? "" : ", ") +
                   (a.most > a.least ? translated(texts::control_file_codes::number_to_number, a.least, a.most) : std::to_string(a.least));
    return Failed(place(name_, row, "arg") + who + translated(texts::control_file_codes::arg_must_be, quoted(c.function), numbers));
  }
  if (c.function == Function::drilling && c.arg == 0 &&
      std::find(std::begin(drilling_tenths), std::end(drilling_tenths), c.letter == 'G' ? c.tenth : 0) == std::end(drilling_tenths))
    return Failed(place(name_, row, "does") + who + translated(texts::control_file_codes::drilling_codes));
  if (c.function == Function::fixture && c.arg > static_cast<int>(def_.behaviour.fixtures))
    return Failed(place(name_, row, "arg") + who + translated(texts::control_file_codes::arg_beyond_fixtures));
  if (c.letter == 'M' && traits_of(c.function).takes_axes() && (c.function == Function::rapid || c.function == Function::linear || c.modal))
    return Failed(place(name_, row, "does") + who + translated(texts::control_file_codes::mode_is_for_g, quoted(c.function)));
  if (c.function == Function::machine_function && c.letter != 'M')
    return Failed(place(name_, row, "does") + who + translated(texts::control_file_codes::machine_function_is_for_m));
  for (std::size_t i = 0; i < max_addresses; ++i) {
    const AddressRow& a = def_.addresses[i];
    const bool needed = (c.needs >> i & 1u) != 0;
    if (needed && a.function == Function::count && !(def_.grammar.zero_between_slashes && i == 0))
      return Failed(place(name_, row, "needs") + who +
                    translated(texts::control_file_codes::needs_no_address, address_written(static_cast<char>('A' + static_cast<int>(i)))));
    if (needed && names_word_of(a.function) && a.function == Function::word_of_code && (c.takes >> i & 1u) == 0)
      return Failed(place(name_, row, "needs") + who + translated(texts::control_file_codes::needs_not_taken, address_written(a.letter)));
  }
  if (c.function == Function::dwell && (c.takes & ((std::uint64_t{1} << 26) - 1)) == 0)
    return Failed(place(name_, row, "takes") + who + translated(texts::control_file_codes::dwell_takes_time));
  return {};
}

}  // namespace kadr
