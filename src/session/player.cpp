// Player: plays a session in the machine's time. It is used by embedding programs and tested by tests/session/player_test.cpp.

#include "session/player.h"

#include <utility>

namespace kadr {

Player::Player(Session& session, double rate)
    : session_(session), planned_(session.plan(session.own())), axes_(session.control().axes().size()), playback_(planned_.limits(), rate) {
  planned_.on_cells = [this](const TimedCells& cells) { to_come_.push_back(cells); };
}

Player::~Player() { planned_.on_cells = nullptr; }

/// Passes the first stored cells of the plan to the playback. Returns false if the playback has no space for all of them.
bool Player::offer() {
  const TimedCells& cells = to_come_.front();
  offered_ += playback_.offer(cells, offered_);
  begun_ = offered_ < cells.laws.size();
  if (begun_) return false;
  to_come_.pop_front();
  offered_ = 0;
  return true;
}

/// Passes enough cells of the plan to the playback for the next instant, so that the axes do not brake for lack of cells. Further cells are
/// not passed. Therefore a feed hold has the same effect, no matter how far the session has been executed in advance.
void Player::provide() {
  constexpr double enough = 3 * Playback::reserve;
  while (true) {
    if (begun_ && !offer()) return;
    if (playback_.ahead() > enough) return;
    if (!to_come_.empty()) begun_ = true;
    else if (planned_all_) return playback_.finish();
    else go_on();
  }
}

void Player::go_on() {
  if (state_ == Session::State::running) state_ = session_.go_on();
  if (state_ == Session::State::running) return;
  (void)planned_.finish();
  planned_all_ = true;
}

std::size_t Player::next(double* positions, std::size_t count) {
  for (std::size_t row = 0; row < count; ++row) {
    if (playback_.done()) return row;
    provide();
    if (playback_.fill(positions + row * axes_, 1) == 0) return row;
  }
  return count;
}

std::optional<Player::Memory> Player::snapshot() {
  auto session = session_.snapshot();
  if (!session) return std::nullopt;
  return Memory{std::move(*session), playback_.memory(), to_come_, begun_, offered_, state_, planned_all_};
}

Status Player::restore(const Memory& from) {
  KADR_TRY(session_.restore(from.session));
  playback_.resume_from(from.playback);
  to_come_ = from.to_come;
  begun_ = from.begun;
  offered_ = from.offered;
  state_ = from.state;
  planned_all_ = from.planned_all;
  return {};
}

}  // namespace kadr
