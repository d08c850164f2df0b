// Spindles by name and number, constant surface speed, positioning, gear ranges (spec/nct/11).

#include <algorithm>
#include <cmath>

#include "control/fanuc/fanuc.h"
#include "control/functions/functions.h"
#include "control/macro_b/calls/interrupt.h"

namespace kadr::fanuc {
namespace {

constexpr double mm_per_m = 1000;
constexpr double mm_per_foot = 304.8;

/// Returns the lowest and the highest speed of the spindle in rev/min: those of the selected gear range, or if none is selected, of all
/// gear ranges together.
std::pair<double, double> limits_of(const Fanuc& fanuc, int number) {
  const auto found = fanuc.ranges.find(number);
  if (found == fanuc.ranges.end() || found->second.empty()) return {0, 1e300};
  const int selected = fanuc.spindle(number).range;
  if (selected > 0 && static_cast<std::size_t>(selected) <= found->second.size())
    return found->second[static_cast<std::size_t>(selected) - 1];
  std::pair<double, double> all = found->second.front();
  for (const auto& [least, most] : found->second) all = {std::min(all.first, least), std::max(all.second, most)};
  return all;
}

/// Returns the number of the gear range that contains the speed; 0 if no range contains it. If several ranges contain the speed, returns
/// the selected range (11.3).
int range_of(const Fanuc& fanuc, int number, double rpm) {
  const auto found = fanuc.ranges.find(number);
  if (found == fanuc.ranges.end()) return 0;
  int range = 0;
  for (std::size_t i = 0; i < found->second.size(); ++i) {
    if (rpm < found->second[i].first || rpm > found->second[i].second) continue;
    if (range != 0) return fanuc.spindle(number).range;
    range = static_cast<int>(i) + 1;
  }
  return range;
}

std::string name_of_spindle(const BlockContext& m, int number) {
  const auto found = fanuc_of(m).spindle_names.find(number);
  return found != fanuc_of(m).spindle_names.end() && !found->second.empty() ? found->second : "S" + std::to_string(number);
}

/// Checks that the spindle belongs to this channel. INFERRED: if the set-up lists spindles, a spindle number that is not in this list
/// raises alarm 2017.
Status own_spindle(const BlockContext& m, int number, Span where) {
  const SpindleState& s = fanuc_of(m).spindle(number);
  if (!s.known && !fanuc_of(m).spindle_names.empty())
    return fail(alarm(AlarmId::illegal_address, where, std::string_view(name_of_spindle(m, number))));
  if (!s.known || s.channel == m.def.channel) return {};
  return fail(alarm(AlarmId::spindle_of_other_channel, where, std::string_view(name_of_spindle(m, number)), double(s.channel)));
}

/// Turns the spindle by `degrees` while its position loop is closed.
void turn(Emitter& m, int number, double degrees, bool absolute) {
  SpindleState& s = fanuc_of(m).spindle(number);
  s.angle += degrees;
  s.angle -= 360 * std::floor(s.angle / 360);
  Spindle action{SpindleDir::position, 0, static_cast<std::uint8_t>(number), degrees, {}};
  if (absolute || s.referenced) action.angle = s.angle;
  m.emit(action);
}

/// Returns the number of the spindle that a word of the block names; S without a number names the default spindle. If the block has no such
/// word, returns the spindle to which a word referred last (11.1.1, 11.2).
int spindle_of_block(const BlockContext& m) {
  const Fanuc& fanuc = fanuc_of(m);
  for (std::uint32_t i = 0; i < m.block->word_count; ++i) {
    const Word& w = m.block->words[i];
    if (w.address == 0 || m.def.address(w.address).function != Function::spindle_word) continue;
    const int named = m.def.address(w.address).number;
    if (named != 0) return named;
    if (m.modal.surface_speed) return fanuc.state.main_spindle;
    if (fanuc.spindle_by_p != 0) return fanuc.spindle_by_p;
    if (fanuc.settings.lathe.is_lathe) return fanuc.state.main_spindle;  // G14 of a Haas makes it the second one
    return fanuc.settings.default_spindle > 0 ? fanuc.settings.default_spindle : 1;
  }
  return fanuc.state.current_spindle;
}

/// Limits the speed (rev/min) of an S word to the gear range; S0 stays 0.
double limited(const Fanuc& fanuc, int number, double rpm) {
  const auto [least, most] = limits_of(fanuc, number);
  return rpm == 0 ? 0 : std::clamp(rpm, least, most);
}

Status loop_closed(const BlockContext& m, int number, Span where) {
  if (fanuc_of(m).spindle(number).loop_closed) return {};
  return fail(alarm(AlarmId::spindle_loop_open, where, std::string_view(name_of_spindle(m, number))));
}

}  // namespace

SurfaceSpeed Fanuc::surface_speed(const BlockContext& m) const {
  SurfaceSpeed law{m.modal.surface_speed, static_cast<std::uint8_t>(state.main_spindle), SurfaceSpeed::no_axis, state.surface_speed, 0, 0};
  for (std::size_t a = 0; a < m.axis_count; ++a)
    if (m.def.axis_numbers[a] == state.css_axis) law.axis = static_cast<std::uint8_t>(a);
  const auto [least, most] = limits_of(*this, state.main_spindle);
  law.least = std::max(settings.min_css_speed, least);
  law.most = state.max_css_speed > 0 ? std::min(state.max_css_speed, most) : most;
  return law;
}

void Fanuc::emit_surface_speed(Emitter& m) const {
  if (m.batch != nullptr) m.emit(surface_speed(m));
}

double Fanuc::css_rpm(const Emitter& m) const { return surface_speed(m).rpm(m.position.work, spindle(state.main_spindle).rpm); }

double Fanuc::spindle_rpm(const Emitter& m) const {
  const SpindleState& s = spindle(state.main_spindle);
  if (s.dir != SpindleDir::cw && s.dir != SpindleDir::ccw) return 0;
  return m.modal.surface_speed ? css_rpm(m) : s.rpm;
}

}  // namespace kadr::fanuc

