// Executes a compiled block: which statement it is, and its M functions, feed and side. Used by control/heidenhain.

#include "control/heidenhain/block_run.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "control/functions/cutter_compensation.h"

namespace kadr::heidenhain {
namespace {

/// M functions that act at the end of their block; all others act at its start (spec/heidenhain 3.5).
constexpr int ending_codes[] = {0, 1, 2, 5, 6, 9, 30, 89, 97, 98, 99, 102, 108, 111, 117, 127, 129, 137, 145, 149};
/// M functions that change neither path nor feed of a run (spec/heidenhain 3.8).
constexpr int quiet_codes[] = {90, 94, 101, 102, 107, 108, 116, 117, 118, 120, 124, 134, 135, 138, 141, 142, 143, 144, 145, 148, 149, 150};
constexpr int refused_codes[] = {112, 113, 114, 115};

template <std::size_t n>
bool among(const int (&list)[n], double code) {
  return std::find(std::begin(list), std::end(list), code) != std::end(list);
}

bool moves(KlartextKind kind) {
  return (kind >= KlartextKind::line && kind <= KlartextKind::departure && kind != KlartextKind::centre) ||
         kind == KlartextKind::free_contour;
}

}  // namespace

Result<double> BlockRun::number(Name name) const {
  const KlartextWord* const word = read_.find(name);
  return word == nullptr ? Result<double>(0.0) : own_.value(m_, read_, *word);
}

// NOLINTNEXTLINE(readability-function-size): one row for each statement
Status BlockRun::run() {
  const Span where = m_.block->where;
  switch (read_.kind) {
    case KlartextKind::begin_program:
      m_.run_modes({read_.number == 1 ? Function::inch : Function::millimetre});
      if (own_.memory.calls.empty()) own_.memory.inch_outermost = read_.number == 1;
      if (const std::string& twice = own_.index(m_).twice(); !twice.empty())
        return fail(alarm(AlarmId::label_twice, where, std::string_view(twice)));
      return {};
    case KlartextKind::end_program: return own_.end_of_program(m_, where);
    case KlartextKind::blank_form:
    case KlartextKind::passed_over: return {};
    case KlartextKind::label:
      if (read_.name != "0" || own_.memory.calls.empty() || own_.memory.calls.back().of_program) return {};
      return own_.leave(m_, where);
    case KlartextKind::call_label: return own_.call_label(m_, read_);
    case KlartextKind::jump: return own_.jump(m_, read_);
    case KlartextKind::call_program:
      if (m_.modal.radius_side != 0) KADR_TRY(run_code(-40, where));
      return own_.call_program(m_, path_written(), where);
    case KlartextKind::select_program: own_.memory.selected = path_written(); return {};
    case KlartextKind::call_selected: return own_.call_program(m_, own_.memory.selected, where);
    case KlartextKind::tool_call: KADR_TRY(own_.tool_call(m_, read_)); return functions(true);
    case KlartextKind::tool_definition: return own_.tool_definition(m_, read_);
    case KlartextKind::cycle_definition: return own_.define_cycle(m_, read_);
    case KlartextKind::assignment: {
      if (read_.part == 1) return own_.set_parameter(read_.target, undefined);
      const auto value = own_.evaluate(m_, read_, read_.value);
      if (!value) return fail(value.error());
      return own_.set_parameter(read_.target, *value);
    }
    case KlartextKind::text_assignment: {
      auto text = own_.text_value(m_, read_);
      if (!text) return fail(text.error());
      own_.memory.texts[read_.target.index] = std::move(*text);
      return {};
    }
    case KlartextKind::read_system: {
      const auto id = number("ID"), row = number("NR"), at = has("IDX") ? number("IDX") : Result<double>(-1.0);
      for (const auto* each : {&id, &row, &at})
        if (!*each) return fail(each->error());
      const auto value = own_.system_value(m_, *id, *row, *at, where);
      if (!value) return fail(value.error());
      return own_.set_parameter(read_.target, *value);
    }
    case KlartextKind::error: {
      const auto code = own_.evaluate(m_, read_, read_.value);
      if (!code) return fail(code.error());
      return fail(alarm(AlarmId::error_by_program, where, *code, "FN 14"));
    }
    case KlartextKind::print: m_.emit(Message{read_.name}); return {};
    case KlartextKind::plane: return own_.plane(m_, read_);
    case KlartextKind::tip_control: return hold_tip(read_.name != "RESET");
    case KlartextKind::datum:
      if (read_.name == "TABLE") {
        if (has("FILE")) own_.memory.datum_table = read_.find("FILE")->text;
        const auto row = number("TABLINE");
        if (!row) return fail(row.error());
        return own_.take_datum_row(m_, *row, where);
      }
      if (read_.name != "RESET") return own_.shift_datum(m_, read_);
      own_.memory.shift = {};
      return own_.set_frame(m_);
    case KlartextKind::pattern: return own_.call_pattern(m_, read_);
    case KlartextKind::circle_data: return own_.circle_data(m_, read_);
    case KlartextKind::probe: return own_.define_probe(m_, read_);
    case KlartextKind::select_table: own_.memory.datum_table = path_written(); return {};
    case KlartextKind::select_pattern: return own_.select_points(m_, path_written(), where);
    case KlartextKind::export_locals: return export_locals();
    case KlartextKind::not_available: return fail(alarm(AlarmId::not_available, where, std::string_view(read_.name)));
    case KlartextKind::chamfer:
    case KlartextKind::rounding:
      // The block before has made the corner, if there is one (spec/heidenhain 6).
      if (!own_.index(m_).has_corners() || !own_.memory.has_direction)
        return fail(alarm(AlarmId::element_missing, where, read_.kind == KlartextKind::chamfer ? "CHF" : "RND"));
      return {};
    default: return move();
  }
}

/// The path of CALL PGM, SEL PGM, SEL TABLE …: written, or the text of a QS parameter.
std::string BlockRun::path_written() const { return read_.name.empty() ? own_.memory.texts[read_.target.index] : read_.name; }

/// FN 37: QL parameters of a called program become those of its caller (spec/heidenhain 10.6); QS parameters are common anyway.
Status BlockRun::export_locals() {
  auto& calls = own_.memory.calls;
  for (const KlartextStep& step : read_.code) {
    if (step.family != ParameterFamily::ql) continue;
    for (auto call = calls.rbegin(); call != calls.rend(); ++call) {
      if (!call->of_program) continue;
      if (step.index < call->locals.size()) call->locals[step.index] = own_.memory.ql[step.index];
      break;
    }
  }
  return {};
}

Status BlockRun::move() {
  KADR_TRY(modes_before());
  switch (read_.kind) {
    case KlartextKind::words: break;
    case KlartextKind::stop: break;
    case KlartextKind::line:
    case KlartextKind::normal_line:
    case KlartextKind::polar_line: {
      Axes to;
      AxisMask named = 0;
      if (machine_) KADR_TRY(machine_line());
      else {
        KADR_TRY(read_.kind == KlartextKind::polar_line ? polar_target(to, named) : target(to, named));
        KADR_TRY(straight_to(to, named));
      }
      break;
    }
    case KlartextKind::centre: KADR_TRY(centre()); break;
    case KlartextKind::circle: KADR_TRY(circle()); break;
    case KlartextKind::polar_circle: KADR_TRY(polar_circle()); break;
    case KlartextKind::radius_circle: KADR_TRY(radius_circle()); break;
    case KlartextKind::tangent_circle:
    case KlartextKind::polar_tangent_circle: KADR_TRY(tangent_circle()); break;
    case KlartextKind::approach: KADR_TRY(approach()); break;
    case KlartextKind::departure: KADR_TRY(departure()); break;
    case KlartextKind::cycle_call: KADR_TRY(call_at_position()); break;
    case KlartextKind::free_contour: KADR_TRY(free_contour()); break;
    default: break;
  }
  if (has("MB") || has("MBMAX")) KADR_TRY(retract());
  return finish_motion();
}

Status BlockRun::modes_before() {
  own_.corner_rounding = own_.corner_chamfer = own_.corner_feed = 0;
  own_.corner = CornerJoin::arc;
  own_.memory.feed_before = m_.modal.feed_known ? m_.modal.feed : 0;
  KADR_TRY(feed_words());
  for (const KlartextWord& word : read_.words)
    if (word.name == word_name("M") && (word.number == 97 || word.number == 98))
      own_.corner = word.number == 97 ? CornerJoin::straight : CornerJoin::open;
  KADR_TRY(functions(false));
  KADR_TRY(side_words());
  return corner_words();
}

Status BlockRun::finish_motion() {
  if (moves(read_.kind)) own_.memory.moved_at_rapid = rapid_;
  if (read_.kind == KlartextKind::line) own_.note_straight(m_, rapid_);
  KADR_TRY(functions(true));
  if (read_.kind == KlartextKind::stop) KADR_TRY(run_code(0, m_.block->where));
  const bool called = calls_ || (own_.memory.calls_always && moves(read_.kind));
  return called ? own_.call_cycle(m_, m_.block->where, raised_) : Status();
}

Status BlockRun::feed_words() {
  rapid_ = has("FMAX");
  for (const Name name : {Name("F"), Name("FU"), Name("FZ"), Name("FT"), Name("FAUTO")}) {
    if (!has(name)) continue;
    if (name == "FT") return fail(alarm(AlarmId::not_available, where(name), "FT"));
    auto feed = name == "FAUTO" ? Result<double>(own_.memory.tool_feed / m_.unit_scale()) : number(name);
    if (feed && name == "FZ") feed = own_.feed_per_turn(m_, *feed, where(name));
    if (!feed) return fail(feed.error());
    if (!(*feed > 0)) return fail(alarm(AlarmId::value_out_of_range, where(name), "F", *feed));
    m_.modal.feed = *feed * m_.unit_scale();
    m_.modal.feed_known = true;
    if (name == "FU" || name == "FZ") m_.modal.feed_mode = FeedMode::per_revolution;
    else if (!own_.memory.feed_per_turn) m_.modal.feed_mode = FeedMode::per_minute;
  }
  return {};
}

Status BlockRun::side_words() {
  const bool ends = has("R0"), left = has("RL"), right = has("RR");
  if (read_.kind == KlartextKind::approach) return {};
  if (ends && m_.modal.radius_side != 0) return run_code(-40, m_.block->where);
  const int side = left ? -1 : right ? 1 : 0;
  if (side == 0) return {};
  if (m_.modal.radius_side == side) return {};
  if (m_.modal.radius_side != 0) return fail(alarm(AlarmId::compensation_active, where(left ? "RL" : "RR"), left ? "RL" : "RR"));
  return run_code(left ? -41 : -42, m_.block->where);
}

/// Executes a code of the table: an M function, or a G code of the table as a negative number.
Status BlockRun::run_code(int code, Span where) {
  const std::int32_t row = m_.def.row_of(code < 0 ? 'G' : 'M', std::abs(code) * 10);
  if (row < 0 || m_.def.codes[static_cast<std::size_t>(row)].function == Function::machine_function) {
    m_.emit(MachineFunction{static_cast<std::uint32_t>(code), {}, {}});
    return {};
  }
  const CodeRow& found = m_.def.codes[static_cast<std::size_t>(row)];
  KADR_TRY(handler_of(found.function)(m_, {&found, nullptr, where}));
  if (found.group != 0 && found.modal) m_.modal.rows[found.group] = static_cast<std::int16_t>(row);
  own_.after_code(m_, found, std::abs(code) * 10);
  return {};
}

/// M128, M129, FUNCTION TCPM: the tip stays on its path while rotary axes turn (spec/heidenhain 13.3).
Status BlockRun::hold_tip(bool on) {
  own_.memory.holds_tip = on;
  m_.change_frames();
  return {};
}

Status BlockRun::functions(bool at_end) {
  for (const KlartextWord& word : read_.words) {
    if (word.name != word_name("M")) continue;
    const double code = word.number;
    if (code != std::floor(code) || !(code >= 0 && code <= 9999)) return fail(alarm(AlarmId::value_out_of_range, word.where, "M", code));
    if (among(ending_codes, code) != at_end) continue;
    if (among(refused_codes, code)) return fail(alarm(AlarmId::not_available, word.where, m_.block->text_of(word.where)));
    KADR_TRY(at_end ? function_after(code, word) : function_before(code, word));
  }
  return {};
}

Status BlockRun::function_before(double code, const KlartextWord& word) {
  Memory& memory = own_.memory;
  if (among(quiet_codes, code)) return {};
  switch (static_cast<int>(code)) {
    case 91: machine_ = true; return {};
    case 92: machine_ = from_reference_ = true; return {};
    case 103: {
      const auto factor = number("MF");
      if (!factor) return fail(factor.error());
      memory.plunge = has("MF") ? *factor / 100 : 0;
      return {};
    }
    case 109: memory.edge_feed = EdgeFeed::all; return {};
    case 110: memory.edge_feed = EdgeFeed::inside; return {};
    case 126: memory.shortest = true; return {};
    case 128: return hold_tip(true);
    case 130: untilted_ = true; return {};
    case 136:
      memory.feed_per_turn = true;
      m_.modal.feed_mode = FeedMode::per_revolution;
      return {};
    case 140: return {};
    default: return run_code(static_cast<int>(code), word.where);
  }
}

Status BlockRun::function_after(double code, const KlartextWord& word) {
  Memory& memory = own_.memory;
  switch (static_cast<int>(code)) {
    case 97:
    case 98: return {};
    case 89: memory.calls_always = true; return {};
    case 99:
      calls_ = true;
      memory.calls_always = false;
      return {};
    case 111: memory.edge_feed = EdgeFeed::none; return {};
    case 127: memory.shortest = false; return {};
    case 129: return hold_tip(false);
    case 137:
      memory.feed_per_turn = false;
      m_.modal.feed_mode = FeedMode::per_minute;
      return {};
    default: break;
  }
  if (among(quiet_codes, code)) return {};
  return run_code(static_cast<int>(code), word.where);
}

}  // namespace kadr::heidenhain
