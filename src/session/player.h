#pragma once
// Player: plays a session in the machine's time. The caller has the servo clock and requests the positions of the axes at the next
// instants; the session is run as far ahead as the planner's look-ahead needs. Feed hold, resume and override may act between any two
// positions.
//
//   next() ◀── Playback ◀── cells of the planner ◀── Session::go_on(), when fewer than some seconds are available

#include <deque>

#include "motion/play/playback.h"
#include "session/session.h"

namespace kadr {

class Player {
 public:
  /// Plays the session's own channel. The session must not have started or have a planner, and must outlive this object.
  ///   rate  instants of the servo clock per second, Hz
  Player(Session& session, double rate);
  ~Player();
  Player(const Player&) = delete;  // the planner calls back this object
  Player& operator=(const Player&) = delete;

  /// Writes the positions at the next `count` instants, one row per instant with all axes: machine coordinates, mm or degrees.
  ///   returns  number of rows written; fewer than `count` at the end of the motion: then the last row is the end position
  std::size_t next(double* positions, std::size_t count);
  bool done() const { return playback_.done(); }

  /// Changes the speed along the path to 0 … 1 of the planned speed, from the next instant on and within the limits of the axes.
  void override_to(double share) { playback_.override_to(share); }
  void hold() { override_to(0); }
  /// True if a feed hold has stopped the axes, so that further positions do not change.
  bool is_held() const { return playback_.is_held(); }
  /// The share of the planned speed that is reached now.
  double share() const { return playback_.share(); }
  /// The program line to which the last position belongs.
  Spent at() const { return Spent::of(playback_.tag()); }

  /// State of the session, which is ahead of the played positions by the look-ahead.
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
  /// Stores the state between two positions. Returns nullopt while the control waits for a probe.
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
  std::deque<TimedCells> to_come_;  // cells of the plan that have not been offered to playback_ completely
  bool begun_ = false;              // the first entry of to_come_ has been offered in part
  std::size_t offered_ = 0;         // number of cells of that entry that have been offered
  Session::State state_ = Session::State::running;
  bool planned_all_ = false;
};

}  // namespace kadr
