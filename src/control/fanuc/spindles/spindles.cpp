// Spindles by name and number, constant surface speed, positioning, ranges (spec/nct/11).

#include <algorithm>
#include <cmath>

#include "control/functions/functions.h"
#include "control/macro_b/calls/interrupt.h"
#include "control/nct/nct.h"
#include "control/nct/waiting.h"

namespace kadr::nct {
namespace {

constexpr double mm_per_m = 1000;
constexpr double mm_per_foot = 304.8;

/// Least and most speed the spindle may have: the selected range, or all of them.
std::pair<double, double> limits_of(const Nct& nct, int number) {
  const auto found = nct.ranges.find(number);
  if (found == nct.ranges.end() || found->second.empty()) return {0, 1e300};
  const int selected = nct.spindle(number).range;
  if (selected > 0 && static_cast<std::size_t>(selected) <= found->second.size())
    return found->second[static_cast<std::size_t>(selected) - 1];
  std::pair<double, double> all = found->second.front();
  for (const auto& [least, most] : found->second) all = {std::min(all.first, least), std::max(all.second, most)};
  return all;
}

/// The one range that holds the speed; 0: none or several (11.3).
int range_of(const Nct& nct, int number, double rpm) {
  const auto found = nct.ranges.find(number);
  if (found == nct.ranges.end()) return 0;
  int range = 0;
  for (std::size_t i = 0; i < found->second.size(); ++i) {
    if (rpm < found->second[i].first || rpm > found->second[i].second) continue;
    if (range != 0) return nct.spindle(number).range;
    range = static_cast<int>(i) + 1;
  }
  return range;
}

std::string name_of_spindle(const Interpreter& m, int number) {
  const auto found = nct_of(m).spindle_names.find(number);
  return found != nct_of(m).spindle_names.end() && !found->second.empty() ? found->second : "S" + std::to_string(number);
}

/// INFERRED: a number that the set-up has not, where it has spindles, is alarm 2017.
Status own_spindle(const Interpreter& m, int number, Span where) {
  const SpindleState& s = nct_of(m).spindle(number);
  if (!s.known && !nct_of(m).spindle_names.empty())
    return fail(alarm(AlarmId::illegal_address, where, std::string_view(name_of_spindle(m, number))));
  if (!s.known || s.channel == m.def.channel) return {};
  return fail(alarm(AlarmId::spindle_of_other_channel, where, std::string_view(name_of_spindle(m, number)), double(s.channel)));
}

/// Turns the spindle by `degrees` in the position loop.
void turn(Interpreter& m, int number, double degrees, bool absolute) {
  SpindleState& s = nct_of(m).spindle(number);
  s.angle += degrees;
  s.angle -= 360 * std::floor(s.angle / 360);
  Spindle action{SpindleDir::position, 0, static_cast<std::uint8_t>(number), degrees, {}};
  if (absolute || s.referenced) action.angle = s.angle;
  m.emit(action);
}

/// The spindle that a word of the block names, or plain S means; without one the spindle referred to last (11.1.1, 11.2).
int spindle_of_block(const Interpreter& m) {
  const Nct& nct = nct_of(m);
  for (std::uint32_t i = 0; i < m.block->word_count; ++i) {
    const Word& w = m.block->words[i];
    if (w.address == 0 || m.def.address(w.address).function != Function::spindle_word) continue;
    const int named = m.def.address(w.address).number;
    if (named != 0) return named;
    if (m.modal.surface_speed) return nct.state.main_spindle;
    if (nct.spindle_by_p != 0) return nct.spindle_by_p;
    return nct.settings.default_spindle > 0 ? nct.settings.default_spindle : 1;
  }
  return nct.state.current_spindle;
}

/// The speed of an S word within the limits; S0 is 0.
double limited(const Nct& nct, int number, double rpm) {
  const auto [least, most] = limits_of(nct, number);
  return rpm == 0 ? 0 : std::clamp(rpm, least, most);
}

Status loop_closed(const Interpreter& m, int number, Span where) {
  if (nct_of(m).spindle(number).loop_closed) return {};
  return fail(alarm(AlarmId::spindle_loop_open, where, std::string_view(name_of_spindle(m, number))));
}

}  // namespace

SurfaceSpeed Nct::surface_speed(const Interpreter& m) const {
  SurfaceSpeed law{m.modal.surface_speed, static_cast<std::uint8_t>(state.main_spindle), SurfaceSpeed::no_axis, state.surface_speed, 0, 0};
  for (std::size_t a = 0; a < m.axis_count; ++a)
    if (m.def.axis_numbers[a] == state.css_axis) law.axis = static_cast<std::uint8_t>(a);
  const auto [least, most] = limits_of(*this, state.main_spindle);
  law.least = std::max(settings.css_least, least);
  law.most = state.css_most > 0 ? std::min(state.css_most, most) : most;
  return law;
}

void Nct::tell_surface_speed(Interpreter& m) const {
  if (m.batch != nullptr) m.emit(surface_speed(m));
}

double Nct::css_rpm(const Interpreter& m) const { return surface_speed(m).rpm(m.position.work, spindle(state.main_spindle).rpm); }

double Nct::spindle_rpm(const Interpreter& m) const {
  const SpindleState& s = spindle(state.main_spindle);
  if (s.dir != SpindleDir::cw && s.dir != SpindleDir::ccw) return 0;
  return m.modal.surface_speed ? css_rpm(m) : s.rpm;
}

}  // namespace kadr::nct

