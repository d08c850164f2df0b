// The variables #1 … #33 of each call level, and #100 … #999 (spec/nct/23 23.1.3, 23.1.4). Used by the rest of control.

#include "control/variables/macro_variables.h"

#include <algorithm>
#include <utility>

namespace kadr {

Locals no_locals() {
  Locals all;
  all.fill(vacant);
  return all;
}

MacroVariables::MacroVariables(std::shared_ptr<Commons> shared, int shared_100, int shared_500)
    : shared_(std::move(shared)), own_(std::make_unique<Commons>()) {
  for (int n = first_common; n <= last_common; ++n) {
    const bool is_shared = n < first_permanent ? n - first_common < shared_100 : n - first_permanent < shared_500;
    commons_[static_cast<std::size_t>(n - first_common)] = &(is_shared ? shared_.get() : own_.get())->values[static_cast<std::size_t>(n)];
  }
  levels_.push_back(no_locals());
}

std::vector<std::uint16_t> MacroVariables::take_changed() {
  is_changed_.fill(false);
  return std::exchange(changed_, {});
}

MacroVariables::Memory MacroVariables::memory() const {
  Memory now{{}, levels_, further_};
  now.commons.reserve(commons_.size());
  for (const double* const common : commons_) now.commons.push_back(*common);
  return now;
}

void MacroVariables::resume_from(const Memory& memory) {
  for (std::size_t i = 0; i < commons_.size(); ++i) set_common(first_common + static_cast<int>(i), memory.commons[i]);
  levels_ = memory.levels;
  further_ = memory.further;
}

void MacroVariables::power_off() {
  for (int n = first_common; n < first_permanent; ++n) *commons_[static_cast<std::size_t>(n - first_common)] = vacant;
  levels_.assign(1, no_locals());
}

}  // namespace kadr
