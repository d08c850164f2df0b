#pragma once
// Turning cycles G70.7 … G79.7 (spec/nct/19). The manual gives only their names and one example, so the code follows section 19.B, which is
// INFERRED as a whole. Depths, allowances, tapers and R of a diameter axis are radii (5.3). A compound cycle has two blocks: the first
// block sets its data, the second block executes the cycle.

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "action/action.h"
#include "base/result.h"
#include "base/vec.h"
#include "control/fanuc/state/cycle_memory.h"

namespace kadr {
class BlockContext;
class Emitter;
class Interpreter;
struct Call;
struct CodeRow;
}  // namespace kadr

namespace kadr::fanuc {

/// Checks whether the last block of the contour of G70.7 has been executed. If so, moves the tool back to the start point and continues
/// the program after G70.7.
///   returns  true if the contour has ended
Result<bool> end_contour(Interpreter& m);

// ---- functions for the files of the turning cycles

/// Executes the second block of a compound cycle: finish() of G70.7, rough() of G71.7 and G72.7, pattern() of G73.7, groove() of G74.7 and
/// G75.7, compound_thread() of G76.7.
Status finish(Interpreter& m, const Call& call);
Status rough(Interpreter& m, const Call& call, Vec2 allowance);
Status pattern(Interpreter& m, const Call& call, Vec2 allowance);
Status groove(Emitter& m, const Call& call);
Status compound_thread(Emitter& m, const Call& call);

/// The data of a pecking cycle. In each point, x is the programmed coordinate in mm along the pecks, and y that along which the pecking
/// positions follow one another.
struct GrooveJob {
  bool deep_first = true;  // true (G74): the pecks are along the first axis of the plane; false (G75): along the second axis
  Vec2 start;              // start point of the grooving cycle: x along the pecks, y across the pecks
  Vec2 target;
  double peck = 0, step = 0;
  double back = 0;  // length of the retract after each peck
  // displacement across the pecks, mm, by which the tool leaves the wall before it leaves the groove; its sign is that of the coordinate
  double relief = 0;
};
/// Checks the numbers of pecks and positions and starts the cycle. `peck`, `step`: the letters of their words, for alarms.
///   alarms  value_out_of_range
Status start_groove(Emitter& m, const GrooveJob& job, char peck, char step);

/// The data of a compound threading cycle, mm. The depth of pass n is first·√n.
struct ThreadJob {
  Vec2 start, target;  // points of the plane: start of the cycle, and end of the thread at its root
  double taper = 0;    // difference between start and end of the thread along the second axis, mm
  double height = 0;   // height of the thread from root to crest, mm
  double first = 0;    // depth of the first pass (Δ1), mm
  double lead = 0;     // thread lead, mm
  double chamfer = 0;  // length of the run-out, mm
  double rise = 1;     // tangent of the run-out's angle
  double angle = 0;    // spindle angle at the start of each pass, degrees
  bool zigzag = false;  // every second pass is moved to the other side, so that the flanks cut in turn
  bool even = false;    // the depth of pass n is first·n
  TurningMemory data;
};
/// Checks the number of passes and starts the cycle. alarms value_out_of_range
Status start_thread(Emitter& m, const ThreadJob& job);

/// One pass of a thread. The tool moves at rapid from `start` to `from`, cuts along the thread to `to`, retracts from the thread, and
/// returns to `start`.
struct ThreadPass {
  Vec2 from, to;
  Vec2 start;          // point at which the tool starts the thread pass and to which it returns
  double lead = 0;     // thread lead, mm
  double angle = 0;    // spindle angle at the start of the thread, degrees
  double chamfer = 0;  // length in mm, along the thread's axis, of the run-out at the end of the thread
  double rise = 1;     // tangent of the angle between the run-out and the thread's axis
};
Status thread_pass(Emitter& m, const ThreadPass& pass);
/// Returns the thread lead in mm, which F or E gives; without these words, the last thread lead. alarms thread_definition, not_together
/// (G96)
Result<double> thread_lead_of(BlockContext& m, const Call& call);

}  // namespace kadr::fanuc
