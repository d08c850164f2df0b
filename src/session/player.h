#pragma once
// Player: plays a session in the machine's time. The caller has the servo clock and requests the positions of the axes at the next
// instants. The session is executed in advance, as far as the planner's look-ahead needs. Feed hold, resume and override may act between
// any two positions.
//
//   next() ◀── Playback ◀── cells of the planner ◀── Session::go_on(), when cells for fewer than some seconds are available

#include <deque>

#include "motion/play/playback.h"
#include "session/session.h"

namespace kadr {

class Player {
 public:
  /// Plays the session's own channel. The session must not have started, must have no planner, and must outlive the Player object.
  ///   rate  number of instants of the servo clock per second, Hz
  Player(Session& session, double rate);
  ~Player();
  Player(const Player&) = delete;  // not copyable: the planner has a pointer to this object
  Player& operator=(const Player&) = delete;

  /// Writes the positions at the next `count` instants. Each instant is a row of all axes in machine coordinates, mm or degrees.
  ///   returns  number of rows written; at the end of the motion it is less than `count`, and the last row is the end position
  std::size_t next(double* positions, std::size_t count);
  bool done() const { return playback_.done(); }

  /// Sets the override: `share` is the fraction (0 to 1) of the planned speed. The speed along the path changes from the next instant on,
  /// within the limits of the axes.
  void override_to(double share) { playback_.override_to(share); }
  void hold() { override_to(0); }
  /// True if a feed hold has stopped the axes. Then further positions are equal.
  bool is_held() const { return playback_.is_held(); }
  /// Returns the fraction (0 to 1) of the planned speed that the axes have now. It approaches the override gradually.
  double share() const { return playback_.share(); }
  /// Returns the program line to which the last position belongs.
  Spent at() const { return Spent::of(playback_.tag()); }

  /// Returns the state of the session, which has been executed further than the positions played so far.
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
  /// Returns a snapshot between two positions; nullopt while the control waits for the result of a probe motion.
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
  std::deque<TimedCells> to_come_;  // cells of the plan that playback_ has not accepted completely
  bool begun_ = false;              // true: playback_ has accepted some cells of the first entry of to_come_
  std::size_t offered_ = 0;         // number of cells of the first entry of to_come_ that playback_ has accepted
  Session::State state_ = Session::State::running;
  bool planned_all_ = false;
};

}  // namespace kadr
