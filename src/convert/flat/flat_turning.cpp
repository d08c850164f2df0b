// Writes what only programs of lathes have: diameters, T words of a turret, increments U W, threads, limits of the spindle speed. Part of
// convert/flat/flat_program; tested by tests/convert_lathe.py.

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "action/by_kind.h"
#include "convert/flat/flat_program.h"
#include "out/program/words.h"

namespace kadr {
namespace {

constexpr double same_number = 1e-9;  // lengths, leads and angles closer than this are equal: mm, degrees

const CodeRow* limit_code(const ControlDef& def) {
  const CodeRow* const row = row_that_does(def, {{Function::new_system, 0}});
  return row != nullptr && (row->takes >> ('S' - 'A') & 1U) != 0 ? row : nullptr;
}

}  // namespace

/// Begins a program of a lathe: the plane Z X, and diameters if the target control has a code for them (spec/linuxcnc 7.1).
Status FlatProgram::begin_turning() {
  blocks_.code_if_there({{Function::plane_zx, any_argument}, {Function::select_plane, 18}});
  plane_ = 18;
  if (source_.diameters) blocks_.code_if_there({{Function::diameter_mode, 1}});
  return {};
}

/// Writes the word of an axis.
///   value  mm or degrees; X as a radius, which is doubled if the target text has diameters
Status FlatProgram::axis_word(std::size_t axis, double value) {
  const auto letter = letter_of(axis);
  return letter ? blocks_.word(*letter, factor_of(axis) * value) : no_code(axes_[axis].c_str());
}

/// Returns the value of an axis, mm or degrees, that its rounded word states.
double FlatProgram::rounded(std::size_t axis, double value) const {
  return Words(blocks_.def(), axes_[axis].front()).rounded(factor_of(axis) * value) / factor_of(axis);
}

/// Writes the words of increments of 0, on a lathe without a code for incremental dimensions: U0 W0 (spec/fanuc-t 5.5).
Status FlatProgram::increments_of_zero(const Motion& motion) {
  constexpr std::pair<const char*, const char*> increments[] = {{"X", "U0"}, {"Y", "V0"}, {"Z", "W0"}, {"C", "H0"}};
  for (std::size_t a = 0; a < axes_.size() && a < max_axes; ++a) {
    if ((motion.named >> a & 1U) == 0) continue;
    const char* word = nullptr;
    for (const auto& [axis, increment] : increments)
      if (axes_[a] == axis) word = increment;
    if (word == nullptr || !letter_of(a)) return no_code(axes_[a].c_str());
    blocks_.text(word);
  }
  return {};
}

/// Keeps the T word of a lathe, tool and offset (spec/fanuc-t 4.1), for the block of the next motion.
Status FlatProgram::turret(std::uint32_t number, const OffsetsInForce& now) {
  constexpr std::uint32_t most_number = 99;
  const std::uint32_t offset = form_ == FlatForm::plain || now.length_sign == 0 ? 0 : now.length_number;
  if (now.length_sign < 0) return no_code("length_minus");
  if (number > most_number || offset > most_number) return fail(alarm(AlarmId::word_has_no_room, {}, 'T', double(number)));
  turret_word_ = fmt::format("T{:02}{:02}", number, offset);
  selected_ = number;
  written_offsets_ = now;
  return {};
}

/// Writes the T word in the block of a motion: the word of a tool change before it, or that of another offset of the same tool.
Status FlatProgram::turret_offset(const OffsetsInForce& now) {
  const auto number = [](const OffsetsInForce& of) { return of.length_sign == 0 ? 0 : of.length_number; };
  if (form_ != FlatForm::plain && number(now) != number(written_offsets_)) KADR_TRY(turret(selected_, now));
  if (!turret_word_.empty()) blocks_.text(std::exchange(turret_word_, {}));
  return {};
}

/// Writes the code for the lengths of a turning tool (nct 15.4) in a block of its own, because axis words in its block may belong to it.
Status FlatProgram::turning_length(const OffsetsInForce& now) {
  KADR_TRY(blocks_.code({{Function::length_comp, source_.turning_length->arg}}));
  KADR_TRY(blocks_.word('H', now.length_number));
  written_offsets_ = now;
  return blocks_.end();
}

Status FlatProgram::note_offsets(const OffsetsInForce& now) {
  const auto number = [](const OffsetsInForce& of) { return of.length_sign == 0 ? 0 : of.length_number; };
  if (!has_turret() || form_ == FlatForm::plain || number(now) == number(written_offsets_)) return {};
  KADR_TRY(end_block());
  KADR_TRY(turret(selected_, now));
  return end_block();
}

/// Holds a rapid motion of a lathe's program to where the axes are already. G28 U0 W0 has such a motion, which is left out, because in
/// other states its coordinates are others (spec/fanuc-t 5.5).
bool FlatProgram::hold(const Motion& motion, const OffsetsInForce& now) {
  if (!source_.turns || is_between() || motion.kind != MotionKind::rapid || motion.end_reference != EndReference::by_work) return false;
  for (std::size_t a = 0; a < axes_.size() && a < max_axes; ++a)
    if (std::fabs(motion.machine[a] - at_[a]) > same_number) return false;
  held_ = motion, held_offsets_ = now;
  return true;
}

/// Writes the motion that hold() has kept, unless the next action moves to a reference point.
Status FlatProgram::write_held(const Action* next) {
  if (!held_) return {};
  const Motion held = *std::exchange(held_, std::nullopt);
  const Motion* const after = next == nullptr ? nullptr : motion_of(*next);
  return after != nullptr && reference_of(after->end_reference) != 0 ? Status() : motion(held, held_offsets_);
}

/// Checks that the radius offset in force is that of the T word, because a lathe has no other word for it.
Status FlatProgram::side_of_turret(const OffsetsInForce& now) const {
  return now.radius_number == 0 || now.radius_number == now.length_number ? Status() : no_code("radius_number");
}

/// Writes a thread of constant lead. F is the lead in mm, Q the angle of the spindle at its start; on a lathe Q counts 0.001° (spec/fanuc-t
/// 8.1). K of LinuxCNC is the lead along the path (spec/linuxcnc 7.2), so a taper thread is another one there.
Status FlatProgram::thread(const Motion& motion) {
  constexpr double counts_per_degree = 1000;
  const double lead = motion.detail ? motion.detail->lead.value_or(0) : 0;
  const double angle = motion.detail ? motion.detail->start_angle.value_or(0) : 0;
  const bool is_constant = lead > 0 && std::fabs(motion.feed - lead) <= same_number, has_angle = std::fabs(angle) > same_number;
  int moved = 0;
  for (std::size_t a = 0; a < axes_.size() && a < max_axes; ++a) moved += std::fabs(motion.machine[a] - at_[a]) > same_number ? 1 : 0;
  const bool by_feed = row_that_does(blocks_.def(), {{Function::thread, 0}}) != nullptr;
  const bool is_other = moved > 1 && !source_.same_threads, cannot_turn = has_angle && !by_feed;
  if (!is_constant || is_other || cannot_turn) return no_code("thread");
  code_ = Function::count, feed_ = -1;  // the lead is an F word too, so the next cut writes its feed again
  if (!blocks_.code_if_there({{Function::thread, 0}, {Function::thread_by_spindle, 0}})) return no_code("thread");
  KADR_TRY(axis_words(motion));
  KADR_TRY(blocks_.word(by_feed ? 'F' : 'K', lead));
  if (!has_angle) return {};
  if (!has_turret()) return blocks_.word('Q', angle);
  blocks_.text(fmt::format("Q{:.0f}", counts_per_degree * angle));
  return {};
}

/// Writes the limit of the spindle speed with constant surface speed: G50 S or G92 S in a block of its own, or D in the block of G96
/// (spec/fanuc-t 6, nct 11.5.2, spec/linuxcnc 7.9).
Status FlatProgram::surface_limit(const SurfaceSpeed& law) {
  if (law.number != 1) return {};
  const CodeRow* const row = limit_code(blocks_.def());
  const bool by_word = row_that_does(blocks_.def(), {{Function::surface_speed_limited, 0}}) != nullptr;
  if (!law.on) {
    if (by_word) written_most_rpm_ = 0;  // G97 ends the limit, so the next G96 states it again
    return std::exchange(surface_, false) ? constant_speed() : Status();
  }
  const double most = law.most < SurfaceSpeed::no_limit ? law.most : 0;
  if (most == written_most_rpm_) return {};
  if (!by_word && (row == nullptr || most == 0)) return no_code("surface_speed");
  KADR_TRY(end_block());
  surface_ = surface_ || row == nullptr;
  written_most_rpm_ = most;
  if (row != nullptr) {
    blocks_.text(with_digits(blocks_.def(), *row));
    KADR_TRY(blocks_.word('S', most));
  } else {
    KADR_TRY(blocks_.code({{Function::surface_speed_limited, 0}}));
    if (most != 0) KADR_TRY(blocks_.word('D', most));
    if (law.metres == 0) return {};  // the S word of the same block follows as an action of its own
    KADR_TRY(blocks_.word('S', law.metres));
  }
  return end_block();
}

}  // namespace kadr
