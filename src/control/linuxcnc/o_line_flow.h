#pragma once
// Executes O lines, M98 and M99 (spec/linuxcnc 6).

#include <optional>
#include <string>

#include "base/result.h"
#include "control/linuxcnc/linuxcnc.h"

namespace kadr {
class BlockContext;
class Interpreter;
}  // namespace kadr

namespace kadr::linuxcnc {

/// Executes the interpreter's current block, which is an O line.
///   alarms  rs274_flow, and the alarms of the line's expressions
Status run_o_line(Interpreter& m);

inline constexpr std::size_t max_calls_of_program = 9;  // greatest depth of calls (spec/linuxcnc 6.2)

/// Records that a subprogram has been called. `level`: arguments of the call; nullopt for M98, whose subprogram uses the arguments of the
/// caller.
void enter_sub(BlockContext& m, Label label, std::optional<Level> level, bool by_m98);
/// Calls a subprogram without arguments, as `O… call` does.
Status call_sub(Interpreter& m, const std::string& label, Span where);
/// Ends one execution of a subprogram. Either its next execution follows, or the caller continues.
Status leave_sub(Interpreter& m, Span where);
/// Restores, at the end of a subprogram, the modes that M73 has saved in this subprogram (spec/linuxcnc 8).
Status restore_at_end(Interpreter& m);

}  // namespace kadr::linuxcnc
