// What the second turret and the second spindle of a lathe change: G68, G69 mirror X for the turret on the other side of the part
// (spec/fanuc-t 11.3), G14, G15 of a Haas mirror Z for the second spindle (spec/haas-st 9).

#include <array>

#include "control/fanuc/fanuc.h"
#include "control/fanuc/lathe/lathe.h"
#include "control/fanuc/words/coordinates.h"
#include "control/functions/functions.h"

namespace kadr::fanuc {
namespace {

/// Checks that the axis may be mirrored: only in G40 (spec/fanuc-t 11.3). A reset, which calls the function without a word, always may.
///   alarms  compensation_active
Status may_mirror(const BlockContext& m, const Call& call) {
  const bool by_word = call.where.end > call.where.begin;
  if (!by_word || m.modal.radius_side == 0) return {};
  return fail(alarm(AlarmId::compensation_active, call.where, call.row->code));
}

/// Mirrors an axis about the work zero, or ends that. The machine stands; the programmed coordinates of the tool change.
void mirror_axis(Emitter& m, std::size_t axis, bool on) {
  m.transform.mirror[axis] = on ? std::int8_t{-1} : std::int8_t{1};
  m.transform.refresh();
  m.change_frames();
  m.position.programmed = m.transform.to_programmed(m.position.work);
}

}  // namespace

std::uint8_t nose_in_force(const BlockContext& m, std::uint8_t tip) {
  constexpr std::array<std::uint8_t, 10> across_z{0, 4, 3, 2, 1, 5, 8, 7, 6, 9};
  return fanuc_of(m).state.second_turret && tip < across_z.size() ? across_z[tip] : tip;
}

}  // namespace kadr::fanuc

namespace kadr::functions {

/// G68, G69 (spec/fanuc-t 11.3): X_machine = 1290 - X, where 1290 is a diameter. X of the offset in force and the side of the nose are
/// mirrored too. INFERRED: the sign of 1290; work coordinates count from the part's axis, so that 1290 shifts the origin.
Status turret_mirror(Emitter& m, const Call& call) {
  KADR_TRY(fanuc::may_mirror(m, call));
  fanuc::UndoableState& state = fanuc_of(m).state;
  const bool on = call.row->arg == 68;
  const int x = fanuc::main_axis(m, 1);
  if (on == state.second_turret || x < 0) return {};
  const auto axis = static_cast<std::size_t>(x);
  state.nose = fanuc::nose_in_force(m, state.nose);  // from the second turret back to the first
  state.second_turret = on;
  state.nose = fanuc::nose_in_force(m, state.nose);
  m.modal.lengths[axis] = -m.modal.lengths[axis];
  state.wear[axis] = -state.wear[axis];
  fanuc::mirror_axis(m, axis, on);
  return {};
}

/// G14, G15 of a Haas (spec/haas-st 9): S, M3 to M5 and G96 act on the second spindle, and Z is mirrored. INFERRED: about the work zero,
/// as G101 does.
Status second_spindle(Emitter& m, const Call& call) {
  KADR_TRY(fanuc::may_mirror(m, call));
  fanuc::Fanuc& fanuc = fanuc_of(m);
  const bool on = call.row->arg == 14;
  const int z = fanuc::main_axis(m, 3);
  if (on == (fanuc.state.main_spindle == 2) || z < 0) return {};
  if (m.modal.surface_speed) KADR_TRY(css_off(m, call));
  fanuc.state.main_spindle = fanuc.state.current_spindle = on ? 2 : 1;
  m.modal.main_spindle = static_cast<std::uint8_t>(fanuc.state.main_spindle);
  const fanuc::SpindleState& spindle = fanuc.spindle(fanuc.state.main_spindle);
  m.modal.spindle = spindle.dir;
  m.modal.rpm = spindle.rpm;
  fanuc::mirror_axis(m, static_cast<std::size_t>(z), on);
  return {};
}

/// G43, G44, G49 are codes of lathes with a tool changer, parameter 5040#3 TCT; on a turret they are unknown (spec/fanuc-t 2.2).
///   alarms  tool_changer_code (PS0010); not_available: G43, G44 on a lathe with a tool changer
Status tool_changer_code(Emitter& m, const Call& call) {
  if (!fanuc_of(m).settings.lathe.tool_changer) return fail(alarm(AlarmId::tool_changer_code, call.where, call.row->code));
  if (call.row->arg != 49) return fail(alarm(AlarmId::not_available, call.where, call.row->code));
  return {};
}

}  // namespace kadr::functions
