#pragma once
// TurnedPast: the states of a turned part at every instant of its cut. It keeps what each motion has removed, and the region of the part
// from time to time: a state is such a region without the removals that follow. It is used by view/turned_part.

#include <optional>
#include <vector>

#include "action/action.h"
#include "stock/turned/thread_groove.h"
#include "stock/turned/turned_stock.h"

namespace kadr {

/// What one body of a tool has removed along a straight segment, in the half plane of the part. Times are those of the machine, s.
struct TurnedRemoval {
  const InsertSweep* body = nullptr;
  Vec2 from, to;
  double begins = 0, seconds = 0;
  Origin origin;
  std::uint32_t tool = 0;
};

/// One pass of a threading tool.
struct TurnedThread {
  ThreadGroove groove;
  double begins = 0, seconds = 0;
  Origin origin;
  std::uint32_t tool = 0;
};

class TurnedPast {
 public:
  /// `most_bytes`: memory for the kept regions; if there are more, every second one is dropped.
  TurnedPast(TurnedRegion blank, std::size_t most_bytes);

  /// Adds what happens, in the order of time. `now`: the part after the removal.
  void add(const TurnedRemoval& removal, const TurnedStock& now);
  void add(const TurnedThread& thread);
  /// Declares that nothing follows.
  void finish(const TurnedStock& end);

  struct Then {
    TurnedRegion region;
    double volume = 0;                  // mm³; threads are not counted
    std::vector<ThreadGroove> threads;  // what has been cut of them; `maker` is a number for who()
    std::size_t removals = 0;           // how many have begun
    double instant = 0;
  };
  /// Returns the state at an instant, s since the start of the program.
  Then at(double instant) const;
  /// Returns a number for who() of what made an edge of the region of `then`; -1: it is the surface of the blank.
  std::int32_t maker_of(Vec2 a, Vec2 b, const Then& then) const;
  struct Maker {
    Origin origin;
    std::uint32_t tool = 0;
  };
  Maker who(std::int32_t maker) const;
  std::size_t bytes() const;

 private:
  struct Kept {
    std::size_t removals = 0;  // how many are contained
    TurnedRegion region;
  };
  struct Box {
    Vec2 least, most;
  };
  static std::size_t bytes_of(const TurnedRegion& region);

  std::size_t most_bytes_, between_;
  std::vector<TurnedRemoval> removals_;
  std::vector<Box> boxes_;  // for each removal: around its swept area
  std::vector<TurnedThread> threads_;
  std::vector<Kept> kept_;
  std::size_t kept_bytes_ = 0;
  std::optional<double> end_volume_;
};

}  // namespace kadr
