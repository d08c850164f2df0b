#pragma once
// LatticePart: cuts any part for the page, on a lattice. It is used by view/part_run.
//
//   CutRun ─▶ two stocks: a fine one as in `kadr cut`, for volumes and findings,
//             and a coarser one that records its history, for display

#include "session/cutting/cut_run.h"
#include "view/part_run.h"

namespace kadr {

class LatticePart final : public PartRun {
 public:
  LatticePart(const OpenedProgram& opened, const StopToken& stop) : PartRun(opened, stop) {}

  /// Reads the solids, chooses the cells and opens the session. Returns an error sentence if something is wrong.
  tl::expected<void, std::string> begin(const PartRequest& request);
  tl::expected<void, std::string> execute() override;
  std::size_t alarms() const override { return run_->alarms(); }
  std::size_t warnings() const override { return run_->warnings(); }
  PartThen at(double instant) const override;
  Vec3 zero() const override { return run_->cutting().zero(); }

 private:
  Maker maker_of(std::int32_t number) const override;
  const std::optional<AlarmReport>& without_shape() const override { return run_->without_shape(); }
  double bytes() const override { return double(run_->cutting().bytes()); }
  tl::expected<void, std::string> find_material(const PartRequest& request);
  tl::expected<std::shared_ptr<const Blank>, std::string> body(const std::string& text);

  std::unique_ptr<MachineWatch> watch_;
  std::unique_ptr<CutRun> run_;
};

}  // namespace kadr
