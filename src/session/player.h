#pragma once
// Player: a session in the machine's time. Whoever has the servo clock asks for the axes' next positions; the session goes on as far as
// the planner must see ahead. Feed hold, resume and override act between any two positions.
//
//   next() ◀── Playback ◀── cells of the planner ◀── Session::go_on(), when less than some seconds are there

#include <deque>

#include "motion/play/playback.h"
#include "session/session.h"

namespace kadr {

class Player {
 public:
  /// Of the session's own channel; it has not begun, has no planner yet, and must outlive this.
  ///   rate  of the servo clock, Hz
  Player(Session& session, double rate);
  ~Player();
  Player(const Player&) = delete;  // the planner calls it back
  Player& operator=(const Player&) = delete;

  /// Positions at the next instants, `count` rows of all axes: machine coordinates, mm or degrees.
  ///   returns  rows; fewer: the motion is over, the last one before was its end
  std::size_t next(double* positions, std::size_t count);
  bool done() const { return playback_.done(); }

  /// 0 … 1 of the planned speed, from the next instant on: along the path, within the limits of the axes.
  void override_to(double share) { playback_.override_to(share); }
  void hold() { override_to(0); }
  /// It stands by a feed hold: further positions are the same.
  bool is_held() const { return playback_.is_held(); }
  /// The share that has been reached.
  double share() const { return playback_.share(); }
  /// What the last position belongs to: the program's line.
  Spent at() const { return Spent::of(playback_.tag()); }

  /// What the session stands at, further on by what is seen ahead.
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
  /// Between two positions. Nothing while the control waits for a probe.
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
  std::deque<TimedCells> to_come_;  // planned and not offered yet …
  bool begun_ = false;              // … but for some of the first,
  std::size_t offered_ = 0;         // so many
  Session::State state_ = Session::State::running;
  bool planned_all_ = false;
};

}  // namespace kadr
