// The data and the selection of the turning cycles of lathes (spec/fanuc-t 9).

#include "control/fanuc/lathe/lathe.h"

#include <algorithm>
#include <cmath>

#include "base/code_literals.h"
#include "base/units.h"
#include "control/fanuc/fanuc.h"
#include "control/fanuc/lathe/lathe_words.h"
#include "control/functions/functions.h"
#include "lang/block/grammar.h"

namespace kadr::fanuc {

void start_turning_memory(Fanuc& fanuc) {
  const macro_b::ParameterSource p = macro_b::source_of(fanuc.parameters);
  TurningMemory& t = fanuc.state.turning;
  t.groove_back = p.value("groove_back", 0);
  t.least = p.value("thread_least", 0);
  t.allowance = p.value("thread_allowance", 0);
  t.finishing = static_cast<std::uint32_t>(std::max(p.value("thread_finishing", 0), 1.0));
  t.tool_angle = p.value("thread_angle", 0);
  t.chamfer = fanuc.settings.lathe.run_out;
}

double digits_of(const BlockContext& m, char letter) {
  const Word* const w = m.word(letter);
  return w == nullptr ? 0 : w->value * std::pow(10.0, w->counted);
}

double least_increment(const BlockContext& m) {
  constexpr double least_mm = 0.001, least_inch = 0.0001;
  return m.modal.inch ? least_inch * mm_per_inch : least_mm;
}

double step_of(const BlockContext& m, char letter) {
  const Word* const w = m.word(letter);
  if (w == nullptr) return 0;
  if (w->has_point) return w->value * m.unit_scale();
  return digits_of(m, letter) * least_increment(m);
}

Status no_point(const BlockContext& m, char letter) {
  const Word* const w = m.word(letter);
  if (w == nullptr || !w->has_point) return {};
  return fail(alarm(AlarmId::point_not_allowed, w->where, letter));
}

Status check_thread_words(const BlockContext& m, const Call& call) {
  if (m.def.behaviour.lathe != Lathe::fanuc) return {};
  const bool line = call.row->function == Function::thread;  // R of a cycle is its taper
  for (const char letter : {comma_chamfer, comma_rounding, 'I', 'R', 'K'}) {
    const bool comma = letter == comma_chamfer || letter == comma_rounding, lead = letter == 'K' && call.row->arg == 34;
    if (m.has(letter) && (comma || (line && !lead))) return fail(alarm(AlarmId::corner_in_thread, m.where(letter)));
  }
  return no_point(m, 'Q');
}

double start_angle_of(const BlockContext& m) {
  const Word* const w = m.word('Q');
  if (w == nullptr) return 0;
  constexpr double least_degrees = 0.001;
  return w->has_point ? w->value : digits_of(m, 'Q') * least_degrees;
}

double run_out_leads(const BlockContext& m) {
  const TurningMemory& memory = fanuc_of(m).state.turning;
  const bool on_lathe = m.def.behaviour.lathe != Lathe::none;  // INFERRED: G78.7 of the NCT has no run-out
  return on_lathe && !memory.cuts_through ? memory.chamfer : 0;
}

Result<double> mean_lead(const BlockContext& m, double lead, const Axes& to, AxisMask named) {
  double travel = 0;
  for (std::size_t a = 0; a < m.axis_count; ++a)
    if ((named >> a & 1U) != 0) travel = std::max(travel, std::fabs(to[a] - m.position.programmed[a]));
  const double change = m.length_value('K');
  // n revolutions travel n·lead + n²·change/2; the lead after them is lead + n·change, so its square is lead² + 2·change·travel
  const double end_square = lead * lead + 2 * change * travel;
  if (!(end_square > 0)) return fail(alarm(AlarmId::thread_lead_change, m.where('K'), 0.0));
  return (lead + std::sqrt(end_square)) / 2;
}

Status turned_cycle(Interpreter& m, const Call& call) {
  macro_b_of(m).moved = true;
  switch (call.row->arg) {
    case 70.7_g: return lathe_finish(m, call);
    case 71.7_g:
    case 72.7_g: return lathe_rough(m, call);
    case 73.7_g: return lathe_pattern(m, call);
    case 74.7_g:
    case 75.7_g: return lathe_groove(m, call);
    default: return lathe_thread(m, call);
  }
}

}  // namespace kadr::fanuc
