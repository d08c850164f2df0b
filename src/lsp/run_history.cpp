// RunHistory: goes back in a run. Used by lsp/debug_adapter; tested by tests/dap.py.

#include "lsp/run_history.h"

#include <algorithm>

namespace kadr {
namespace {

constexpr std::uint32_t first_distance = 1024;  // blocks between two snapshots at first
constexpr std::size_t most_snapshots = 512;     // then every second one is dropped

}  // namespace

RunHistory::RunHistory(Session& session, Stepping& stepping)
    : session_(session), stepping_(stepping), first_(stepping.snapshot()), each_(first_distance) {}

void RunHistory::note() {
  const std::uint32_t number = session_.control().origin().number;
  if (number < (all_.empty() ? 0 : all_.back().number) + each_) return;
  auto snapshot = stepping_.snapshot();
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
    KADR_TRY(stepping_.restore(all_.back().memory));
  }
  return stepping_.go_to(target);
}

/// Runs on to the block with the number `until`, and notes the last block before it at which a stop point holds the program.
///   returns  false if `stop` has ended the run before that block
bool RunHistory::search_part(Search& of, const std::function<bool(std::size_t)>& holds, const StopToken& stop) {
  StopPoint end;
  end.number = of.until;
  const std::size_t added = stepping_.add(end);
  bool ended = true;
  while (stepping_.go(Stepping::How::free) == Session::State::held && stepping_.next()->number < of.until) {
    if (stepping_.hit() != 0 && holds(stepping_.hit())) of.last = stepping_.next()->number;
    if (!stop.requested()) continue;
    ended = false;
    break;
  }
  stepping_.remove(added);
  return ended;
}

RunHistory::Search RunHistory::begin_search() const {
  return {stepping_.next() ? stepping_.next()->number : session_.control().origin().number + 1};
}

Result<std::optional<Session::State>> RunHistory::search(Search& of, const std::function<bool(std::size_t)>& holds, const StopToken& stop) {
  const auto to = [&](std::uint32_t number) -> Result<std::optional<Session::State>> {
    const auto state = go_back(number);
    if (!state) return fail(state.error());
    return std::optional(*state);
  };
  const bool any = std::any_of(stepping_.points().begin(), stepping_.points().end(), [&](const auto& point) { return holds(point.first); });
  if (!first_ || !any) return to(0);
  const auto after = [](const Kept& kept) { return kept.number + 2; };  // the block directly after a snapshot is not asked about again
  if (!of.inside) {
    while (!all_.empty() && after(all_.back()) >= of.until) all_.pop_back();
    KADR_TRY(stepping_.restore(all_.empty() ? *first_ : all_.back().memory));
    of.inside = true;
    of.last.reset();
  }
  if (!search_part(of, holds, stop)) return std::optional<Session::State>();
  of.inside = false;
  if (of.last) return to(*of.last);
  if (all_.empty()) return to(0);
  of.until = after(all_.back());
  return std::optional<Session::State>();
}

}  // namespace kadr
