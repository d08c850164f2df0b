// The fast path for a sequence of plain motions. Used by Interpreter::run(). Described in motion_run.h.

#include "control/block/motion_run.h"

#include <algorithm>
#include <cmath>

#include "action/by_kind.h"
#include "control/functions/cutter_compensation.h"
#include "control/interpreter.h"

namespace kadr {
namespace {

/// Returns true if only the words and the modes determined the block's motion: the block had no G53, no G9, and no code that uses the axis
/// words itself.
bool was_plain(const BlockContext& m) { return !m.block_machine_coordinates && !m.block_axes_taken && !m.block_exact; }

/// Returns true from G41 or G42 on until the tool has left the contour.
bool on_contour(const Modal& modal) { return modal.radius_side != 0 || modal.contour != CompensationPhase::off; }

/// Returns true if the words of a motion alone determine the motion. Then transformations, polar mode and inch mode are off, cutter
/// compensation is off or continues without a change, and neither an interrupt macro nor the machine's logic observes the blocks.
bool only_words_count(const Emitter& m) {
  const Modal& modal = m.modal;
  const bool plain_modes = !modal.inch && !modal.polar && modal.surface == PathSurface::plane && modal.diameter == 0 &&
                           modal.feeds_of_axes == 0 && modal.feed_mode != FeedMode::inverse_time;
  const bool plain_contour = !on_contour(modal) || m.dialect->contour_follows(m);
  const bool plain_frames = m.transform.identity && m.frames.is_plain();
  const bool unwatched = !m.use.watches() && !m.each_block && (m.on_block == nullptr || !*m.on_block);
  const bool in_program = !m.program().in_body() && m.program().started() && !m.skipping_section;
  return plain_modes && plain_contour && plain_frames && unwatched && in_program && m.unsupported == 0 && m.unknown_position == 0 &&
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
      if (block.statement.words_follow) return false;
      const Expression target = block.statement.target;
      const Instruction& number = block.code[target.begin];
      return target.end == target.begin + 1 && number.op == Op::number && number.number <= last_common;
    }
    default: return false;
  }
}

/// Returns true if the block has only a label, such as `O9010` at the start of a subprogram.
bool is_label(const Block& block) {
  return block.marker == Marker::label && block.word_count == 0 && block.assignments.empty() && block.comments.empty();
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
  const Block& block = *m.block;
  if (block.statement.kind != StatementKind::none) {
    if (!keeps_modes(block)) end();
    else if (!on_ && block.repeated) begin_loop(m);
    return;
  }
  if (is_label(block)) return;
  if (sets_variables_only(block)) {
    if (!on_ && block.repeated) begin_loop(m);
    return;
  }
  if (!block.shape && !is_repeated(block)) return end();
  const Form& form = forms_.of(m, block);
  if (form.fits) return begin(m, form);
  if (!form.calls || !stays_after_call(m)) end();
}

void MotionRun::begin(const Emitter& m, const Form& form) {
  on_ = false;
  const auto* const mode = std::find(std::begin(mode_made), std::end(mode_made), m.modal.motion);
  const std::int16_t row = m.modal.motion_row;
  if (m.modal.motion == MotionMode::cycle) return begin_holes(m, form);
  if (row < 0 || mode == std::end(mode_made) || m.batch->empty() || m.cycling() || m.cycle_memory.row >= 0) return end();
  const auto kind = static_cast<Kind>(mode - mode_made);
  if ((kind >= arc_cw) != form.gives_arc()) return end();
  const Action& last = m.batch->back();
  const auto* const motion = motion_of(last);
  if (motion == nullptr || last.origin.number != m.origin.number || motion->detail || motion->kind != kind_made[kind]) return end();
  // The motion that begins or leaves a contour differs from those in between.
  if (motion->side_step != SideStep::none) return end();
  const AxisMask named = kind >= arc_cw ? form.named | plane_of(m) : form.named;
  if (named != motion->named || !was_plain(m) || !only_words_count(m)) return end();
  on_ = true;
  contour_ = on_contour(m.modal);
  known_ = static_cast<std::uint8_t>(known_ | 1u << kind);
  rows_[kind] = row;
  modes_[kind] = *motion;
  if (m.modal.feed != feed_) note_feed(m.modal.feed);
  old_feed_ = static_cast<std::uint8_t>(old_feed_ & ~(1u << kind));
  note_modes(m);
}

