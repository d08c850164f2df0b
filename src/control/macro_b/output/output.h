#pragma once
// Executes the output statements POPEN, FOPEN, DPRNT, BPRNT, PCLOS, FCLOS (spec/nct/23 23.2.13) by calls of the class OutputFile.

#include <string>

#include "base/result.h"
#include "lang/block/block.h"

namespace kadr {
class Emitter;
}

namespace kadr::macro_b {

Status output(Emitter& m, const Statement& s);
/// Replaces each `#v[cd]` in a message by the value of variable v with c digits before and d after the point, and `\n` by a line break
/// (23.1.8).
Result<std::string> embedded_values(Emitter& m, const std::string& text, Span where);

}  // namespace kadr::macro_b
