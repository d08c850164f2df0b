#pragma once
// Turning cycles G70.7 … G79.7 (spec/nct/19). The manual states names and a sample only: section 19.B, INFERRED as a whole,
// is what is built. Depths, allowances, tapers and R of a diameter axis are radii (5.3).

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

/// After the last block of a contour: back to the start, and on after G70.7.
///   returns  true: it has been left
Result<bool> end_contour(Interpreter& m);

// ---- for the cycles' own files

/// Second lines of the compound cycles.
Status finish(Interpreter& m, const Call& call);
Status rough(Interpreter& m, const Call& call, Vec2 allowance);
Status pattern(Interpreter& m, const Call& call, Vec2 allowance);
Status groove(Emitter& m, const Call& call);
Status compound_thread(Emitter& m, const Call& call);

/// One pass of a thread: at rapid to the depth of `from`, along it to `to`, out, back to the start.
struct ThreadPass {
  Vec2 from, to;
  Vec2 start;          // the tool comes from there and goes back
  double lead = 0;     // mm
  double angle = 0;    // of the spindle at the start, degrees
  double chamfer = 0;  // mm along the thread's axis, at its end: out at 45°
};
Status thread_pass(Emitter& m, const ThreadPass& pass);
/// F or E: lead in mm; without them the last one. alarms thread_definition, not_together (G96)
Result<double> thread_lead_of(BlockContext& m, const Call& call);

}  // namespace kadr::fanuc
