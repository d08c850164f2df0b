#pragma once
// Stepping: a session block by block, into, over and out of calls, to a line, a pass, a call, a condition; lines of the operator between
// two blocks. The debugger, restart in mid program and the panel are made of it.
//
//   held before a block ── go(how) ──▶ held before the next one that `how` or a stop point asks for, or over
//
// Of several channels the program's own is stepped; the others go on in virtual time beside it.

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "session/session.h"

namespace kadr {

/// Where a program is to be held: before a block for which all that is given holds.
struct StopPoint {
  std::uint32_t line = 0;                // 0: any
  std::string file{};                    // path or its last part; empty: the main program
  std::uint32_t pass = 0;                // that the line comes for so many times since stepping began; 0: each time
  std::string call{};                    // the first block of a call: "O100", "L02" as Control::calls() names it
  std::string condition{};               // "#100 > 5", or a value that is not 0
  std::uint32_t number = 0;              // of the block in the run (Origin::number); 0: any
  std::uint32_t tool = 0;                // comes into the spindle; 0: any
  std::optional<std::uint32_t> block{};  // its number N in the file
  friend bool operator==(const StopPoint&, const StopPoint&) = default;
};

class Stepping {
 public:
  /// The session has not begun; it must outlive this.
  explicit Stepping(Session& session);
  ~Stepping();
  Stepping(const Stepping&) = delete;  // the control calls it back
  Stepping& operator=(const Stepping&) = delete;

  enum class How : std::uint8_t {
    block,  // the next one, also one without an action; of a call: its first
    over,   // the next one that is not of a call made by this
    out,    // the first one after the innermost call
    free,   // until a stop point
  };
  /// The first time: before the first block, unless `free`.
  Session::State go(How how);
  /// Held before the first block for which it holds, stop points or not; or, ran_out(), before the first one after so many.
  Session::State go_to(const StopPoint& target, std::uint64_t most_blocks = ~std::uint64_t{0});
  bool ran_out() const { return ran_out_; }
  /// The block that it is held before begins: what is handed over at once.
  Session::State begin_block();
  /// After the block that line `line` of the main program holds, the calls that it makes included.
  Session::State go_past(std::uint32_t line);

  /// go() and enter() bit by bit, for whoever has more to do meanwhile: after begin(), begin_entering() Session::go_on() until it is not
  /// running; then, where a line was entered, end_entering().
  void begin(How how);
  void begin_entering(const std::string& line);
  void end_entering(Session::State came_to);
  /// On the way of begin(): held before the next block that comes, whatever it is.
  void hold_next() { hold_asked_ = true; }

  /// Called before each block of the program, held or not.
  std::function<void(const Origin&)> on_asked;

  /// The block that comes next; nothing: it is not held.
  const std::optional<Origin>& next() const { return next_; }
  /// Its line, as it is shown.
  AlarmReport::Line line() const;

  /// The operator enters a line (MDI): it is carried out in the present state, and the session is held where it was.
  ///   returns  stopped: by an alarm of the line; it is held where it was all the same
  Session::State enter(const std::string& line);
  /// The value of an expression as the program would write it: a watch.
  Result<double> value(std::string_view expression) const { return session_.control().evaluate(expression); }
  /// Is it true? `A op B` with < <= > >= == != or EQ NE GT GE LT LE between two values, or a value that is not 0.
  Result<bool> holds(std::string_view condition) const;

  /// Where it is held and how it goes on: a value. Stop points are not in it.
  struct Memory {
    SessionSnapshot session;
    std::optional<Origin> next;
    Origin last;
    std::map<std::pair<std::uint16_t, std::uint32_t>, std::uint32_t> seen;
  };
  std::optional<Memory> snapshot() const;
  /// Held there again.
  ///   alarms  those of Session::restore()
  Status restore(const Memory& from);
  /// The session goes on from there; the target's line has come `passed` times before.
  Status restore(const SessionSnapshot& from, const StopPoint& target, std::uint32_t passed);

  /// Its number from 1 on.
  std::size_t add(StopPoint point);
  /// Those of another run, by their numbers.
  void keep(std::map<std::size_t, StopPoint> points) { points_ = std::move(points); }
  /// False: there is none of that number.
  bool remove(std::size_t number);
  const std::map<std::size_t, StopPoint>& points() const { return points_; }
  /// The number of the stop point that it is held by; 0: none.
  std::size_t hit() const { return hit_; }
  /// How often a line has come so far.
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
  std::size_t depth_ = 0;                   // of calls, where it was held
  std::optional<StopPoint> target_;         // of go_to
  std::uint32_t past_ = 0;                  // of go_past: the line; 0: none
  std::optional<std::size_t> past_at_;      // its depth, once it has come
  bool again_ = false;                      // the block that it is held before is asked for once more: it goes on
  std::uint64_t most_ = ~std::uint64_t{0};  // of go_to: blocks asked for
  bool ran_out_ = false;
  bool entered_ = false;  // a line of the operator is being carried out
  bool hold_asked_ = false;
  std::optional<Origin> stood_;  // before a line was entered
  std::size_t hit_ = 0;
  std::optional<Origin> next_;
  Origin last_;                               // asked for
  std::uint32_t tool_ = 0, tool_before_ = 0;  // in the spindle then, and the block before; where a stop point asks for one
  std::map<std::size_t, StopPoint> points_;
  std::map<std::pair<std::uint16_t, std::uint32_t>, std::uint32_t> seen_;  // by file and line: how often it came, of lines asked for
};

}  // namespace kadr
