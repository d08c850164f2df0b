// RunHistory: goes back in a run. Used by lsp/debug_adapter; tested by tests/dap.py.

#include "lsp/run_history.h"

#include <algorithm>

namespace kadr {
namespace {

constexpr std::uint32_t first_distance = 4096;  // blocks between two snapshots at first
constexpr std::size_t most_snapshots = 128;     // then every second one is dropped

}  // namespace

RunHistory::RunHistory(Session& session, Stepping& stepping)
    : session_(session), stepping_(stepping), first_(stepping.snapshot()), each_(first_distance) {}

void RunHistory::note() {
  const std::uint32_t number = session_.control().origin().number;
  if (number < (all_.empty() ? 0 : all_.back().number) + each_) return;
  auto snapshot = session_.snapshot();
  if (!snapshot) return;
  all_.push_back({std::move(*snapshot), number});
  if (all_.size() < most_snapshots) return;
  std::size_t kept = 0;
  for (std::size_t i = 0; i < all_.size(); i += 2) all_[kept++] = std::move(all_[i]);
  all_.erase(all_.begin() + static_cast<std::ptrdiff_t>(kept), all_.end());
  each_ *= 2;
}

Result<Session::State> RunHistory::go_back(std::uint32_t number) {
  if (!first_) return session_.go_on();
  // The block directly after a snapshot is not asked about again, so it cannot be the target.
  const auto from = std::find_if(all_.rbegin(), all_.rend(), [&](const Kept& kept) { return kept.number + 1 < number; });
  all_.erase(from.base(), all_.end());  // the run may go another way from here
  StopPoint target;
  target.number = number;
  if (all_.empty() || !first_->next || number <= first_->next->number) {
    KADR_TRY(stepping_.restore(*first_));
    if (!first_->next || number <= first_->next->number) return Session::State::held;
  } else {
    KADR_TRY(stepping_.restore(all_.back().snapshot, target, 0));
  }
  return stepping_.go_to(target);
}

}  // namespace kadr
