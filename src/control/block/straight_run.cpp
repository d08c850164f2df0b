// For Interpreter::run().

#include "control/block/straight_run.h"

#include <algorithm>
#include <cmath>

#include "control/interpreter.h"

namespace kadr {
namespace {

/// Nothing but the end point decides what a straight motion does.
bool only_the_end_counts(const Interpreter& m) {
  const Modal& modal = m.modal;
  const bool plain_modes = !modal.inch && !modal.polar && modal.surface == PathSurface::plane && modal.diameter == 0 &&
                           modal.feeds_of_axes == 0 && modal.feed_mode != FeedMode::inverse_time;
  const bool uncompensated = modal.radius_side == 0 && modal.contour == ContourPhase::off;
  const bool plain_frames = m.transform.identity && !m.frames.turn && !m.block_machine_coordinates && !m.block_axes_taken && !m.block_exact;
  const bool unwatched = !m.use.watches() && !m.each_block && (m.on_block == nullptr || !*m.on_block);
  const bool in_program = !m.flow.in_body() && m.flow.started() && !m.skipping_section && !m.cycling() && m.cycle_memory.row < 0;
  return plain_modes && uncompensated && plain_frames && unwatched && in_program && m.unserved == 0 &&
         (!m.dialect || m.dialect->lines_follow(m));
}

}  // namespace

void StraightRun::begin(const Interpreter& m) {
  on_ = false;
  const std::int16_t row = m.modal.motion_row;
  if (row < 0 || (m.block->letters & m.letters.axes) == 0 || m.batch->empty()) return;
  const Action& last = m.batch->back();
  const auto* const motion = std::get_if<Motion>(&last.what);
  if (motion == nullptr || last.origin.number != m.origin.number || motion->detail) return;
  const bool straight = (m.modal.motion == MotionMode::rapid && motion->kind == MotionKind::rapid) ||
                        (m.modal.motion == MotionMode::linear && motion->kind == MotionKind::feed);
  if (!straight || !m.block->shape || !only_the_end_counts(m)) return;
  if (row != row_) forms_ = {};
  row_ = row;
  absolute_ = m.modal.absolute;
  code_in_force_ = m.modal.rows[m.def.codes[static_cast<std::size_t>(row)].group] == row;
  rolling_ = m.dialect ? m.dialect->rolling_axes(m) : 0;
  const Form& form = form_of(m, *m.block);
  on_ = form.fits && form.named == motion->named;
  if (!on_) return;
  modes_ = *motion;
  const AddressRow& number = m.def.address('N');
  const bool checks_numbers = m.def.grammar.macro;  // nct 1.1
  number_least_ = checks_numbers ? static_cast<std::uint32_t>(std::clamp(number.least, 0.0, 4e9)) : 0;
  number_most_ = checks_numbers ? static_cast<std::uint32_t>(std::clamp(number.most, 0.0, 4e9)) : ~std::uint32_t{0};
}

const StraightRun::Form& StraightRun::form_of(const Interpreter& m, const Block& block) {
  Form& form = forms_[(block.shape.first * 0x9E3779B97F4A7C15u) >> 60];
  static_assert(forms == 16);
  if (form.shape == block.shape) [[likely]]
    return form;
  form = {};
  form.shape = block.shape;
  form.fits = make(m, block, form);
  return form;
}

/// Axis words, each axis once, and besides at most the motion code that is in force.
bool StraightRun::make(const Interpreter& m, const Block& block, Form& form) const {
  constexpr double most_value = 1e9;  // as Interpreter::check_ranges
  for (std::uint32_t i = 0; i < block.word_count; ++i) {
    const Word& w = block.words[i];
    if (w.code >= 0) {
      if (m.def.row_of(w.address, w.code) != row_) return false;
      form.coded = true;
      continue;
    }
    if (w.address == 0 || (m.letters.axes & letter_bit(w.address)) == 0 || form.count == most_words) return false;
    const AddressRow& row = m.def.address(w.address);
    if (row.whole || (form.named >> row.axis & 1u) != 0) return false;
    form.named |= 1u << row.axis;
    form.slots[form.count++] = {
        static_cast<std::uint8_t>(i),  row.axis, row.function == Function::increment_axis, row.scale, std::max(row.least, -most_value),
        std::min(row.most, most_value)};
  }
  return form.count != 0;
}

bool StraightRun::take(Interpreter& m) {
  const Block& block = *m.block;
  if (!block.shape || block.skip != 0 || block.marker != Marker::none || block.altered) return false;
  const Form& form = form_of(m, block);
  if (!form.fits || (form.coded && !code_in_force_) || (form.named & rolling_) != 0) return false;
  if (block.has_number && (block.number < number_least_ || block.number > number_most_)) return false;
  std::array<double, most_words> to;
  for (std::size_t i = 0; i < form.count; ++i) {
    const Slot& slot = form.slots[i];
    const double v = block.words[slot.word].value;
    if (!(v >= slot.least && v <= slot.most)) return false;
    const double way = v * slot.scale;
    to[i] = absolute_ && !slot.adds ? way : m.position.programmed[slot.axis] + way;
    if (!(std::fabs(to[i]) <= farthest)) return false;
  }
  for (std::size_t i = 0; i < form.count; ++i) {
    const std::size_t a = form.slots[i].axis;
    m.position.programmed[a] = m.position.work[a] = to[i];
    m.position.machine[a] = to[i] + m.frames.origin[a] + m.frames.length[a];
  }
  Action& action = m.batch->add();
  action.origin = m.origin;
  Motion* const reused = std::get_if<Motion>(&action.what);
  Motion& motion = reused != nullptr ? *reused : action.what.emplace<Motion>();
  static_cast<MotionModes&>(motion) = modes_;
  motion.named = form.named;
  motion.detail.reset();
  for (std::size_t a = 0; a < m.axis_count; ++a) {  // the others stay 0
    motion.to[a] = m.position.work[a];
    motion.machine[a] = m.position.machine[a];
  }
  if (m.dialect) m.dialect->note_line(m);
  return true;
}

}  // namespace kadr
