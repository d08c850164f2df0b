// M98 P L, M99: subprograms by number (spec/linuxcnc 6.5).

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "control/functions/functions.h"
#include "control/interpreter.h"
#include "control/linuxcnc/flow.h"
#include "control/linuxcnc/linuxcnc.h"

namespace kadr::functions {

using linuxcnc::linuxcnc_of;

/// M98 P L: a subprogram that begins with `On` further on in the file (6.5).
Status call_numbered(Interpreter& m, const Call& call) {
  const linuxcnc::LinuxCnc& control = linuxcnc_of(m);
  if (!control.machine.fanuc_subprograms)
    return control.fault(AlarmId::rs274_flow, call.where, "DISABLE_FANUC_STYLE_SUB set in INI file, but found m98");
  if (!m.has('P')) return control.fault(AlarmId::rs274_flow, call.where, "Found 'm98' code with no P-word");
  const double p = m.value('P');
  if (std::fabs(p - std::round(p)) > 1e-4) return control.fault(AlarmId::rs274_flow, m.where('P'), "Non integer value for integer");
  const double times = m.has('L') ? std::round(m.value('L')) : 1;
  const std::string label = fmt::format("{:.0f}", p);
  if (times < 1) return {};
  const linuxcnc::OFile& file = linuxcnc_of(m).flow.of(m);
  for (const linuxcnc::OLine& line : file.lines) {
    if (line.at.offset < m.block->position.offset || line.label != label) continue;
    if (line.word == OWord::sub) {  // found out at that line
      linuxcnc_of(m).flow.memory.refused = "'O.... sub' subroutine must be called with 'O.... call'";
      m.flow.jump(line.at);
      return {};
    }
    if (line.word != OWord::label) continue;
    if (control.flow.memory.calls.size() >= linuxcnc::most_calls_of_program)
      return control.fault(AlarmId::rs274_flow, call.where, "Too many subroutine levels");
    CallFrame frame;
    frame.kind = CallFrame::Kind::subprogram;
    frame.name = static_cast<std::uint32_t>(p);
    frame.left = static_cast<std::uint32_t>(std::min(times, 1e9));
    frame.caller = m.origin;
    KADR_TRY(m.flow.call_at(m.flow.reader(), line.behind, frame, call.where));
    linuxcnc::enter_sub(m, label, std::nullopt, true);
    return {};
  }
  return control.fault(AlarmId::rs274_flow, call.where,
                       fmt::format("EOF in file:{} seeking o-word: o<{}> from line: {}", m.flow.file(), label, m.block->position.line));
}

/// M99: back; in the main program: from its first line again (6.5).
Status return_numbered(Interpreter& m, const Call& call) {
  const linuxcnc::LinuxCnc& control = linuxcnc_of(m);
  if (!control.machine.fanuc_subprograms)
    return control.fault(AlarmId::rs274_flow, call.where, "DISABLE_FANUC_STYLE_SUB set in INI file, but found m99");
  if (m.flow.depth() == 0) return m.begin_again(call.where);
  if (!control.flow.memory.by_m98.back())
    return control.fault(AlarmId::rs274_flow, call.where, "Found 'M99' instead of 'O endsub' after 'O sub'");
  return linuxcnc::leave_sub(m, call.where);
}

}  // namespace kadr::functions
