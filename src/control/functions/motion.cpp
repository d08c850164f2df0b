// Straight motions and frames: converts a programmed point to work and machine coordinates, and emits the Motion to it.

#include <algorithm>
#include <cmath>
#include <utility>

#include "action/by_kind.h"
#include "base/tolerance.h"
#include "control/emitter.h"
#include "control/functions/cutter_compensation.h"

namespace kadr {

double BlockContext::axis_target(const Word& w, std::size_t axis) const {
  const bool is_length = def.address(w.address).unit == WordUnit::length;
  double v = w.value * def.address(w.address).scale * (is_length && modal.inch ? mm_per_inch : 1.0);
  if ((modal.diameter >> axis & 1u) != 0) v /= 2;
  const bool absolute = modal.absolute && !w.incremental && def.address(w.address).function != Function::increment_axis;
  return absolute ? v : position.programmed[axis] + v;
}

Status BlockContext::target(Axes& to, AxisMask& named) const { return dialect->target(*this, to, named); }

Status BlockContext::axis_words(Axes& to, AxisMask& named) const {
  to = position.programmed;
  named = 0;
  for (std::uint32_t i = 0; i < block->word_count; ++i) {
    const Word& w = block->words[i];
    if ((letters.axes & letter_bit(w.address)) == 0) continue;
    const auto axis = static_cast<std::size_t>(static_cast<unsigned char>(letters.axis_of[static_cast<std::size_t>(w.address - 'A')]));
    to[axis] = axis_target(w, axis);
    named |= 1u << axis;
    if (!(std::fabs(to[axis]) <= farthest)) return fail(alarm(AlarmId::position_out_of_range, w.where, w.address, to[axis]));
  }
  return {};
}

/// Returns the next action of the batch as a motion to the computed position. The caller must set its modes, which are still those of an
/// earlier action.
Motion& Emitter::next_motion() {
  Action& action = batch->add();
  action.origin = origin;
  Motion* const reused = motion_of(action);
  Motion& motion = reused != nullptr ? *reused : action.what.emplace<Motion>();
  motion.detail.reset();
  for (std::size_t a = 0; a < axis_count; ++a) {  // the coordinates of axes that the control lacks remain 0
    motion.to[a] = position.work[a];
    motion.machine[a] = position.machine[a];
  }
  return motion;
}

std::uint16_t BlockContext::length_row() const {
  const bool ends_with_its_number = def.grammar.o_words;  // on LinuxCNC, G49 sets length_number to 0, and length_sign is not used
  if (modal.length_sign == 0 && !ends_with_its_number) return 0;
  return static_cast<std::uint16_t>(modal.length_number != 0 ? modal.length_number : modal.offset_number);
}

Motion& Emitter::add_motion(MotionKind kind, AxisMask named) {
  Motion& motion = next_motion();
  static_cast<MotionModes&>(motion) = MotionModes{};
  motion.kind = kind;
  motion.first = static_cast<std::uint8_t>(modal.axes.first);
  motion.second = static_cast<std::uint8_t>(modal.axes.second);
  motion.named = named;
  motion.inch = modal.inch;
  motion.diameters = modal.diameter;
  motion.spindle = modal.main_spindle;
  motion.own_override = !modal.override_enabled || (modal.override_permission & feed_permission) == 0;
  motion.exact = block_exact || (modal.exact && kind != MotionKind::rapid);
  motion.tolerance = modal.blend_tolerance;
  motion.length_offset = length_row();
  motion.radius_offset = modal.radius_side == 0 ? std::uint16_t{0} : static_cast<std::uint16_t>(modal.offset_number);
  motion.system = has_fixtures ? static_cast<std::uint16_t>(modal.fixture) : modal.work_zero;
  dialect->note_motion(*this, motion);
  return motion;
}

void Emitter::move_to(const Axes& programmed, const Axes& work, AxisMask named) {
  if (modal.inch || modal.contour != CompensationPhase::off || modal.feeds_of_axes != 0) moved_from = position.work;
  named = transform.moved_with(named);
  const AxisMask own = named & ((AxisMask{1} << axis_count) - 1);
  for (AxisMask rest = own; rest != 0; rest &= rest - 1) {
    const auto a = static_cast<std::size_t>(__builtin_ctz(rest));
    position.work[a] = work[a];
  }
  if (!frames.is_plain()) {
    const Axes machine = frames.machine_of(position.work);
    const AxisMask moved = frames.moved_with(named);
    for (std::size_t a = 0; a < axis_count; ++a)
      if ((moved >> a & 1u) != 0) position.machine[a] = machine[a];
    // With bit FOS of parameter N3212 (nct), X, Y and Z do not move while rotary axes move alone, so the work coordinates are computed from
    // the positions of the axes.
    if (frames.space && frames.space->changes_work(named)) {
      position.work = frames.work_of(position.machine);
      position.programmed = transform.to_programmed(position.work);
      return;
    }
  } else {
    for (AxisMask rest = own; rest != 0; rest &= rest - 1) {
      const auto a = static_cast<std::size_t>(__builtin_ctz(rest));
      position.machine[a] = work[a] + frames.origin[a] + frames.length[a];
    }
  }
  position.programmed = programmed;
}

Status BlockContext::within_reach(const Axes& work) const {
  for (std::size_t a = 0; a < axis_count; ++a)
    if (!(std::fabs(work[a]) <= farthest)) return fail(alarm(AlarmId::position_out_of_range, block->where, axis_names[a], work[a]));
  return {};
}

Status Emitter::straight(MotionKind kind, const Axes& programmed, AxisMask named) {
  if (modal.surface != PathSurface::plane) return dialect->surface_line(*this, kind, programmed, named);
  if (transform.identity) [[likely]] {
    move_to(programmed, programmed, named);
  } else {
    const Axes work = transform.to_work(programmed);
    KADR_TRY(within_reach(work));
    move_to(programmed, work, named);
  }
  Motion& motion = add_motion(kind, named);
  if (kind != MotionKind::rapid && kind != MotionKind::home) set_feed(motion);
  if (kind == MotionKind::feed && modal.feeds_of_axes != 0) motion.feed = feed_by_axes(motion);
  return {};
}

/// Returns the feed along a straight motion on which at least one axis has its own feed (GOST 20999-83). INFERRED: the path remains
/// straight, and the slowest component decides: that of an axis with its own feed, or that of all other axes together.
double BlockContext::feed_by_axes(const Motion& motion) const {
  double time = 0, rest = 0, all = 0;
  for (std::size_t a = 0; a < axis_count; ++a) {
    const double travel = motion.to[a] - moved_from[a];
    all += travel * travel;
    if ((modal.feeds_of_axes >> a & 1u) != 0) time = std::max(time, std::fabs(travel) / modal.axis_feed[a]);
    else rest += travel * travel;
  }
  if (modal.feed > 0) time = std::max(time, std::sqrt(rest) / modal.feed);
  return time > 0 ? feed_limited(std::sqrt(all) / time) : motion.feed;
}

void Emitter::stand_at(const Axes& machine) {
  position.machine = machine;
  for (std::size_t a = 0; a < axis_count && frames.is_plain(); ++a) position.work[a] = machine[a] - frames.origin[a] - frames.length[a];
  if (!frames.is_plain()) position.work = frames.work_of(machine);
  position.programmed = transform.to_programmed(position.work);
}

Status Emitter::to_machine(MotionKind kind, const Axes& machine, AxisMask named, double feed, EndReference end) {
  KADR_TRY(dialect->may_move(*this, named));
  for (std::size_t a = 0; a < axis_count; ++a) {
    if ((named >> a & 1u) == 0) continue;
    const std::size_t driven = frames.driven(a);
    position.machine[driven] = machine[driven];
    if (frames.is_plain()) position.work[a] = machine[a] - frames.origin[a] - frames.length[a];
  }
  if (!frames.is_plain()) position.work = frames.work_of(position.machine);
  position.programmed = transform.to_programmed(position.work);
  Motion& motion = add_motion(kind, named);
  motion.end_reference = end;
  if (feed > 0) motion.feed = feed;
  else if (kind == MotionKind::feed) set_feed(motion);
  if (frames.space && frames.space->controls_tip()) {  // the axes move linearly, so the end is not a programmed point of the tool tip
    auto detail = motion.detail ? std::make_shared<MotionDetail>(*motion.detail) : std::make_shared<MotionDetail>();
    detail->evenly = true;
    motion.detail = std::move(detail);
  }
  return {};
}

Status Emitter::feed_known(Span at) {
  if (modal.feed_mode == FeedMode::inverse_time) {
    if (!has('F')) return fail(alarm(AlarmId::feed_missing, at));
    return {};
  }
  if (modal.feed_known && modal.feed > 0) [[likely]]
    return {};
  if (modal.feeds_of_axes != 0 && axes_have_feeds()) return {};
  if (def.behaviour.feed_required || modal.feed_known) return fail(alarm(AlarmId::feed_missing, at));
  if (!std::exchange(feed_missing_reported, true)) warn(warning(AlarmId::feed_missing, at));
  return {};
}

std::optional<std::size_t> BlockContext::axis_of_feed(std::uint32_t index) const {
  const auto is_axis = [&](std::uint32_t i) { return (letters.axes & letter_bit(block->words[i].address)) != 0; };
  if (index == 0 || !is_axis(index - 1)) return std::nullopt;
  for (std::uint32_t i = index + 1; i < block->word_count; ++i)
    if (is_axis(i)) return static_cast<std::size_t>(letters.axis_of[static_cast<std::size_t>(block->words[index - 1].address - 'A')]);
  return std::nullopt;
}

/// Returns true if each axis that has a word in the block has its own feed.
bool BlockContext::axes_have_feeds() const {
  const bool arc = modal.motion == MotionMode::arc_cw || modal.motion == MotionMode::arc_ccw;
  AxisMask named = 0;
  for (std::size_t a = 0; a < axis_count; ++a)
    if (letters.axis_letter[a] != 0 && has(letters.axis_letter[a])) named |= 1u << a;
  return !arc && named != 0 && (named & ~modal.feeds_of_axes) == 0;
}

double BlockContext::feed_limited(double feed) const {
  const double most = def.behaviour.feed_most;
  return most > 0 && feed > most ? most : feed;  // 2С42 6.5.2: the feed is at most 5 m/min
}

double feed_in_inches(const BlockContext& m, const Motion& motion, const Axes& from) {
  bool turns = false;
  for (std::size_t a = 0; a < m.axis_count; ++a) {
    if (std::fabs(motion.to[a] - from[a]) <= tol::same_point) continue;
    if ((m.def.rotary >> a & 1u) == 0) return motion.feed;
    turns = true;
  }
  return turns ? motion.feed / mm_per_inch : motion.feed;
}

void Emitter::set_feed(Motion& motion) {
  switch (modal.feed_mode) {
    case FeedMode::per_minute:
      motion.unit = FeedUnit::mm_per_min;
      motion.feed = feed_limited(modal.feed);
      if (modal.inch) motion.feed = dialect->inch_feed(*this, motion, moved_from);
      break;
    case FeedMode::per_revolution:
      motion.unit = FeedUnit::mm_per_rev;
      motion.feed = modal.feed;
      break;
    case FeedMode::inverse_time:
      motion.unit = FeedUnit::per_min;
      motion.feed = modal.feed;
      break;
  }
}

// ---- frames

double BlockContext::radius_in_force() const {
  if (modal.radius_by_word >= 0) return modal.radius_by_word;
  return modal.offset_number < tables.offsets.size() ? tables.offsets[modal.offset_number].whole_radius() : 0.0;
}

SurfaceSpeed BlockContext::surface_speed() const { return dialect->surface_speed(*this); }

SurfaceSpeed BlockContext::speed_by_x() const {
  const auto x = std::find(axis_names.begin(), axis_names.end(), "X");
  const bool there = x != axis_names.end();
  return {modal.surface_speed, 1, there ? static_cast<std::uint8_t>(x - axis_names.begin()) : SurfaceSpeed::no_axis, modal.rpm};
}

FrameChange BlockContext::frame_change() const {
  FrameChange change{frames, position.work};
  const Axes shift = dialect->shift_of_origin(*this);
  if (shift != Axes{}) change.shifted = std::make_shared<const Axes>(shift);
  return change;
}

void Emitter::refresh_frames() { dialect->refresh_frames(*this); }

Axes BlockContext::shift_by_tables() const {
  Axes shift = zero_shift;
  for (std::size_t a = 0; a < axis_count; ++a) shift[a] += set_position[a];
  return shift;
}

void Emitter::frames_by_tables() {
  const std::uint32_t fixtures = variables.first(VariableKind::fixture);
  for (std::size_t a = 0; a < axis_count; ++a) {
    double origin_of_axis = tables.common[a] + zero_shift[a] + set_position[a];
    if (fixtures != 0 && a < 6)
      origin_of_axis += variables.raw(variables.first(VariableKind::fixture, modal.fixture - 1) + static_cast<std::uint32_t>(a));
    else origin_of_axis += tables.zeros[modal.work_zero][a];
    frames.origin[a] = origin_of_axis;
  }
  constexpr std::size_t length_axis = 2;  // Z
  const std::uint32_t number = modal.length_number != 0 ? modal.length_number : modal.offset_number;
  const bool in_table = number < tables.offsets.size();
  if (modal.length_sign != 0 && number != 0 && in_table)
    use.note(UseKind::length, number, origin, tables.offsets[number].whole_length() == 0);
  frames.length[length_axis] = modal.length_sign == 0 || !in_table ? 0.0 : modal.length_sign * tables.offsets[number].whole_length();
}

void Emitter::change_frames() {
  const Placement before = frames;
  refresh_frames();
  if (before == frames) return;
  if (!before.is_plain() || !frames.is_plain()) {
    position.work = frames.work_of(position.machine);
    dialect->roll(*this, position.work);
    emit(frame_change());
    position.programmed = transform.to_programmed(position.work);
    return;
  }
  for (std::size_t a = 0; a < axis_count; ++a) {
    // With LengthOffset::next_motion a new length takes effect in the next motion along its axis. Until then the tool's coordinate remains
    // as programmed.
    const double length = def.behaviour.length_offset == LengthOffset::at_once ? frames.length[a] - before.length[a] : 0.0;
    const double shift = frames.origin[a] - before.origin[a] + length;
    if (shift != 0) position.work[a] -= shift;
  }
  dialect->roll(*this, position.work);
  emit(frame_change());
  position.programmed = transform.to_programmed(position.work);
}

void Emitter::apply_mirror() {
  for (std::size_t a = 0; a < axis_count; ++a) {
    bool on = mirror_switches[a];
    if (a == 1 && modal.plane == Plane::zx) on = false;  // 2С42 6.8: in G18 the panel's mirror switch for Y has no effect
    if (a == 0 && modal.plane == Plane::yz) on = false;  // 2С42 6.8: in G19 the panel's mirror switch for X has no effect
    transform.mirror[a] = on ? std::int8_t{-1} : std::int8_t{1};
  }
  transform.refresh();
  position.programmed = transform.to_programmed(position.work);
}

}  // namespace kadr
