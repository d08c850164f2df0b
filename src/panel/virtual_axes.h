#pragma once
// VirtualAxes is the axes of one channel of Kadr's virtual machine. It passes the planned motion of these axes to the channel's servo
// clock, leg by leg. Only the machine's thread uses a VirtualAxes; the servo clock has its own thread.
//
//   plan() ──▶ Planned ──cells──▶ the last leg … the first ──▶ Playback ──▶ ServoClock

#include <deque>

#include "panel/channel_axes.h"

namespace kadr {

class VirtualAxes final : public ChannelAxes {
 public:
  /// `stand` is the position of the axes at the start, in machine coordinates. `rate` is that of the servo clock, Hz.
  VirtualAxes(int its_number, std::vector<std::string> names, const AxisRoles& its_roles, double rate, const Axes& stand)
      : ChannelAxes(its_number, std::move(names), its_roles), rate_(rate), clock_(rate, stand, its_roles) {}

  ServoSample sample() const override { return clock_.sample(); }
  void stop_at_once() override { clock_.stop_at_once(); }
  void release() override { clock_.release(); }
  bool was_stopped() const override { return clock_.was_stopped(); }
  void stand_at(const Axes& machine) override { clock_.stand_at(machine); }
  double nearly_there() const override { return 1e-6; }

  void begin_leg(Session& session, std::size_t channel, const PanelOverrides& shares) override { plan(session.plan(channel), shares); }
  void take(const Step&) override {}  // the session's planner has it
  void begin_by_hand(const Channel& channel, const MachineProfile& machine, const ToolPosition& stand,
                     const PanelOverrides& shares) override;
  void take_by_hand(const Step& step) override { by_hand_->consume(step); }
  void end_leg(std::shared_ptr<PanelMeeting> meeting = {}, const Origin& at = {}) override;
  void meet(const std::shared_ptr<PanelMeeting>& meeting) override {
    if (!legs_.empty()) legs_.back().meeting = meeting;
  }
  const PanelMeeting* meeting() const override { return legs_.empty() ? nullptr : legs_.back().meeting.get(); }
  const PanelMeeting* waits_for() const override;
  const Origin& block() const override { return waits_for() != nullptr ? legs_.front().waits_in : on.origin; }
  bool is_planned() const override { return planned_ != nullptr; }
  /// True if less than `enough` seconds are planned ahead of the clock.
  bool wants_more() const override { return planned_ != nullptr && ahead() < enough; }
  bool is_full() const override { return cells_ > max_cells; }
  void go_on() override;
  void note_block() override;
  void apply_overrides(const PanelOverrides& shares, bool stands) override;
  std::optional<PanelLimit> limit() override;
  bool is_over() const override;
  bool stands() const override;
  void settle() override;
  void drop() override;

 private:
  void plan(Planned& planned, const PanelOverrides& shares);
  /// The motion from one stop of the axes to the next stop.
  struct Leg {
    Leg(const MotionLimits& of_axes, double rate) : playback(of_axes, rate) {}
    Playback playback;
    PanelBlocks blocks;
    std::deque<PanelLimit> limits;   // limits of the motion that is not played yet, in the order of time
    std::deque<TimedCells> to_come;  // cells of the plan that are not yet offered to the playback
    std::size_t offered = 0;         // number of cells in the first element of to_come that are already offered
    double seconds = 0;              // planned duration of the leg (the motion up to the next stop), s
    bool planned_all = false;
    std::shared_ptr<PanelMeeting> meeting;  // the waiting code, with its channels, at the end of the leg; nullptr: there is none
    Origin waits_in;                        // the block with the waiting code at the end of the leg
  };
  static constexpr double enough = 3 * Playback::reserve;  // Planning continues while less than this time is planned ahead of the clock, s.
  // Limit of stored cells, about 40 MB. It is reached only if another channel needs much more planning than this channel.
  static constexpr std::size_t max_cells = 100'000;

  double ahead() const;
  bool is_through(const Leg& leg) const;
  bool offer_first(Leg& leg);
  void offer(Leg& leg);
  void take_cells(Leg& leg, const TimedCells& cells, const MotionLimits& limits);

  const double rate_;
  ServoClock clock_;
  std::unique_ptr<Planned> by_hand_;  // planner of the leg in which the operator moves the axes
  Planned* planned_ = nullptr;        // The planner of the leg that was started last; nullptr when this leg is completely planned.
  std::deque<Leg> legs_;
  std::size_t cells_ = 0;         // number of cells in all legs that are not yet offered to a playback
  const Leg* playing_ = nullptr;  // the first of the stored legs while the clock plays its motion; otherwise nullptr
  double share_ = 1;              // the last requested override, as a factor of the planned speed
};

}  // namespace kadr