/// Starts a run after a statement of a loop. Until a motion is executed the general way, the run has only statements.
void MotionRun::begin_loop(const Emitter& m) {
  end();
  if (m.cycling() || m.cycle_memory.row >= 0 || !only_words_count(m)) return;
  on_ = true;
  contour_ = on_contour(m.modal);
  note_modes(m);
}

/// Notes the modes that decide what the words of the next blocks mean.
void MotionRun::note_modes(const Emitter& m) {
  absolute_ = m.modal.absolute;
  arcs_ = m.arc_rule();
  rolling_ = m.dialect->rolling_axes(m);
  const AddressRow& number = m.def.address('N');
  const bool checks_numbers = m.def.machine_axes();  // the range of the block number is checked as in nct 1.1
  number_least_ = checks_numbers ? static_cast<std::uint32_t>(std::clamp(number.least, 0.0, 4e9)) : 0;
  number_most_ = checks_numbers ? static_cast<std::uint32_t>(std::clamp(number.most, 0.0, 4e9)) : ~std::uint32_t{0};
}

/// Starts a run of holes after a block that has started a drilling cycle.
void MotionRun::begin_holes(const Emitter& m, const Form& form) {
  end();
  if (!is_hole(m, form) || !was_plain(m) || on_contour(m.modal) || !only_words_count(m)) return;
  const bool repeats = m.running ? m.running->repeats(m) : m.canned_cycle_run.active() && m.canned_cycle_run.repeats(m);
  if (!repeats) return;
  on_ = holes_ = true;
  by_steps_ = m.running != nullptr;
  note_modes(m);
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

/// Reads the centre of the arc. Returns false if the words of the centre are not those of an arc in the plane.
bool MotionRun::find_center(const BlockContext& m, const Form& form, Vec2& center) const {
  const PlaneAxes plane = m.modal.axes;
  const AxisMask normal = AxisMask{1} << plane.normal;
  if (!arcs_.by_words || plane.first > 2 || plane.second > 2 || plane.normal > 2) return false;
  if (form.center[plane.normal].word != no_word || (arcs_.lead_on_normal && (form.named & normal) != 0)) return false;
  bool given = false;
  const auto read = [&](const MotionSlot& slot, double& at) {
    if (slot.word == no_word) return true;
    const double v = m.block->words[slot.word].value;
    if (!(v >= slot.least && v <= slot.most)) return false;
    given = true;
    at = arcs_.absolute ? v * slot.scale : at + v * slot.scale;
    return true;
  };
  return read(form.center[plane.first], center.x) && read(form.center[plane.second], center.y) && given;
}

/// Computes the arc from its centre or its radius, by the same rules as functions::arc_cw and functions::arc_ccw.
bool MotionRun::find_arc(Emitter& m, const Form& form, Kind kind, const Axes& to, PlaneArc& arc) const {
  const PlaneAxes plane = m.modal.axes;
  const Vec2 from{m.position.programmed[plane.first], m.position.programmed[plane.second]};
  const ArcEnds ends{from, {to[plane.first], to[plane.second]}, kind == arc_cw ? Turn::cw : Turn::ccw};
  const auto keep = [&](const Result<PlaneArc>& found) {
    if (found) arc = *found;
    return found.has_value();
  };
  if (form.centered) {
    Vec2 center = from;
    return find_center(m, form, center) && keep(m.dialect->arc_of_center(m, arcs_, ends, center));
  }
  const double v = m.block->words[form.radius.word].value;
  const bool fits = arcs_.radius_by_words && !arcs_.lead_on_normal && (form.named & plane_of(m)) != 0 && v >= form.radius.least &&
                    v <= form.radius.most && length(ends.to - ends.from) > tol::same_point;
  return fits && keep(m.dialect->arc_of_radius(m, arcs_, ends, v * form.radius.scale));
}

/// Executes a block of a run of holes: starts the drilling cycle in force at the position that the block states.
bool MotionRun::take_hole(Interpreter& m, const Form& form) {
  if (!is_hole(m, form) || (form.named & rolling_) != 0 || !number_fits(*m.block)) return refused();
  Axes to = m.position.programmed;
  if (!find_end(m, form, to)) return refused();
  if (!by_steps_) {
    m.canned_cycle_run.repeat_at(m, to);
  } else if (m.finished) {
    m.finished->repeat_at(to);
    m.running = std::move(m.finished);
  } else {
    return refused();
  }
  return true;
}

/// Computes the coordinates of the end point that the block states. Returns false if one of them is out of range.
bool MotionRun::find_end(const BlockContext& m, const Form& form, Axes& to) const {
  for (std::size_t i = 0; i < form.axes; ++i) {
    const MotionSlot& slot = form.slots[i];
    const double v = m.block->words[slot.word].value;
    if (!(v >= slot.least && v <= slot.most)) return false;
    const double scaled = v * slot.scale;
    to[slot.axis] = absolute_ && !slot.adds ? scaled : m.position.programmed[slot.axis] + scaled;
    if (!(std::fabs(to[slot.axis]) <= farthest)) return false;
  }
  return true;
}

/// Puts a new feed into force. The copies of the feed in `modes_`, one for each motion code, are updated when their code is used next.
void MotionRun::take_feed(BlockContext& m, double feed) {
  if (m.modal.feed_known && feed == m.modal.feed) return;
  m.modal.feed = feed;
  m.modal.feed_known = true;
  m.dialect->note_feed(m);
  note_feed(feed);
}

/// Returns true if a block of this form only states a position in the plane.
bool MotionRun::is_hole(const BlockContext& m, const Form& form) {
  const bool only_axes = form.fits && form.row < 0 && form.codes == 0 && form.feed.word == no_word && !form.gives_arc();
  return only_axes && (form.named & ~plane_of(m)) == 0;
}

bool MotionRun::changes_radius(const BlockContext& m, const Axes& to, Vec2 center) {
  const PlaneAxes& plane = m.modal.axes;
  const Axes& from = m.position.programmed;
  return radius_changes({from[plane.first], from[plane.second]}, {to[plane.first], to[plane.second]}, center);
}

// NOLINTNEXTLINE(readability-function-size): one function, because it runs once per line of a long program
bool MotionRun::take(Interpreter& m) {
  const Block& block = *m.block;
  if (holes_ && !block.shape) return refused();
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
  const Form& form = forms_.of(m, block);
  if (holes_) return take_hole(m, form);
  if (form.calls) {
    const bool done = form.call != no_word && is_read_again(block) && number_fits(block) && m.execute_call(form.call);
    if (done && !stays_after_call(m)) end();
    return done;
  }
  if (!form.fits) return refused();
  if (known_ == 0) return on_ = false;
  // If a word has no valid value, the general way (Interpreter::execute_block) evaluates the words again and reports the error.
  if (!block.shape && (!m.evaluate_words() || block.letters != form.letters)) return refused();
  if (form.feed.word != no_word || !block.shape) m.dialect->count_words(m);
  if ((form.named & rolling_) != 0 || !holds(m, form)) return refused();
  // A control may refuse codes under cutter compensation although they change nothing (LinuxCNC: the code of the plane).
  if (contour_ && form.codes != 0) return refused();
  const std::int16_t row = form.row >= 0 ? form.row : m.modal.motion_row;
  std::size_t k = 0;
  while (k < kinds && !((known_ >> k & 1u) != 0 && rows_[k] == row)) ++k;
  // A motion code that is new in this run is executed the general way (Interpreter::execute_block); note() then adds the code to the run.
  if (k == kinds) return on_ = false;
  const auto kind = static_cast<Kind>(k);
  if ((kind >= arc_cw) != form.gives_arc()) return refused();

  const bool arc = kind >= arc_cw;
  Axes to;
  if (arc) to = m.position.programmed;
  if (!find_end(m, form, to)) return refused();
  PlaneArc found;
  if (arc && !find_arc(m, form, kind, to, found)) return refused();

  const AxisMask named = arc ? form.named | plane_of(m) : form.named;
  const bool turns_evenly = arc && arcs_.even_angle && named == plane_of(m) && changes_radius(m, to, found.center);
  const Axes& work = m.position.work;
  const Vec2 from{work[m.modal.axes.first], work[m.modal.axes.second]};
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
  if (contour_) [[unlikely]]
    continue_contour(m, motion, from);
  m.dialect->note_line(m);
  return true;
}

}  // namespace kadr
