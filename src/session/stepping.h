#pragma once
// Stepping: runs a session block by block, into, over and out of calls, up to a line, a pass, a call or a condition, and executes lines
// of the operator between two blocks. The debugger, restart in mid program and the panel are built on it.
//
//   held before a block ── go(how) ──▶ held before the next block that `how` or a stop point selects, or ended
//
// With several channels, the program's own channel is stepped; the others continue in virtual time in parallel.

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "session/session.h"

namespace kadr {

/// Where a program is to be held: before a block for which every given condition is true.
struct StopPoint {
  std::uint32_t line = 0;                // 0: any
  std::string file{};                    // path or its last component; empty: the main program
  std::uint32_t pass = 0;                // the line must come for the n-th time since stepping began; 0: every time
  std::string call{};                    // the first block of a call: "O100", "L02" as Control::calls() names it
  std::string condition{};               // "#100 > 5", or a value, which counts as true if it is not 0
  std::uint32_t number = 0;              // of the block in the run (Origin::number); 0: any
  std::uint32_t tool = 0;                // that comes into the spindle with the block; 0: any
  std::optional<std::uint32_t> block{};  // its N number in the file
  friend bool operator==(const StopPoint&, const StopPoint&) = default;
};

class Stepping {
 public:
  ///   pre  the session has not started yet; it must outlive this object
  explicit Stepping(Session& session);
  ~Stepping();
  Stepping(const Stepping&) = delete;  // the control calls it back
  Stepping& operator=(const Stepping&) = delete;

  enum class How : std::uint8_t {
    block,  // hold before the next block, even one without an action; a call: before its first block
    over,   // hold before the next block that is not part of a call that this one makes
    out,    // hold before the first block after the innermost call
    free,   // run until a stop point
  };
  /// The first call holds before the first block, unless `free`.
  Session::State go(How how);
  /// Runs until it is held before the first block that matches `target`, ignoring stop points. Gives up after `most_blocks`: then it is
  /// held before the next block, and ran_out() is true.
  Session::State go_to(const StopPoint& target, std::uint64_t most_blocks = ~std::uint64_t{0});
  bool ran_out() const { return ran_out_; }
  /// Starts the block that it is held before: executes what the control passes on at once.
  Session::State begin_block();
  /// Runs until it is held after the block in line `line` of the main program, including the calls that the block makes.
  Session::State go_past(std::uint32_t line);

  /// go() and enter() in small steps, for callers that do other work meanwhile: call begin() or begin_entering(), then Session::go_on()
  /// until it no longer runs; after an entered line, call end_entering().
  void begin(How how);
  void begin_entering(const std::string& line);
  void end_entering(Session::State came_to);
  /// After begin(): holds before the next block, whatever it is.
  void hold_next() { hold_asked_ = true; }

  /// Called before each block of the program, held or not.
  std::function<void(const Origin&)> on_asked;

  /// The block that comes next; nullopt if the session is not held.
  const std::optional<Origin>& next() const { return next_; }
  /// The text of its line, as it is displayed.
  AlarmReport::Line line() const;

  /// The operator enters a line (MDI): it is executed in the present state, and the session is held again before the same block.
  ///   returns  stopped, if the line raised an alarm; even then the session is held before the same block
  Session::State enter(const std::string& line);
  /// Evaluates an expression as the program would write it: a watch of the debugger.
  Result<double> value(std::string_view expression) const { return session_.control().evaluate(expression); }
  /// Evaluates a condition: `A op B`, where op is < <= > >= == != or EQ NE GT GE LT LE, or a single value, which is true if it is not 0.
  Result<bool> holds(std::string_view condition) const;

  /// Where the session is held and how it continues, as a value. Stop points are not included.
  struct Memory {
    SessionSnapshot session;
    std::optional<Origin> next;
    Origin last;
    std::map<std::pair<std::uint16_t, std::uint32_t>, std::uint32_t> seen;
  };
  std::optional<Memory> snapshot() const;
  /// Restores the session and holds it there again.
  ///   alarms  as Session::restore()
  Status restore(const Memory& from);
  /// Restores the session and continues towards `target`, whose line has been executed `passed` times before.
  Status restore(const SessionSnapshot& from, const StopPoint& target, std::uint32_t passed);

  /// Adds a stop point. Returns its number, from 1 on.
  std::size_t add(StopPoint point);
  /// Replaces the stop points by those of another run, keyed by number.
  void keep(std::map<std::size_t, StopPoint> points) { points_ = std::move(points); }
  /// Returns false if no stop point has this number.
  bool remove(std::size_t number);
  const std::map<std::size_t, StopPoint>& points() const { return points_; }
  /// The number of the stop point that holds the session; 0: none.
  std::size_t hit() const { return hit_; }
  /// How often a line has been reached so far.
  std::uint32_t passes(std::uint32_t line, const std::string& file = {}) const;

 private:
  bool asked(const Origin& origin);
  bool ends_at_target(const Origin& origin, bool same_line, bool begins_call);
  bool asks_for(const Origin& origin, bool same_line) const;
  bool matches(const StopPoint& point, const Origin& origin, bool begins_call) const;
  bool is_file(const std::string& file, std::uint16_t reader) const;
  Session::State run();
  void set_out();
  void note_tool();

  Session& session_;
  How how_ = How::block;
  std::size_t depth_ = 0;                   // call depth where it was held
  std::optional<StopPoint> target_;         // set by go_to
  std::uint32_t past_ = 0;                  // set by go_past: the line; 0: none
  std::optional<std::size_t> past_at_;      // call depth of that line, once it is reached
  bool again_ = false;                      // the control asks again about the block it was held before: do not hold
  std::uint64_t most_ = ~std::uint64_t{0};  // limit of go_to: number of blocks
  bool ran_out_ = false;
  bool entered_ = false;  // a line of the operator is being executed
  bool hold_asked_ = false;
  std::optional<Origin> stood_;  // the next block before a line was entered
  std::size_t hit_ = 0;
  std::optional<Origin> next_;
  Origin last_;                               // the block asked about last
  std::uint32_t tool_ = 0, tool_before_ = 0;  // in the spindle at that block and at the one before; kept only if a stop point names a tool
  std::map<std::size_t, StopPoint> points_;
  std::map<std::pair<std::uint16_t, std::uint32_t>, std::uint32_t> seen_;  // (file, line): how often reached; stop points only
};

}  // namespace kadr
