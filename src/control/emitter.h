#pragma once
// Emitter: what a block does to the machine. Motions, changes of the frames, functions and warnings leave through it as actions; the state
// follows them. A function that moves or switches something takes one; it cannot change where the program goes on. Only src/control
// includes it.

#include <functional>
#include <memory>
#include <utility>

#include "control/block_context.h"
#include "control/cycles/cycle_run.h"
#include "control/cycles/ellipse_run.h"

namespace kadr {

class Emitter;
class Interpreter;

/// A code or an address of the block, as its function gets it.
struct Call {
  const CodeRow* row = nullptr;  // nullptr: an address that acts by itself
  const Word* word = nullptr;    // nullptr: the motion in force
  Span where;
};

inline constexpr std::size_t batch_size = 64;  // actions emitted at a time

/// What goes on after its block, some actions at a time, so that a cycle of any length runs in constant memory.
class Running {
 public:
  virtual ~Running() = default;
  /// A copy that goes on from here, in a control restored from a snapshot.
  virtual std::unique_ptr<Running> clone() const = 0;
  /// Emits the next actions, at most a few; false: it is over.
  virtual Result<bool> next(Emitter& m) = 0;
  /// It is over: from here it may lead the program elsewhere.
  virtual Status lead_on(Interpreter& m) const;
  /// The other functions of its block act before it goes on (drilling, nct 18.0); else those after the motion wait for its end.
  virtual bool functions_first() const { return false; }
};

/// A cycle that is a plain value: `class Pocket final : public RunningValue<Pocket>`.
template <class Cycle>
class RunningValue : public Running {
 public:
  std::unique_ptr<Running> clone() const final { return std::make_unique<Cycle>(static_cast<const Cycle&>(*this)); }
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

  /// The value of an expression as the program would write it, now.
  ///   alarms  those of compile_value and of its evaluation; expression_syntax: something follows it
  Result<double> value_of(std::string_view expression);

  // ---- motion

  /// Emits a straight motion to a programmed point.
  Status straight(MotionKind kind, const Axes& programmed, AxisMask named);
  /// A straight motion to a machine position on the named axes.
  Status to_machine(MotionKind kind, const Axes& machine, AxisMask named, double feed, EndGiven end = EndGiven::by_machine);
  /// An arc as the file's tables say: a dialect may say otherwise.
  Status plain_arc(Turn turn, Span where);
  /// The axes have been moved by hand.
  void stand_at(const Axes& machine);
  /// The tool stands where `position.programmed` says, on these axes, where work coordinates are the programmed ones and the frame is not
  /// turned.
  void place_plainly(AxisMask named) {
    for (; named != 0; named &= named - 1) {
      const auto a = static_cast<std::size_t>(__builtin_ctz(named));
      position.work[a] = position.programmed[a];
      position.machine[a] = position.work[a] + frames.origin[a] + frames.length[a];
    }
  }
  /// Position after a motion; the axes not named stay where they are.
  void move_to(const Axes& programmed, const Axes& work, AxisMask named);
  Motion& add_motion(MotionKind kind, AxisMask named);
  /// The same where the modes are known: to where the tool is to stand now.
  Motion& add_motion_as(const MotionModes& modes, AxisMask named);
  Status feed_known(Span where);
  /// The motion's feed, unit, exact stop from the modal state.
  void set_feed(Motion& motion);
  Status note_answer(const ProbeAnswer& answer);

  // ---- frames

  /// Origin and length worked out again from the tables and the modal state.
  void refresh_frames();
  void frames_by_tables();
  /// The same, and the tool's coordinates in the new frame (the machine stands).
  void change_frames();
  /// The mirrored axes of the panel that are in force in the plane (2С42 6.8).
  void apply_mirror();

  // ---- machine and operator

  /// The machine's logic gets the code, which the control executes itself (nct 13.1).
  ///   code  in tenths
  void tell_machine(std::int32_t code);
  Status emit_machine_function(const Call& call);
  /// (MSG, …) of the block's comments.
  void show_messages();
  /// A cycle of the block is being executed.
  bool cycling() const { return cycle_run.active() || ellipse_run.active() || running != nullptr; }

  ActionBatch* batch = nullptr;
  CycleRun cycle_run;
  EllipseRun ellipse_run;
  std::unique_ptr<Running> running;                              // a cycle of the dialect
  bool each_block = false;                                       // actions are handed over after each block
  std::function<void(const Origin&, bool)>* on_block = nullptr;  // who looks at each block, at its start and its end

 protected:
  using BlockContext::BlockContext;
  ~Emitter() = default;

 private:
  Motion& next_motion();
};

}  // namespace kadr
