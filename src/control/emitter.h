#pragma once
// Emitter: what a block does to the machine. Motions, changes of the coordinate frames, functions and warnings leave the interpreter
// through the Emitter as actions, and the Emitter updates the state accordingly. A function that moves an axis or switches an output
// receives an Emitter, which cannot change the program flow. Only src/control includes this file.

#include <functional>
#include <memory>
#include <utility>

#include "control/block_context.h"
#include "control/cycles/canned_cycle_run.h"
#include "control/cycles/ellipse_run.h"

namespace kadr {

class Emitter;
class Interpreter;

/// A code or an address of the block, as it is passed to the C++ function that executes it.
struct Call {
  const CodeRow* row = nullptr;  // row of the code in ControlDef; nullptr: an address calls a function without a code
  // Word that calls the function; nullptr: the motion code in force is executed, and the block has no word for it.
  const Word* word = nullptr;
  Span where;
};

inline constexpr std::size_t batch_size = 64;  // number of actions at which a batch is full, so that run() returns

/// A canned cycle that is executed in parts, a few actions at a time, so that a cycle of any length needs constant memory.
class SteppedCycle {
 public:
  virtual ~SteppedCycle() = default;
  /// Returns a copy that continues at the same action, for a control that is restored from a snapshot.
  virtual std::unique_ptr<SteppedCycle> clone() const = 0;
  /// Emits the next few actions of the cycle. Returns false if the cycle is finished.
  virtual Result<bool> next(Emitter& m) = 0;
  /// Finishes the cycle after its last action. The function may make the program continue at another block.
  virtual Status finish(Interpreter& m) const;
  /// Returns true if a next block that only states another position in the plane repeats the cycle there without any other change.
  /// repeat_at() then makes the finished cycle such a cycle. `to`: position in the plane, programmed coordinates.
  virtual bool repeats(const BlockContext&) const { return false; }
  virtual void repeat_at(const Axes& /*to*/) {}
  /// Returns true if the other functions of the block are executed before the cycle continues (drilling, nct 18.0). If false, the functions
  /// that follow the motion wait until the cycle has ended.
  virtual bool functions_first() const { return false; }
};

/// Base of a cycle that can be copied as a value: `class Pocket final : public SteppedCycleValue<Pocket>`.
template <class Cycle>
class SteppedCycleValue : public SteppedCycle {
 public:
  std::unique_ptr<SteppedCycle> clone() const final { return std::make_unique<Cycle>(static_cast<const Cycle&>(*this)); }
};

class Emitter : public BlockContext {
 public:
  template <class What>
  void emit(What&& what) {
    Action& action = batch->add();
    action.origin = origin;
    action.what = std::forward<What>(what);
  }
  virtual void warn(const Alarm& alarm) = 0;

  /// Returns the present value of an expression in the program's notation, such as `#100+1`.
  ///   alarms  those of compile_value and of the evaluation; expression_syntax if text follows the expression
  Result<double> value_of(std::string_view expression);

  // ---- motion

  /// Emits a straight motion to a programmed point.
  Status straight(MotionKind kind, const Axes& programmed, AxisMask named);
  /// Emits a straight motion to a machine position on the named axes.
  Status to_machine(MotionKind kind, const Axes& machine, AxisMask named, double feed, EndReference end = EndReference::by_machine);
  /// Emits an arc by the rules of the control's file. A dialect may have other rules for arcs.
  Status plain_arc(Turn turn, Span where);
  /// Sets the machine position after the operator has moved the axes by hand.
  void stand_at(const Axes& machine);
  /// Computes work and machine position on the axes `named` from `position.programmed`. Valid only if work coordinates equal the programmed
  /// coordinates and the frame is not rotated.
  void set_plain_position(AxisMask named) {
    for (; named != 0; named &= named - 1) {
      const auto a = static_cast<std::size_t>(__builtin_ctz(named));
      position.work[a] = position.programmed[a];
      position.machine[a] = position.work[a] + frames.origin[a] + frames.length[a];
    }
  }
  /// Sets the position to the end of a motion. Axes that are not in `named` keep their coordinates.
  void move_to(const Axes& programmed, const Axes& work, AxisMask named);
  Motion& add_motion(MotionKind kind, AxisMask named);
  /// Adds a motion to the position that was computed last, as add_motion() does, but with the given modes instead of the modes in force.
  Motion& add_motion_as(const MotionModes& modes, AxisMask named);
  Status feed_known(Span where);
  /// Sets the motion's feed, unit and exact stop from the modal state.
  void set_feed(Motion& motion);
  Status note_answer(const ProbeAnswer& answer);

  // ---- frames

  /// Recomputes the origin and the tool length from the tables and the modal state.
  void refresh_frames();
  void frames_by_tables();
  /// Recomputes the frames as refresh_frames() does, and converts the tool's coordinates to the new frame. The machine does not move.
  void change_frames();
  /// Applies the mirror switches of the panel that are in force in the selected plane (2С42 6.8).
  void apply_mirror();

  // ---- machine and operator

  /// Reports to the machine's logic a code that the control itself executes (nct 13.1).
  ///   code  number of the code, in tenths
  void report_to_machine(std::int32_t code);
  Status emit_machine_function(const Call& call);
  /// Emits the (MSG, …) comments of the block as messages.
  void show_messages();
  /// Starts a cycle of the dialect. If the last one was of the same class, its memory is used again.
  template <class Cycle, class... Arguments>
  void start_cycle(Arguments&&... arguments) {
    auto* const last = dynamic_cast<Cycle*>(finished.get());
    if (last == nullptr) return void(running = std::make_unique<Cycle>(std::forward<Arguments>(arguments)...));
    Cycle next(std::forward<Arguments>(arguments)...);
    std::destroy_at(last);
    std::construct_at(last, std::move(next));
    running = std::move(finished);
  }
  /// Returns true while a canned cycle of the block is being executed.
  bool cycling() const { return canned_cycle_run.active() || ellipse_run.active() || running != nullptr; }

  ActionBatch* batch = nullptr;
  CannedCycleRun canned_cycle_run;
  EllipseRun ellipse_run;
  std::unique_ptr<SteppedCycle> running;   // the dialect's canned cycle that is being executed; nullptr if no such cycle is being executed
  std::unique_ptr<SteppedCycle> finished;  // the last cycle of the dialect that has ended; nullptr: none has ended
  bool each_block = false;                 // run() returns the actions of each block separately
  // A function of the client, called by the interpreter at the start and at the end of each block; nullptr if nothing observes the blocks.
  std::function<void(const Origin&, bool)>* on_block = nullptr;

 protected:
  using BlockContext::BlockContext;
  ~Emitter() = default;

 private:
  Motion& next_motion();
};

}  // namespace kadr
