// Checks settings of a control file that need or exclude each other. A setting that the engine cannot execute is always rejected. A key
// that has no effect together with the other keys is rejected only in the user's own file. Tested by the same tests as
// control_loader_functions.cpp.

#include <algorithm>
#include <cmath>

#include "config/control/control_loader.h"
#include "texts/control_file.h"
#include "texts/control_file_behaviour.h"
#include "texts/control_file_codes.h"
#include "texts/control_file_cycles.h"
#include "texts/control_file_grammar.h"
#include "texts/control_file_variables.h"

namespace kadr {

using toml_tools::place;

namespace {

/// Settings of [grammar] that have an effect only on the machine of the NCT (dialect = "nct").
constexpr std::pair<std::string_view, bool Grammar::*> nct_grammar[] = {
    {"macro", &Grammar::custom_macros},
    {"operator_i", &Grammar::operator_i},
    {"comma_words", &Grammar::comma_words},
    {"file_names", &Grammar::file_names},
};

/// A key of [behaviour] and the functions that read it. If the control has none of these functions, the key has no effect.
struct ReadBy {
  std::string_view key;
  std::vector<Function> functions;
};
const std::vector<ReadBy>& behaviour_of_functions() {
  static const std::vector<ReadBy> rows = {
      {"arc_centers", {Function::arc_cw, Function::arc_ccw}},
      {"arc_radius_word", {Function::arc_cw, Function::arc_ccw}},
      {"arc_radius_difference", {Function::arc_cw, Function::arc_ccw}},
      {"feed_of_axis", {Function::feed_word}},
      {"feed_most", {Function::feed_word}},
      {"reference_feed", {Function::approach_reference}},
      {"probe_least_distance", {Function::probe}},
      {"probe_in_inverse_time", {Function::probe}},
      {"speed_needs_direction", {Function::speed_word}},
      {"tool_and_corrector", {Function::tool_word}},
      {"compensation_entry", {Function::radius_comp_left, Function::radius_comp_right, Function::tool_side}},
      {"fixtures", {Function::fixture, Function::set_data, Function::table_system}},
      {"return_chip_break", {Function::cycle}},
      {"return_near", {Function::cycle}},
  };
  return rows;
}

/// Keys of [behaviour] that have no effect on the machine of the NCT (dialect = "nct"), because parameters of the control replace them.
constexpr std::string_view not_of_nct[] = {
    "arc_centers",        "reference_feed",        "return_chip_break",  "return_near",        "probe_least_distance",
    "tool_and_corrector", "speed_needs_direction", "compensation_entry", "delayed_assignment", "fixtures"};

/// Keys of [behaviour] that have an effect only on the machine of the NCT (dialect = "nct").
constexpr std::string_view only_of_nct[] = {
    "later_word_counts",   "dwell_unit",         "repeats_in_program_number", "cycle_words", "machine_move_absolute",
    "repeats_by_k",        "reference_all_axes", "tool_along_third",          "alarm_base",  "returns_to_own_block",
    "repeats_keep_locals", "further_systems",    "m_codes_of_block",          "lathe"};

/// Functions that act in a plane, or along the axis perpendicular to a plane.
constexpr Function plane_functions[] = {
    Function::arc_cw,     Function::arc_ccw,     Function::cycle,        Function::circular_pocket,  Function::plane_xy,
    Function::plane_zx,   Function::plane_yz,    Function::polar_on,     Function::rotation_on,      Function::pole_rapid,
    Function::pocket_run, Function::length_plus, Function::length_minus, Function::radius_comp_left, Function::radius_comp_right,
    Function::call_word,  Function::probe,
};

/// A function, and the kind of system variables that store its data.
struct Stores {
  Function function;
  int arg;  // value of the key `arg` that the rows of the system variables must have; -1: any value
  VariableKind kind;
  std::string_view name;
};
constexpr Stores stores[] = {
    {Function::home_through, 1, VariableKind::home, "home"},
    {Function::home_through, 2, VariableKind::home_second, "home_second"},
    {Function::fixture, -1, VariableKind::fixture, "fixture"},
    {Function::set_data, -1, VariableKind::fixture, "fixture"},
    {Function::set_position_restore, -1, VariableKind::set_position, "set_position"},
};

constexpr std::uint32_t stored_axes = 6;  // number of axes for which the system variables store the coordinates of a point

}  // namespace

/// Returns true if at least one row of the control calls one of these functions.
bool ControlLoader::does(std::initializer_list<Function> functions) const {
  const auto one_of = [&](Function f) { return std::find(functions.begin(), functions.end(), f) != functions.end(); };
  return std::any_of(def_.codes.begin(), def_.codes.end(), [&](const CodeRow& row) { return one_of(row.function); }) ||
         std::any_of(def_.addresses.begin(), def_.addresses.end(), [&](const AddressRow& row) { return one_of(row.function); });
}

/// Checks that a control has both the machine and the program language of the NCT (dialect = "nct"), or neither. One of them does not work
/// without the other.
Done ControlLoader::check_machine() {
  const Grammar& g = def_.grammar;
  const toml::table* const words = section("grammar");
  const toml::table* const behaves = section("behaviour");
  // Returns the location for an error sentence: of the key, or of `dialect` if the user's own file sets the dialect
  const auto at = [&](std::string_view key) {
    const toml::node* const own = file_.get("dialect");
    const bool blames_machine = own != nullptr && is_own(*own);
    if (blames_machine) return place(name_, *own);
    return words == nullptr ? name_ + ": " : place(name_, *words, key);
  };
  for (const auto& [key, flag] : nct_grammar)
    if (g.*flag && !def_.machine_axes()) return Failed(at(key) + translated(texts::control_file_behaviour::grammar_needs_nct, key));
  if (!def_.machine_axes()) return {};
  if (!g.custom_macros || !g.expressions)
    return Failed(at(g.custom_macros ? "expressions" : "macro") + translated(texts::control_file_behaviour::nct_needs_macro));
  if (file_.get("parameters") == nullptr) return Failed(at("macro") + translated(texts::control_file_behaviour::nct_needs_parameters));
  if (g.variables < 100'000) return Failed(at("variables") + translated(texts::control_file_behaviour::nct_needs_variables));
  if (g.label_address != 'O') return Failed(at("label") + translated(texts::control_file_behaviour::nct_needs_label));
  for (const auto& [key, on] : {std::pair<std::string_view, bool>{"formal_parameter", g.parameter_address != 0},
                                {"section", g.section_address != 0},
                                {"zero_between_slashes", g.zero_between_slashes},
                                {"block_number_required", g.block_number_required},
                                {"main_blocks", g.main_blocks}})
    if (on) return Failed(at(key) + translated(texts::control_file_behaviour::does_not_work_with_nct, "[grammar] " + std::string(key)));
  for (const std::string_view key : not_of_nct)
    KADR_LOAD(no_effect(*behaves, key, translated(texts::control_file_behaviour::no_effect_with_nct, key)));
  // The key `diameter` has no effect on an NCT, because its parameters and the set-up state which axes are programmed as diameters.
  KADR_LOAD(no_effect(*section("axes"), "diameter", translated(texts::control_file_behaviour::no_effect_with_nct, "diameter")));
  return {};
}

Done ControlLoader::check_grammar() {
  const toml::table* const t = section("grammar");
  if (t == nullptr) return {};
  const Grammar& g = def_.grammar;
  const auto function_at = [&](char letter) { return def_.addresses[static_cast<std::size_t>(letter - 'A')].function; };
  const auto letter_is = [&](char letter, Function function, const char* key) -> Done {
    if (letter == 0 || function_at(letter) == function) return {};
    return Failed(place(name_, *t, key) + translated(texts::control_file_grammar::address_must_do, key, letter, traits_of(function).name));
  };
  KADR_LOAD(letter_is(g.parameter_address, Function::formal_parameter, "formal_parameter"));
  KADR_LOAD(letter_is(g.label_address, Function::label, "label"));
  KADR_LOAD(letter_is(g.section_address, Function::call_word, "section"));
  if (g.expressions && g.parameter_address != 0)
    return Failed(place(name_, *t, "expressions") + translated(texts::control_file_grammar::expressions_and_formal_parameter));
  if (g.percent_ignored && g.program_start_required)
    return Failed(place(name_, *t, "percent_ignored") + translated(texts::control_file_grammar::percent_ignored_but_required));
  if (g.label_address != 0 && g.section_address != 0)
    return Failed(place(name_, *t, "label") + translated(texts::control_file_grammar::label_and_section));
  const auto pointless = [&](bool is_so, std::string_view key, TextId<1> why) -> Done {
    return is_so ? no_effect(*t, key, translated(why, key)) : Done();
  };
  KADR_LOAD(
      pointless(!g.percent_number || g.percent_ignored, "percent_digits", texts::control_file_grammar::no_effect_without_percent_number));
  KADR_LOAD(
      pointless(g.percent_number && g.percent_ignored, "percent_number", texts::control_file_grammar::no_effect_beside_percent_ignored));
  KADR_LOAD(pointless(g.end_of_block == EndOfBlock::line_only, "mark_everywhere", texts::control_file_grammar::no_effect_with_line_only));
  KADR_LOAD(pointless(g.parameter_address == 0, "parameters_in", texts::control_file_grammar::no_effect_without_formal_parameter));
  KADR_LOAD(pointless(!g.expressions && def_.variables.empty() && g.variables != 0, "variables",
                      texts::control_file_grammar::no_effect_without_expressions));
  KADR_LOAD(pointless(g.zero_between_slashes && !does({Function::zero_shift}), "zero_between_slashes",
                      texts::control_file_grammar::no_effect_without_zero_shift));
  if (const toml::table* const most = (*t)["most_codes"].as_table())
    for (const auto& [letter, node] : *most)
      if (function_at(letter.str()[0]) == Function::count)
        KADR_LOAD(no_effect(*most, letter.str(), translated(texts::control_file_grammar::most_codes_no_address, letter.str())));
  return {};
}

Done ControlLoader::check_behaviour() {
  const toml::table* const t = section("behaviour");
  if (t == nullptr) return {};
  const Behaviour& b = def_.behaviour;
  const std::pair<const char*, double> lengths[] = {
      {"arc_radius_difference", b.arc_radius_difference}, {"feed_most", b.feed_most},     {"reference_feed", b.reference_feed},
      {"return_chip_break", b.return_chip_break},         {"return_near", b.return_near}, {"probe_least_distance", b.probe_least_distance}};
  for (const auto& [key, value] : lengths)
    if (!(value >= 0 && value <= 1e6)) return Failed(place(name_, *t, key) + translated(texts::control_file::must_be_to_million, key));
  if (!(b.reference_feed > 0))
    return Failed(place(name_, *t, "reference_feed") + translated(texts::control_file::must_be_positive, "reference_feed"));
  if (b.call_depth == 0)
    return Failed(place(name_, *t, "call_depth") + translated(texts::control_file::must_be_whole, "call_depth", 1, 255));
  if (b.fixtures == 0) return Failed(place(name_, *t, "fixtures") + translated(texts::control_file::must_be_whole, "fixtures", 1, 1000));
  if (def_.has_correctors() && !does({Function::corrector_word}))
    return Failed(place(name_, file_, "dialect") + translated(texts::control_file_behaviour::correctors_need_l));
  if (def_.machine_axes()) return {};
  for (const std::string_view key : only_of_nct)
    KADR_LOAD(no_effect(*t, key, translated(texts::control_file_variables::key_needs_nct, key)));
  for (const ReadBy& row : behaviour_of_functions()) {
    const bool looked_at = std::any_of(row.functions.begin(), row.functions.end(), [&](Function f) { return does({f}); });
    if (!looked_at)
      KADR_LOAD(no_effect(*t, row.key,
                          translated(texts::control_file_behaviour::needs_row_that_does, row.key, traits_of(row.functions[0]).name)));
  }
  if (!def_.grammar.expressions && b.delayed_assignment)
    KADR_LOAD(no_effect(*t, "delayed_assignment", translated(texts::control_file_behaviour::delayed_assignment_needs_expressions)));
  return {};
}

/// Checks that every axis has an address, and that a control with functions in a plane has three axes.
Done ControlLoader::check_axes() const {
  if (def_.machine_axes()) return {};
  const auto words = [&](Function function) {
    std::uint32_t axes = 0;
    for (const AddressRow& row : def_.addresses)
      if (row.function == function) axes |= 1u << row.axis;
    return axes;
  };
  const toml::table& t = *file_["axes"].as_table();
  const std::uint32_t named = words(Function::axis), centers = words(Function::center);
  for (std::size_t a = 0; a < def_.axes.size(); ++a)
    if ((named >> a & 1u) == 0) return Failed(place(name_, t, "names") + translated(texts::control_file::axis_without_word, def_.axes[a]));
  const auto in_plane = [&](const CodeRow& row) {
    return std::find(std::begin(plane_functions), std::end(plane_functions), row.function) != std::end(plane_functions);
  };
  if (def_.axes.size() < 3)
    if (const auto row = std::find_if(def_.codes.begin(), def_.codes.end(), in_plane); row != def_.codes.end())
      return Failed(place(name_, t, "names") + translated(texts::control_file::needs_three_axes, row->code, traits_of(row->function).name));
  if (def_.axes.size() < 3 && (def_.has_correctors() || def_.has_sections()))
    return Failed(place(name_, t, "names") + translated(texts::control_file::sections_need_three_axes));
  if (def_.behaviour.helix_by_lead() && (centers & 7u) != 7u)
    return Failed(place(name_, t, "names") + translated(texts::control_file::centers_need_three_axes));
  return {};
}

/// Checks that the control has the system variables that its functions need, and address words for coded feeds and speeds.
Done ControlLoader::check_functions() {
  const auto kept = [&](VariableKind kind) {
    return std::any_of(def_.variables.begin(), def_.variables.end(), [&](const VariableRow& v) { return v.kind == kind; });
  };
  for (const CodeRow& row : def_.codes) {
    const toml::table* const codes = section(row.letter == 'G' ? "g" : "m");
    for (const Stores& s : stores)
      if (s.function == row.function && (s.arg < 0 || s.arg == row.arg) && !kept(s.kind))
        return Failed((codes == nullptr ? name_ + ": " : place(name_, *codes)) +
                      translated(texts::control_file_codes::needs_variables, row.code, traits_of(row.function).name, s.name));
  }
  if (def_.machine_axes() && (!def_.feed_codes.empty() || !def_.speed_codes.empty()))
    return Failed(name_ + ": " + translated(texts::control_file::coded_tables_of_nct));
  if (!def_.feed_codes.empty() && !does({Function::feed_word}))
    return Failed(translated(texts::control_file::coded_table_without_address, name_, "feed_codes", "feed_word"));
  if (!def_.speed_codes.empty() && !does({Function::speed_word}))
    return Failed(translated(texts::control_file::coded_table_without_address, name_, "speed_codes", "speed_word"));
  return {};
}

/// Rejects a cycle that could never end or never start.
Done ControlLoader::check_cycle(const toml::table& row, const CycleRow& c) const {
  const std::string who = translated(texts::control_file_cycles::cycle, c.name);
  const auto has = [&](CycleStep step) { return std::find(c.steps.begin(), c.steps.end(), step) != c.steps.end(); };
  const auto needs = [&](char letter) { return (c.needs & letter_bit_of(letter)) != 0; };
  const bool called = c.name[0] == 'L';
  if (has(CycleStep::passes_by_parameter) && !called)
    return Failed(place(name_, row, "steps") + who + translated(texts::control_file_cycles::by_parameter_is_for_called));
  if (called && c.call_number == 0) return Failed(place(name_, row) + who + translated(texts::control_file_cycles::number_after_l));
  if (called && !def_.has_sections()) return Failed(place(name_, row) + who + translated(texts::control_file_cycles::called_needs_section));
  if (called && def_.grammar.parameter_address == 0)
    return Failed(place(name_, row) + who + translated(texts::control_file_cycles::words_are_formal_parameters));
  if (called && !c.steps.empty() && (c.steps.size() != 1 || c.steps[0] != CycleStep::passes_by_parameter))
    return Failed(place(name_, row, "steps") + who + translated(texts::control_file_cycles::steps_of_called));
  if (called) {
    for (const char* const key : {"needs", "needs_spindle", "needs_spindle_cw"})
      KADR_LOAD(no_effect(row, key, who + translated(texts::control_file_cycles::no_effect_on_called, key)));
    return {};
  }
  if (!c.body.empty() && def_.grammar.long_parameters.empty())
    return Failed(place(name_, row, "body") + who + translated(texts::control_file_cycles::body_is_for_called));
  if (!c.body.empty()) return {};  // a cycle with a body is a permanent subprogram, which has no steps to check
  KADR_LOAD(no_effect(row, "needs_override_off", who + translated(texts::control_file_cycles::override_off_is_for_called)));
  if (!needs('Z') || !needs('R')) return Failed(place(name_, row, "needs") + who + translated(texts::control_file_cycles::needs_z_and_r));
  if ((has(CycleStep::peck_full) || has(CycleStep::peck_break)) && !needs('Q'))
    return Failed(place(name_, row, "needs") + who + translated(texts::control_file_cycles::pecks_need_q));
  return {};
}

/// Rejects a row of [[variables]] whose variable the engine cannot store.
Done ControlLoader::check_variable(const toml::table& row, const VariableRow& v) const {
  if (def_.machine_axes()) return {};
  const std::string kind(row["is"].value_or(std::string()));
  const std::string who = "'" + kind + "': ";
  if (v.kind > VariableKind::fixture || v.kind == VariableKind::free)
    return Failed(place(name_, row, "is") + who + translated(texts::control_file_variables::needs_nct));
  for (const char* const key : {"ranges", "symbol", "first", "arg", "bit", "of", "access", "works"})
    if (row.contains(key)) return Failed(place(name_, row, key) + who + translated(texts::control_file_variables::key_needs_nct, key));
  const VariableRange& range = v.ranges.front();
  const std::uint32_t expected = v.kind == VariableKind::fixture_number ? 1 : stored_axes;
  if (range.count != expected)
    return Failed(place(name_, row, "count") + who + translated(texts::control_file_variables::count_must_be, expected));
  if (v.kind == VariableKind::fixture) {
    if (range.stride < expected)
      return Failed(place(name_, row, "stride") + who + translated(texts::control_file_variables::stride_too_small, expected));
    if (range.repeat < def_.behaviour.fixtures)
      return Failed(place(name_, row, "repeat") + who + translated(texts::control_file_variables::repeat_too_small));
  } else {
    for (const char* const key : {"stride", "repeat"})
      KADR_LOAD(no_effect(row, key, who + translated(texts::control_file_variables::there_is_one, key)));
  }
  // Variables with numbers below 1000 are not system variables but ordinary variables of the program
  constexpr std::uint32_t first_system_variable = 1000;
  const std::uint64_t last = range.from + std::uint64_t{range.stride} * (range.repeat - 1) + range.count - 1;
  if (range.from < first_system_variable || range.repeat == 0)
    return Failed(place(name_, row, "from") + who + translated(texts::control_file_variables::from_too_small));
  if (last > def_.grammar.variables)
    return Failed(place(name_, row, "from") + who + translated(texts::control_file_variables::beyond_variables, last));
  return {};
}

/// Checks a code that is put in force at the end of the program. It may only set a mode, and not move an axis, call a subprogram, stop or
/// end.
Done ControlLoader::check_end_code(const toml::node& node, const CodeRow& c) const {
  const FunctionTraits& traits = traits_of(c.function);
  const bool straight = c.function == Function::rapid || c.function == Function::linear || c.function == Function::mirror_off;
  const bool switches_off = c.function == Function::macro_modal_off || c.function == Function::interrupt_off;
  const bool acts = (traits.takes_axes() && !straight) || (traits.phase == Phase::flow && !switches_off) || traits.phase == Phase::stop ||
                    c.function == Function::machine_function || c.function == Function::gear_range || c.function == Function::change_tool ||
                    c.function == Function::exchange_tool || c.function == Function::dwell || c.function == Function::dwell_or_turns ||
                    c.function == Function::machine_coordinates || !c.works;
  if (acts) return Failed(place(name_, node) + translated(texts::control_file_codes::end_is_no_mode, c.code, traits.name));
  return {};
}

}  // namespace kadr
