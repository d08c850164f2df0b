// Writes motions to machine positions: G53, G28, G30. Part of convert/flat/flat_program; tested by tests/convert_open.py.

#include <algorithm>

#include "convert/flat/flat_program.h"

namespace kadr {

/// True if the control has no modal code that cancels the work offsets, but only G53 for a single block.
bool FlatProgram::has_no_zeroless_system() const { return row_that_does(blocks_.def(), {{Function::work_zero, 0}}) == nullptr; }

namespace {

constexpr std::initializer_list<FunctionArg> machine_codes = {
    {Function::machine_coordinates, any_argument}, {Function::machine_block, any_argument}, {Function::machine_move, any_argument}};

const CodeRow* reference_code(const ControlDef& def, int point) {
  // argument of the code in the control's table: 1 for G28, 2 for G30; points above 2 use the row of G30
  const int row = std::min(point, 2);
  const CodeRow* const found = row_that_does(
      def,
      {{Function::reference_return, row}, {Function::home_through, row}, {Function::reference_move, row}, {Function::stored_move, row}});
  return found != nullptr && (point <= 2 || found->function == Function::reference_return) ? found : nullptr;
}

}  // namespace

/// True if the target control has a modal code that cancels the work offset (G53 of the 2С42 and of GOST). Words after this code are
/// machine coordinates, except for the tool length.
bool FlatProgram::is_without_zero(const Motion& motion) const {
  return form_ != FlatForm::plain && motion.end_reference == EndReference::by_machine &&
         row_that_does(blocks_.def(), machine_codes) == nullptr && !has_no_zeroless_system();
}

Status FlatProgram::motion_without_zero(Function function, const Motion& motion) {
  const CodeRow* const with_zero = row_that_does(blocks_.def(), {{Function::work_zero, motion.system}});
  if (motion.system != 0 && with_zero == nullptr) return no_code("machine_coordinates");
  if (relative_) KADR_TRY(blocks_.code({{Function::absolute, any_argument}}));
  KADR_TRY(blocks_.code({{Function::work_zero, 0}}));
  KADR_TRY(blocks_.end());
  KADR_TRY(motion_code(function));
  for (std::size_t a = 0; a < axes_.size() && a < max_axes; ++a) {
    if ((motion.named >> a & 1U) == 0) continue;
    KADR_TRY(axis_word(a, motion.machine[a] - placement_.length[a]));
  }
  KADR_TRY(blocks_.end());
  if (relative_) KADR_TRY(blocks_.code({{Function::incremental, any_argument}}));
  return motion.system == 0 ? Status() : blocks_.code({{Function::work_zero, motion.system}});
}

bool FlatProgram::is_in_machine(const Motion& motion) const {
  if (motion.end_reference == EndReference::by_machine && row_that_does(blocks_.def(), machine_codes) != nullptr) return true;
  return form_ != FlatForm::plain && source_.has_systems && motion.system == 0 && has_no_zeroless_system();
}

/// True if the target control allows motions at feed (G1), not only rapids, in machine coordinates.
bool FlatProgram::cuts_in_machine() const {
  return row_that_does(blocks_.def(), {{Function::machine_coordinates, any_argument}, {Function::machine_block, any_argument}}) != nullptr;
}

Status FlatProgram::machine_motion(Function function, const Motion& motion) {
  if (relative_) KADR_TRY(blocks_.code({{Function::absolute, any_argument}}));
  KADR_TRY(blocks_.code(machine_codes));
  if (cuts_in_machine()) KADR_TRY(motion_code(function));
  for (std::size_t a = 0; a < axes_.size() && a < max_axes; ++a) {
    if ((motion.named >> a & 1U) == 0) continue;
    KADR_TRY(axis_word(a, motion.machine[a]));
  }
  if (!relative_) return {};
  KADR_TRY(blocks_.end());
  return blocks_.code({{Function::incremental, any_argument}});
}

bool FlatProgram::is_by_reference(const Motion& motion) const {
  const int point = reference_of(motion.end_reference);
  return point != 0 && reference_code(blocks_.def(), point) != nullptr;
}

/// Writes a motion to a reference point. The intermediate point is the present position (increments of 0), so that the axes move directly
/// to the reference point.
Status FlatProgram::reference_motion(const Motion& motion) {
  const int point = reference_of(motion.end_reference);
  const CodeRow* const row = reference_code(blocks_.def(), point);
  const bool by_letters = has_turret() && row_that_does(blocks_.def(), {{Function::incremental, any_argument}}) == nullptr;
  if (!relative_ && !by_letters) KADR_TRY(blocks_.code({{Function::incremental, any_argument}}));
  KADR_TRY(blocks_.code({{row->function, row->arg}}));
  if (point > 1 && row->function == Function::reference_return) KADR_TRY(blocks_.word('P', point));
  code_ = Function::count;
  if (by_letters) return increments_of_zero(motion);
  for (std::size_t a = 0; a < axes_.size() && a < max_axes; ++a) {
    if ((motion.named >> a & 1U) == 0) continue;
    const auto letter = letter_of(a);
    if (!letter) return no_code(axes_[a].c_str());
    KADR_TRY(blocks_.word(*letter, 0));
  }
  if (relative_) return {};
  KADR_TRY(blocks_.end());
  return blocks_.code({{Function::absolute, any_argument}});
}

}  // namespace kadr
