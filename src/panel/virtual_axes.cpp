// VirtualAxes is the axes of one channel of the virtual machine. Used by panel/panel_machine; tested by
// tests/panel/panel_channels_test.cpp.

#include "panel/virtual_axes.h"

#include <algorithm>
#include <utility>

namespace kadr {
namespace {

// Time of motion, s, that the planner computes in one step. It is short, so that a program with long motions starts at once.
constexpr double planned_each = 1;

}  // namespace

void VirtualAxes::take_cells(Leg& leg, const TimedCells& cells, const MotionLimits& limits) {
  for (std::size_t i = 0; i < cells.laws.size(); ++i) {
    leg.seconds += cells.laws[i].seconds;
    const PanelLimit limit{limited_by(cells, i, limits), Spent::of(cells.sources[i].tag).on == Spent::On::rapid, leg.seconds};
    const auto is_same = [&](const PanelLimit& last) {
      return last.by.limit == limit.by.limit && last.by.axis == limit.by.axis && last.rapid == limit.rapid;
    };
    if (!leg.limits.empty() && is_same(leg.limits.back())) leg.limits.back().until = limit.until;
    else leg.limits.push_back(limit);
  }
  cells_ += cells.laws.size();
  leg.to_come.push_back(cells);
}

void VirtualAxes::plan(Planned& planned, const PanelOverrides& shares) {
  planned_ = &planned;
  // The list of legs is a deque, so the address of the new leg stays valid when further legs are added.
  Leg& leg = legs_.emplace_back(planned.limits(), rate_);
  planned.on_cells = [this, &leg, &limits = planned.limits()](const TimedCells& cells) { take_cells(leg, cells, limits); };
  planned.number_motions([this, &leg](std::uint64_t motion) {
    pending.motion = motion;
    leg.blocks.add(pending);
  });
  planned.plan_each(planned_each);
  planned.run_dry(shares.dry_feed);
  planned.scale_feed(shares.planned());
}

void VirtualAxes::begin_by_hand(const Channel& channel, const MachineProfile& machine, const ToolPosition& stand,
                                const PanelOverrides& shares) {
  by_hand_ = std::make_unique<Planned>(channel, machine, stand);
  plan(*by_hand_, shares);
}

void VirtualAxes::end_leg(std::shared_ptr<PanelMeeting> meeting, const Origin& at) {
  if (planned_ == nullptr) return;
  (void)planned_->finish();
  planned_ = nullptr;
  legs_.back().planned_all = true;
  legs_.back().meeting = std::move(meeting);
  legs_.back().waits_in = at;
}

double VirtualAxes::ahead() const {
  double seconds = 0;
  for (const Leg& leg : legs_) seconds += leg.seconds;
  const ServoSample at = clock_.sample();
  return seconds - (playing_ != nullptr && at.plays ? at.played : 0);
}

/// Offers the first stored cells of the leg's plan to the leg's playback. Returns false if some of these cells do not fit.
bool VirtualAxes::offer_first(Leg& leg) {
  const TimedCells& cells = leg.to_come.front();
  leg.offered += leg.playback.offer(cells, leg.offered);
  if (leg.offered < cells.laws.size()) return false;
  cells_ -= cells.laws.size();
  leg.to_come.pop_front();
  leg.offered = 0;
  return true;
}

void VirtualAxes::offer(Leg& leg) {
  while (!leg.to_come.empty())
    if (!offer_first(leg)) return;
  if (leg.planned_all) leg.playback.finish();
}

bool VirtualAxes::is_through(const Leg& leg) const {
  return &leg == playing_ && leg.planned_all && leg.to_come.empty() && !clock_.sample().plays;
}

void VirtualAxes::go_on() {
  while (!legs_.empty()) {
    Leg& leg = legs_.front();
    offer(leg);
    if (playing_ == nullptr) {
      leg.playback.override_to(share_);
      playing_ = &leg;
      clock_.play(&leg.playback);
    }
    if (!is_through(leg) || leg.meeting == nullptr) return;
    leg.meeting->here.insert(number);
    if (!leg.meeting->is_over() || legs_.size() == 1) return;
    note_block();
    clock_.play(nullptr);
    playing_ = nullptr;
    legs_.pop_front();
  }
}

void VirtualAxes::note_block() {
  if (playing_ == nullptr) return;
  if (const PanelBlock* const block = legs_.front().blocks.at(clock_.sample().motion)) on = *block;
}

/// Sets the override of the current motion: the feed override or the rapid override. When rapid motion changes to feed, the new override
/// applies some thousandths of a second late.
void VirtualAxes::apply_overrides(const PanelOverrides& shares, bool stands) {
  const double spindle = on.by_turn ? std::min(1.0, shares.spindle) : 1;
  const double share = on.feed > 0 ? shares.feed / on.factor * spindle : std::min(shares.rapid, shares.feed > 0 ? 1.0 : 0.0);
  share_ = stands ? 0 : share;
  if (planned_ != nullptr) planned_->scale_feed(shares.planned());
  if (!legs_.empty()) legs_.front().playback.override_to(share_);
}

std::optional<PanelLimit> VirtualAxes::limit() {
  const ServoSample at = clock_.sample();
  if (playing_ == nullptr || !at.plays || at.held) return std::nullopt;
  std::deque<PanelLimit>& limits = legs_.front().limits;
  while (limits.size() > 1 && limits.front().until <= at.played) limits.pop_front();
  return limits.empty() ? std::nullopt : std::optional(limits.front());
}

bool VirtualAxes::is_over() const {
  return legs_.empty() ||
         (legs_.size() == 1 && is_through(legs_.front()) && (legs_.front().meeting == nullptr || !legs_.front().meeting->is_over()));
}

bool VirtualAxes::stands() const {
  const ServoSample at = clock_.sample();
  return at.held || !at.plays;
}

const PanelMeeting* VirtualAxes::waits_for() const {
  return !legs_.empty() && is_through(legs_.front()) ? legs_.front().meeting.get() : nullptr;
}

void VirtualAxes::settle() {
  note_block();
  if (!waits()) drop();
}

void VirtualAxes::drop() {
  clock_.play(nullptr);
  playing_ = nullptr;
  planned_ = nullptr;
  legs_.clear();
  cells_ = 0;
}

}  // namespace kadr
