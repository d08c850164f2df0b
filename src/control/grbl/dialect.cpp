// What the interpreter asks a dialect (control/dialect.h), answered for Grbl.

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "base/ascii.h"
#include "base/units.h"
#include "control/functions/arc_motion.h"
#include "control/functions/functions.h"
#include "control/grbl/grbl.h"

namespace kadr {

std::unique_ptr<Dialect> make_grbl_dialect(const Setup& setup) { return std::make_unique<grbl::Grbl>(setup); }

namespace grbl {
namespace {

struct GrblMemory : DialectState {
  explicit GrblMemory(const State& all) : state(all) {}
  State state;
};

AxisMask named_in(const Interpreter& m) {
  AxisMask named = 0;
  for (std::size_t a = 0; a < axes; ++a)
    if (m.has(m.letters.axis_letter[a])) named |= AxisMask{1} << a;
  return named;
}

/// "$130=200" → 130 and 200.
struct Assigned {
  int number = 0;
  double value = 0;
};
std::optional<Assigned> assigned(std::string_view line) {
  Assigned all;
  const char* const end = line.data() + line.size();
  const auto number = std::from_chars(line.data() + 1, end, all.number);
  if (number.ec != std::errc() || number.ptr == end || *number.ptr != '=') return std::nullopt;
  const auto value = std::from_chars(number.ptr + 1, end, all.value);
  if (value.ec != std::errc() || value.ptr != end || !std::isfinite(all.value)) return std::nullopt;
  return all;
}

}  // namespace

Grbl& grbl_of(const Interpreter& m) { return static_cast<Grbl&>(*m.dialect); }

Result<bool> set(Settings& settings, int number, double value, Span where) {
  constexpr int first_travel = 130;
  if (value < 0) return fail(alarm(AlarmId::value_below_zero, where, std::to_string(number), value));
  switch (number) {
    case 20:
      if (value != 0 && !settings.homing) return fail(alarm(AlarmId::soft_limits_need_homing, where));
      settings.soft_limits = value != 0;
      return true;
    case 22:
      settings.homing = value != 0;
      settings.soft_limits = settings.soft_limits && settings.homing;
      return true;
    case 30: settings.speed_most = value; return true;
    case 31: settings.speed_least = value; return true;
    case first_travel:
    case first_travel + 1:
    case first_travel + 2: settings.travel[static_cast<std::size_t>(number - first_travel)] = value; return true;
    default: return false;
  }
}

/// The settings of the set-up; the others are those of the generic build (10).
Grbl::Grbl(const Setup& setup) {
  constexpr double usual_travel = 200;
  for (std::size_t a = 0; a < axes; ++a) state.settings.travel[a] = usual_travel;
  for (const int number : {22, 20, 30, 31, 130, 131, 132}) {
    const std::string digits = std::to_string(number);
    const auto given = setup.parameters.find({std::string(4 - digits.size(), '0') + digits, "", ""});
    if (given == setup.parameters.end() || !std::holds_alternative<double>(given->second)) continue;
    (void)set(state.settings, number, std::get<double>(given->second), {});
  }
}

std::shared_ptr<const DialectState> Grbl::snapshot() const { return std::make_shared<GrblMemory>(state); }

Status Grbl::restore(Interpreter&, const DialectState& from) {
  state = before_ = static_cast<const GrblMemory&>(from).state;
  return {};
}

/// Its codes could not stand in one line: G49 and G0 both want axis words.
bool Grbl::start(Interpreter& m, const Setup&) {
  for (std::size_t g = 0; g < m.def.groups.size(); ++g)
    if (m.def.groups[g].power_on >= 0) m.modal.rows[g] = static_cast<std::int16_t>(m.def.groups[g].power_on);
  m.modal.motion = MotionMode::rapid;
  m.modal.motion_row = static_cast<std::int16_t>(m.def.row_of('G', 0));
  m.modal.work_zero = 1;
  return true;
}

void Grbl::started(Interpreter&) { before_ = state; }

/// `$` lines (9, 11): a jog, homing, settings that count; the others are passed over, with a note.
Result<bool> Grbl::statement(Interpreter& m) {
  std::string line;
  for (const char c : m.block->text_of(m.block->statement.text))
    if (static_cast<unsigned char>(c) > ' ') line += to_upper(c);
  const Span where = m.block->statement.where;
  if (line.starts_with("$J=")) {
    KADR_TRY(jog(m));
    return true;
  }
  if (line == "$H") {
    if (!state.settings.homing) return fail(alarm(AlarmId::homing_off, where));
    KADR_TRY(m.to_machine(MotionKind::home, Axes{}, (AxisMask{1} << axes) - 1, 0));
    return true;
  }
  if (line == "$X") return true;
  if (line.size() > 1 && is_digit(line[1])) {
    const auto row = assigned(line);
    const auto& known = m.def.parameters;
    if (!row || std::none_of(known.begin(), known.end(), [&](const ParameterRow& p) { return p.number == row->number; }))
      return fail(alarm(AlarmId::system_line, where, line.substr(0, 30)));
    const auto counts = set(state.settings, row->number, row->value, where);
    if (!counts) return fail(counts.error());
    if (*counts) return true;
  }
  m.warn(note(AlarmId::system_line_passed, where, line.substr(0, 30)));
  return true;
}

/// `$J=`: a straight motion at its own F, in mm/min; the modes are left as they are (9).
Status Grbl::jog(Interpreter& m) {
  const auto jog = check(m, *this, true);
  if (!jog) return fail(jog.error());
  const Modal before = m.modal;
  m.modal.feed_mode = FeedMode::per_minute;
  m.modal.inch = jog->inch;
  m.modal.feed = m.length_value('F');
  m.modal.feed_known = true;
  const bool by_machine = jog->non_modal == 530;
  const Status moved = by_machine ? m.to_machine(MotionKind::feed, jog->target, named_in(m), m.modal.feed)
                                  : m.straight(MotionKind::feed, jog->target, named_in(m));
  m.modal = before;
  return moved;
}

Result<bool> Grbl::takes_block(Interpreter& m) {
  const auto all = check(m, *this, false);
  if (!all) return fail(all.error());
  checked = *all;
  KADR_TRY(m.check_ranges());
  if (!m.has('S')) return false;
  const Settings& s = state.settings;  // $30, $31 (4.17)
  double& speed = m.block->words[m.block->at['S' - 'A']].value;
  if (speed > 0) speed = std::clamp(speed, std::min(s.speed_least, s.speed_most), s.speed_most);
  return false;
}

void Grbl::begin_block(Interpreter&) { before_ = state; }

void Grbl::take_back(Interpreter&) { state = before_; }

BlockChanges Grbl::changes_of(const Interpreter&, const Plan&) const { return BlockChanges::anything; }

/// After G80 there is none.
std::int16_t Grbl::motion_row(const Interpreter& m) const { return checked.moves ? m.modal.motion_row : std::int16_t{-1}; }

/// M2, M30: nothing moves again by the G1 that comes into force.
bool Grbl::end_program(Interpreter& m) {
  m.block_axes_taken = true;
  return false;
}

Status Grbl::after_block(Interpreter& m) {
  const bool probes = checked.motion > 380 && checked.motion < 390;
  if (probes) m.modal.motion_row = static_cast<std::int16_t>(m.def.row_of('G', checked.motion));  // 3: G38.n is a mode
  if (m.modal.feed_mode == FeedMode::inverse_time) {                                              // 4.2: F counts for its block
    m.modal.feed = 0;
    m.modal.feed_known = false;
  }
  return {};
}

bool Grbl::lines_follow(const Interpreter& m) const {
  return m.modal.feed_mode == FeedMode::per_minute && m.modal.feed_known && m.modal.feed > 0 && !state.settings.soft_limits;
}

/// Its arcs are looked at one by one.
ArcRule Grbl::arc_rule(const Interpreter& m) const {
  ArcRule rule = m.plain_arc_rule();
  rule.by_words = false;
  return rule;
}

Status Grbl::arc(Interpreter& m, const kadr::Call&, Turn turn) {
  if (!checked.arc) return {};
  AxisMask named = 0;
  Axes end;
  KADR_TRY(m.target(end, named));
  KADR_TRY(m.within_reach(end));
  arc_motion(m, *checked.arc, turn, end, named);
  return {};
}

void Grbl::refresh_frames(Interpreter& m) {
  m.frames_by_tables();
  m.frames.length[2] = state.length;
}

/// Without contact only .2 and .4 are faults (4.16).
Status Grbl::take_answer(Interpreter& m, const ProbeAnswer& answer) {
  const Status noted = m.note_answer(answer);
  const bool must = m.modal.motion_row == m.def.row_of('G', 382) || m.modal.motion_row == m.def.row_of('G', 384);
  if (noted || must) return noted;
  return {};
}

/// M1 is ignored (7).
Status Grbl::machine_code(Interpreter&, const kadr::Call&) { return {}; }

}  // namespace grbl
}  // namespace kadr
