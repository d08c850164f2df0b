// Warnings about breaches of rules in the manual of the 2С42 that the control itself does not report (6.3.6, 6.4.1, 6.7).
//   reference_again, reference_late  G25 may come once only, at the start of the program (6.4.1)
//   plane_without_stop               G9 is needed at a change of plane, except with G0 (6.4.1); table 9 writes it next to G17
//   return_not_alone                 M17 must be in a block of its own, without motions (6.4.2)
//   length_beside_radius             only one code of group 9 in a block (6.4.1): G43 next to G41
//   subprogram_shadowed              a canned cycle hides the program's own subprogram of this number (6.7.1); once per number

#include "control/dialect.h"

#include "control/functions/cutter_compensation.h"
#include "control/interpreter.h"

namespace kadr::s2c42 {
namespace {

/// Returns the first code of the block that calls one of the given functions; nullptr if the block has no such code.
const Word* code_of(const BlockContext& m, std::initializer_list<Function> functions) {
  for (std::uint32_t i = 0; i < m.block->word_count; ++i) {
    const Word& w = m.block->words[i];
    const std::int32_t row = w.code >= 0 ? m.def.row_of(w.address, w.code) : -1;
    if (row < 0) continue;
    for (const Function function : functions)
      if (m.def.codes[static_cast<std::size_t>(row)].function == function) return &w;
  }
  return nullptr;
}

/// The facts about the blocks executed so far that the warnings depend on.
struct Seen {
  bool reference = false;  // the program has executed G25, the approach to the reference point
  bool moved = false;
  bool at_rest = true;        // the last motion ended with a stop, so the plane may change
  std::uint64_t shadows = 0;  // one bit per canned cycle whose hidden subprogram has been reported
};

void check_reference(Emitter& m, Seen& seen) {
  const Word* const reference = code_of(m, {Function::approach_reference});
  if (reference == nullptr) return;
  if (seen.reference) m.warn(warning(AlarmId::reference_again, reference->where));
  else if (seen.moved) m.warn(warning(AlarmId::reference_late, reference->where));
  seen.reference = true;
}

/// Warns if the plane changes without a stop. INFERRED: the stop is a G9 in the block with the new plane, as in table 9, or in the last
/// preceding block with a motion.
void check_plane(Emitter& m, const Seen& seen, Plane before) {
  const Word* const plane = code_of(m, {Function::plane_xy, Function::plane_zx, Function::plane_yz});
  if (plane == nullptr || m.modal.plane == before || seen.at_rest || m.block_exact) return;
  m.warn(warning(AlarmId::plane_without_stop, plane->where, m.block->text_of(plane->where)));
}

/// Warns if M17 is not the only word of its block. M2 may be in the same block, because M2 ends the section (6.3.5).
void check_return(Emitter& m) {
  const Word* const end = code_of(m, {Function::subprogram_end});
  if (end == nullptr) return;
  const bool ends_section = code_of(m, {Function::program_end}) != nullptr;
  const std::uint32_t own = ends_section ? 2 : 1;
  if (m.block->word_count > own || !m.block->assignments.empty()) m.warn(warning(AlarmId::return_not_alone, end->where));
}

void check_length(Emitter& m) {
  const Word* const length = code_of(m, {Function::length_plus, Function::length_minus});
  const Word* const radius = code_of(m, {Function::radius_comp_left, Function::radius_comp_right, Function::compensation_off});
  if (length == nullptr || radius == nullptr) return;
  const Word* const second = length > radius ? length : radius;
  const Word* const first = length > radius ? radius : length;
  m.warn(warning(AlarmId::length_beside_radius, second->where, m.block->text_of(second->where), m.block->text_of(first->where)));
}

void note_moved(const BlockContext& m, Seen& seen) {
  const bool calls = m.has('L');  // word L calls a canned cycle, which ends with a stop (table 9)
  const bool stands = code_of(m, {Function::dwell, Function::program_stop, Function::optional_stop, Function::change_tool}) != nullptr;
  const bool machine = code_of(m, {Function::approach_reference, Function::machine_point}) != nullptr;
  const bool takes_axes = code_of(m, {Function::zero_shift}) != nullptr;
  const bool moves = m.has_axis_words() && !takes_axes;
  if (moves && !machine) seen.at_rest = m.block_exact || m.modal.motion == MotionMode::rapid;
  if (stands || machine || calls) seen.at_rest = true;
  seen.moved = seen.moved || moves || machine || calls;
}

class S2c42 final : public Dialect {
 public:
  Result<bool> takes_block(Interpreter& m) override {
    in_body_ = m.program().in_body();
    plane_ = m.modal.plane;
    return Dialect::takes_block(m);
  }

  Status after_block(Interpreter& m) override {
    if (in_body_) {
      seen_.moved = seen_.at_rest = true;
      return {};
    }
    check_reference(m, seen_);
    check_plane(m, seen_, plane_);
    check_return(m);
    check_length(m);
    note_moved(m, seen_);
    return {};
  }

  bool lines_follow(const BlockContext&) const override { return true; }
  bool contour_follows(const BlockContext& m) const override { return continues_contour(m.modal); }
  void note_line(BlockContext& m) override {
    seen_.at_rest = m.modal.motion == MotionMode::rapid;
    seen_.moved = true;
  }

  void note_shadowed(Emitter& m, std::uint32_t number, Span where) override {
    const std::uint64_t bit = number < 128 && number >= 64 ? std::uint64_t{1} << (number - 64) : 0;
    if (bit == 0 || (seen_.shadows & bit) != 0) return;
    seen_.shadows |= bit;
    m.warn(warning(AlarmId::subprogram_shadowed, where, double(number)));
  }

  std::shared_ptr<const DialectState> snapshot() const override { return std::make_shared<Memory>(seen_); }
  Status restore(BlockContext&, const DialectState& from) override {
    seen_ = static_cast<const Memory&>(from).seen;
    return {};
  }

 private:
  struct Memory : DialectState {
    explicit Memory(const Seen& all) : seen(all) {}
    Seen seen;
  };
  Seen seen_;
  // the state at the start of the current block
  bool in_body_ = false;  // true: the current block is in the body of a canned cycle
  Plane plane_ = Plane::xy;
};

}  // namespace
}  // namespace kadr::s2c42

namespace kadr {

std::unique_ptr<Dialect> make_s2c42_dialect() { return std::make_unique<s2c42::S2c42>(); }

}  // namespace kadr
