#pragma once
// Rotation, scaling, mirroring: G68, G51, G51.1 (spec/nct/16). The class Transform in control/state/control_state.h computes the
// transformed coordinates.

namespace kadr {
class BlockContext;
struct CodeRow;
}  // namespace kadr

namespace kadr::fanuc {

/// Ends mirroring on all axes. The tool does not move.
void clear_mirror(BlockContext& m);
/// Keeps G51.1 as the code in force of modal group 22 while any axis is mirrored (16.3, INFERRED). `row`: the table row of the code that
/// has just been executed.
void note_mirror_code(BlockContext& m, const CodeRow& row);

}  // namespace kadr::fanuc
