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

/// Executes the interpreter's block, which is an O line.
///   alarms  rs274_flow, and the alarms of its expressions
Status run_o_line(Interpreter& m);

inline constexpr std::size_t max_calls_of_program = 9;  // 6.2

/// Records that a subprogram has been called. `level`: the arguments of the call; nullopt if the subprogram uses the caller's (M98).
void enter_sub(BlockContext& m, Label label, std::optional<Level> level, bool by_m98);
/// Calls a subprogram without arguments, as `O… call` does.
Status call_sub(Interpreter& m, const std::string& label, Span where);
/// Ends a subprogram: repeats it, or returns to the caller.
Status leave_sub(Interpreter& m, Span where);
/// Restores, at the end of a subprogram, the modes that M73 saved in it (8).
Status restore_at_end(Interpreter& m);

}  // namespace kadr::linuxcnc
