// O lines: labels and subprograms (spec/linuxcnc 6; interp_o_word.cc of LinuxCNC's source). Loops and branches are in o_line_loops.cpp.

#include "control/linuxcnc/o_line_flow.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "control/flow/program_file.h"
#include "control/functions/functions.h"
#include "control/interpreter.h"
#include "control/linuxcnc/files/sub_files.h"
#include "control/linuxcnc/linuxcnc.h"
#include "control/linuxcnc/o_lines.h"
#include "control/variable_reader.h"
#include "lang/expression/expression.h"

namespace kadr::linuxcnc {
Status OLines::run() {
  file_ = &flow_.of(m_);
  here_ = index_of(m_.block->position);
  const auto named = label();
  if (!named) return fail(named.error());
  label_ = *named;
  if (!flow_.refused.empty()) return wrong(std::exchange(flow_.refused, {}));
  if (flow_.defining != no_label) return define();
  switch (s_.o_word) {
    case OWord::label:
      if (control_.machine.fanuc_subprograms) return {};
      return wrong("DISABLE_FANUC_STYLE_SUB disabled in INI file, but found bare O-word");
    case OWord::sub: return begin_sub();
    case OWord::endsub:
    case OWord::return_: return end_sub();
    case OWord::call: return call();
    case OWord::do_: return begin_do();
    case OWord::while_: return while_loop();
    case OWord::endwhile: return end_loop(OWord::while_);
    case OWord::repeat: return repeat();
    case OWord::endrepeat: return end_loop(OWord::repeat);
    case OWord::if_: return branch();
    case OWord::elseif:
    case OWord::else_: return other_branch();
    case OWord::endif: return end_branch();
    case OWord::break_: return leave_loop(false);
    case OWord::continue_: return leave_loop(true);
  }
  return {};
}

std::string_view OLines::line_text() const {
  const std::string_view all = m_.block->text;
  const std::size_t begin = all.find_first_not_of(" \t"), end = all.find_last_not_of(" \t\r");
  return begin == std::string_view::npos ? std::string_view() : all.substr(begin, end + 1 - begin);
}

Result<Label> OLines::label() {
  if (here_ >= 0 && row(here_).label != no_label) return row(here_).label;
  if (s_.text.end > s_.text.begin) return flow_.label_of(VariableNames::plain(m_.block->text_of(s_.text)));
  if (!s_.value) return flow_.label_of({});
  const auto value = evaluate(*m_.block, s_.value, VariableReader{m_});
  if (!value) return fail(value.error());
  return flow_.label_of(label_of_number(std::round(*value)));
}

std::int32_t OLines::index_of(const Position& at) const {
  const auto found = file_->by_offset.find(at.offset);
  return found == file_->by_offset.end() ? -1 : found->second;
}

Label OLines::label_of(const OLine& row) const {
  if (row.label != no_label) return row.label;
  const auto value = m_.value_of(row.expression);
  return value ? flow_.label_of(label_of_number(std::round(*value))) : no_label;
}

std::int32_t OLines::next_of(std::initializer_list<OWord> words) {
  if (here_ < 0) return -1;
  const auto count = static_cast<std::int32_t>(file_->lines.size());
  const bool chained = row(here_).label != no_label;
  for (std::int32_t i = chained ? row(here_).next : here_ + 1; i >= 0 && i < count; i = chained ? row(i).next : i + 1) {
    if (!chained && label_of(row(i)) != label_) continue;
    if (std::find(words.begin(), words.end(), row(i).word) != words.end()) return i;
  }
  return -1;
}

tl::unexpected<Alarm> OLines::end_of_file_seeking(bool sought, bool of_all) const {
  std::string what = "File ended with no percent sign or program end";
  if (file_->closed) what = fmt::format("Failed to find sub 'O{}' before EOF", sought || of_all ? text() : local_name());
  else if (sought) what = fmt::format("EOF in file:{} seeking o-word: o<{}> from line: {}", m_.program().file(), text(), line());
  else if (control_.state.percent) what = "File ended with no percent sign";
  return control_.fault(AlarmId::rs274_flow, s_.where, std::move(what));
}

Status OLines::jump_to(const Position& at) {
  m_.flow.jump(at);
  return {};
}

Mark& OLines::place() {
  if (here_ < 0 || row(here_).label == no_label) return flow_.mark(flow_.mark_of(where(), label_));
  OLine& own = row(here_);
  if (own.mark_of != where()) {
    own.mark_of = where();
    own.mark = flow_.mark_of(where(), label_);
  }
  return flow_.mark(own.mark);
}

Result<Mark*> OLines::take_mark(OWord word, bool of_branch) {
  Mark& known = place();
  if (known.used) {
    if (known.at == m_.block->position && known.reader == m_.program().reader()) return &known;
    if (of_branch)
      return wrong(fmt::format("{}: duplicate O-word label - already defined in line {}: '{}'", line(), known.at.line, line_text()));
    return wrong(fmt::format("{}: duplicate O-word label: '{}' - defined in line {}", line(), line_text(), known.at.line));
  }
  known = {true, word, m_.block->position, m_.program().reader()};
  return &known;
}

Status OLines::define() {
  flow_.defining = no_label;
  return s_.o_word == OWord::sub ? Status(wrong("Nested subroutine definition")) : Status();
}

Status OLines::begin_sub() {
  if (!flow_.calls.empty()) {  // Inside a call `sub` defines no subprogram: its lines are executed, and its `endsub` returns from the call
    if (flow_.by_m98.back()) return wrong("'O.... sub' subroutine must be called with 'O.... call'");
    m_.warn(warning(AlarmId::sub_in_sub, s_.where, std::string_view(text())));
    return {};
  }
  PassedSub& known = flow_.passed(label_);
  const bool here = known.known && known.reader == m_.program().reader() && known.at == m_.block->position;
  if (here && m_.program().passes() == 1)
    return wrong(fmt::format("File:{} line:{} sub: o|{}| found in illegal location", m_.program().file(), line(), text()));
  if (known.known && !here)
    return wrong(fmt::format("File:{} line:{} redefining sub: o|{}| already defined in file:{}", m_.program().file(), line(), text(),
                             m_.program().file(known.reader).path()));
  known = {true, m_.program().reader(), m_.block->position};
  std::int32_t end = next_of({OWord::endsub});
  if (end < 0) return end_of_file_seeking(false, true);
  for (std::int32_t i = here_ + 1; i < end; ++i)
    if (row(i).word == OWord::sub) end = i;
  flow_.defining = label_;
  return jump_to(row(end).at);
}

Status OLines::end_sub() {
  if (flow_.calls.empty() || m_.program().depth() == 0)
    return wrong(fmt::format("{}: not in a subroutine definition: '{}'", line(), m_.block->text_of(m_.block->where)));
  if (flow_.by_m98.back()) return wrong("Fanuc 'O....' subroutine definition must end with 'M99'");
  double value = 0;
  if (s_.condition_count != 0) {
    const auto returned = value_of(s_.conditions[0]);
    if (!returned) return fail(returned.error());
    value = *returned;
  }
  control_.state.value = value;
  control_.state.value_returned = s_.condition_count != 0;
  return leave_sub(m_, s_.where);
}

Result<OLines::Place> OLines::find_sub() {
  if (const PassedSub& known = flow_.passed(label_); known.known) return place_of(known.reader, known.at);
  if (const auto reader = file_of_label(m_.flow, control_, text())) {
    for (const OLine& each : flow_.of(m_, *reader).lines)
      if (each.word == OWord::sub && label_of(each) == label_) return found_at(*reader, each);
    return end_of_file_seeking(true);
  }
  for (std::size_t i = static_cast<std::size_t>(here_ + 1); i < file_->lines.size(); ++i) {
    const OLine& each = file_->lines[i];
    if (label_of(each) != label_) continue;
    if (each.word == OWord::sub) return found_at(m_.program().reader(), each);
    if (each.word == OWord::label) {
      flow_.refused = "Fanuc 'O....' subroutine must be called with 'M98'";
      return Place{m_.program().reader(), each.at, true};
    }
  }
  return end_of_file_seeking(true);
}

OLines::Place OLines::found_at(std::uint16_t reader, const OLine& line) {
  flow_.passed(label_) = {true, reader, line.at};
  return {reader, line.position_after, false};
}

Result<OLines::Place> OLines::place_of(std::uint16_t reader, Position at) {
  const OFile& all = flow_.of(m_, reader);
  const auto found = all.by_offset.find(at.offset);
  if (found == all.by_offset.end()) return end_of_file_seeking(true);
  return Place{reader, all.lines[static_cast<std::size_t>(found->second)].position_after, false};
}

Status OLines::call() {
  Level made;
  std::size_t n = 1;
  for (const Expression argument : m_.block->arguments) {
    const auto value = value_of(argument);
    if (!value) return fail(value.error());
    made.arguments[n++] = *value;
  }
  if (control_.machine.argument_count)
    if (const auto name = m_.def.grammar.named_variables->number_of("n_args")) made.named[*name] = static_cast<double>(n - 1);
  return enter(std::move(made));
}

Status OLines::enter(Level made) {
  const auto place = find_sub();
  if (!place) return fail(place.error());
  if (place->fanuc) return jump_to(place->start);
  if (flow_.calls.size() >= max_calls_of_program) return wrong("Too many subroutine levels");
  CallFrame frame;
  frame.kind = CallFrame::Kind::subprogram;
  frame.name = static_cast<std::uint32_t>(std::strtoul(text().c_str(), nullptr, 10));
  frame.left = 1;
  frame.caller = m_.origin;
  KADR_TRY(m_.flow.call_at(place->reader, place->start, frame, s_.where));
  enter_sub(m_, label_, std::move(made), false);
  return {};
}

Status OLines::call_labelled(const std::string& label) {
  file_ = &flow_.of(m_);
  here_ = index_of(m_.block->position);
  label_ = flow_.label_of(label);
  return enter(Level());
}

Status call_sub(Interpreter& m, const std::string& label, Span) { return OLines(m).call_labelled(label); }

Status run_o_line(Interpreter& m) { return OLines(m).run(); }

}  // namespace kadr::linuxcnc
