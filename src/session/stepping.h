#pragma once
// Stepping: runs a session block by block: into, over and out of calls, or up to a line, a pass, a call or a condition. Between two
// blocks it executes lines of the operator. The debugger, restart in mid program and the operator panel use it.
//
//   held before a block ── go(how) ──▶ held before the next block that `how` or a stop point selects, or ended
//
// With several channels, only the program's own channel is stepped; the others run in parallel in virtual time.

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "session/session.h"

namespace kadr {

/// A condition for holding: the program is held before a block to which all given members apply.
struct StopPoint {
  std::uint32_t line = 0;                // line number; 0: any
  std::string file{};                    // file of the line: a path or the last component of one; empty: the main program
  std::uint32_t pass = 0;                // hold when the line is reached for the n-th time since stepping began; 0: every time
  std::string call{};                    // hold before the first block of this call: "O100", "L02", as Control::calls() names it
  std::string condition{};               // hold if this condition is true: "#100 > 5", or a single value, which is true if it is not 0
  std::uint32_t number = 0;              // number of the block in the run (Origin::number); 0: any
  std::uint32_t tool = 0;                // hold if the block brings this tool into the spindle; 0: any
  std::optional<std::uint32_t> block{};  // N number of the block in the file
  friend bool operator==(const StopPoint&, const StopPoint&) = default;
};

class Stepping {
 public:
  ///   pre  the session has not started; it must outlive this object
  explicit Stepping(Session& session);
  ~Stepping();
  Stepping(const Stepping&) = delete;  // the control calls back this object
  Stepping& operator=(const Stepping&) = delete;

  enum class How : std::uint8_t {
    block,  // hold before the next block, even if it has no action; at a call, before the first block of the subprogram
    over,   // hold before the next block outside the calls that this block makes
    out,    // hold before the first block after the return from the innermost call
    free,   // run until a stop point holds
  };
  /// Continues the session. The first call holds before the first block, unless `how` is `free`.
  Session::State go(How how);
  /// Runs until the session is held before the first block that matches `target`; stop points are ignored. After `max_blocks` blocks
  /// without a match the session is held before the next block, and ran_out() is true.
  Session::State go_to(const StopPoint& target, std::uint64_t max_blocks = ~std::uint64_t{0});
  bool ran_out() const { return ran_out_; }
  /// Starts the block before which the session is held, and executes the first actions that the control passes together.
  Session::State begin_block();
  /// Runs until the session is held after the block in line `line` of the main program and after all calls that this block makes.
  Session::State go_past(std::uint32_t line);

  /// Versions of go() and enter() for callers that do other work meanwhile: call begin() or begin_entering(), then Session::go_on() until
  /// it returns a state other than running; after an entered line call end_entering().
  void begin(How how);
  void begin_entering(const std::string& line);
  void end_entering(Session::State came_to);
  /// Call after begin(). Holds before the next block, whichever it is.
  void hold_next() { hold_asked_ = true; }

  /// Called before each block of the program, whether or not the session is held before that block.
  std::function<void(const Origin&)> on_asked;

  /// The block that is executed next; nullopt if the session is not held.
  const std::optional<Origin>& next() const { return next_; }
  /// Location and text of that block's line, for display.
  AlarmReport::Line line() const;

  /// Enters a line of the operator (MDI). It is executed in the present state; then the session is held before the same block as before.
  ///   returns  stopped if the line raised an alarm; the session is held before the same block all the same
  Session::State enter(const std::string& line);
  /// Evaluates an expression written in the syntax of the program, as the debugger's watches need it.
  Result<double> value(std::string_view expression) const { return session_.control().evaluate(expression); }
  /// Evaluates a condition: `A op B`, where op is < <= > >= == != or EQ NE GT GE LT LE; or a single value, which is true if it is not 0.
  Result<bool> holds(std::string_view condition) const;

  /// The block where the session is held and how it continues, as a value. Stop points are not included.
  struct Memory {
    SessionSnapshot session;
    std::optional<Origin> next;
    Origin last;
    std::map<std::pair<std::uint16_t, std::uint32_t>, std::uint32_t> seen;
  };
  std::optional<Memory> snapshot() const;
  /// Restores the session; it is held at the stored block.
  ///   alarms  as Session::restore()
  Status restore(const Memory& from);
  /// Restores the session and continues to `target`. `passed`: how often the line of `target` had been executed before.
  Status restore(const SessionSnapshot& from, const StopPoint& target, std::uint32_t passed);

  /// Adds a stop point. Returns its number, from 1 on.
  std::size_t add(StopPoint point);
  /// Replaces all stop points by `points`, keyed by number; used to transfer them from another run.
  void keep(std::map<std::size_t, StopPoint> points) { points_ = std::move(points); }
  /// Returns false if no stop point has this number.
  bool remove(std::size_t number);
  const std::map<std::size_t, StopPoint>& points() const { return points_; }
  /// Number of the stop point that holds the session; 0: no stop point.
  std::size_t hit() const { return hit_; }
  /// Number of times that a line has been reached so far.
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
  std::size_t depth_ = 0;                   // number of calls around the block where the session was held
  std::optional<StopPoint> target_;         // the target of go_to()
  std::uint32_t past_ = 0;                  // the line of go_past(); 0: none
  std::optional<std::size_t> past_at_;      // call depth of the line of go_past(), once it is reached
  bool again_ = false;                      // the control asks a second time about the block where the session was held: do not hold again
  std::uint64_t most_ = ~std::uint64_t{0};  // max_blocks of go_to()
  bool ran_out_ = false;
  bool entered_ = false;  // a line of the operator is being executed
  bool hold_asked_ = false;
  std::optional<Origin> stood_;  // the next block of the program, stored while a line of the operator is executed
  std::size_t hit_ = 0;
  std::optional<Origin> next_;
  Origin last_;  // the block about which the control asked last
  // tool in the spindle at the block last_, and at the block before that one; updated only if a stop point names a tool
  std::uint32_t tool_ = 0, tool_before_ = 0;
  std::map<std::size_t, StopPoint> points_;
  // number of times that each line, (file, line), was reached; only lines of stop points
  std::map<std::pair<std::uint16_t, std::uint32_t>, std::uint32_t> seen_;
};

}  // namespace kadr
