#pragma once
// Player: plays a session in the machine's time. The caller has the servo clock and requests the next positions of the axes; the session
// continues as far as the planner must look ahead. Feed hold, resume and override act between any two positions.
//
//   next() ◀── Playback ◀── cells of the planner ◀── Session::go_on(), when fewer than some seconds are available

#include <deque>

#include "motion/play/playback.h"
#include "session/session.h"

namespace kadr {

class Player {
 public:
  /// Plays the session's own channel. The session has not started, has no planner yet, and must outlive this.
  ///   rate  of the servo clock, Hz
  Player(Session& session, double rate);
  ~Player();
  Player(const Player&) = delete;  // the planner calls it back
  Player& operator=(const Player&) = delete;

  /// Writes the positions at the next instants, `count` rows of all axes: machine coordinates, mm or degrees.
  ///   returns  number of rows; fewer than `count` if the motion is over: then the last row was its end
  std::size_t next(double* positions, std::size_t count);
  bool done() const { return playback_.done(); }

  /// Sets the speed to 0 … 1 of the planned speed from the next instant on: along the path, within the limits of the axes.
  void override_to(double share) { playback_.override_to(share); }
  void hold() { override_to(0); }
  /// True if a feed hold has stopped the axes: further positions are the same.
  bool is_held() const { return playback_.is_held(); }
  /// The share of the planned speed that is reached now.
  double share() const { return playback_.share(); }
  /// The program line that the last position belongs to.
  Spent at() const { return Spent::of(playback_.tag()); }

  /// State of the session, which is further on than the positions by the look-ahead.
  Session::State state() const { return state_; }

  struct Memory {
    SessionSnapshot session;
    Playback::Memory playback;
    std::deque<TimedCells> to_come;
    bool begun = false;
    std::size_t offered = 0;
    Session::State state = Session::State::running;
    bool planned_all = false;
  };
  /// Takes a snapshot between two positions. Returns nullopt while the control waits for a probe.
  std::optional<Memory> snapshot();
  ///   alarms  those of Session::restore()
  Status restore(const Memory& from);

 private:
  bool offer();
  void provide();
  void go_on();

  Session& session_;
  Planned& planned_;
  std::size_t axes_;
  Playback playback_;
  std::deque<TimedCells> to_come_;  // planned and not offered to playback yet …
  bool begun_ = false;              // … except the beginning of the first …
  std::size_t offered_ = 0;         // … of which this many are offered
  Session::State state_ = Session::State::running;
  bool planned_all_ = false;
};

}  // namespace kadr