namespace kadr::functions {

/// Executes S, S1=…, SSB…, S… P: sets the speed of one spindle. With G96, plain S is the surface speed (11.1, 11.5.1).
Status spindle_word(Emitter& m, const Call& call) {
  fanuc::Fanuc& fanuc = fanuc_of(m);
  if (m.has_code({Function::new_system})) return {};  // 11.5.2: in a block with G92, S limits the speed and does not command it
  const double value = call.word->value;
  if (!(value >= 0)) return fail(alarm(AlarmId::value_out_of_range, call.where, call.word->address, value));
  const int named = m.def.address(call.word->address).number;
  if (m.modal.surface_speed && named == 0) {
    fanuc.state.surface_speed = m.modal.inch ? value * fanuc::mm_per_foot / fanuc::mm_per_m : value;
    m.emit(Speed{fanuc.state.surface_speed, true, static_cast<std::uint8_t>(fanuc.state.main_spindle), 0, fanuc.css_rpm(m)});
    fanuc.emit_surface_speed(m);
    return {};
  }
  const int number = fanuc::spindle_of_block(m);
  KADR_TRY(fanuc::own_spindle(m, number, call.where));
  fanuc::SpindleState& s = fanuc.spindle(number);
  const double rpm = fanuc::limited(fanuc, number, value);
  s.rpm = rpm;
  fanuc.state.current_spindle = number;
  m.modal.rpm = value;
  m.emit(Speed{rpm, false, static_cast<std::uint8_t>(number), static_cast<std::uint8_t>(fanuc::range_of(fanuc, number, rpm))});
  return {};
}

/// Executes M3, M4, M5, M19 for the spindle to which a word referred last (11.2).
Status spindle_code(Emitter& m, const Call& call) {
  fanuc::Fanuc& fanuc = fanuc_of(m);
  const int number = fanuc.state.current_spindle;
  fanuc::SpindleState& s = fanuc.spindle(number);
  s.master = 0;
  fanuc.state.machine_may_turn = false;
  const bool turned = s.dir == SpindleDir::cw || s.dir == SpindleDir::ccw;
  // When G97 ends G96, the present spindle speed remains in force (11.5.1).
  if (turned && m.modal.surface_speed && number == fanuc.state.main_spindle) s.rpm = fanuc.css_rpm(m);
  switch (call.row->arg) {
    case 3: s.dir = SpindleDir::cw; break;
    case 4: s.dir = SpindleDir::ccw; break;
    case 19: s.dir = SpindleDir::orient; break;
    default: s.dir = SpindleDir::stop;
  }
  if (number == fanuc.state.main_spindle) m.modal.spindle = s.dir;
  s.loop_closed = s.referenced = s.dir == SpindleDir::orient && fanuc.settings.spindles[static_cast<std::size_t>(number)].indexes;
  if (s.dir == SpindleDir::orient) s.angle = 0;
  const bool turns = s.dir == SpindleDir::cw || s.dir == SpindleDir::ccw;
  m.emit(Spindle{s.dir,
                 turns ? (m.modal.surface_speed && number == fanuc.state.main_spindle ? fanuc.css_rpm(m) : s.rpm) : 0,
                 static_cast<std::uint8_t>(number),
                 {},
                 {}});
  return {};
}

/// M11 … M18 (11.3): selects the gear range of the spindle that the block names. A speed in force is limited to the new range (11.1).
Status gear_range(Emitter& m, const Call& call) {
  const int number = fanuc::spindle_of_block(m);
  fanuc::SpindleState& s = fanuc_of(m).spindle(number);
  s.range = call.row->arg;
  m.emit(MachineFunction{static_cast<std::uint32_t>(call.word->code / 10), {}, {}, static_cast<std::uint8_t>(number)});
  if (m.modal.surface_speed) fanuc_of(m).emit_surface_speed(m);
  const double rpm = fanuc::limited(fanuc_of(m), number, s.rpm);
  if (rpm != s.rpm && !m.modal.surface_speed && !fanuc::has_spindle_word(m)) {
    s.rpm = rpm;
    m.emit(Speed{rpm, false, static_cast<std::uint8_t>(number), static_cast<std::uint8_t>(s.range)});
  }
  return {};
}

/// Executes words such as CS2=30: turns spindle 2 to 30° in the shorter direction, or by 30° if the word is an increment (11.7.3).
Status spindle_axis_word(Emitter& m, const Call& call) {
  const int number = m.def.address(call.word->address).number;
  KADR_TRY(fanuc::own_spindle(m, number, call.where));
  KADR_TRY(fanuc::loop_closed(m, number, call.where));
  fanuc::SpindleState& s = fanuc_of(m).spindle(number);
  const double value = call.word->value;
  if (!m.modal.absolute || call.word->incremental) {
    fanuc::turn(m, number, value, false);
    return {};
  }
  if (!s.referenced) return fail(alarm(AlarmId::spindle_not_referenced, call.where, std::string_view(fanuc::name_of_spindle(m, number))));
  double degrees = value - s.angle;
  degrees -= 360 * std::floor(degrees / 360);
  fanuc::turn(m, number, degrees <= 180 ? degrees : degrees - 360, true);
  return {};
}

/// G96 P: P selects the axis whose position is the diameter for the constant surface speed (11.5.3).
Status css_on(Emitter& m, const Call&) {
  if (m.has('P')) {
    const auto axis = m.whole('P', 1, 32);
    if (!axis) return fail(axis.error());
    const auto& numbers = m.def.axis_numbers;
    if (std::find(numbers.begin(), numbers.begin() + static_cast<std::ptrdiff_t>(m.axis_count), *axis) ==
        numbers.begin() + static_cast<std::ptrdiff_t>(m.axis_count))
      // INFERRED: a P word of G96 with an unknown axis number raises the same alarm as for AX[n] (23.2.12)
      return fail(alarm(AlarmId::axis_number_wrong, m.where('P'), double(*axis)));
    fanuc_of(m).state.css_axis = static_cast<int>(*axis);
  }
  m.modal.surface_speed = true;
  fanuc_of(m).emit_surface_speed(m);
  return {};
}

/// G97: ends G96; the last spindle speed of G96 remains in force (11.5.1).
Status css_off(Emitter& m, const Call&) {
  if (m.modal.surface_speed && m.batch != nullptr) {
    fanuc::SpindleState& s = fanuc_of(m).spindle(fanuc_of(m).state.main_spindle);
    if (s.dir == SpindleDir::cw || s.dir == SpindleDir::ccw) s.rpm = fanuc_of(m).css_rpm(m);
  }
  m.modal.surface_speed = false;
  fanuc_of(m).emit_surface_speed(m);
  return {};
}

}  // namespace kadr::functions

