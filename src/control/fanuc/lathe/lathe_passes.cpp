// G74, G75: pecks repeated side by side; G76: compound thread. Both in two blocks, or in one block with D (spec/fanuc-t 9.7 to 9.10,
// spec/haas-st 6.6 to 6.8).

#include <algorithm>
#include <cmath>

#include "base/code_literals.h"
#include "base/tolerance.h"
#include "control/emitter.h"
#include "control/fanuc/fanuc.h"
#include "control/fanuc/geometry/sides.h"
#include "control/fanuc/lathe/lathe.h"
#include "control/fanuc/lathe/lathe_words.h"
#include "control/fanuc/turning/turning.h"
#include "control/fanuc/turning/turning_plane.h"

namespace kadr::fanuc {
namespace {

constexpr double tool_angles[] = {80, 60, 55, 30, 29, 0};

bool is_tool_angle(double angle) { return std::find(std::begin(tool_angles), std::end(tool_angles), angle) != std::end(tool_angles); }

/// Returns true for a cycle in the format of one block (9.10). Its words D, I, K do not exist in the format of two blocks, which a Haas
/// does not have.
bool is_one_block(const BlockContext& m) { return is_haas(m) || m.has('D') || m.has('I') || m.has('K'); }

/// The steps of a grooving cycle as the program writes them: radii and lengths in mm, with their signs.
struct GrooveWords {
  double along_second = 0;  // step along X: P, in one block I
  double along_first = 0;   // step along Z: Q, in one block K
  double relief = 0;        // R, in one block D
};

Result<GrooveWords> groove_words(const BlockContext& m) {
  if (is_one_block(m)) return GrooveWords{m.length_value('I'), m.length_value('K'), step_of(m, 'D')};
  KADR_TRY(no_point(m, 'P'));
  return GrooveWords{step_of(m, 'P'), step_of(m, 'Q'), m.length_value('R')};
}

/// Warns of the words of the format of one block in a first block of G76, where they have no meaning (9.9, 9.10).
void pass_over_thread_words(Emitter& m) {
  for (const char letter : {'I', 'K', 'D', 'A'})
    if (m.has(letter)) m.warn(warning(AlarmId::word_passed_over, m.where(letter), m.block->text_of(m.where(letter))));
}

/// Reads the first block of G76: P mmrraa, Q the least depth, R the finishing allowance (9.9).
Status set_thread_data(BlockContext& m) {
  TurningMemory& memory = fanuc_of(m).state.turning;
  if (m.has('P')) {
    KADR_TRY(no_point(m, 'P'));
    const auto digits = m.whole('P', 0, 999'999);
    if (!digits) return fail(digits.error());
    const double angle = *digits % 100;
    if (!is_tool_angle(angle)) return fail(alarm(AlarmId::thread_angle, m.where('P'), angle));
    memory.finishing = std::max(1U, *digits / 10'000);
    memory.chamfer = *digits / 100 % 100 / 10.0;
    memory.tool_angle = angle;
  }
  if (m.has('Q')) memory.least = std::fabs(step_of(m, 'Q'));
  if (m.has('R')) memory.allowance = std::fabs(m.length_value('R'));
  return {};
}

/// Reads what G76 of a Haas has besides: the start angle Q; the run-out of M23, and the settings of the thread (spec/haas-st 6.8).
/// INFERRED: without a finishing allowance the last pass at full depth is not repeated.
void take_haas_thread(const BlockContext& m, ThreadJob& job) {
  job.angle = start_angle_of(m);
  job.data.chamfer = run_out_leads(m);
  job.data.finishing = job.data.allowance > 0 ? 1 : 0;
  job.data.least = std::min(job.data.least, job.height);
}

/// Returns true if the tool may have this angle: one of a list, on a Haas any up to 120 degrees (spec/haas-st 6.8).
bool is_possible_angle(const BlockContext& m, double angle) {
  constexpr double most_on_haas = 120;
  return is_haas(m) ? angle >= 0 && angle <= most_on_haas : is_tool_angle(angle);
}

/// Reads the words of G76 in one block (9.10, spec/haas-st 6.8): I taper, K height, D first depth, A angle, P1 … P4 infeed.
Status one_block_thread(const BlockContext& m, ThreadJob& job) {
  job.taper = m.length_value('I');
  job.height = m.length_value('K');
  job.first = step_of(m, 'D');
  const Word* const a = m.word('A');
  if (a != nullptr) job.data.tool_angle = a->has_point ? a->value : digits_of(m, 'A');
  if (!is_possible_angle(m, job.data.tool_angle)) return fail(alarm(AlarmId::thread_angle, m.where('A'), job.data.tool_angle));
  if (is_haas(m)) take_haas_thread(m, job);
  if (!m.has('P')) return {};
  const auto infeed = m.whole('P', 1, 4);
  if (!infeed) return fail(infeed.error());
  job.zigzag = *infeed == 2 || *infeed == 4;
  job.even = *infeed >= 3;
  return {};
}

/// Reads the second block of G76 (9.9).
Status two_block_thread(const BlockContext& m, ThreadJob& job) {
  KADR_TRY(no_point(m, 'P'));
  job.taper = m.length_value('R');
  job.height = step_of(m, 'P');
  job.first = step_of(m, 'Q');
  return {};
}

}  // namespace

/// The order of the tests is INFERRED (9.7, U).
Status lathe_groove(Emitter& m, const Call& call) {
  TurningMemory& memory = fanuc_of(m).state.turning;
  if (!m.has_axis_words() && !m.has('P') && !m.has('Q') && !is_one_block(m)) {
    if (!m.has('R')) return fail(alarm(AlarmId::word_missing, call.where, 'R', call.row->code));
    memory.groove_back = std::fabs(m.length_value('R'));
    return {};
  }
  const auto words = groove_words(m);
  if (!words) return fail(words.error());
  GrooveJob job;
  job.deep_first = call.row->arg == 74.7_g;
  const std::size_t deep = job.deep_first ? 0 : 1;
  const auto target = plane_target(m);
  if (!target) return fail(target.error());
  if (!target->given[deep]) return fail(alarm(AlarmId::word_missing, call.where, letter_of(m, deep), call.row->code));
  const auto turned = [&](Vec2 v) { return job.deep_first ? v : Vec2{v.y, v.x}; };
  job.start = turned(plane_point(m));
  job.target = turned(target->to);
  job.peck = job.deep_first ? words->along_first : words->along_second;
  job.step = job.deep_first ? words->along_second : words->along_first;
  if (words->along_first < 0 || words->along_second < 0) return fail(alarm(AlarmId::groove_step, call.where));
  const bool single = std::fabs(job.target.y - job.start.y) <= tol::level;
  if (single) job.target.y = job.start.y;
  if (!single && words->relief < 0) return fail(alarm(AlarmId::groove_relief, call.where));
  const bool deepens = std::fabs(job.target.x - job.start.x) > tol::level;
  if ((deepens && !(job.peck > 0)) || (!single && !(job.step > 0))) return fail(alarm(AlarmId::groove_end, call.where));
  // Against the direction of the columns; a single column has no direction, and the sign of R is that of the displacement (9.7)
  job.relief = single ? words->relief : job.target.y < job.start.y ? words->relief : -words->relief;
  job.back = memory.groove_back;
  KADR_TRY(m.feed_known(call.where));
  suspend_side(m);
  return start_groove(m, job, job.deep_first ? 'Q' : 'P', job.deep_first ? 'P' : 'Q');
}

Status lathe_thread(Emitter& m, const Call& call) {
  if (!m.has_axis_words() && !is_haas(m)) {
    pass_over_thread_words(m);
    return set_thread_data(m);
  }
  ThreadJob job;
  const auto target = plane_target(m);
  if (!target) return fail(target.error());
  for (std::size_t i = 0; i < 2; ++i)
    if (!target->given[i]) return fail(alarm(AlarmId::word_missing, call.where, letter_of(m, i), call.row->code));
  job.data = fanuc_of(m).state.turning;
  KADR_TRY(is_one_block(m) ? one_block_thread(m, job) : two_block_thread(m, job));
  if (!(job.height > 0) || !(job.first > 0)) return fail(alarm(AlarmId::thread_height, call.where));
  if (job.data.least > job.height) return fail(alarm(AlarmId::thread_cut_depth, call.where));
  job.data.allowance = std::min(job.data.allowance, job.height);
  const auto lead = thread_lead_of(m, call);
  if (!lead) return fail(lead.error());
  job.start = plane_point(m);
  job.target = target->to;
  job.lead = *lead;
  job.chamfer = job.data.chamfer * *lead;
  const SinCos out = sincos_deg(fanuc_of(m).settings.lathe.run_out_angle);
  job.rise = out.sin / out.cos;
  suspend_side(m);
  return start_thread(m, job);
}

}  // namespace kadr::fanuc
