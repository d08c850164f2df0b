#pragma once
// GrblAxes is the axes of a real machine with a controller of the Grbl family. The actions of the session, of any control, become lines of
// the controller (GrblWriter); a leg is a job of the machine (GrblMachine). The position is the one that the controller has reported last.
//
//   take(Step) ──▶ GrblWriter ──▶ GrblMachine ──▶ controller ──▶ report ──▶ sample(), on

#include <atomic>

#include "drive/grbl/grbl_machine.h"
#include "drive/grbl/grbl_writer.h"
#include "panel/channel_axes.h"

namespace kadr {

class GrblAxes final : public ChannelAxes {
 public:
  GrblAxes(std::shared_ptr<drive::GrblMachine> machine, std::vector<std::string> names, const AxisRoles& its_roles);

  ServoSample sample() const override;
  void stop_at_once() override;
  void release() override { stopped_ = false; }
  bool was_stopped() const override { return stopped_; }
  std::optional<RealMachine> real() const override;
  void stand_at(const Axes&) override {}
  double nearly_there() const override { return step_error; }
  bool is_real() const override { return true; }
  PanelOverrides possible(PanelOverrides wanted) const override;
  std::string fault() override;
  std::string not_ready() const override;
  void recover() override;
  bool home() override;
  bool unlock() override;

  void begin_leg(Session& session, std::size_t channel, const PanelOverrides& shares) override;
  void take(const Step& step) override;
  void begin_by_hand(const Channel& channel, const MachineProfile& machine, const ToolPosition& stand,
                     const PanelOverrides& shares) override;
  void take_by_hand(const Step& step) override { take(step); }
  bool begin_jog(std::size_t axis, double end, double feed) override;
  bool begin_probe(std::size_t axis, double end, double feed) override;
  std::optional<Axes> touched() const override;
  void keep_jogging() override { machine_->keep_jogging(); }
  void end_leg(std::shared_ptr<PanelMeeting> meeting = {}, const Origin& at = {}) override;
  bool is_planned() const override { return is_open_; }
  bool wants_more() const override { return is_open_ && machine_->queued() < enough; }
  bool is_full() const override { return machine_->queued() > most_queued; }
  void go_on() override {}
  void note_block() override;
  void apply_overrides(const PanelOverrides& shares, bool stands) override;
  bool is_over() const override;
  bool stands() const override;
  void settle() override;
  void drop() override;

  // Greatest difference between a reported and a commanded position at rest: half a step, and the rounding of reports, mm.
  static constexpr double step_error = 0.02;

 private:
  static constexpr std::size_t enough = 64, most_queued = 512;  // lines

  void open_leg(const PanelOverrides& shares, bool by_hand);
  void wait_for_rest() const;
  bool is_working() const;

  const std::shared_ptr<drive::GrblMachine> machine_;
  drive::GrblWriter writer_;
  PanelBlocks blocks_;
  std::atomic<bool> stopped_{false};
  bool is_open_ = false;       // the session may still add to the leg
  std::uint64_t job_ = 0;      // number of the job of the leg; 0: the leg has no line yet
  std::uint64_t touches_ = 0;  // number of touches before the present probe motion
  bool jogs_ = false;          // the leg is a motion by a held key
  std::uint32_t motion_ = 0;   // number of the last motion
  bool holds_ = false;         // a feed hold was sent
  std::string refused_;        // why an action cannot be executed
  std::optional<PanelOverrides> sent_;
};

}  // namespace kadr
