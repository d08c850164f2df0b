// AxisLinks moves axes of one channel that follow axes of another channel, and exchanges axes between channels (spec/nct/20 20.2, 20.3). It
// is used by session/channels and tested by tests/cases/nct/20-channels.cases.

#include "session/axis_links.h"

#include <algorithm>

#include "session/channels.h"

namespace kadr {

std::optional<AxisLinks::Place> AxisLinks::place_of(int number) const {
  for (std::size_t c = 0; c < channels_.size(); ++c)
    for (std::size_t a = 0; a < channels_[c].control->axes().size(); ++a)
      if (channels_[c].control->axis_number(a) == number) return Place{c, a};
  return std::nullopt;
}

/// True if `axis` follows `master`, directly or through other axes. An axis also counts as following itself.
bool AxisLinks::follows(Place axis, Place master) const {
  if (axis == master) return true;
  return std::any_of(links_.begin(), links_.end(), [&](const LinkedAxis& link) {
    return link.far.link == AxisLink::follows && Place{link.channel, link.far.axis} == axis &&
           follows({link.to_channel, link.to_axis}, master);
  });
}

bool AxisLinks::may_link(const LinkedAxis& link) const {
  const Place own{link.channel, link.far.axis}, other{link.to_channel, link.to_axis};
  const Control& its = *channels_[link.to_channel].control;
  if (link.far.link == AxisLink::follows) return !follows(other, own) && !its.rolls_over(link.to_axis);
  const bool is_master = std::any_of(links_.begin(), links_.end(), [&](const LinkedAxis& l) {
    const Place master{l.to_channel, l.to_axis};
    return master == own || master == other;
  });
  return !is_master && channels_[link.channel].control->may_exchange(link.far.axis) && its.may_exchange(link.to_axis);
}

/// Returns the machine position of the link's master axis, mm or degrees: while the master is parked, its programmed position (nct 20.2);
/// otherwise its actual position.
double AxisLinks::master_at(const LinkedAxis& link) const {
  const Control& control = *channels_[link.to_channel].control;
  const bool parked = control.is_parked(link.to_axis);
  return (parked ? control.tool_position() : runs_[link.to_channel]->position()).machine[link.to_axis];
}

double AxisLinks::offset_of(const LinkedAxis& link) const {
  return runs_[link.channel]->position().machine[link.far.axis] - link.far.sign * master_at(link);
}

void AxisLinks::begin(LinkedAxis link) {
  if (link.far.link == AxisLink::follows) {
    link.offset = offset_of(link);
    runs_[link.channel]->hang(link.far.axis, true);
  } else {
    runs_[link.channel]->exchange(link.far.axis, *runs_[link.to_channel], link.to_axis, true);
  }
  links_.push_back(link);
}

void AxisLinks::end(const LinkedAxis& link) {
  if (link.far.link == AxisLink::follows) runs_[link.channel]->hang(link.far.axis, false);
  else runs_[link.channel]->exchange(link.far.axis, *runs_[link.to_channel], link.to_axis, false);
}

void AxisLinks::relink(std::size_t channel) {
  Control& control = *channels_[channel].control;
  const std::vector<CrossChannelAxis> far_axes = control.cross_channel_axes();
  std::erase_if(links_, [&](const LinkedAxis& link) {
    if (link.channel != channel || std::find(far_axes.begin(), far_axes.end(), link.far) != far_axes.end()) return false;
    end(link);
    return true;
  });
  for (const CrossChannelAxis& far : far_axes) {
    const bool known =
        std::any_of(links_.begin(), links_.end(), [&](const LinkedAxis& link) { return link.channel == channel && link.far == far; });
    if (known) continue;
    const auto place = place_of(far.other);
    const LinkedAxis link{channel, far, place ? place->first : 0, place ? place->second : 0, 0};
    if (place && may_link(link)) begin(link);
    else control.drop_cross_channel(far);
  }
}

Status AxisLinks::carry(std::size_t moved) {
  for (LinkedAxis& link : links_) {
    if (link.to_channel != moved || link.far.link != AxisLink::follows) continue;
    // INFERRED: an axis that is no longer parked follows from its present position. Therefore the offset is computed again here.
    if (channels_[link.channel].control->is_parked(link.far.axis)) {
      link.offset = offset_of(link);
      continue;
    }
    const double to = link.offset + link.far.sign * master_at(link);
    if (to == runs_[link.channel]->position().machine[link.far.axis]) continue;
    KADR_TRY(runs_[link.channel]->move_linked_axis(link.far.axis, to));
    KADR_TRY(carry(link.channel));
  }
  return {};
}

void AxisLinks::resume_from(const std::vector<LinkedAxis>& then) {
  const auto put = [&](bool on) {
    for (const LinkedAxis& link : links_) {
      if (link.far.link == AxisLink::follows) runs_[link.channel]->hang(link.far.axis, on);
      else runs_[link.channel]->exchange_limits(link.far.axis, *runs_[link.to_channel], link.to_axis);
    }
  };
  put(false);
  links_ = then;
  put(true);
}

}  // namespace kadr
