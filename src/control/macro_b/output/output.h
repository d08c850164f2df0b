#pragma once
// POPEN, FOPEN, DPRNT, BPRNT, PCLOS, FCLOS (spec/nct/23 23.2.13): turns statements into calls of the file being written.

#include <string>

#include "base/result.h"
#include "lang/block/block.h"

namespace kadr {
class Emitter;
}

namespace kadr::macro_b {

Status output(Emitter& m, const Statement& s);
/// Replaces `#v[cd]` in a message by values, and `\n` by line ends (23.1.8).
Result<std::string> embedded_values(Emitter& m, const std::string& text, Span where);

}  // namespace kadr::macro_b
