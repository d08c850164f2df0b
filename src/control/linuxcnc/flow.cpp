// O lines: subprograms, loops, branches (spec/linuxcnc 6; interp_o_word.cc of the source).

#include "control/linuxcnc/flow.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "control/flow/program_file.h"
#include "control/functions/functions.h"
#include "control/interpreter.h"
#include "control/linuxcnc/linuxcnc.h"
#include "control/linuxcnc/sub_files.h"
#include "control/reading.h"
#include "lang/expression/expression.h"

namespace kadr::linuxcnc {
namespace {

class OLines {
 public:
  explicit OLines(Interpreter& m) : m_(m), control_(linuxcnc_of(m)), memory_(control_.flow.memory), s_(m.block->statement) {}

  Status run() {
    const auto named = label();
    if (!named) return fail(named.error());
    label_ = *named;
    if (!memory_.refused.empty()) return wrong(std::exchange(memory_.refused, {}));
    if (!memory_.defining.empty()) return define();
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

  /// By a label that no O line says.
  Status call_labelled(const std::string& label) {
    label_ = label;
    return enter(Level());
  }

 private:
  tl::unexpected<Alarm> wrong(std::string text) const { return control_.fault(AlarmId::rs274_flow, s_.where, std::move(text)); }
  std::uint32_t line() const { return m_.block->position.line; }
  std::string where() const { return memory_.calls.empty() ? std::string() : memory_.calls.back(); }

  Result<std::string> label() {
    std::string text = written_label(*m_.block);
    if (!text.empty() || !s_.value) return text;
    const auto value = evaluate(*m_.block, s_.value, Reading{m_});
    if (!value) return fail(value.error());
    return label_of_number(std::round(*value));
  }

  Result<double> value_of(Expression e) { return evaluate(*m_.block, e, Reading{m_}); }

  // ---- where lines are

  const OFile& file() { return control_.flow.of(m_); }
  std::int32_t index_here() {
    const auto found = file().by_offset.find(m_.block->position.offset);
    return found == file().by_offset.end() ? -1 : found->second;
  }

  std::string label_of(const OLine& row) const {
    if (!row.label.empty()) return row.label;
    const auto value = m_.value_of(row.expression);
    return value ? label_of_number(std::round(*value)) : std::string();
  }

  /// The next line behind this one with the same label, of the same subprogram, that is one of `words`; -1: none.
  std::int32_t next_of(std::initializer_list<OWord> words) {
    const OFile& all = file();
    const std::int32_t here = index_here();
    if (here < 0) return -1;
    const bool chained = !all.lines[static_cast<std::size_t>(here)].label.empty();
    for (std::int32_t i = chained ? all.lines[static_cast<std::size_t>(here)].next : here + 1;
         i >= 0 && i < static_cast<std::int32_t>(all.lines.size()); i = chained ? all.lines[static_cast<std::size_t>(i)].next : i + 1) {
      const OLine& row = all.lines[static_cast<std::size_t>(i)];
      if (!chained && label_of(row) != label_) continue;
      if (std::find(words.begin(), words.end(), row.word) != words.end()) return i;
    }
    return -1;
  }

  const OLine& row(std::int32_t index) { return file().lines[static_cast<std::size_t>(index)]; }

  /// The end was looked for and not found: the whole file has been read (2.1).
  tl::unexpected<Alarm> end_of_file_seeking() const {
    return control_.fault(AlarmId::rs274_flow, s_.where,
                          fmt::format("EOF in file:{} seeking o-word: o<{}> from line: {}", m_.flow.file(), label_, line()));
  }

  Status jump_to(const Position& at) {
    m_.flow.jump(at);
    return {};
  }

  // ---- labels

  Mark* mark() {
    const auto found = memory_.marks.find({where(), label_});
    return found == memory_.marks.end() ? nullptr : &found->second;
  }

  /// The label begins something here: it may do so again, but nowhere else.
  Result<Mark*> take_mark(OWord word, bool of_branch = false) {
    if (Mark* const known = mark(); known != nullptr) {
      if (known->at == m_.block->position && known->reader == m_.flow.reader()) return known;
      if (of_branch)
        return wrong(fmt::format("{}: duplicate O-word label - already defined in line {}: '{}'", line(), known->at.line, label_));
      return wrong(fmt::format("{}: duplicate O-word label: '{}' - defined in line {}", line(), label_, known->at.line));
    }
    Mark made;
    made.word = word;
    made.at = m_.block->position;
    made.reader = m_.flow.reader();
    return &memory_.marks.insert_or_assign({where(), label_}, made).first->second;
  }

  tl::unexpected<Alarm> undefined() const { return wrong(fmt::format("{}: undefined O-word label: '{}'", line(), label_)); }
  std::string found(const Mark& other) const { return fmt::format("(found '{}' in line {})", name_of(other.word), other.at.line); }

  // ---- subprograms

  /// On the way over a definition only its end counts, and no other may begin.
  Status define() {
    if (s_.o_word == OWord::sub) {
      memory_.defining.clear();
      return wrong("Nested subroutine definition");
    }
    memory_.defining.clear();
    return {};
  }

  /// Passed over; its label is known from now on.
  Status begin_sub() {
    const auto known = memory_.passed.find(label_);
    const std::pair here{m_.flow.reader(), m_.block->position};
    if (known != memory_.passed.end() && known->second != here)
      return wrong(fmt::format("File:{} line:{} redefining sub: o|{}| already defined in file:{}", m_.flow.file(), line(), label_,
                               m_.flow.file(known->second.first).path()));
    memory_.passed.insert_or_assign(label_, here);
    std::int32_t end = next_of({OWord::endsub});
    const std::int32_t begin = index_here();
    if (end < 0) return end_of_file_seeking();
    for (std::int32_t i = begin + 1; i < end; ++i)
      if (row(i).word == OWord::sub) end = i;
    memory_.defining = label_;
    return jump_to(row(end).at);
  }

  Status end_sub() {
    if (memory_.calls.empty() || m_.flow.depth() == 0)
      return wrong(fmt::format("{}: not in a subroutine definition: '{}'", line(), m_.block->text_of(m_.block->where)));
    if (memory_.by_m98.back()) return wrong("Fanuc 'O....' subroutine definition must end with 'M99'");
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

  struct Place {
    std::uint16_t reader = 0;
    Position start;
    bool fanuc = false;
  };

  /// 6.2: passed already, then a file of that name, then further on in this file.
  Result<Place> find_sub() {
    if (const auto known = memory_.passed.find(label_); known != memory_.passed.end())
      return place_of(known->second.first, known->second.second);
    if (const auto reader = file_of_label(m_, label_)) {
      const OFile& all = control_.flow.of(m_, *reader);
      for (const OLine& each : all.lines)
        if (each.word == OWord::sub && label_of(each) == label_) return Place{*reader, each.behind, false};
      return end_of_file_seeking();
    }
    const std::int32_t here = index_here();
    const OFile& all = file();
    for (std::size_t i = static_cast<std::size_t>(here + 1); i < all.lines.size(); ++i) {
      const OLine& each = all.lines[i];
      if (label_of(each) != label_) continue;
      if (each.word == OWord::sub) return Place{m_.flow.reader(), each.behind, false};
      if (each.word == OWord::label) {
        memory_.refused = "Fanuc 'O....' subroutine must be called with 'M98'";
        return Place{m_.flow.reader(), each.at, true};
      }
    }
    return end_of_file_seeking();
  }

  Result<Place> place_of(std::uint16_t reader, Position at) {
    const OFile& all = control_.flow.of(m_, reader);
    const auto found = all.by_offset.find(at.offset);
    if (found == all.by_offset.end()) return end_of_file_seeking();
    return Place{reader, all.lines[static_cast<std::size_t>(found->second)].behind, false};
  }

  Status call() {
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

  Status enter(Level made) {
    const auto place = find_sub();
    if (!place) return fail(place.error());
    if (place->fanuc) return jump_to(place->start);
    if (memory_.calls.size() >= most_calls_of_program) return wrong("Too many subroutine levels");
    CallFrame frame;
    frame.kind = CallFrame::Kind::subprogram;
    frame.name = static_cast<std::uint32_t>(std::strtoul(label_.c_str(), nullptr, 10));
    frame.left = 1;
    frame.caller = m_.origin;
    KADR_TRY(m_.flow.call_at(place->reader, place->start, frame, s_.where));
    enter_sub(m_, label_, std::move(made), false);
    return {};
  }

  // ---- loops

  Status begin_do() {
    const auto made = take_mark(OWord::do_);
    return made ? Status() : Status(fail(made.error()));
  }

  Status while_loop() {
    const auto test = value_of(s_.conditions[0]);
    if (!test) return fail(test.error());
    if (const Mark* const known = mark(); known != nullptr && known->word == OWord::do_ && known->at != m_.block->position) {
      if (*test != 0) return jump_to(behind(*known));
      memory_.marks.erase({where(), label_});
      return {};
    }
    if (*test != 0) {
      const auto made = take_mark(OWord::while_);
      return made ? Status() : Status(fail(made.error()));
    }
    memory_.marks.erase({where(), label_});
    return behind_end({OWord::endwhile});
  }

  Status repeat() {
    const auto count = value_of(s_.conditions[0]);
    if (!count) return fail(count.error());
    if (std::round(*count) < 1) return behind_end({OWord::endrepeat});
    const auto made = take_mark(OWord::repeat);
    if (!made) return fail(made.error());
    (*made)->left = std::round(*count);
    return {};
  }

  /// Behind the line that ends it.
  Status behind_end(std::initializer_list<OWord> ends) {
    const std::int32_t end = next_of(ends);
    if (end < 0) return end_of_file_seeking();
    return jump_to(row(end).behind);
  }

  Position behind(const Mark& of) {
    const OFile& all = control_.flow.of(m_, of.reader);
    const auto found = all.by_offset.find(of.at.offset);
    return found == all.by_offset.end() ? of.at : all.lines[static_cast<std::size_t>(found->second)].behind;
  }

  Status end_loop(OWord of) {
    Mark* const known = mark();
    if (known == nullptr) return undefined();
    if (known->word != of) return wrong(fmt::format("{}: no matching label: '{}' {}", line(), label_, found(*known)));
    if (of == OWord::while_) return jump_to(known->at);
    if (--known->left < 1) {
      memory_.marks.erase({where(), label_});
      return {};
    }
    return jump_to(behind(*known));
  }

  Status leave_loop(bool again) {
    const Mark* const known = mark();
    if (known == nullptr) return undefined();
    if (known->word != OWord::while_ && known->word != OWord::do_)
      return wrong(fmt::format("{}: no matching while/do label: '{}' {}", line(), label_, found(*known)));
    if (again && known->word == OWord::while_) return jump_to(known->at);
    const std::int32_t end = next_of({OWord::endwhile, OWord::while_});
    if (end < 0) return end_of_file_seeking();
    if (again) return jump_to(row(end).at);
    memory_.marks.erase({where(), label_});
    return jump_to(row(end).behind);
  }

  // ---- branches

  Status branch() {
    const auto test = value_of(s_.conditions[0]);
    if (!test) return fail(test.error());
    const auto made = take_mark(OWord::if_, true);
    if (!made) return fail(made.error());
    (*made)->taken = *test != 0;
    return *test != 0 ? Status() : on_to_other();
  }

  Status on_to_other() {
    const std::int32_t other = next_of({OWord::elseif, OWord::else_, OWord::endif});
    if (other < 0) return end_of_file_seeking();
    return jump_to(row(other).at);
  }

  Status other_branch() {
    Mark* const known = mark();
    if (known == nullptr) return undefined();
    if (known->word != OWord::if_) return wrong(fmt::format("{}: no matching 'if' label: '{}' {}", line(), label_, found(*known)));
    if (known->taken) return behind_end({OWord::endif});
    if (s_.o_word == OWord::else_) {
      known->taken = true;
      return {};
    }
    const auto test = value_of(s_.conditions[0]);
    if (!test) return fail(test.error());
    known->taken = *test != 0;
    return *test != 0 ? Status() : on_to_other();
  }

  Status end_branch() {
    const Mark* const known = mark();
    if (known == nullptr) return undefined();
    if (known->word != OWord::if_)
      return wrong(fmt::format("{}: no matching label: '{}' {}: '{}'", line(), label_, found(*known), m_.block->text_of(m_.block->where)));
    return {};
  }

  Interpreter& m_;
  LinuxCnc& control_;
  FlowTable::Memory& memory_;
  const Statement& s_;
  std::string label_;
};

}  // namespace

void enter_sub(Interpreter& m, const std::string& label, std::optional<Level> level, bool by_m98) {
  LinuxCnc& control = linuxcnc_of(m);
  control.flow.memory.calls.push_back(label);
  control.flow.memory.by_m98.push_back(by_m98);
  control.kept_modes.emplace_back();
  if (level) control.levels().push_back(std::move(*level));
}

Status leave_sub(Interpreter& m, Span where) {
  LinuxCnc& control = linuxcnc_of(m);
  const auto left = m.flow.end_subprogram(where);
  if (!left) return fail(left.error());
  if (*left == nullptr) return {};  // once more
  if (!control.flow.memory.by_m98.back() && control.levels().size() > 1) control.levels().pop_back();
  control.flow.memory.calls.pop_back();
  control.flow.memory.by_m98.pop_back();
  KADR_TRY(restore_at_end(m));
  const bool profile_ends = control.turning && control.flow.memory.calls.size() == control.turning->depth;
  return profile_ends ? run_turning(m) : Status();
}

Status call_sub(Interpreter& m, const std::string& label, Span) { return OLines(m).call_labelled(label); }

Status run_o_line(Interpreter& m) { return OLines(m).run(); }

}  // namespace kadr::linuxcnc
