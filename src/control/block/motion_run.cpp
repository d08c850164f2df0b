// The fast path for a sequence of plain motions. Used by Interpreter::run(). Described in motion_run.h.

#include "control/block/motion_run.h"

#include <algorithm>
#include <cmath>

#include "action/by_kind.h"
#include "control/interpreter.h"

namespace kadr {
namespace {

/// Returns true if only the words and the modes determined the block's motion: the block had no G53, no G9, and no code that uses the axis
/// words itself.
bool was_plain(const BlockContext& m) { return !m.block_machine_coordinates && !m.block_axes_taken && !m.block_exact; }

/// Returns true if the words of a motion alone determine the motion. Then cutter compensation, transformations, polar mode and inch mode
/// are off, and neither an interrupt macro nor the machine's logic observes the blocks.
bool only_words_count(const Emitter& m) {
  const Modal& modal = m.modal;
  const bool plain_modes = !modal.inch && !modal.polar && modal.surface == PathSurface::plane && modal.diameter == 0 &&
                           modal.feeds_of_axes == 0 && modal.feed_mode != FeedMode::inverse_time;
  const bool uncompensated = modal.radius_side == 0 && modal.contour == CompensationPhase::off;
  const bool plain_frames = m.transform.identity && m.frames.is_plain();
  const bool unwatched = !m.use.watches() && !m.each_block && (m.on_block == nullptr || !*m.on_block);
  const bool in_program = !m.program().in_body() && m.program().started() && !m.skipping_section && !m.cycling() && m.cycle_memory.row < 0;
  return plain_modes && uncompensated && plain_frames && unwatched && in_program && m.unsupported == 0 && m.unknown_position == 0 &&
         m.dialect->lines_follow(m);
}

/// Returns true if the run of plain motions (see motion_run.h) remains valid after a subprogram call, because no modal macro call comes
/// into force again in the caller.
bool stays_after_call(const BlockContext& m) { return !m.program().in_body() && !m.skipping_section && m.dialect->lines_follow(m); }

constexpr MotionKind kind_made[] = {MotionKind::rapid, MotionKind::feed, MotionKind::arc_cw, MotionKind::arc_ccw};
constexpr MotionMode mode_made[] = {MotionMode::rapid, MotionMode::linear, MotionMode::arc_cw, MotionMode::arc_ccw};

/// Returns true if the statement changes neither modes nor tables, so that motions do not depend on it.
bool keeps_modes(const Block& block) {
  switch (block.statement.kind) {
    case StatementKind::loop:
    case StatementKind::loop_end:
    case StatementKind::go_to:
    // these statements change no modes; a subprogram end that restores modes calls modes_changed() itself (restore_modes())
    case StatementKind::o_word: return true;
    case StatementKind::assign: {
      const Expression target = block.statement.target;
      const Instruction& number = block.code[target.begin];
      return target.end == target.begin + 1 && number.op == Op::number && number.number <= last_common;
    }
    default: return false;
  }
}

/// Returns true if the block only calls a subprogram or returns from one.
bool only_calls(const BlockContext& m, const Block& block) {
  bool calls = false, takes_words = false;
  for (std::uint32_t i = 0; i < block.word_count; ++i) {
    const Word& w = block.words[i];
    if (w.code < 0 || w.address == 0) continue;
    const std::int32_t row = m.def.row_of(w.address, w.code);
    const Function function = row < 0 ? Function::count : m.def.codes[static_cast<std::size_t>(row)].function;
    if (row < 0 || !traits_of(function).is(function_fact::passes_control)) return false;
    calls = true;
    takes_words = takes_words || function == Function::macro_call;
  }
  return calls && (takes_words || (block.letters & (m.letters.acting | m.letters.axes)) == 0);
}

/// Returns true if the block has only a label, such as `O9010` at the start of a subprogram.
bool is_label(const Block& block) {
  return block.marker == Marker::label && block.word_count == 0 && block.assignments.empty() && block.comments.empty();
}

/// Returns the index of the word that calls a macro, or of a return that is the block's only word; no_word for all other blocks. A block
/// with such an index either fails before it has changed anything, or succeeds.
std::uint8_t quick_call(const BlockContext& m, const Block& block) {
  std::uint8_t word = no_word;
  for (std::uint32_t i = 0; i < block.word_count; ++i) {
    if (block.words[i].code < 0) continue;
    if (word != no_word) return no_word;
    word = static_cast<std::uint8_t>(i);
  }
  const Word& w = block.words[word];
  const Function function = m.def.codes[static_cast<std::size_t>(m.def.row_of(w.address, w.code))].function;
  const bool quick = function == Function::macro_call || (function == Function::return_program && block.word_count == 1);
  return quick ? word : no_word;
}

/// Returns true if the block is kept in memory for a loop and has only words: it has no skip mark, label, comment or warning.
bool is_read_again(const Block& block) {
  return block.repeated && block.no_clock && block.skip == 0 && block.marker == Marker::none && block.comments.empty() &&
         block.warnings.empty();
}

/// Returns true if a loop executes the block again, the block has only words (is_read_again()), and some of its words are expressions.
bool is_repeated(const Block& block) { return block.evaluates && is_read_again(block) && !block.codes_vary && block.assignments.empty(); }

AxisMask plane_of(const BlockContext& m) { return AxisMask{1} << m.modal.axes.first | AxisMask{1} << m.modal.axes.second; }

}  // namespace

Motion& Emitter::add_motion_as(const MotionModes& modes, AxisMask named) {
  Motion& motion = next_motion();
  static_cast<MotionModes&>(motion) = modes;
  motion.named = named;
  return motion;
}

void MotionRun::note(const Emitter& m) {
  if (m.modal.radius_side != 0 || m.modal.contour != CompensationPhase::off)
    // under cutter compensation the fast path is not used; this test is cheap and comes first, because compensation stays on for many
    // blocks
    return end();
  const Block& block = *m.block;
  if (block.statement.kind != StatementKind::none) {
    if (!keeps_modes(block)) end();
    return;
  }
  if (is_label(block) || sets_variables_only(block)) return;
  if (!block.shape && !is_repeated(block)) return end();
  const Form& form = form_of(m, block);
  if (form.fits) return begin(m, form);
  if (!form.calls || !stays_after_call(m)) end();
}

void MotionRun::begin(const Emitter& m, const Form& form) {
  on_ = false;
  const auto* const mode = std::find(std::begin(mode_made), std::end(mode_made), m.modal.motion);
  const std::int16_t row = m.modal.motion_row;
  if (row < 0 || mode == std::end(mode_made) || m.batch->empty()) return end();
  const auto kind = static_cast<Kind>(mode - mode_made);
  const Action& last = m.batch->back();
  const auto* const motion = motion_of(last);
  if (motion == nullptr || last.origin.number != m.origin.number || motion->detail || motion->kind != kind_made[kind]) return end();
  const AxisMask named = kind >= arc_cw ? form.named | plane_of(m) : form.named;
  if (named != motion->named || !was_plain(m) || !only_words_count(m)) return end();
  on_ = true;
  known_ = static_cast<std::uint8_t>(known_ | 1u << kind);
  rows_[kind] = row;
  modes_[kind] = *motion;
  if (m.modal.feed != feed_) note_feed(m.modal.feed);
  old_feed_ = static_cast<std::uint8_t>(old_feed_ & ~(1u << kind));
  absolute_ = m.modal.absolute;
  arcs_ = m.arc_rule();
  rolling_ = m.dialect->rolling_axes(m);
  const AddressRow& number = m.def.address('N');
  const bool checks_numbers = m.def.machine_axes();  // the range of the block number is checked as in nct 1.1
  number_least_ = checks_numbers ? static_cast<std::uint32_t>(std::clamp(number.least, 0.0, 4e9)) : 0;
  number_most_ = checks_numbers ? static_cast<std::uint32_t>(std::clamp(number.most, 0.0, 4e9)) : ~std::uint32_t{0};
}

const MotionRun::Form& MotionRun::form_of(const BlockContext& m, const Block& block) {
  const bool shaped = static_cast<bool>(block.shape);
  const std::uint64_t key = shaped ? block.shape.first : reinterpret_cast<std::uintptr_t>(&block) / alignof(Block);  // NOLINT: a hash key
  Form& form = forms_[(key * 0x9E3779B97F4A7C15u) >> 60];
  static_assert(forms == 16);
  if (shaped ? form.shape == block.shape : form.repeated == &block && form.letters == block.letters) [[likely]]
    return form;
  form = {};
  if (shaped) form.shape = block.shape;
  else form.repeated = &block, form.letters = block.letters;
  form.fits = make(m, block, form);
  form.calls = !form.fits && only_calls(m, block);
  if (form.calls && block.repeated) form.call = quick_call(m, block);
  return form;
}

/// Describes the block in `form`. Returns true if the block has only these words: axis words, each axis once; at most one motion code;
/// codes that are in force already; words of an arc centre; a feed.
bool MotionRun::make(const BlockContext& m, const Block& block, Form& form) const {
  constexpr double max_value = 1e9;  // the greatest absolute value that Interpreter::check_ranges accepts
  for (std::uint32_t i = 0; i < block.word_count; ++i) {
    const Word& w = block.words[i];
    if (w.code >= 0) {
      if (!add_code(m, w, form)) return false;
      continue;
    }
    if (w.address == 0 || w.address != w.written || w.incremental || w.bare || w.axis) return false;
    const AddressRow& row = m.def.address(w.address);
    if (row.whole) return false;
    const Slot slot{
        static_cast<std::uint8_t>(i), row.axis, row.function == Function::increment_axis, row.scale, std::max(row.least, -max_value),
        std::min(row.most, max_value)};
    if ((m.letters.axes & letter_bit(w.address)) != 0) {
      if (form.axes == max_words || (form.named >> row.axis & 1u) != 0) return false;
      form.named |= AxisMask{1} << row.axis;
      form.slots[form.axes++] = slot;
    } else if (row.function == Function::feed_word) {
      const bool of_axis = m.def.behaviour.feed_of_axis && m.axis_of_feed(i);
      if (form.feed.word != no_word || of_axis || !m.def.feed_codes.empty()) return false;
      form.feed = slot;
    } else {
      const auto* const axis = std::find(m.letters.center_letter.begin(), m.letters.center_letter.begin() + form.center.size(), w.address);
      const auto a = static_cast<std::size_t>(axis - m.letters.center_letter.begin());
      if (row.function != Function::center || a == form.center.size() || form.center[a].word != no_word) return false;
      form.center[a] = slot;
      form.centered = true;
    }
  }
  return form.axes != 0 || form.centered;
}

bool MotionRun::add_code(const BlockContext& m, const Word& word, Form& form) const {
  const std::int32_t row = m.def.row_of(word.address, word.code);
  if (row < 0) return false;
  const CodeRow& code = m.def.codes[static_cast<std::size_t>(row)];
  const FunctionTraits& traits = traits_of(code.function);
  if (!code.modal || code.group == 0 || !code.works) return false;
  if (traits.is(function_fact::plain_motion)) {
    if (form.row >= 0) return false;
    form.row = static_cast<std::int16_t>(row);
    return true;
  }
  if (!traits.is(function_fact::steady) || form.codes == most_codes) return false;
  for (std::size_t i = 0; i < form.codes; ++i)
    if (m.def.codes[static_cast<std::size_t>(form.steady[i])].group == code.group) return false;
  form.steady[form.codes++] = static_cast<std::int16_t>(row);
  return true;
}

/// Returns true if the block changes no mode: all its codes except the motion code are in force already, its block number and its feed are
/// within their limits, and its feed needs no warning.
bool MotionRun::holds(const BlockContext& m, const Form& form) const {
  const Block& block = *m.block;
  for (std::size_t i = 0; i < form.codes; ++i)
    if (m.modal.rows[m.def.codes[static_cast<std::size_t>(form.steady[i])].group] != form.steady[i]) return false;
  if (form.feed.word != no_word) {
    const double v = block.words[form.feed.word].value, feed = v * form.feed.scale, most = m.def.behaviour.feed_most;
    if (!(v >= form.feed.least && v <= form.feed.most) || !(feed > 0) || (most > 0 && feed > most)) return false;
  }
  return number_fits(block);
}

/// Computes the arc from its centre, by the same rules as functions::arc_cw and functions::arc_ccw.
bool MotionRun::find_arc(const BlockContext& m, const Form& form, Kind kind, const Axes& to, PlaneArc& arc) const {
  const PlaneAxes plane = m.modal.axes;
  const AxisMask normal = AxisMask{1} << plane.normal;
  if (!arcs_.by_words || plane.first > 2 || plane.second > 2 || plane.normal > 2) return false;
  if (form.center[plane.normal].word != no_word || (arcs_.lead_on_normal && (form.named & normal) != 0)) return false;
  const Vec2 from{m.position.programmed[plane.first], m.position.programmed[plane.second]};
  Vec2 center = from;
  bool given = false;
  const auto read = [&](const Slot& slot, double& at) {
    if (slot.word == no_word) return true;
    const double v = m.block->words[slot.word].value;
    if (!(v >= slot.least && v <= slot.most)) return false;
    given = true;
    at = arcs_.absolute ? v * slot.scale : at + v * slot.scale;
    return true;
  };
  if (!read(form.center[plane.first], center.x) || !read(form.center[plane.second], center.y) || !given) return false;
  const auto found = arc_around(from, {to[plane.first], to[plane.second]}, center, kind == arc_cw ? Turn::cw : Turn::ccw, arcs_.difference);
  if (found) arc = *found;
  return found.has_value();
}

/// Puts a new feed into force. The copies of the feed in `modes_`, one for each motion code, are updated when their code is used next.
void MotionRun::take_feed(BlockContext& m, double feed) {
  if (m.modal.feed_known && feed == m.modal.feed) return;
  m.modal.feed = feed;
  m.modal.feed_known = true;
  m.dialect->note_feed(m);
  note_feed(feed);
}

bool MotionRun::changes_radius(const BlockContext& m, const Axes& to, Vec2 center) {
  const PlaneAxes& plane = m.modal.axes;
  const Axes& from = m.position.programmed;
  return radius_changes({from[plane.first], from[plane.second]}, {to[plane.first], to[plane.second]}, center);
}

// NOLINTNEXTLINE(readability-function-size): one function, because it runs once per line of a long program
bool MotionRun::take(Interpreter& m) {
  const Block& block = *m.block;
  if (block.statement.kind != StatementKind::none) {
    if (!is_read_again(block) || !keeps_modes(block) || !number_fits(block)) return false;
    m.execute_statement();
    return true;
  }
  if (sets_variables_only(block)) return is_read_again(block) && number_fits(block) && m.assign_again();
  if (is_label(block))
    // The label of a kept block was checked when the block was executed the first time.
    return block.repeated && m.program().depth() != 0 && !m.def.behaviour.label_is_number;
  if (!block.shape && !is_repeated(block)) return false;
  if (block.skip != 0 || block.marker != Marker::none || block.altered) return refused();
  const Form& form = form_of(m, block);
  if (form.calls) {
    const bool done = form.call != no_word && is_read_again(block) && number_fits(block) && m.execute_call(form.call);
    if (done && !stays_after_call(m)) end();
    return done;
  }
  if (!form.fits) return refused();
  // If a word has no valid value, the general way (Interpreter::execute_block) evaluates the words again and reports the error.
  if (!block.shape && (!m.evaluate_words() || block.letters != form.letters)) return refused();
  if (form.feed.word != no_word || !block.shape) m.dialect->count_words(m);
  if ((form.named & rolling_) != 0 || !holds(m, form)) return refused();
  const std::int16_t row = form.row >= 0 ? form.row : m.modal.motion_row;
  std::size_t k = 0;
  while (k < kinds && !((known_ >> k & 1u) != 0 && rows_[k] == row)) ++k;
  // A motion code that is new in this run is executed the general way (Interpreter::execute_block); note() then adds the code to the run.
  if (k == kinds) return on_ = false;
  const auto kind = static_cast<Kind>(k);
  if (kind < arc_cw ? form.centered : !form.centered) return refused();

  const bool arc = kind >= arc_cw;
  Axes to;
  if (arc) to = m.position.programmed;
  for (std::size_t i = 0; i < form.axes; ++i) {
    const Slot& slot = form.slots[i];
    const double v = block.words[slot.word].value;
    if (!(v >= slot.least && v <= slot.most)) return refused();
    const double scaled = v * slot.scale;
    to[slot.axis] = absolute_ && !slot.adds ? scaled : m.position.programmed[slot.axis] + scaled;
    if (!(std::fabs(to[slot.axis]) <= farthest)) return refused();
  }
  PlaneArc found;
  if (arc && !find_arc(m, form, kind, to, found)) return refused();

  const AxisMask named = arc ? form.named | plane_of(m) : form.named;
  const bool turns_evenly = arc && arcs_.even_angle && named == plane_of(m) && changes_radius(m, to, found.center);
  for (AxisMask rest = form.named; rest != 0; rest &= rest - 1) {
    const auto a = static_cast<std::size_t>(__builtin_ctz(rest));
    m.position.programmed[a] = to[a];
  }
  m.set_plain_position(named);
  if (form.row >= 0) {
    m.modal.motion = mode_made[kind];
    m.modal.motion_row = m.modal.rows[m.def.codes[static_cast<std::size_t>(row)].group] = row;
  }
  if (form.feed.word != no_word) take_feed(m, block.words[form.feed.word].value * form.feed.scale);
  Motion& motion = m.add_motion_as(modes_[kind], named);
  if (old_feed_ != 0 && (old_feed_ >> kind & 1u) != 0) [[unlikely]] {
    m.set_feed(motion);
    modes_[kind].feed = motion.feed;
    old_feed_ = static_cast<std::uint8_t>(old_feed_ & ~(1u << kind));
  }
  if (arc) {
    motion.center = found.center;
    motion.turns = found.turns;
    if (turns_evenly) motion.along = FeedAlong::turn;
    else if (motion.along == FeedAlong::turn) motion.along = FeedAlong::arc;
  }
  m.dialect->note_line(m);
  return true;
}

}  // namespace kadr
