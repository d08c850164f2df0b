// Reads the section [behaviour] of a control file: the behaviour of the engine's functions where controls differ. Used by
// control_loader_words.

#include <algorithm>
#include <set>

#include "config/control/control_loader.h"
#include "config/machine/machine_axes.h"
#include "config/range.h"
#include "texts/control_file.h"
#include "texts/control_file_behaviour.h"

namespace kadr {

using toml_tools::place;

namespace {

/// Keys of [behaviour] in earlier versions, each with its replacement.
constexpr std::pair<std::string_view, std::string_view> gone[] = {
    {"helix_by_lead", "arc_centers = \"as_distance\""},
    {"arc_difference_inch", "arc_radius_difference = [0.013, 0.0508]"},
    {"arc_radius_first", "arc_radius_word = \"before_centre\""},
    {"contour_entry_tangent", "compensation_entry = \"tangent\""},
    {"contour_queued", "compensation_entry = \"queued\""},
    {"last_word_counts", "later_word_counts = \"everywhere\""},
    {"later_argument_counts", "later_word_counts = \"arguments\""},
    {"dwell_in_milliseconds", "dwell_unit = \"milliseconds\""},
    {"dwell_by_point", "dwell_unit = \"milliseconds_without_point\""},
    {"drills_by_level", "cycle_words = \"shift_by_q\""},
    {"shifts_by_q", "cycle_words = \"shift_by_q\""},
    {"pecks_by_ijk", "cycle_words = \"pecks_by_ijk\""},
    {"drills_third", "tool_along_third"},
    {"length_axis_third", "tool_along_third"},
    // Keys of earlier versions that have been replaced. The second text of each pair is the row that has the same effect now.
    {"contour_blocks_checked", "[alarms] compensation_two_blocks = {}"},
    {"zero_change_checked", "[alarms] zero_change = {}"},
    {"reference_outside_cycles", "[alarms] reference_in_cycle = {}"},
    {"compensation_in_xy", "[alarms] compensation_plane = {}"},
    {"machine_codes_listed", "[alarms] machine_code_unknown = {}"},
    {"offset_numbers_checked", "[alarms] offset_number_large = {}"},
    {"minus_named", "[alarms] value_below_zero = {}"},
    {"subprograms_by_section", "[grammar] section"},
    {"subprogram_zero_local", "[grammar] section"},
    {"own_programs_first", "[grammar] programs_by_label"},
    {"rounds_words", "[grammar] least_increments"},
    {"uvw_are_increments", "[grammar] operator_i"},
    {"goes_on_behind_end", "dialect = \"grbl\""},
    {"tool_in_spindle", "format = \"… T*02 …\""},
    {"diameter_by_setup", "[axes] diameter = \"setup\""},
    {"numbers_by_five", "program_digits = 5"},
    {"label_may_be_zero", "[address] O = { least = 0 }"},
    {"second_reference_usual", "[g] \"30\" = { needs = \"\" }"},
    {"taps_rigid", "[g] \"84\" = { arg = 842 }"},
    {"common_is_local_shift", "[[variables]] is = \"zero_local\""},
    // Keys of earlier versions that a parameter of the control has replaced. The value of this parameter is in the set-up.
    {"arc_difference_free", "N3410"},
    {"arc_without_centre_straight", "N3403#5"},
    {"scale_in_increments", "N5400#7"},
    {"common_cleared", "N6001#6"},
    {"feed_counts_increments", "N0077, N1403#0"},
};

std::string_view instead_of(std::string_view key) {
  const auto* const found = std::find_if(std::begin(gone), std::end(gone), [&](const auto& row) { return row.first == key; });
  return found == std::end(gone) ? std::string_view() : found->second;
}

constexpr std::string_view choice_keys[] = {"arc_centers",       "arc_radius_word", "length_offset", "compensation_entry",
                                            "later_word_counts", "cycle_words",     "dwell_unit",    "lathe"};

}  // namespace

/// Reads a key whose value must be one of `words`. The words are in the order of the enum's values.
template <class Choice>
Done ControlLoader::choice(const toml::table& row, std::string_view key, std::initializer_list<std::string_view> words, Choice& to) {
  const std::string written = text(row, key);
  if (written.empty()) return {};
  const auto* const found = std::find(words.begin(), words.end(), written);
  if (found != words.end()) {
    to = static_cast<Choice>(found - words.begin());
    return {};
  }
  std::string list;
  for (const std::string_view word : words) list += (list.empty() ? "" : ", ") + std::string(word);
  return Failed(place(name_, row, key) + translated(texts::control_file::must_be_one_of, key, list));
}

Done ControlLoader::choices(const toml::table& t) {
  Behaviour& b = def_.behaviour;
  KADR_LOAD(choice(t, "arc_centers", {"incremental", "as_distance", "by_code"}, b.arc_centers));
  KADR_LOAD(choice(t, "length_offset", {"at_once", "next_motion"}, b.length_offset));
  KADR_LOAD(choice(t, "compensation_entry", {"normal", "tangent", "queued"}, b.compensation_entry));
  KADR_LOAD(choice(t, "later_word_counts", {"nowhere", "arguments", "everywhere"}, b.later_word_counts));
  KADR_LOAD(choice(t, "lathe", {"none", "fanuc", "haas"}, b.lathe));
  KADR_LOAD(choice(t, "cycle_words", {"shift_by_ijk", "shift_by_q", "pecks_by_ijk"}, b.cycle_words));
  KADR_LOAD(choice(t, "dwell_unit", {"seconds", "milliseconds", "milliseconds_without_point"}, b.dwell_unit));
  // In earlier versions the key arc_radius_word had the value true or false
  if (const auto flag = t["arc_radius_word"].value_exact<bool>()) {
    b.arc_radius_word = *flag ? ArcRadius::alone : ArcRadius::none;
    return {};
  }
  return choice(t, "arc_radius_word", {"none", "alone", "before_centre"}, b.arc_radius_word);
}

/// Reads arc_radius_difference: one number, or two numbers, the second for programs in inches; both numbers are in mm.
Done ControlLoader::arc_difference(const toml::table& t) {
  Behaviour& b = def_.behaviour;
  const toml::array* const two = t["arc_radius_difference"].as_array();
  if (two == nullptr) {
    ranged(t, "arc_radius_difference", ranges::distance, b.arc_radius_difference);
    return {};
  }
  double* const to[] = {&b.arc_radius_difference, &b.arc_difference_inch};
  if (two->size() != std::size(to)) return Failed(place(name_, *two) + translated(texts::control_file_behaviour::arc_difference_numbers));
  for (std::size_t i = 0; i < std::size(to); ++i) {
    const auto value = (*two)[i].value<double>();
    if (!value || !is_within(*value, ranges::distance))
      return Failed(place(name_, *two) + translated(texts::control_file_behaviour::arc_difference_numbers));
    *to[i] = *value;
  }
  return {};
}

/// Copies values of the machine from the control's parameter table, for those keys that [behaviour] does not contain.
void ControlLoader::figures() {
  const toml::table* const t = section("behaviour");
  for (const auto& [key, figure] : figures_of_machine)
    for (const ParameterRow& row : def_.parameters)
      if (row.type != ParameterType::bits && !row.means.empty() && row.means.front() == key && (t == nullptr || !t->contains(key)))
        def_.behaviour.*figure = row.initial;
}

Done ControlLoader::behaviour() {
  const toml::table* const t = section("behaviour");
  if (t == nullptr) return {};
  Behaviour& b = def_.behaviour;
  std::set<std::string_view> known = {"arc_radius_difference"};
  for (const std::string_view key : choice_keys) known.insert(key);
  const auto flag = [&](const char* key, bool& to) {
    known.insert(key);
    to = typed(*t, key, to);
  };
  const auto number = [&](const char* key, double& to, const NumberRange& range) {
    known.insert(key);
    ranged(*t, key, range, to);
  };
  const auto count = [&](const char* key, std::uint32_t& to, std::uint32_t most) {
    known.insert(key);
    to = whole(*t, key, to, most);
  };
  number("result_most", b.result_most, ranges::any);
  KADR_LOAD(arc_difference(*t));
  flag("arc_angle_even", b.arc_angle_even);
  number("feed_most", b.feed_most, ranges::feed);
  flag("feed_required", b.feed_required);
  number("reference_feed", b.reference_feed, ranges::feed);
  number("return_chip_break", b.return_chip_break, ranges::distance);
  number("return_near", b.return_near, ranges::distance);
  number("probe_least_distance", b.probe_least_distance, ranges::distance);
  number("probe_retract", b.probe_retract, ranges::distance);
  flag("probe_in_inverse_time", b.probe_in_inverse_time);
  flag("speed_needs_direction", b.speed_needs_direction);
  flag("skip_asks", b.skip_asks);
  flag("tool_and_corrector", b.tool_and_corrector);
  flag("end_required", b.end_required);
  flag("ends_reading", b.ends_reading);
  flag("delayed_assignment", b.delayed_assignment);
  flag("feed_of_axis", b.feed_of_axis);
  flag("label_is_number", b.label_is_number);
  flag("repeats_in_program_number", b.repeats_in_program_number);
  flag("machine_move_absolute", b.machine_move_absolute);
  flag("repeats_by_k", b.repeats_by_k);
  flag("rapids_apart", b.rapids_apart);
  flag("tool_along_third", b.tool_along_third);
  flag("reference_all_axes", b.reference_all_axes);
  flag("returns_to_own_block", b.returns_to_own_block);
  flag("repeats_keep_locals", b.repeats_keep_locals);
  flag("words_passed_over", b.words_passed_over);
  count("alarm_base", b.alarm_base, 9000);
  count("call_depth", b.call_depth, 255);
  count("m_codes_of_block", b.m_codes_of_block, 8);
  count("program_digits", b.program_digits, 8);
  count("offsets", b.offsets, 9999);
  count("fixtures", b.fixtures, 1000);
  count("further_systems", b.further_systems, max_further_systems);
  KADR_LOAD(choices(*t));
  for (const auto& [key, node] : *t)
    if (const std::string_view instead = instead_of(key.str()); !instead.empty())
      return Failed(place(name_, node) + translated(texts::control_file_behaviour::key_has_gone, key.str(), instead));
    else if (!known.contains(key.str()))
      return unknown_key(node, key.str(), {known.begin(), known.end()}, texts::control_file_behaviour::unknown_key);
  return {};
}

}  // namespace kadr
