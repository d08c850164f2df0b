// CodeMatch: matches the codes of two controls by their functions. Used by convert/block_rewriter; tested by tests/convert.

#include "convert/code_match.h"

#include <algorithm>
#include <array>
#include <utility>

#include "out/program/codes.h"

namespace kadr {
namespace {

struct Meaning {
  Function function = Function::count;
  int arg = 0;  // argument of the function in the control's table; the value any_argument matches every argument
};

/// Each row lists functions that have the same effect on controls of different families.
constexpr std::array<std::array<Meaning, 4>, 35> families = {{
    {{{Function::plane_xy, any_argument}, {Function::select_plane, 17}}},
    {{{Function::plane_zx, any_argument}, {Function::select_plane, 18}}},
    {{{Function::plane_yz, any_argument}, {Function::select_plane, 19}}},
    {{{Function::spindle_cw, any_argument}, {Function::spindle_code, 3}}},
    {{{Function::spindle_ccw, any_argument}, {Function::spindle_code, 4}}},
    {{{Function::spindle_stop, any_argument}, {Function::spindle_code, 5}}},
    {{{Function::spindle_orient, any_argument}, {Function::spindle_code, 19}}},
    {{{Function::radius_comp_off, any_argument}, {Function::radius_side, 0}, {Function::compensation_off, any_argument}}},
    {{{Function::radius_comp_left, any_argument}, {Function::radius_side, 1}, {Function::tool_side, 41}}},
    {{{Function::radius_comp_right, any_argument}, {Function::radius_side, 2}, {Function::tool_side, 42}}},
    {{{Function::length_plus, any_argument}, {Function::length_comp, 1}, {Function::tool_length, 0}}},
    {{{Function::length_minus, any_argument}, {Function::length_comp, 2}}},
    {{{Function::length_off, any_argument}, {Function::length_comp, 0}, {Function::tool_length_off, any_argument}}},
    {{{Function::surface_speed, any_argument}, {Function::css_on, any_argument}, {Function::surface_speed_limited, 0}}},
    {{{Function::spindle_rpm, any_argument}, {Function::css_off, any_argument}, {Function::surface_speed_limited, 1}}},
    {{{Function::change_tool, any_argument}, {Function::exchange_tool, any_argument}, {Function::load_tool, any_argument}}},
    {{{Function::dwell, any_argument}, {Function::dwell_or_turns, any_argument}}},
    {{{Function::drilling_off, any_argument}, {Function::no_motion, any_argument}}},
    {{{Function::call_subprogram, any_argument}, {Function::call_program, any_argument}, {Function::call_numbered, any_argument}}},
    {{{Function::subprogram_return, any_argument},
      {Function::return_program, any_argument},
      {Function::return_numbered, any_argument},
      {Function::subprogram_end, any_argument}}},
    {{{Function::program_end, any_argument}, {Function::tape_end, any_argument}}},
    {{{Function::probe, any_argument}, {Function::measure, any_argument}, {Function::probe_move, 2}}},
    {{{Function::set_position, any_argument}, {Function::coordinate_shift, 0}, {Function::new_system, any_argument}}},
    {{{Function::set_position_reset, any_argument}, {Function::coordinate_shift_off, any_argument}}},
    {{{Function::temporary_shift, any_argument}, {Function::local_system, any_argument}, {Function::coordinate_shift, 1}}},
    {{{Function::machine_coordinates, any_argument}, {Function::machine_block, any_argument}, {Function::machine_move, any_argument}}},
    {{{Function::rotation_on, any_argument}, {Function::plane_rotation_on, any_argument}}},
    {{{Function::rotation_off, any_argument}, {Function::plane_rotation_off, any_argument}}},
    {{{Function::scale_on, any_argument}, {Function::scaling_on, any_argument}}},
    {{{Function::scale_off, any_argument}, {Function::scaling_off, any_argument}}},
    {{{Function::set_data, any_argument},
      {Function::table_data, any_argument},
      {Function::stored_offsets, any_argument},
      {Function::set_tables, any_argument}}},
    {{{Function::home_through, any_argument},
      {Function::reference_return, any_argument},
      {Function::reference_move, any_argument},
      {Function::stored_move, any_argument}}},
    {{{Function::polar_on, any_argument}, {Function::polar_data_on, any_argument}}},
    {{{Function::constant_velocity, any_argument}, {Function::feed_control, continuous_cutting}}},
    {{{Function::polar_off, any_argument}, {Function::polar_data_off, any_argument}}},
}};

bool is_zero(Function function) {
  return function == Function::work_zero || function == Function::fixture || function == Function::work_system ||
         function == Function::table_system;
}

bool same_argument(const CodeRow& a, int arg) { return arg == any_argument || a.arg == arg; }

const CodeRow* first_that(const ControlDef& to, const std::string& liked, const auto& does) {
  const CodeRow* found = nullptr;
  for (const CodeRow& row : to.codes) {
    if (!row.works || !does(row)) continue;
    if (row.code == liked) return &row;
    if (found == nullptr) found = &row;
  }
  return found;
}

const CodeRow* match_of(const CodeRow& row, const ControlDef& from, const ControlDef& to) {
  if (!row.works) return nullptr;
  if (is_canned_cycle(row)) {
    if (row.cycle != 0) {
      const std::vector<CycleStep>& steps = from.cycles[row.cycle - 1U].steps;
      if (const CodeRow* const same = first_that(to, row.code, [&](const CodeRow& one) {
            return one.cycle != 0 && !steps.empty() && to.cycles[one.cycle - 1U].steps == steps;
          }))
        return same;
    }
    return first_that(to, row.code, [&](const CodeRow& one) { return is_canned_cycle(one) && one.code == row.code; });
  }
  if (is_zero(row.function))
    return first_that(to, row.code, [&](const CodeRow& one) { return is_zero(one.function) && one.arg == row.arg; });
  if (const CodeRow* const same = first_that(
          to, row.code, [&](const CodeRow& one) { return one.function == row.function && one.arg == row.arg && one.cycle == 0; })) {
    if (row.function != Function::machine_function || same->code == row.code) return same;
    return nullptr;  // M codes that go to the machine keep their number, so they are not matched by function
  }
  for (const auto& family : families) {
    if (std::none_of(family.begin(), family.end(),
                     [&](const Meaning& one) { return one.function == row.function && same_argument(row, one.arg); }))
      continue;
    for (const Meaning& one : family)
      if (one.function != Function::count)
        if (const CodeRow* const same = first_that(to, row.code, [&](const CodeRow& other) {
              return other.function == one.function && same_argument(other, one.arg) && other.cycle == 0;
            }))
          return same;
  }
  return nullptr;
}

}  // namespace

bool is_canned_cycle(const CodeRow& row) {
  return row.function == Function::cycle || row.function == Function::drilling || row.function == Function::canned_cycle;
}

bool ends_cycles(const CodeRow& row) { return row.function == Function::drilling_off || row.function == Function::no_motion; }

CodeMatch::CodeMatch(const ControlDef& from, const ControlDef& to) : from_(from), to_(to) {
  rows_.reserve(from.codes.size());
  for (const CodeRow& row : from.codes) {
    const CodeRow* const match = match_of(row, from, to);
    rows_.push_back(match == nullptr ? -1 : static_cast<int>(match - to.codes.data()));
  }
}

}  // namespace kadr
