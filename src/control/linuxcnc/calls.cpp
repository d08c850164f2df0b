// Enters and leaves subprograms (spec/linuxcnc 6.2); M98 P L, M99 (6.5).

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "control/functions/functions.h"
#include "control/interpreter.h"
#include "control/linuxcnc/linuxcnc.h"
#include "control/linuxcnc/o_line_flow.h"

namespace kadr::linuxcnc {

void enter_sub(BlockContext& m, Label label, std::optional<Level> level, bool by_m98) {
  LinuxCnc& control = linuxcnc_of(m);
  control.flow.calls.push_back(label);
  control.flow.by_m98.push_back(by_m98);
  control.saved_modes.emplace_back();
  if (level) control.levels().push_back(std::move(*level));
}

Status leave_sub(Interpreter& m, Span where) {
  LinuxCnc& control = linuxcnc_of(m);
  const auto left = m.flow.end_subprogram(where);
  if (!left) return fail(left.error());
  if (*left == nullptr) return {};  // the subprogram is executed once more, so the call is still open
  if (!control.flow.by_m98.back() && control.levels().size() > 1) control.levels().pop_back();
  control.flow.calls.pop_back();
  control.flow.by_m98.pop_back();
  KADR_TRY(restore_at_end(m));
  const bool profile_ends = control.turning && control.flow.calls.size() == control.turning->depth;
  return profile_ends ? run_turning(m) : Status();
}

}  // namespace kadr::linuxcnc

namespace kadr::functions {

using linuxcnc::linuxcnc_of;

/// M98 P L (spec/linuxcnc 6.5): calls the subprogram that starts at a later line `On` of the file, L times.
Status call_numbered(Interpreter& m, const Call& call) {
  const linuxcnc::LinuxCnc& control = linuxcnc_of(m);
  if (!control.machine.fanuc_subprograms)
    return control.fault(AlarmId::rs274_flow, call.where, "DISABLE_FANUC_STYLE_SUB set in INI file, but found m98");
  if (!m.has('P')) return control.fault(AlarmId::rs274_flow, call.where, "Found 'm98' code with no P-word");
  const double p = m.value('P');
  if (std::fabs(p - std::round(p)) > 1e-4) return control.fault(AlarmId::rs274_flow, m.where('P'), "Non integer value for integer");
  const double times = m.has('L') ? std::round(m.value('L')) : 1;
  const linuxcnc::Label label = linuxcnc_of(m).flow.label_of(linuxcnc::label_of_number(p));
  if (times < 1) return {};
  const linuxcnc::OFile& file = linuxcnc_of(m).flow.of(m);
  for (const linuxcnc::OLine& line : file.lines) {
    if (line.at.offset < m.block->position.offset || line.label != label) continue;
    if (line.word == OWord::sub) {  // the report is about the line with `sub`, not about the call
      linuxcnc_of(m).flow.refused = "'O.... sub' subroutine must be called with 'O.... call'";
      m.flow.jump(line.at);
      return {};
    }
    if (line.word != OWord::label) continue;
    if (control.flow.calls.size() >= linuxcnc::max_calls_of_program)
      return control.fault(AlarmId::rs274_flow, call.where, "Too many subroutine levels");
    CallFrame frame;
    frame.kind = CallFrame::Kind::subprogram;
    frame.name = static_cast<std::uint32_t>(p);
    frame.left = static_cast<std::uint32_t>(std::min(times, 1e9));
    frame.caller = m.origin;
    KADR_TRY(m.flow.call_at(m.program().reader(), line.position_after, frame, call.where));
    linuxcnc::enter_sub(m, label, std::nullopt, true);
    return {};
  }
  const std::string& text = linuxcnc_of(m).flow.text_of(label);
  if (file.closed) return control.fault(AlarmId::rs274_flow, call.where, fmt::format("Failed to find sub 'O{}' before EOF", text));
  return control.fault(AlarmId::rs274_flow, call.where,
                       fmt::format("EOF in file:{} seeking o-word: o<{}> from line: {}", m.program().file(), text, m.block->position.line));
}

/// M99 (spec/linuxcnc 6.5): returns from a subprogram; in the main program, starts the program again at its first line.
Status return_numbered(Interpreter& m, const Call& call) {
  const linuxcnc::LinuxCnc& control = linuxcnc_of(m);
  if (!control.machine.fanuc_subprograms)
    return control.fault(AlarmId::rs274_flow, call.where, "DISABLE_FANUC_STYLE_SUB set in INI file, but found m99");
  if (m.program().depth() == 0) return m.begin_again(call.where);
  if (!control.flow.by_m98.back())
    return control.fault(AlarmId::rs274_flow, call.where, "'O.... endsub' or 'O.... return' must follow 'O.... sub' subroutine definition");
  return linuxcnc::leave_sub(m, call.where);
}

}  // namespace kadr::functions
