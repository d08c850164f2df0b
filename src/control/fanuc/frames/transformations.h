#pragma once
// Rotation, scaling, mirroring: G68, G51, G51.1 (spec/nct/16). The map itself: Transform of control/state/state.h.

namespace kadr {
class BlockContext;
struct CodeRow;
}  // namespace kadr

namespace kadr::fanuc {

/// No axis is mirrored any more; the tool stands.
void clear_mirror(BlockContext& m);
/// Group 22 shows G51.1 as long as an axis is mirrored (16.3, INFERRED). `row`: a code just carried out.
void note_mirror_code(BlockContext& m, const CodeRow& row);

}  // namespace kadr::fanuc