namespace kadr::functions {

/// S, S1=…, SSB…, S… P: a speed for one spindle; with G96 plain S is the surface speed (11.1, 11.5.1).
Status spindle_word(Interpreter& m, const Call& call) {
  nct::Nct& nct = nct_of(m);
  if (m.has_code({Function::new_system})) return {};  // G92 S limits the speed (11.5.2)
  const double value = call.word->value;
  if (!(value >= 0)) return fail(alarm(AlarmId::value_out_of_range, call.where, call.word->address, value));
  const int named = m.def.address(call.word->address).number;
  if (m.modal.surface_speed && named == 0) {
    nct.state.surface_speed = m.modal.inch ? value * nct::mm_per_foot / nct::mm_per_m : value;
    m.emit(Speed{nct.state.surface_speed, true, static_cast<std::uint8_t>(nct.state.main_spindle), 0, nct.css_rpm(m)});
    nct.tell_surface_speed(m);
    return {};
  }
  const int number = nct::spindle_of_block(m);
  KADR_TRY(nct::own_spindle(m, number, call.where));
  nct::SpindleState& s = nct.spindle(number);
  const double rpm = nct::limited(nct, number, value);
  s.rpm = rpm;
  nct.state.current_spindle = number;
  m.modal.rpm = value;
  m.emit(Speed{rpm, false, static_cast<std::uint8_t>(number), static_cast<std::uint8_t>(nct::range_of(nct, number, rpm))});
  return {};
}

/// M3, M4, M5, M19 for the spindle referred to last (11.2).
Status spindle_code(Interpreter& m, const Call& call) {
  nct::Nct& nct = nct_of(m);
  const int number = nct.state.current_spindle;
  nct::SpindleState& s = nct.spindle(number);
  s.master = 0;
  const bool turned = s.dir == SpindleDir::cw || s.dir == SpindleDir::ccw;
  if (turned && m.modal.surface_speed && number == nct.state.main_spindle) s.rpm = nct.css_rpm(m);  // it stays at G97 (11.5.1)
  switch (call.row->arg) {
    case 3: s.dir = SpindleDir::cw; break;
    case 4: s.dir = SpindleDir::ccw; break;
    case 19: s.dir = SpindleDir::orient; break;
    default: s.dir = SpindleDir::stop;
  }
  if (number == nct.state.main_spindle) m.modal.spindle = s.dir;
  s.loop_closed = s.referenced = s.dir == SpindleDir::orient && nct.settings.spindles[static_cast<std::size_t>(number)].indexes;
  if (s.dir == SpindleDir::orient) s.angle = 0;
  const bool turns = s.dir == SpindleDir::cw || s.dir == SpindleDir::ccw;
  m.emit(Spindle{s.dir,
                 turns ? (m.modal.surface_speed && number == nct.state.main_spindle ? nct.css_rpm(m) : s.rpm) : 0,
                 static_cast<std::uint8_t>(number),
                 {},
                 {}});
  return {};
}

/// M11 … M18 (11.3): of the spindle that the block names. A speed in force that lies outside is limited (11.1).
Status gear_range(Interpreter& m, const Call& call) {
  const int number = nct::spindle_of_block(m);
  nct::SpindleState& s = nct_of(m).spindle(number);
  s.range = call.row->arg;
  m.emit(MachineFunction{static_cast<std::uint32_t>(call.word->code / 10), {}, {}, static_cast<std::uint8_t>(number)});
  if (m.modal.surface_speed) nct_of(m).tell_surface_speed(m);
  const double rpm = nct::limited(nct_of(m), number, s.rpm);
  if (rpm != s.rpm && !m.modal.surface_speed && !nct::has_spindle_word(m)) {
    s.rpm = rpm;
    m.emit(Speed{rpm, false, static_cast<std::uint8_t>(number), static_cast<std::uint8_t>(s.range)});
  }
  return {};
}

/// CS2=30: to an angle by the shorter way, or by an increment (11.7.3).
Status spindle_axis_word(Interpreter& m, const Call& call) {
  const int number = m.def.address(call.word->address).number;
  KADR_TRY(nct::own_spindle(m, number, call.where));
  KADR_TRY(nct::loop_closed(m, number, call.where));
  nct::SpindleState& s = nct_of(m).spindle(number);
  const double value = call.word->value;
  if (!m.modal.absolute || call.word->incremental) {
    nct::turn(m, number, value, false);
    return {};
  }
  if (!s.referenced) return fail(alarm(AlarmId::spindle_not_referenced, call.where, std::string_view(nct::name_of_spindle(m, number))));
  double way = value - s.angle;
  way -= 360 * std::floor(way / 360);
  nct::turn(m, number, way <= 180 ? way : way - 360, true);
  return {};
}

/// G96 P: axis of the diameter (11.5.3).
Status css_on(Interpreter& m, const Call&) {
  if (m.has('P')) {
    const auto axis = m.whole('P', 1, 32);
    if (!axis) return fail(axis.error());
    const auto& numbers = m.def.axis_numbers;
    if (std::find(numbers.begin(), numbers.begin() + static_cast<std::ptrdiff_t>(m.axis_count), *axis) ==
        numbers.begin() + static_cast<std::ptrdiff_t>(m.axis_count))
      return fail(alarm(AlarmId::axis_number_wrong, m.where('P'), double(*axis)));  // INFERRED, as AX[n] (23.2.12)
    nct_of(m).state.css_axis = static_cast<int>(*axis);
  }
  m.modal.surface_speed = true;
  nct_of(m).tell_surface_speed(m);
  return {};
}

/// G97: the last speed of G96 stays (11.5.1).
Status css_off(Interpreter& m, const Call&) {
  if (m.modal.surface_speed && m.batch != nullptr) {
    nct::SpindleState& s = nct_of(m).spindle(nct_of(m).state.main_spindle);
    if (s.dir == SpindleDir::cw || s.dir == SpindleDir::ccw) s.rpm = nct_of(m).css_rpm(m);
  }
  m.modal.surface_speed = false;
  nct_of(m).tell_surface_speed(m);
  return {};
}

}  // namespace kadr::functions

