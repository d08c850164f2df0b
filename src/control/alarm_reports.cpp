// Reports for people: the locations of alarms, the state at the end of a run, and the faults of subprograms that were never called.

#include <algorithm>
#include <memory>

#include "control/block/plan.h"
#include "control/interpreter.h"
#include "lang/text/encoding.h"

namespace kadr {
namespace {

std::uint32_t characters(std::string_view text) {
  return static_cast<std::uint32_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

/// Limits the report to the one line that contains the fault, if the text of the block spans several lines. Example: a comment spans
/// several lines, and the block with the fault begins after the comment in its last line (nct 14.3).
void to_own_line(AlarmReport& r) {
  const std::string_view before = std::string_view(r.line_text).substr(0, r.alarm.where.begin);
  const std::size_t end = r.line_text.find('\n', r.alarm.where.begin);
  if (end != std::string::npos) r.line_text.resize(end);
  const std::size_t last = before.rfind('\n');
  if (last == std::string_view::npos) return;
  const auto cut = static_cast<std::uint32_t>(last + 1);
  r.origin.line += static_cast<std::uint32_t>(std::count(before.begin(), before.end(), '\n'));
  r.line_text.erase(0, cut);
  r.alarm.where = {r.alarm.where.begin - cut, std::max(r.alarm.where.end, cut) - cut};
}

}  // namespace

void Interpreter::warn(const Alarm& alarm) {
  if (*on_warning) (*on_warning)(report_of(alarm, origin, block->text));
}

/// Replaces the internal one-letter codes of long addresses by the names of these addresses (`,C`, `XDE`). An argument that is copied from
/// the program's text remains as written: a `]` in the text is not the internal code of `,A`.
Alarm Interpreter::with_names(Alarm alarm) const {
  if (alarm.id == AlarmId::expression_syntax || alarm.id == AlarmId::unexpected_character) return alarm;
  for (std::size_t i = 0; i < alarm.arg_count; ++i) {
    if (alarm.args[i].is_number() || alarm.args[i].text().size() != 1 || alarm.args[i].text()[0] <= 'Z') continue;
    const char address = alarm.args[i].text()[0];
    alarm.args[i] = AlarmArg(std::string_view(address_written(address)));
    for (const AddressName& name : def.grammar.names)
      if (name.address == address) alarm.args[i] = AlarmArg(std::string_view(name.text));
  }
  return alarm;
}

/// Converts arguments that were copied undecoded from the program's text (a comment, DPRNT) to UTF-8.
void Interpreter::decode_arguments(Alarm& alarm) const {
  for (AlarmArg& arg : alarm.args) {
    std::string text;
    if (arg.is_number() || append_utf8(arg.text(), Encoding::utf8, text)) continue;
    Span all;
    arg = AlarmArg(std::string_view(flow.shown(arg.text(), all)));
  }
}

AlarmReport Interpreter::plain_report_of(const Alarm& alarm, const Origin& at, std::string_view line_text) const {
  AlarmReport r{def.grammar.names.empty() && !def.grammar.comma_words ? alarm : with_names(alarm), flow.file(), {}, at, {}, {}};
  decode_arguments(r.alarm);
  const bool in_body = flow.in_body() && !line_text.empty();
  if (in_body) r.alarm.where = call_where;  // the body of a canned cycle is in no file, so the report has the location of the call
  r.line_text = in_body ? call_text : flow.shown(line_text, r.alarm.where);
  if (r.alarm.where.begin <= r.line_text.size() && r.line_text.find('\n') != std::string::npos) to_own_line(r);
  if (r.alarm.where.begin <= r.line_text.size())
    r.origin.column = characters(std::string_view(r.line_text).substr(0, r.alarm.where.begin)) + 1;
  if (alarm.id == AlarmId::program_alarm && !block->comments.empty()) {
    Span all;
    r.own_text = flow.shown(block->text_of(block->comments.front()), all);
  }
  r.calls = calls();
  return r;
}

AlarmReport Interpreter::report_of(const Alarm& alarm, const Origin& at, std::string_view line_text) const {
  AlarmReport r = plain_report_of(alarm, at, line_text);
  dialect->reword(*this, r);
  return r;
}

std::vector<AlarmReport::Call> Interpreter::calls() const {
  std::vector<AlarmReport::Call> open;
  for (const CallFrame& frame : flow.frames())
    open.push_back({Flow::name_of(def, frame), frame.caller.line, frame.caller.block, frame.caller.has_block});
  return open;
}

std::vector<AlarmReport::Call> Interpreter::calls_of(const Origin& at) const {
  std::vector<AlarmReport::Call> calls;
  if (!call_tree_) return calls;
  for (const CallTree::Call& c : call_tree_->calls(at.calls)) {
    calls.push_back(c.call);
    if (c.file > 1) calls.back().file = flow.file(c.file).path();
  }
  return calls;
}

Origin Interpreter::origin_of_block() const {
  Origin o;
  o.line = block->position.line;
  o.column = block->where.begin == 0 ? 1 : characters(block->text.substr(0, block->where.begin)) + 1;
  o.block = block->number;
  o.has_block = block->has_number;
  o.main_block = block->main_block;
  o.block_digits = block->number_digits;
  o.file = flow.reader();
  o.number = static_cast<std::uint32_t>(flow.blocks());
  o.depth = static_cast<std::uint8_t>(std::min<std::size_t>(flow.depth(), 255));
  if (call_tree_) o.calls = call_tree_->chain_of(def, flow.frames());
  return o;
}

// ---- one block

void Interpreter::check_uncalled(const std::function<void(const AlarmReport&)>& on_fault) {
  auto plan = std::make_unique<Plan>();
  flow.each_uncalled([&](Result<BlockReader::Got> got, const Block& read) {
    Status status = got ? Status() : Status(fail(got.error()));
    Block& looked_at = const_cast<Block&>(read);  // an expression has no value here, so a block with a computed code number is not planned
    bool known = true;
    for (std::uint32_t i = 0; i < looked_at.word_count; ++i)
      known = known &&
              !(looked_at.words[i].expression && looked_at.words[i].code < 0 && letters.codes >> (looked_at.words[i].address - 'A') & 1u);
    if (status && known) status = plan_block(def, letters, read, any_motion, *plan);
    Origin at;
    at.line = read.position.line;
    at.block = read.number;
    at.has_block = read.has_number;
    at.block_digits = read.number_digits;
    if (!status) on_fault(report_of(status.error(), at, read.text));
  });
}

/// Returns the codes in force, and the words F, S, T, D and H with their values.
std::vector<std::string> Interpreter::codes_in_force(const Modal& of) const {
  std::vector<std::string> codes;
  for (std::size_t g = 1; g < def.groups.size(); ++g)
    if (of.rows[g] >= 0) codes.push_back(def.codes[static_cast<std::size_t>(of.rows[g])].code);
  const auto add = [&](const char* letter, double v) {
    std::string text = std::to_string(v);
    while (text.back() == '0') text.pop_back();
    if (text.back() == '.') text.pop_back();
    codes.push_back(letter + text);
  };
  if (of.feed_known) add("F", of.inch && of.feed_mode != FeedMode::inverse_time ? of.feed / mm_per_inch : of.feed);
  add("S", of.rpm);
  add("T", of.tool_selected);
  add("D", of.offset_number);
  add("H", of.length_number);
  return codes;
}

BlockState Interpreter::state_now() const { return {codes_in_force(modal), modal.tool, frames.origin, frames.length}; }

std::optional<BlockState> Interpreter::state_of(const Origin& at) const {
  const auto state = block_states_ ? block_states_->of(at.number) : nullptr;
  if (!state) return std::nullopt;
  return BlockState{codes_in_force(state->modal), state->modal.tool, state->frames.origin, state->frames.length};
}

FinalState Interpreter::ending() {
  FinalState e;
  e.position = frames.space ? frames.space->in_system(position.work) : position.work;
  e.machine_position = position.machine;
  dialect->add_variables(*this, e, watch_);
  for (std::uint32_t n = 1; macro_variables == nullptr && n <= variables.highest() && def.grammar.variables != 0; ++n)
    if (variables.is_set(n)) e.variables.emplace_back("#" + std::to_string(n), *variables.variable(n, {}));
  for (int i = 0; i < variables.parameter_count(); ++i)
    if (variables.parameter_set(i)) e.variables.emplace_back(variables.name_of_parameter(i), variables.raw_parameter(i));
  for (const std::string& name : watch_) {
    if (macro_variables != nullptr) break;
    const auto same = [&](const auto& v) { return v.first == name; };
    if (std::any_of(e.variables.begin(), e.variables.end(), same)) continue;
    const auto read =
        name.starts_with('#') ? variables.variable(std::strtod(name.c_str() + 1, nullptr), {}) : Result<double>(fail(Alarm()));
    if (read) e.variables.emplace_back(name, *read);
    else e.watched_unset.emplace_back(name, true);
  }
  e.modal = codes_in_force(modal);
  return e;
}

/// Returns true for the letter of an axis that machines of this control may have.
constexpr bool names_an_axis(char letter) { return (letter >= 'A' && letter <= 'C') || (letter >= 'U' && letter <= 'Z'); }

/// Warns of words that no function of the block uses; the real control ignores such words without a report (spec/fanuc 1.2).
void Interpreter::warn_passed_over(std::uint64_t letters_passed) {
  for (std::uint32_t i = 0; i < block->word_count; ++i)
    if (const Word& w = block->words[i]; w.address != 0 && (letters_passed & letter_bit(w.address)) != 0)
      warn(names_an_axis(w.address) && (letters.axes & letter_bit(w.address)) == 0
               ? warning(AlarmId::axis_passed_over, w.where, std::string_view(&w.address, 1), block->text_of(w.where))
               : warning(AlarmId::word_passed_over, w.where, block->text_of(w.where)));
}

/// Reports the data that the block has changed and that survive power-off.
void Interpreter::report_changes() {
  if (on_changes == nullptr || !*on_changes) return;
  const StateChanges changes = dialect->take_changes(*this);
  if (!changes.rows.empty()) (*on_changes)(changes);
}

bool Interpreter::runs_unseen() const {
  const bool held = holds_before != nullptr && *holds_before, reports = on_changes != nullptr && *on_changes;
  return !each_block && !is_watched() && !held && !reports && line_marks == nullptr && !block_states_ && !use.watches() &&
         !flow.in_entered();
}

void Interpreter::take_common(const Interpreter& from) {
  dialect->take_common(*this, *from.dialect);
  report_changes();
}

}  // namespace kadr
