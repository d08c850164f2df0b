// Drilling cycles of lathes: G83, G84, G85 along Z on the face, G87, G88, G89 along X on the side (spec/fanuc-t 10).

#include <cmath>

#include "base/code_literals.h"
#include "control/fanuc/drilling/drilling.h"
#include "control/fanuc/drilling/drilling_run.h"
#include "control/fanuc/fanuc.h"
#include "control/fanuc/geometry/sides.h"
#include "control/fanuc/lathe/lathe.h"
#include "control/fanuc/lathe/lathe_words.h"
#include "control/fanuc/words/coordinates.h"
#include "control/functions/functions.h"

namespace kadr::fanuc {
namespace {

constexpr double max_holes = 9999;
constexpr double max_pecks = 1e6;

bool is_on_side(std::int32_t code) { return code == 87_g || code == 88_g || code == 89_g; }

/// Returns the cycle of DrillingRun that has the steps of a lathe's cycle (spec/fanuc-t 10.2, 10.3).
std::int32_t steps_of(const LatheSettings& s, std::int32_t code, bool pecks, bool rigid) {
  switch (code) {
    case 83_g:
    case 87_g: return !pecks ? 82_g : s.pecks_to_level ? 83_g : 73_g;
    case 84_g:
    case 88_g: return rigid ? 84.2_g : 84_g;
    default: return 89_g;
  }
}

/// Returns the block's word for the drilling axis, Z or W on the face, X or U on the side; nullptr if there is none.
const Word* word_along(const BlockContext& m, std::size_t axis) {
  const Word* found = nullptr;
  for (std::uint32_t i = 0; i < m.block->word_count; ++i) {
    const Word& w = m.block->words[i];
    if (w.address != 0 && (m.letters.axes & letter_bit(w.address)) != 0 && m.def.address(w.address).axis == axis) found = &w;
  }
  return found;
}

/// Stores the words of the block, which stay in force until G80 or a code of group 01 (spec/fanuc-t 10.1).
Status take_words(Emitter& m, DrillingMemory& memory) {
  if (const Word* const bottom = word_along(m, memory.axis); bottom != nullptr) {
    memory.bottom = coordinate(m, *bottom, memory.axis);
    memory.bottom_added = is_increment(m, *bottom);
    memory.bottom_known = true;
  }
  if (m.has('R')) {
    const bool halves = fanuc_of(m).settings.lathe.level_is_diameter && is_diameter(m, memory.axis);
    memory.level = m.length_value('R') * (halves ? 0.5 : 1);
    // In system A R is a position whenever 5102#6 says so; in B and C G91 makes it a distance (10.1, U)
    memory.level_added = !(fanuc_of(m).settings.lathe.level_is_position && m.modal.absolute);
  }
  if (m.def.behaviour.lathe == Lathe::fanuc) KADR_TRY(no_point(m, 'Q'));  // 1.4
  if (m.has('Q')) memory.peck = std::fabs(step_of(m, 'Q'));
  if (m.has('P')) {
    const auto seconds = dwell_by_digits(m);
    if (!seconds) return fail(seconds.error());
    if (!(*seconds >= 0)) return fail(alarm(AlarmId::value_out_of_range, m.where('P'), 'P', *seconds));
    memory.dwell = *seconds;
  }
  return {};
}

Result<std::uint32_t> holes_of(const BlockContext& m) {
  if (!m.has('K')) return 1;
  const double holes = digits_of(m, 'K');
  if (holes != std::floor(holes)) return fail(alarm(AlarmId::word_not_integer, m.where('K'), 'K', holes));
  if (!(holes >= 0 && holes <= max_holes)) return fail(alarm(AlarmId::value_out_of_range, m.where('K'), 'K', holes));
  return static_cast<std::uint32_t>(holes);
}

Result<DrillingRun::Job> job_of(const Emitter& m, const Call& call, const DrillingMemory& memory, std::uint32_t holes) {
  const Fanuc& fanuc = fanuc_of(m);
  const LatheSettings& s = fanuc.settings.lathe;
  DrillingRun::Job job;
  job.code = steps_of(s, call.row->tenth, memory.peck > 0, fanuc.state.rigid_tap || fanuc.settings.taps_rigid);
  job.axis = memory.axis;
  job.passes = holes;
  job.initial = memory.initial;
  job.level = memory.level_added ? memory.initial + memory.level : memory.level;
  job.bottom = memory.bottom_added ? job.level + memory.bottom : memory.bottom;
  // System A has no G98 and G99: the tool always returns to the initial level (1.1)
  const bool has_levels =
      m.def.row_of('G', 98_g) >= 0 && m.def.codes[static_cast<std::size_t>(m.def.row_of('G', 98_g))].function == Function::retract_initial;
  job.to_initial = !has_levels || m.modal.retract_initial;
  job.peck = memory.peck;
  job.clearance = fanuc.settings.return_g73;
  job.dwell = memory.dwell;
  job.out_percent = s.boring_back_percent;
  for (const double level : {job.level, job.bottom, job.initial})
    if (!(std::fabs(level) <= farthest))
      return fail(alarm(AlarmId::position_out_of_range, call.where, std::string_view(m.axis_names[memory.axis]), level));
  if (job.peck > 0 && std::fabs(job.level - job.bottom) / job.peck > max_pecks)
    return fail(alarm(AlarmId::value_out_of_range, m.has('Q') ? m.where('Q') : call.where, 'Q', job.peck));
  return job;
}

/// Returns the M code that clamps the C axis in this block, or 0.
int clamp_of(const BlockContext& m) {
  const int code = fanuc_of(m).settings.lathe.clamp_code;
  for (std::uint32_t i = 0; i < m.block->word_count && code != 0; ++i)
    if (const Word& w = m.block->words[i]; w.address == 'M' && w.code == code * 10) return code;
  return 0;
}

}  // namespace

Status turned_drilling(Emitter& m, const Call& call) {
  Fanuc& fanuc = fanuc_of(m);
  DrillingMemory& memory = fanuc.state.drilling;
  if (m.modal.surface != PathSurface::plane) return fail(alarm(AlarmId::surface_state, call.where, call.row->code));
  const int axis = main_axis(m, is_on_side(call.row->tenth) ? 1 : 3);
  if (axis < 0) return fail(alarm(AlarmId::plane_illegal, call.where));
  const auto drills = static_cast<std::size_t>(axis);
  if (!drilling_on(m) || memory.axis != drills) {
    memory = {};
    memory.axis = drills;
    memory.initial = m.position.programmed[drills];
  }
  KADR_TRY(take_words(m, memory));
  if (!m.has_axis_words()) return {};
  if (!memory.bottom_known) return fail(alarm(AlarmId::cycle_data_missing, call.where));
  const auto holes = holes_of(m);
  if (!holes) return fail(holes.error());
  if (*holes == 0) return {};
  auto job = job_of(m, call, memory, *holes);
  if (!job) return fail(job.error());
  if (const int clamp = clamp_of(m); clamp != 0) {
    job->clamp_code = static_cast<std::uint32_t>(clamp);
    job->release_dwell = fanuc.settings.lathe.release_dwell;
  }
  suspend_side(m);
  KADR_TRY(over_hole(m, memory.axis));
  KADR_TRY(m.feed_known(call.where));
  macro_b_of(m).moved = true;
  m.running = std::make_unique<DrillingRun>(*job);
  return {};
}

}  // namespace kadr::fanuc
