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

/// One pass of a thread. The tool moves at rapid from `start` to `from`, cuts along the thread to `to`, retracts from the thread, and
/// returns to `start`.
struct ThreadPass {
  Vec2 from, to;
  Vec2 start;          // point at which the tool starts the thread pass and to which it returns
  double lead = 0;     // thread lead, mm
  double angle = 0;    // spindle angle at the start of the thread, degrees
  double chamfer = 0;  // length in mm, along the thread's axis, of the run-out at 45° at the end of the thread
};
Status thread_pass(Emitter& m, const ThreadPass& pass);
/// Returns the thread lead in mm, which F or E gives; without these words, the last thread lead. alarms thread_definition, not_together
/// (G96)
Result<double> thread_lead_of(BlockContext& m, const Call& call);

}  // namespace kadr::fanuc
