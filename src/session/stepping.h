#pragma once
// Stepping: runs a session block by block: into, over and out of calls, or up to a line, a pass, a call or a condition. Between two blocks
// it executes lines that the operator enters. The debugger, restart in mid-program and the operator panel use Stepping.
//
//   held before a block ── go(how) ──▶ held before the next block that `how` or a stop point selects, or ended
//
// With several channels, only the program's own channel is stepped. The other channels run in parallel in virtual time.

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "session/session.h"

namespace kadr {

/// A condition under which the program is held. The program is held before a block that fulfils the conditions of all members that are set.
struct StopPoint {
  std::uint32_t line = 0;    // line number; 0: any
  std::string file{};        // file of the line: a path, or the last component of the path; empty: the main program
  std::uint32_t pass = 0;    // n: the program is held when the line is reached for the n-th time; 0: every time
  std::string call{};        // call, as Control::calls() names it ("O100", "L02"); the program is held before its first block
  std::string condition{};   // condition, which must be true: "#100 > 5", or a single value, which must not be 0
  std::uint32_t number = 0;  // number of the block in the run (Origin::number); 0: any block
  // number of a tool; the program is held if the block brings this tool into the spindle; 0: no condition
  std::uint32_t tool = 0;
  std::optional<std::uint32_t> block{};  // block number (word N) of the block in the file
  friend bool operator==(const StopPoint&, const StopPoint&) = default;
};

class Stepping {
 public:
  /// Takes control of a session.
  ///   pre  the session has not started; it must outlive the Stepping object
  explicit Stepping(Session& session);
  ~Stepping();
  Stepping(const Stepping&) = delete;  // not copyable: the control has a pointer to this object
  Stepping& operator=(const Stepping&) = delete;

  enum class How : std::uint8_t {
    // the session is held before the next block, even if that block has no action; at a call, before the first block of the subprogram
    block,
    // like `block`, but a block that only has a comment is executed together with the next one: a press of START executes something.
    // INFERRED: no manual says that the control stops at a comment
    single,
    over,  // the session is held before the next block outside the calls that this block makes
    out,   // the session is held before the first block after the return from the innermost call
    free,  // the session runs until a stop point applies
  };
  /// Continues the session. The first call only goes to the first block and holds the session there, unless `how` is `free`.
  Session::State go(How how);
  /// Runs until the session is held before the first block that matches `target`. Stop points are ignored. After `max_blocks` blocks
  /// without a match the session is held before the next block, and ran_out() is true.
  Session::State go_to(const StopPoint& target, std::uint64_t max_blocks = ~std::uint64_t{0});
  bool ran_out() const { return ran_out_; }
  /// Starts the block before which the session is held, and executes its first batch of actions.
  Session::State begin_block();
  /// Runs until the block in line `line` of the main program and all calls that it makes have been executed. Then the session is held.
  Session::State go_past(std::uint32_t line);

  /// The start and the end of go() and enter(), for callers that do other work while the session runs. Call begin() or begin_entering(),
  /// then Session::go_on() until it returns a state other than running. After an entered line, also call end_entering().
  void begin(How how);
  void begin_entering(const std::string& line);
  void end_entering(Session::State came_to);
  /// Holds the session before the next block in any case. Call this function after begin().
  void hold_next() { hold_requested_ = true; }

  /// A function of the observer; Stepping calls it before each block of the program, even if the session is not held there.
  std::function<void(const Origin&)> on_block;

  /// Location of the block that is executed next; nullopt if the session is not held.
  const std::optional<Origin>& next() const { return next_; }
  /// Location and text of the line of the next block, for display.
  AlarmReport::Line line() const;

  /// Enters a line of the operator (MDI). The line is executed in the present state. Then the session is held before the same block as
  /// before.
  ///   returns  stopped if the line raised an alarm; even then the session is held before the same block
  Session::State enter(const std::string& line);
  /// Evaluates an expression in the syntax of the program, e.g. for display in the debugger.
  Result<double> value(std::string_view expression) const { return session_.control().evaluate(expression); }
  /// Evaluates a condition: `A op B`, where op is < <= > >= == != or EQ NE GT GE LT LE; or a single value, which counts as true if it is
  /// not 0.
  Result<bool> holds(std::string_view condition) const;

  /// A snapshot of the session, with the block before which the session is held. Stop points are not included.
  struct Memory {
    SessionSnapshot session;
    std::optional<Origin> next;
    Origin last;
    std::map<std::pair<std::uint16_t, std::uint32_t>, std::uint32_t> seen;
  };
  std::optional<Memory> snapshot() const;
  /// Restores the session, which is then held before the stored block.
  ///   alarms  as Session::restore()
  Status restore(const Memory& from);
  /// Restores the session without the block before which it was held. The caller then continues with go_to(target). `passed`: number of
  /// times that the line of `target` had been executed before the snapshot.
  Status restore(const SessionSnapshot& from, const StopPoint& target, std::uint32_t passed);

  /// Adds a stop point. Returns its number; the numbers start at 1.
  std::size_t add(StopPoint point);
  /// Replaces all stop points by `points`, keyed by number. With this function stop points are transferred from another run.
  void keep(std::map<std::size_t, StopPoint> points) { points_ = std::move(points); }
  /// Removes a stop point. Returns false if no stop point has this number.
  bool remove(std::size_t number);
  const std::map<std::size_t, StopPoint>& points() const { return points_; }
  /// Number of the stop point at which the session is held; 0: the session is not held at a stop point.
  std::size_t hit() const { return hit_; }
  /// Returns how often a line has been reached so far. Only the lines of stop points and targets are counted.
  std::uint32_t passes(std::uint32_t line, const std::string& file = {}) const;

 private:
  bool must_hold(const Origin& origin);
  bool ends_at_target(const Origin& origin, bool same_line, bool begins_call);
  bool asks_for(const Origin& origin, bool same_line);
  bool is_remark(const Origin& origin) const;
  bool matches(const StopPoint& point, const Origin& origin, bool begins_call) const;
  bool is_file(const std::string& file, std::uint16_t reader) const;
  Session::State run();
  void set_out();
  void note_tool();

  Session& session_;
  How how_ = How::block;
  std::size_t depth_ = 0;               // number of nested calls at the block before which the session was held
  std::optional<StopPoint> target_;     // the target of go_to()
  std::uint32_t past_ = 0;              // the line of go_past(); 0: go_past() is not running
  std::optional<std::size_t> past_at_;  // number of nested calls at the line of go_past(), stored when that line is reached
  // true: the control asks a second time about the block before which the session was held, so the session is not held again
  bool again_ = false;
  std::uint64_t most_ = ~std::uint64_t{0};  // remaining number of blocks of go_to(), at first `max_blocks`
  bool ran_out_ = false;
  bool entered_ = false;       // true: a line that the operator has entered is being executed
  bool only_remarks_ = false;  // true, for How::single: only comments have been executed so far
  bool hold_requested_ = false;
  std::optional<Origin> stood_;  // next block of the program, stored while an entered line is executed
  std::size_t hit_ = 0;
  std::optional<Origin> next_;
  Origin last_;  // location of the block about which the control asked last
  // number of the tool in the spindle at the block last_, and at the block before it; both are updated only if a stop point or the target
  // names a tool
  std::uint32_t tool_ = 0, tool_before_ = 0;
  std::map<std::size_t, StopPoint> points_;
  // (file, line) → number of times that the line was reached; other lines than those of stop points and targets are not counted
  std::map<std::pair<std::uint16_t, std::uint32_t>, std::uint32_t> seen_;
};

}  // namespace kadr
