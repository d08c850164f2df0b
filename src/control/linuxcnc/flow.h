#pragma once
// O lines and M98, M99 carried out (spec/linuxcnc 6).

#include <optional>
#include <string>

#include "base/result.h"
#include "control/linuxcnc/linuxcnc.h"

namespace kadr {
class BlockContext;
class Interpreter;
}  // namespace kadr

namespace kadr::linuxcnc {

/// The O line that the interpreter's block is.
///   alarms  rs274_flow, and those of its expressions
Status run_o_line(Interpreter& m);

inline constexpr std::size_t most_calls_of_program = 9;  // 6.2

/// A subprogram has been called. `level`: its arguments; nothing: those of the caller (M98).
void enter_sub(BlockContext& m, Label label, std::optional<Level> level, bool by_m98);
/// A subprogram without arguments is called, as by `O… call`.
Status call_sub(Interpreter& m, const std::string& label, Span where);
/// Its end: once more, or back.
Status leave_sub(Interpreter& m, Span where);
/// The modes that M73 has kept come back (8).
Status restore_at_end(Interpreter& m);

}  // namespace kadr::linuxcnc
