// The section [behaviour] of a control file: how the engine's functions act where controls differ. For control_loader_words.

#include <set>

#include "config/control_loader.h"
#include "config/range.h"

namespace kadr {

using loader_texts::say;
using toml_tools::place;

Done ControlLoader::behaviour() {
  const toml::table* const t = section("behaviour");
  if (t == nullptr) return {};
  Behaviour& b = def_.behaviour;
  std::set<std::string_view> known = {"arc_centers", "length_offset"};
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
  flag("arc_radius_word", b.arc_radius_word);
  number("result_most", b.result_most, ranges::any);
  number("arc_radius_difference", b.arc_radius_difference, ranges::distance);
  number("arc_difference_inch", b.arc_difference_inch, ranges::distance);
  flag("arc_angle_even", b.arc_angle_even);
  flag("helix_by_lead", b.helix_by_lead);
  number("feed_most", b.feed_most, ranges::feed);
  flag("feed_required", b.feed_required);
  number("reference_feed", b.reference_feed, ranges::feed);
  number("return_chip_break", b.return_chip_break, ranges::distance);
  number("return_near", b.return_near, ranges::distance);
  number("probe_least_distance", b.probe_least_distance, ranges::distance);
  number("probe_retract", b.probe_retract, ranges::distance);
  flag("probe_in_inverse_time", b.probe_in_inverse_time);
  flag("speed_needs_direction", b.speed_needs_direction);
  flag("tool_in_spindle", b.tool_in_spindle);
  flag("skip_asks", b.skip_asks);
  flag("tool_and_corrector", b.tool_and_corrector);
  flag("contour_entry_tangent", b.contour_entry_tangent);
  flag("contour_queued", b.contour_queued);
  flag("contour_blocks_checked", b.contour_blocks_checked);
  flag("zero_change_checked", b.zero_change_checked);
  flag("subprogram_zero_local", b.subprogram_zero_local);
  flag("subprograms_by_section", b.subprograms_by_section);
  flag("end_required", b.end_required);
  flag("ends_reading", b.ends_reading);
  flag("goes_on_behind_end", b.goes_on_behind_end);
  flag("delayed_assignment", b.delayed_assignment);
  flag("feed_of_axis", b.feed_of_axis);
  flag("label_is_number", b.label_is_number);
  flag("diameter_by_setup", b.diameter_by_setup);
  flag("last_word_counts", b.last_word_counts);
  flag("arc_radius_first", b.arc_radius_first);
  flag("arc_without_centre_straight", b.arc_without_centre_straight);
  flag("rapids_apart", b.rapids_apart);
  flag("dwell_in_milliseconds", b.dwell_in_milliseconds);
  flag("repeats_in_program_number", b.repeats_in_program_number);
  flag("later_argument_counts", b.later_argument_counts);
  flag("drills_by_level", b.drills_by_level);
  flag("machine_move_absolute", b.machine_move_absolute);
  flag("second_reference_usual", b.second_reference_usual);
  flag("repeats_by_k", b.repeats_by_k);
  flag("dwell_by_point", b.dwell_by_point);
  flag("shifts_by_q", b.shifts_by_q);
  flag("taps_rigid", b.taps_rigid);
  flag("pecks_by_ijk", b.pecks_by_ijk);
  flag("reference_outside_cycles", b.reference_outside_cycles);
  flag("compensation_in_xy", b.compensation_in_xy);
  flag("reference_all_axes", b.reference_all_axes);
  flag("length_axis_third", b.length_axis_third);
  flag("arc_difference_free", b.arc_difference_free);
  flag("scale_in_increments", b.scale_in_increments);
  flag("common_cleared", b.common_cleared);
  flag("returns_to_own_block", b.returns_to_own_block);
  flag("rounds_words", b.rounds_words);
  flag("machine_codes_listed", b.machine_codes_listed);
  flag("offset_numbers_checked", b.offset_numbers_checked);
  flag("minus_named", b.minus_named);
  flag("repeats_keep_locals", b.repeats_keep_locals);
  flag("words_passed_over", b.words_passed_over);
  flag("own_programs_first", b.own_programs_first);
  flag("feed_counts_increments", b.feed_counts_increments);
  flag("common_is_local_shift", b.common_is_local_shift);
  flag("drills_third", b.drills_third);
  flag("numbers_by_five", b.numbers_by_five);
  flag("label_may_be_zero", b.label_may_be_zero);
  flag("uvw_are_increments", b.uvw_are_increments);
  count("alarm_base", b.alarm_base, 9000);
  count("call_depth", b.call_depth, 255);
  count("m_codes_of_block", b.m_codes_of_block, 8);
  count("program_digits", b.program_digits, 8);
  count("offsets", b.offsets, 9999);
  count("fixtures", b.fixtures, 1000);
  count("further_systems", b.further_systems, most_further_systems);
  const std::string centers = text(*t, "arc_centers");
  if (centers == "by_code") b.arc_centers = ArcCenters::by_code;
  else if (centers == "as_distance") b.arc_centers = ArcCenters::as_distance;
  else if (!centers.empty() && centers != "incremental")
    return Failed(place(name_, *t, "arc_centers") + say("arc_centers: incremental, as_distance or by_code"));
  const std::string length = text(*t, "length_offset");
  if (length == "at_once") b.length_offset = LengthOffset::at_once;
  else if (!length.empty() && length != "next_motion")
    return Failed(place(name_, *t->get("length_offset")) + say("length_offset: at_once or next_motion"));
  for (const auto& [key, node] : *t)
    if (!known.contains(key.str())) return unknown_key(node, key.str(), {known.begin(), known.end()}, "unknown behaviour '{}'");
  return {};
}

}  // namespace kadr
