// Executes threads: G33, tapping by G331 and G332, tapping with a compensating chuck by G63 (spec/sinumerik 12.5). Used by
// control/sinumerik.

#include <cmath>
#include <memory>
#include <utility>

#include "control/sinumerik/block_run.h"

namespace kadr::sinumerik {

Status BlockRun::tap() {
  const std::size_t normal = m_.modal.axes.normal;
  const char lead_letter = m_.letters.center_letter[normal], axis_letter = m_.letters.axis_letter[normal];
  if (!block_.has(lead_letter) || !block_.has(axis_letter))
    return fail(alarm(AlarmId::word_missing, block_.where, lead_letter, "G331, G332"));
  const double lead = block_.find(lead_letter)->value * m_.unit_scale();
  double speed = m_.modal.rpm;
  if (block_.has('S')) m_.modal.rpm = speed = block_.find('S')->value;
  if (!(speed > 0) || lead == 0) return fail(alarm(AlarmId::speed_missing, block_.where));
  Axes to;
  AxisMask named = 0;
  KADR_TRY(m_.target(to, named));
  const double feed = m_.modal.feed;
  const FeedMode mode = m_.modal.feed_mode;
  m_.modal.feed = speed * std::fabs(lead);
  m_.modal.feed_mode = FeedMode::per_minute;
  const Status moved = m_.straight(MotionKind::feed, to, named);
  m_.modal.feed = feed;
  m_.modal.feed_mode = mode;
  return moved;
}

/// G33: a thread of constant lead. I, J, K give the lead along X, Y, Z; the axis with the longest way decides which of them acts.
Status BlockRun::thread() {
  Axes to;
  AxisMask named = 0;
  for (std::uint32_t i = 0; i < block_.word_count; ++i) {
    const Word& w = block_.words[i];
    const bool is_lead = w.address == 'I' || w.address == 'J' || w.address == 'K';
    if (w.address == 'S') m_.modal.rpm = w.value;
    else if (!axis_of(w.address) && !is_lead) return fail(alarm(AlarmId::statement_not_alone, w.where));
  }
  KADR_TRY(m_.target(to, named));
  std::size_t axis = 0;
  for (std::size_t a = 0; a < 3; ++a)
    if (std::fabs(to[a] - m_.position.programmed[a]) > std::fabs(to[axis] - m_.position.programmed[axis])) axis = a;
  const char letter = m_.letters.center_letter[axis];
  if (!block_.has(letter)) return fail(alarm(AlarmId::word_missing, block_.where, letter, "G33"));
  const double lead = std::fabs(block_.find(letter)->value) * m_.unit_scale();
  if (!(lead > 0)) return fail(alarm(AlarmId::thread_definition, block_.where));
  const bool turns = m_.modal.spindle == SpindleDir::cw || m_.modal.spindle == SpindleDir::ccw;
  if (!turns || !(m_.modal.rpm > 0)) return fail(alarm(AlarmId::spindle_not_turning, block_.where, "G33"));
  KADR_TRY(m_.straight(MotionKind::thread, to, named));
  Motion& motion = std::get<Motion>(m_.batch->back().what);
  motion.own_override = motion.no_hold = true;
  motion.unit = FeedUnit::mm_per_rev;
  motion.feed = lead;
  auto detail = motion.detail ? std::make_shared<MotionDetail>(*motion.detail) : std::make_shared<MotionDetail>();
  detail->lead = lead;
  if (own_.words.has("SF")) detail->start_angle = own_.words.number("SF");
  motion.detail = std::move(detail);
  return {};
}

/// G63: a line at feed for this block only; the feed is F, which is the speed times the lead.
Status BlockRun::begin_chuck() {
  own_.words.chuck = m_.modal;
  NamedItem item;
  item.where = block_.where;
  return add_code('G', 1, item);
}

/// SPOS, M19: stops the spindle at an angle.
void BlockRun::orient(double angle) {
  m_.modal.spindle = SpindleDir::stop;
  m_.emit(Spindle{SpindleDir::position, 0, 1, std::nullopt, angle});
}

}  // namespace kadr::sinumerik
