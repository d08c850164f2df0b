// Lnnmm: calls a subprogram of the program's sections, or a canned cycle of the control's file (2С42 6.3, 6.7). Used by
// control/block/structure, control/functions/flow_functions.

#include "control/functions/section_calls.h"

#include <cmath>

#include "base/tolerance.h"
#include "control/functions/cutter_compensation.h"

namespace kadr {
namespace {

constexpr double mm_per_increment = 0.001;  // 2С42 6.5.1
constexpr double pass_dwell = 0.3;          // duration in s: `G4 E3` in the body of L83 (2С42 table 9)
constexpr double max_passes = 100'000;

/// Starts L83 of the 2С42, deep drilling. Its parameters: R1 depth, R2 retract level, R3 depth of one peck, R0 feed. In G91 R1 and R2 are
/// increments (6.7.2). INFERRED: R1 is measured from the tool's position, R2 from the bottom. The sign of R1 gives the direction of
/// drilling; the sign of R3 is ignored.
Status start_deep_drilling(Emitter& m, const CycleRow& cycle, Span where) {
  double r[4];
  for (const int i : {0, 1, 2, 3}) {
    if (m.use.watches()) note_read_parameter(m, i);
    const auto value = m.variables.parameter(i, where);
    if (!value) return fail(value.error());
    r[i] = *value;
  }
  CannedCycleRun::Job job;
  job.cycle = &cycle;
  const double here = m.position.programmed[2];
  job.level = m.modal.absolute ? r[2] * mm_per_increment : here;
  job.bottom = m.modal.absolute ? r[1] * mm_per_increment : here + r[1] * mm_per_increment;
  job.clear = m.modal.absolute ? job.level : job.bottom + r[2] * mm_per_increment;
  job.return_level = m.modal.absolute ? job.level : here;
  job.peck = std::fabs(r[3]) * mm_per_increment;
  job.dwell = pass_dwell;
  job.preliminary = false;
  const double depth = std::fabs(job.level - job.bottom);
  if (!(job.peck > 0) || depth / job.peck > max_passes) return fail(alarm(AlarmId::cycle_peck, where, r[3]));
  if (!(r[0] > 0)) return fail(alarm(AlarmId::feed_missing, where));
  if (depth <= tol::level) return fail(alarm(AlarmId::cycle_level, where, job.level, job.bottom));
  m.modal.feed = r[0];
  m.modal.feed_known = true;
  m.block_exact = true;
  m.canned_cycle_run.start(m, job);
  return {};
}

}  // namespace

const CycleRow* called_cycle(const ControlDef& def, std::uint32_t number) {
  for (const CycleRow& cycle : def.cycles)
    if (cycle.call_number == number) return &cycle;
  return nullptr;
}

Status call_section(Interpreter& m, const Call& call) {
  const Word& w = *call.word;
  if (w.digits != 2 && w.digits != 4) return fail(alarm(AlarmId::call_digits, w.where, double(w.digits)));
  const auto number = static_cast<std::uint32_t>(w.value);
  const std::uint32_t name = w.digits == 2 ? number : number / 100;
  const std::uint32_t times = w.digits == 2 ? 1 : number % 100;
  if (times == 0) return fail(alarm(AlarmId::value_out_of_range, w.where, 'L', w.value));
  const CycleRow* const cycle = called_cycle(m.def, name);
  if (cycle != nullptr) {
    if (m.flow.has_subprogram(name)) m.dialect->note_shadowed(m, name, w.where);
    if (cycle->needs_override_off && m.modal.override_permission != 0) return fail(alarm(AlarmId::cycle_override, w.where, cycle->name));
    if (!cycle->body.empty()) {
      m.call_where = w.where;
      m.call_text = m.program().shown(m.block->text, m.call_where);
      return m.flow.call_body(*cycle, times, m.origin, w.where);
    }
    KADR_TRY(contour_allows_infeed(m, w.where));
    if (m.modal.contour != CompensationPhase::off && m.modal.plane != Plane::xy)
      return fail(alarm(AlarmId::compensation_active, w.where, "G17"));
    // The body of L83 begins with G1 G9 G17 G43 and ends with G0 (2С42 table 9).
    m.run_modes({Function::plane_xy, Function::length_plus});
    KADR_TRY(start_deep_drilling(m, *cycle, w.where));
    m.run_modes({Function::rapid});
    return {};
  }
  const std::size_t depth = m.program().depth();
  KADR_TRY(m.flow.call(name, times, m.origin, w.where));
  CallFrame& frame = m.flow.frames()[depth];
  frame.work_zero = m.modal.work_zero;
  frame.zero_shift = m.zero_shift;
  for (std::size_t g = 1; g < m.def.groups.size(); ++g)
    if (m.modal.rows[g] >= 0 && m.def.codes[static_cast<std::size_t>(m.modal.rows[g])].function == Function::work_zero)
      frame.work_offset_row = m.modal.rows[g];
  return {};
}

void restore_work_offset(Emitter& m, const CallFrame& left) {
  if (!m.def.has_sections() || left.kind != CallFrame::Kind::subprogram) return;
  m.modal.work_zero = left.work_zero;
  m.zero_shift = left.zero_shift;
  if (left.work_offset_row >= 0) m.modal.rows[m.def.codes[static_cast<std::size_t>(left.work_offset_row)].group] = left.work_offset_row;
  m.change_frames();
}

}  // namespace kadr