namespace kadr::fanuc {

/// Executes M codes of spindles: indexing (11.7.3), closing the position loop (11.7.2), optional spindle codes (11.2). All other M codes
/// are passed to the machine.
Status Fanuc::machine_code(Interpreter& m, const Call& call) {
  const auto own_code = interrupt_code(m, call);
  if (!own_code) return fail(own_code.error());
  return *own_code ? Status() : spindle_machine_code(m, call.word->code / 10, call.where);
}

Status Fanuc::spindle_machine_code(Emitter& m, int code, Span where) {
  const int number = state.current_spindle;
  for (int i = 0; i <= static_cast<int>(max_spindles); ++i) {
    // 11.2: if several spindles have this code, the spindle to which the last spindle word referred has priority
    const int n = i == 0 ? number : i;
    const SpindleSettings& s = settings.spindles[static_cast<std::size_t>(n)];
    if (s.index_count > 0 && code >= s.index_from && code < s.index_from + s.index_count) {
      KADR_TRY(loop_closed(m, n, where));
      if (!spindle(n).referenced)  // 11.7.3: the program must execute M19 before the first indexing code
        return fail(alarm(AlarmId::spindle_not_referenced, where, std::string_view(name_of_spindle(m, n))));
      const double degrees = (code - s.index_from + 1) * s.index_angle;
      turn(m, n, s.index_negative ? -degrees : degrees, false);
      return {};
    }
  }
  const SpindleSettings& own = settings.spindles[static_cast<std::size_t>(number)];
  // 11.7.2: the M code of parameter N0823 closes the position loop of the spindle
  const bool closes = own.indexes && own.closing_code != 0 && own.closing_code == code;
  const bool of_spindle = closes || (own.m_high != 0 && code >= own.m_low && code <= own.m_high) || has_spindle_word(m);
  if (closes) {
    spindle(number).loop_closed = true;
    spindle(number).referenced = false;
    spindle(number).dir = SpindleDir::stop;
  }
  m.emit(MachineFunction{static_cast<std::uint32_t>(code), {}, {}, static_cast<std::uint8_t>(of_spindle ? number : 0)});
  return {};
}

/// Finds the axes into which events of the set-up convert spindles. INFERRED from the manual's example, where S1 becomes C1: the name of
/// the axis is C and the spindle's number, for example C2 for spindle 2. For spindle 1 the name may also be C.
void find_spindle_axes(BlockContext& m, const Setup& setup) {
  for (const SetupEvent& event : setup.events) {
    if (event.what != SetupEvent::Do::spindle_to_axis) continue;
    const std::string name = "C" + std::to_string(event.spindle);
    for (std::size_t a = 0; a < m.axis_count; ++a)
      if (m.axis_names[a] == name || (event.spindle == 1 && m.axis_names[a] == "C"))
        fanuc_of(m).spindle_axes.emplace_back(a, event.spindle);
  }
}

void watch_spindle_axes(Emitter& m, AxisMask named) {
  for (const auto& [axis, number] : fanuc_of(m).spindle_axes) {
    const SpindleDir dir = fanuc_of(m).spindle(number).dir;
    if ((named >> axis & 1u) == 0 || (dir != SpindleDir::cw && dir != SpindleDir::ccw)) continue;
    m.warn(warning(AlarmId::axis_is_spindle, m.block->where, std::string_view(m.axis_names[axis]),
                   std::string_view(name_of_spindle(m, number))));
  }
}

bool has_spindle_word(const BlockContext& m) {
  for (std::uint32_t i = 0; i < m.block->word_count; ++i)
    if (const Word& w = m.block->words[i]; w.address != 0 && m.def.address(w.address).function == Function::spindle_word) return true;
  return false;
}

}  // namespace kadr::fanuc
