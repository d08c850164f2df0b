// Reads the words of a block in tool centre point control: I J K as the tool's direction, ,L2 I J K as the surface normal (spec/nct/25h,
// 25i, 25j). Used by control/macro_b/dialect/blocks.

#include <cmath>
#include <utility>

#include "base/code_literals.h"
#include "control/fanuc/drilling/drilling.h"
#include "control/fanuc/fanuc.h"
#include "control/fanuc/five_axis/five_axis_functions.h"
#include "control/fanuc/words/coordinates.h"
#include "control/functions/functions.h"
#include "kinematics/five_axis_tip_path.h"
#include "kinematics/five_axis_transform.h"

namespace kadr::fanuc {
namespace {

constexpr char vector_letters[] = {'I', 'J', 'K'};

/// Returns the mode of tool centre point control that is in force when the block moves, and the table row of the code in the block that
/// sets this mode; nullptr if no code of the block sets it.
std::pair<TipControl, const CodeRow*> tip_control_of_block(const BlockContext& m) {
  for (std::uint32_t i = 0; i < m.block->word_count; ++i) {
    const Word& w = m.block->words[i];
    const std::int32_t index = w.address == 'G' && w.code >= 0 ? m.def.row_of('G', w.code) : -1;
    if (index < 0) continue;
    const CodeRow& row = m.def.codes[static_cast<std::size_t>(index)];
    if (row.function == Function::length_comp) return {TipControl::none, nullptr};
    if (row.function == Function::tool_lead)
      return {row.arg == 43.1_g   ? TipControl::axis
              : row.arg == 43.4_g ? TipControl::tip
              : row.arg == 43.5_g ? TipControl::tip_vector
              : row.arg == 43.8_g ? TipControl::contact
                                  : TipControl::contact_vector,
              &row};
  }
  return {fanuc_of(m).state.five_axis.tip_control, nullptr};
}

std::string_view name_of(TipControl tip_control) { return tip_control == TipControl::tip_vector ? "G43.5" : "G43.9"; }

void hide(BlockContext& m, Word& w) {
  w.address = 0;
  m.block->altered = true;
}

/// Returns true if another code of the block uses the words I J K or P.
bool has_other_taker(const BlockContext& m) {
  return m.has_code({Function::set_tables, Function::tilted_plane, Function::space_rotation, Function::macro_call, Function::macro_modal,
                     Function::work_area_on, Function::vector_corner, Function::radius_side, Function::scaling_on});
}

/// The components I J K of a vector. INFERRED: a component left out is 0 (25.14).
struct Components {
  Vec3 value;
  const Word* first = nullptr;
  bool any() const { return first != nullptr; }
};

/// Reads the words I, J, K whose index in the block is at least `from` and below `to`, and removes them from the block.
Components take_components(BlockContext& m, std::uint32_t from, std::uint32_t to) {
  Components found;
  double* const parts[] = {&found.value.x, &found.value.y, &found.value.z};
  for (std::uint32_t i = from; i < to; ++i) {
    Word& w = m.block->words[i];
    for (std::size_t k = 0; k < 3; ++k) {
      if (w.address != vector_letters[k]) continue;
      *parts[k] = w.value;
      if (found.first == nullptr) found.first = &w;
      hide(m, w);
    }
  }
  return found;
}

/// Reads the surface normal ,L2 I J K (25.17).
Status take_normal(BlockContext& m, TipControl tip_control) {
  FiveAxisState& five = fanuc_of(m).state.five_axis;
  fanuc_of(m).normal_before = five.normal;
  const std::uint32_t count = m.block->word_count;
  std::uint32_t at = 0;
  while (at < count && m.block->words[at].address != comma_vector) ++at;
  if (at == count) return {};
  Word& mark = m.block->words[at];
  if (!controls_contact(tip_control)) return fail(alarm(AlarmId::word_unused, mark.where, m.block->text_of(mark.where)));
  if (mark.value != 2) return fail(alarm(AlarmId::value_out_of_range, mark.where, ",L", mark.value));
  const Components normal = take_components(m, at + 1, count);
  if (!normal.any() || length(normal.value) == 0) return fail(alarm(AlarmId::direction_zero, mark.where, ",L2 I J K"));
  hide(m, mark);
  five.normal = unit(normal.value);
  if (fanuc_of(m).normal_before == Vec3{}) fanuc_of(m).normal_before = five.normal;
  return {};
}

/// Returns `chosen`, or rotary axis positions that avoid a needless swing. Near a singular direction, the tool's direction hardly depends
/// on the position of one rotary axis. If the control's choice turns this axis far although the axis could stay, the result keeps the axis
/// where it is. This rule is not from the manual.
std::optional<RotaryPair> without_rotary_swing(Emitter& m, const Word& where, Vec3 target, RotaryPair present,
                                               const std::optional<RotaryPair>& chosen) {
  constexpr double far = 20;  // degrees
  const Fanuc& fanuc = fanuc_of(m);
  const FiveAxisTransformData& d = space_of(m)->data();
  if (!(fanuc.singular > 0)) return chosen;
  const bool head = d.machine.group == MachineGroup::head_head;
  if (chosen && std::fabs(head ? chosen->first - present.first : chosen->second - present.second) < far) return chosen;
  const auto moved = d.machine.with_one_axis_moved(target, present, d.measured);
  if (!moved || moved->off > fanuc.singular) return chosen;
  constexpr double rounding = 1e-9;  // degrees
  const int axis = moved->first_stays ? d.machine.first.axis : d.machine.second.axis;
  if (moved->off > rounding) m.warn(warning(AlarmId::axis_kept, where.where, m.axis_names[static_cast<std::size_t>(axis)], moved->off));
  return moved->at;
}

/// Replaces the first two of the words I J K by words of the rotary axes, so that the block positions the rotary axes.
Status direct(Emitter& m, TipControl tip_control, const Components& vector, std::uint32_t until) {
  Fanuc& fanuc = fanuc_of(m);
  const FiveAxis& machine = fanuc.settings.five_axis;
  // a machine without five axes: the code that sets the mode raises the alarm, not this function
  if (machine.group == MachineGroup::none) return {};
  if (length(vector.value) == 0) return fail(alarm(AlarmId::direction_zero, vector.first->where, "I J K"));
  const FiveAxisTransform& space = *space_of(m);
  FiveAxisTransformData d = space.data();
  const RotaryPair present = space.rotary(m.position.machine);
  const Vec3 target = unit(vector.value);
  const bool goes_on = fanuc.state.five_axis.posture && fanuc.state.five_axis.tip_control == tip_control;
  const bool leans = fanuc.settings.tilts_tool && !(d.basic == Mat3());
  const Vec3 on_machine = leans ? d.basic * target : target;
  std::optional<RotaryPair> at;
  if (goes_on) {
    // Two opposite tool directions do not define a plane in which the tool could rotate from one direction to the other (25i).
    const Vec3 from = space.direction_of(space.rotary(m.position.machine));
    if (dot(from, on_machine) < -1 + 1e-9) return fail(alarm(AlarmId::lead_angle, vector.first->where, 180.0));
    at = DirectionPath(space, present, from, on_machine, std::nullopt).rotary(1, present);
  } else {
    at = without_rotary_swing(m, *vector.first, on_machine, present, d.machine.chosen(on_machine, present, d.measured));
  }
  if (!at) return fail(alarm(AlarmId::direction_unreachable, vector.first->where, target.x, target.y, target.z));
  RotaryPair programmed = *at;
  if (leans) programmed = d.machine.continued(target, *at, d.measured).value_or(*at);
  const int axes[] = {machine.first.axis, machine.second.axis};
  const double targets[] = {programmed.first, programmed.second};
  std::size_t given = 0;
  for (std::uint32_t i = 0; i < until && given < 2; ++i) {
    Word& w = m.block->words[i];
    if (w.address != 0 || w.written < 'I' || w.written > 'K') continue;
    const auto axis = static_cast<std::size_t>(axes[given]);
    w.address = m.letters.axis_letter[axis];
    fanuc.by_direction |= AxisMask{1} << axis;
    fanuc.directed[axis] = targets[given];
    ++given;
  }
  // if the vector has fewer words than the machine has rotary axes, the other axes are positioned without words
  for (; given < 2; ++given) {
    const auto axis = static_cast<std::size_t>(axes[given]);
    fanuc.by_direction |= AxisMask{1} << axis;
    fanuc.directed[axis] = targets[given];
  }
  return {};
}

/// Executes the words I J K of G43.5, G43.9, which give the tool's direction. Words of the rotary axes raise an alarm (25.14).
Status take_direction(Emitter& m, TipControl tip_control) {
  const FiveAxis& machine = fanuc_of(m).settings.five_axis;
  for (const int axis : {machine.first.axis, machine.second.axis}) {
    if (axis < 0) continue;
    const char letter = m.letters.axis_letter[static_cast<std::size_t>(axis)];
    if (letter != 0 && m.has(letter) &&
        !m.has_code({Function::smoothing, Function::set_tables, Function::machine_move, Function::reference_return}))
      return fail(alarm(AlarmId::lead_words, m.where(letter), name_of(tip_control), letter));
  }
  if (has_other_taker(m)) return {};
  const Components vector = take_components(m, 0, m.block->word_count);
  if (!vector.any()) return {};
  if (!m.has_code({Function::tool_lead}) && space_of(m) == nullptr) return {};
  KADR_TRY(direct(m, tip_control, vector, m.block->word_count));
  return {};
}

/// Raises an alarm for codes that the manual does not describe together with tool centre point control (INFERRED).
Status nothing_refused(const BlockContext& m, TipControl tip_control) {
  if (!controls_tip(tip_control)) return {};
  for (std::uint32_t i = 0; i < m.block->word_count; ++i) {
    const Word& w = m.block->words[i];
    const std::int32_t index = w.address == 'G' && w.code >= 0 ? m.def.row_of('G', w.code) : -1;
    if (index < 0) continue;
    const CodeRow& row = m.def.codes[static_cast<std::size_t>(index)];
    switch (row.function) {
      case Function::radius_side:
        if (row.arg == 0) continue;
        break;
      case Function::drilling:
        if (row.tenth == 80_g) continue;
        break;
      case Function::space_rotation:
      case Function::tilted_plane:
      case Function::tool_orientation:
      case Function::dynamic_zero:
      case Function::cylinder_mode:
      case Function::polar_surface_on:
      case Function::polar_data_on:
      case Function::thread:
      case Function::turning_cycle:
      case Function::turning_simple:
      case Function::measure:
      case Function::measure_length: break;
      default: continue;
    }
    const std::int32_t code = tip_control == TipControl::tip          ? 43.4_g
                              : tip_control == TipControl::tip_vector ? 43.5_g
                              : tip_control == TipControl::contact    ? 43.8_g
                                                                      : 43.9_g;
    const CodeRow& tip_control_row = m.def.codes[static_cast<std::size_t>(m.def.row_of('G', code))];
    return fail(alarm(AlarmId::lead_state, w.where, row.code, tip_control_row.code));
  }
  return {};
}

}  // namespace

bool watches_words(const BlockContext& m) {
  const FiveAxisState& five = fanuc_of(m).state.five_axis;
  return five.plane.kind != 0 || by_vector(five.tip_control) || controls_contact(five.tip_control) || five.posture;
}

bool watches_codes(const BlockContext& m) { return controls_tip(fanuc_of(m).state.five_axis.tip_control) && m.has('G'); }

Status five_axis_block(Emitter& m) {
  const FiveAxisState& five = fanuc_of(m).state.five_axis;
  if (five.plane.kind != 0) KADR_TRY(finish_plane(m));
  const bool has_comma = (m.block->letters & letter_bit(comma_vector)) != 0;
  const bool coded = m.has('G') && m.has_code({Function::tool_lead});
  if (!coded && !has_comma && !controls_tip(five.tip_control)) return {};
  const auto [tip_control, row] = tip_control_of_block(m);
  (void)row;
  if (!coded) KADR_TRY(nothing_refused(m, five.tip_control));
  KADR_TRY(take_normal(m, tip_control));
  if (by_vector(tip_control)) KADR_TRY(take_direction(m, tip_control));
  if (m.block->altered) m.note_addresses();
  return {};
}

}  // namespace kadr::fanuc
