#pragma once
// TurnedPart: cuts a turned part for the page, exactly, as `kadr cut` does on a lathe's control. It is used by view/part_run.
//
//   TurnedRun ─▶ the region of the part, and TurnedPast ─▶ the part at any instant ─▶ surface with threads, sections

#include "session/cutting/turned_past.h"
#include "session/cutting/turned_run.h"
#include "view/part_run.h"

namespace kadr {

class TurnedPart final : public PartRun {
 public:
  TurnedPart(const OpenedProgram& opened, const PartRequest& request, TurnedJob job, const StopToken& stop);

  /// Opens the session. Returns an error sentence if something is wrong.
  tl::expected<void, std::string> begin();
  tl::expected<void, std::string> execute() override;
  std::size_t alarms() const override { return run_->alarms(); }
  std::size_t warnings() const override { return run_->warnings(); }
  PartThen at(double instant) const override;
  std::vector<ShownInsert> inserts() const override;
  Vec3 zero() const override;

 private:
  Maker maker_of(std::int32_t number) const override;
  const std::optional<AlarmReport>& without_shape() const override { return run_->without_shape(); }
  double bytes() const override { return double(past_.bytes()); }

  Vec3 picture_zero_;
  TurnedJob turned_;
  TurnedPast past_;
  double deviation_ = 0;  // greatest deviation of the triangles from the part, mm
  std::unique_ptr<TurnedRun> run_;
};

/// Returns the outlines of a turning tool for display.
///   pre  tool_fault_message(tool) is empty
std::vector<ShownInsert> shown_inserts(const ToolGeometry& tool);

}  // namespace kadr