namespace kadr::nct {

/// M codes for the machine: indexing (11.7.3), closing the loop (11.7.2), optional spindle codes (11.2), all others. Waiting
/// codes stay in the control (14.5).
Status machine_code(Interpreter& m, const Call& call) {
  auto own_code = waiting_code(m, call);
  if (own_code && !*own_code) own_code = interrupt_code(m, call);
  if (!own_code) return fail(own_code.error());
  if (*own_code) return {};
  Nct& nct = nct_of(m);
  const int code = call.word->code / 10;
  const int number = nct.state.current_spindle;
  for (int i = 0; i <= static_cast<int>(most_spindles); ++i) {
    const int n = i == 0 ? number : i;  // that referred to last goes before others with the same codes (11.2)
    const SpindleSettings& s = nct.settings.spindles[static_cast<std::size_t>(n)];
    if (s.index_count > 0 && code >= s.index_from && code < s.index_from + s.index_count) {
      KADR_TRY(loop_closed(m, n, call.where));
      if (!nct.spindle(n).referenced)  // 11.7.3: M19 before the first indexing code
        return fail(alarm(AlarmId::spindle_not_referenced, call.where, std::string_view(name_of_spindle(m, n))));
      const double way = (code - s.index_from + 1) * s.index_angle;
      turn(m, n, s.index_negative ? -way : way, false);
      return {};
    }
  }
  const SpindleSettings& own = nct.settings.spindles[static_cast<std::size_t>(number)];
  const bool closes = own.indexes && own.closing_code != 0 && own.closing_code == code;  // 11.7.2
  const bool of_spindle = closes || (own.m_high != 0 && code >= own.m_low && code <= own.m_high) || has_spindle_word(m);
  if (closes) {
    nct.spindle(number).loop_closed = true;
    nct.spindle(number).referenced = false;
    nct.spindle(number).dir = SpindleDir::stop;
  }
  m.emit(MachineFunction{static_cast<std::uint32_t>(code), {}, {}, static_cast<std::uint8_t>(of_spindle ? number : 0)});
  return {};
}

/// INFERRED from the manual's example, where S1 becomes C1: the axis C with the spindle's number; of spindle 1 also plain C.
void find_spindle_axes(Interpreter& m, const Setup& setup) {
  for (const SetupEvent& event : setup.events) {
    if (event.what != SetupEvent::Do::spindle_to_axis) continue;
    const std::string name = "C" + std::to_string(event.spindle);
    for (std::size_t a = 0; a < m.axis_count; ++a)
      if (m.axis_names[a] == name || (event.spindle == 1 && m.axis_names[a] == "C")) nct_of(m).spindle_axes.emplace_back(a, event.spindle);
  }
}

void watch_spindle_axes(Interpreter& m, AxisMask named) {
  for (const auto& [axis, number] : nct_of(m).spindle_axes) {
    const SpindleDir dir = nct_of(m).spindle(number).dir;
    if ((named >> axis & 1u) == 0 || (dir != SpindleDir::cw && dir != SpindleDir::ccw)) continue;
    m.warn(warning(AlarmId::axis_is_spindle, m.block->where, std::string_view(m.axis_names[axis]),
                   std::string_view(name_of_spindle(m, number))));
  }
}

bool has_spindle_word(const Interpreter& m) {
  for (std::uint32_t i = 0; i < m.block->word_count; ++i)
    if (const Word& w = m.block->words[i]; w.address != 0 && m.def.address(w.address).function == Function::spindle_word) return true;
  return false;
}

}  // namespace kadr::nct
