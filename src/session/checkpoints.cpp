// Checkpoints: stores snapshots of a run at regular numbers of blocks, so that any block of a long program is reached quickly. It is tested
// by tests/session/checkpoints_test.cpp.

#include "session/checkpoints.h"

#include <algorithm>
#include <utility>

namespace kadr {

Checkpoints::Checkpoints(Session& session, std::uint64_t each, std::size_t most)
    : session_(session), each_(each), most_(std::max<std::size_t>(most, 2)) {}

Checkpoints::~Checkpoints() { session_.control().note_lines(nullptr, 0); }

Session::State Checkpoints::run() {
  session_.control().note_lines(&marks_, each_);
  Session::State state = Session::State::running;
  std::uint64_t block = 0, saved_at = 0;
  keep();
  while (state == Session::State::running) {
    state = session_.go_on();
    block = session_.blocks();
    if (block - saved_at < each_ || state != Session::State::running) continue;
    saved_at = block;
    keep();
  }
  if (!all_.empty()) all_.back().marks = marks_;
  session_.control().note_lines(nullptr, 0);
  return state;
}

/// Stores a snapshot, which starts a new segment. The line marks collected so far belong to the segment before the snapshot.
void Checkpoints::keep() {
  auto now = session_.snapshot();
  if (!now) return;
  if (!all_.empty()) all_.back().marks = marks_;
  marks_ = {};
  if (all_.size() >= most_) thin_out();
  all_.push_back({std::move(*now), {}, session_.control().blocks()});
}

void Checkpoints::thin_out() {
  std::vector<Checkpoint> half;
  for (std::size_t i = 0; i < all_.size(); ++i) {
    if (i % 2 == 0) half.push_back(std::move(all_[i]));
    else half.back().marks.add(all_[i].marks);
  }
  all_ = std::move(half);
  each_ *= 2;
}

bool Checkpoints::may_hold(const LineMarks& marks, const StopPoint& target) const {
  if (target.line == 0) return true;
  if (target.file.empty()) return marks.may_hold(0, target.line);
  // True if the line is in a called file. The number of that file is not known before the call, so any segment of the run may contain the
  // line.
  return true;
}

Result<Session::State> Checkpoints::reach(Stepping& stepping, const StopPoint& target) {
  std::uint32_t passed = 0;
  Session::State state = Session::State::ended;
  for (std::size_t i = 0; i < all_.size(); ++i) {
    if (!may_hold(all_[i].marks, target)) continue;
    if (target.number != 0 && i + 1 < all_.size() && all_[i + 1].blocks < target.number) continue;
    KADR_TRY(stepping.restore(all_[i].snapshot, target, passed));
    const std::uint64_t blocks = all_[i].marks.blocks();
    const bool last = i + 1 == all_.size();
    state = stepping.go_to(target, last ? ~std::uint64_t{0} : blocks);
    if (state != Session::State::held || !stepping.ran_out()) return state;
    passed = stepping.passes(target.line, target.file);
  }
  return state == Session::State::held ? Session::State::ended : state;
}

}  // namespace kadr
