// Jumps, control structures and repeated parts of a program (spec/sinumerik 8). Used by control/sinumerik.

#include <cmath>
#include <utility>

#include "base/ascii.h"
#include "control/sinumerik/sinumerik.h"
#include "lang/named/named_parser.h"

namespace kadr::sinumerik {
namespace {

std::string_view keyword_text(Keyword keyword) {
  switch (keyword) {
    case Keyword::if_: return "IF";
    case Keyword::else_: return "ELSE";
    case Keyword::endif: return "ENDIF";
    case Keyword::while_: return "WHILE";
    case Keyword::endwhile: return "ENDWHILE";
    case Keyword::for_: return "FOR";
    case Keyword::endfor: return "ENDFOR";
    case Keyword::loop: return "LOOP";
    case Keyword::endloop: return "ENDLOOP";
    case Keyword::repeat: return "REPEAT";
    default: return "UNTIL";
  }
}

}  // namespace

const ProgramIndex& Sinumerik::index(const BlockContext& m, std::uint16_t reader) {
  if (indices_.size() <= reader) indices_.resize(reader + 1U);
  if (!indices_[reader] || m.program().in_entered()) indices_[reader] = std::make_unique<ProgramIndex>(m.program().file(reader));
  return *indices_[reader];
}

Status Sinumerik::jump(Interpreter& m, const NamedBlock& block, const NamedItem& item) {
  if (item.name == "GOTOS") return {};
  level().acted = true;
  std::string name = item.text;
  if (item.value) {
    const auto value = evaluate(m, block, item.value);
    if (!value) return fail(value.error());
    name = in_capitals(joined_text(*value));
    if (!name.empty() && (is_digit(name[0]) || name[0] == ':')) name = "N" + name.substr(name[0] == ':' ? 1 : 0);
  } else if (const auto found = variable(name); found != nullptr && found->type == Type::text && found->sizes.empty()) {
    name = in_capitals(found->values[0].text);
  }
  const LabelRow* const target = jump_target(index(m), item.name, name, m.block->position);
  if (target == nullptr) {
    if (item.name == "GOTOC") return {};
    return fail(alarm(AlarmId::label_missing, item.where, std::string_view(name)));
  }
  while (!memory.repeated.empty() && memory.repeated.back().depth == m.program().depth()) {
    const RepeatedPart& part = memory.repeated.back();
    if (target->at.offset >= part.begin.offset && target->at.offset < part.end.offset) break;
    m.flow.frames().pop_back();  // the jump leaves the part that is repeated
    memory.repeated.pop_back();
  }
  jump_to(m, target->at);
  return {};
}

void Sinumerik::jump_to(Interpreter& m, const Position& to) {
  loops_ = loops_ || to.offset <= m.block->position.offset;
  m.flow.jump(to);
}

// NOLINTNEXTLINE(readability-function-size): one switch over the keywords
Result<bool> Sinumerik::structure(Interpreter& m, const NamedBlock& block, Keyword keyword) {
  const ProgramIndex& all = index(m);
  const StructureRow* const row = all.structure_at(m.block->position);
  const Span where = m.block->statement.text;
  const std::string_view text = keyword_text(keyword);
  if (row == nullptr || row->misplaced) return fail(alarm(AlarmId::structure_wrong, where, text));
  if (row->depth >= deepest_structure) return fail(alarm(AlarmId::structure_deep, where, double{deepest_structure}));
  if (row->partner < 0) return fail(alarm(all.misplaced_after(*row) ? AlarmId::structure_wrong : AlarmId::structure_open, where, text));
  const StructureRow& partner = all.row(row->partner);
  const auto condition = [&]() -> Result<bool> {
    if (block.items.size() != 1 || block.items[0].kind != NamedItem::Kind::condition || block.items[0].name == "FOR")
      return fail(alarm(AlarmId::statement_not_alone, where));
    const auto value = number(m, block, block.items[0].value, block.items[0].where);
    if (!value) return fail(value.error());
    return *value != 0;
  };
  struct Counter {
    double* number;
    Type type;
  };
  const auto counter = [&](const NamedBlock& head) -> Result<Counter> {
    const NamedItem& item = head.items[0];
    const bool by_number = item.text.size() > 1 && item.text[0] == 'R' && item.text.find_first_not_of("0123456789", 1) == std::string::npos;
    const auto found = variable(item.text);
    if (found == nullptr && (by_number || (item.text == "R" && item.value))) {
      double index = std::strtod(item.text.c_str() + 1, nullptr);
      if (!by_number) {
        const auto value = number(m, head, item.value, item.where);
        if (!value) return fail(value.error());
        index = std::round(*value);
      }
      if (!(index >= 0) || index >= double{parameter_count}) return fail(alarm(AlarmId::index_range, item.where, "R", index));
      return Counter{&memory.parameters[static_cast<std::size_t>(index)], Type::real};
    }
    if (found == nullptr) return fail(alarm(AlarmId::name_unknown, item.where, std::string_view(item.text)));
    if (found->type != Type::integer && found->type != Type::real) return fail(alarm(AlarmId::operand_type, item.where, "FOR"));
    std::vector<NamedExpression> indices;
    if (item.value) indices.push_back(item.value);
    const auto at = element(m, head, item.text, *found, indices, item.where);
    if (!at) return fail(at.error());
    return Counter{&found->values[*at].number, found->type};
  };
  switch (keyword) {
    case Keyword::if_: {
      const auto on = condition();
      if (!on) return on;
      if (!*on) m.flow.jump(partner.after);
      return true;
    }
    case Keyword::else_: m.flow.jump(partner.after); return true;
    case Keyword::endif: return true;
    case Keyword::while_: {
      const auto on = condition();
      if (!on) return on;
      if (!*on) m.flow.jump(partner.after);
      return true;
    }
    case Keyword::endwhile: jump_to(m, partner.at); return true;
    case Keyword::loop:
    case Keyword::repeat: return true;
    case Keyword::endloop: jump_to(m, partner.after); return true;
    case Keyword::until: {
      const auto on = condition();
      if (!on) return on;
      if (!*on) jump_to(m, partner.after);
      return true;
    }
    case Keyword::for_: {
      if (block.items.size() != 1 || block.items[0].name != "FOR") return fail(alarm(AlarmId::statement_not_alone, where));
      const NamedItem& item = block.items[0];
      const auto at = counter(block);
      if (!at) return fail(at.error());
      if (std::exchange(memory.counts_on, std::nullopt) == m.block->position) {
        *at->number += 1;
      } else {
        const auto from = evaluate(m, block, item.arguments[0]);
        if (!from) return fail(from.error());
        const auto value = converted(*from, at->type, item.where);
        if (!value) return fail(value.error());
        *at->number = value->number;
      }
      const auto to = number(m, block, item.arguments[1], item.where);
      if (!to) return fail(to.error());
      if (*at->number > *to) m.flow.jump(partner.after);
      return true;
    }
    case Keyword::endfor: {
      memory.counts_on = partner.at;  // FOR, which is executed again, counts and does not set its variable
      jump_to(m, partner.at);
      return true;
    }
    default: return true;
  }
}

Status Sinumerik::choose(Interpreter& m, const NamedBlock& block) {
  const auto value = number(m, block, block.items[0].value, block.items[0].where);
  if (!value) return fail(value.error());
  for (std::size_t i = 1; i < block.items.size(); ++i) {
    const NamedItem& item = block.items[i];
    if (!item.arguments.empty()) {
      const auto constant = number(m, block, item.arguments[0], item.where);
      if (!constant) return fail(constant.error());
      if (*constant != *value) continue;
    }
    return jump(m, block, item);
  }
  return {};
}

/// REPEAT L, REPEAT L1 L2, REPEATB L, each with P=n (spec/sinumerik 8.3).
Status Sinumerik::repeat_part(Interpreter& m, const NamedBlock& block) {
  const NamedItem& item = block.items[0];
  double times = 1;
  for (std::size_t i = 1; i < block.items.size(); ++i) {
    const NamedItem& word = block.items[i];
    if (word.kind != NamedItem::Kind::word || word.name != "P") return fail(alarm(AlarmId::statement_not_alone, word.where));
    times = word.number;
    if (word.has_equals) {
      const auto value = number(m, block, word.value, word.where);
      if (!value) return fail(value.error());
      times = std::round(*value);
    }
  }
  if (!(times >= 1 && times <= 9999)) return fail(alarm(AlarmId::passes_wrong, item.where, times));
  const ProgramIndex& all = index(m);
  const std::size_t gap = item.text.find(' ');
  const std::string begin_name = item.text.substr(0, gap);
  const Position here = m.block->position;
  const LabelRow* const begin = all.section_label(begin_name, here);
  if (begin == nullptr) return fail(alarm(AlarmId::section_missing, item.where, std::string_view(begin_name)));
  Position end = begin->after;
  if (item.name == "REPEAT") {
    if (gap != std::string::npos) {
      const std::string end_name = item.text.substr(gap + 1);
      const LabelRow* const last = all.section_label(end_name, here);
      if (last == nullptr || last->at.offset < begin->at.offset)
        return fail(alarm(AlarmId::section_missing, item.where, std::string_view(end_name)));
      end = last->after;
    } else {
      const bool before = begin->at.offset < here.offset;
      const LabelRow* const last = all.end_label(begin->at);
      if (last != nullptr && (!before || last->at.offset < here.offset)) end = last->after;
      else end = before ? here : all.program_at(begin->at).end;
    }
  }
  CallFrame frame;
  frame.kind = CallFrame::Kind::subprogram;
  frame.left = static_cast<std::uint32_t>(times);
  frame.caller = m.origin;
  KADR_TRY(m.flow.call_at(m.program().reader(), begin->at, frame, item.where));
  memory.repeated.push_back({begin->at, end, m.program().depth()});
  return {};
}

Status Sinumerik::call_part(Interpreter& m, const NamedBlock& block) {
  const auto& items = block.items;
  const NamedItem& call = items[0];
  const bool whole = items.size() == 3 && items[2].name == "TO" && !items[1].text.empty() && !items[2].text.empty();
  if (!whole) return fail(alarm(AlarmId::expression_syntax, call.where, "CALL BLOCK"));
  if (call.value) return fail(alarm(AlarmId::not_available, call.where, "CALL BLOCK"));
  return call_section(m, items[1].text, items[2].text, call.where);
}

Status Sinumerik::call_section(Interpreter& m, const std::string& from, const std::string& to, Span where) {
  const ProgramIndex& all = index(m);
  const LabelRow* const begin = all.section_label(from, m.block->position);
  const LabelRow* const last = all.section_label(to, m.block->position);
  if (begin == nullptr || last == nullptr || last->at.offset < begin->at.offset)
    return fail(alarm(AlarmId::section_missing, where, std::string_view(begin == nullptr ? from : to)));
  CallFrame frame;
  frame.kind = CallFrame::Kind::subprogram;
  frame.left = 1;
  frame.caller = m.origin;
  KADR_TRY(m.flow.call_at(m.program().reader(), begin->at, frame, where));
  memory.repeated.push_back({begin->at, last->after, m.program().depth()});
  return {};
}

Result<bool> Sinumerik::next_position(Interpreter& m) {
  Pattern& pattern = *memory.pattern;
  const auto& modal = level().modal_call;
  const auto found = modal ? find_program(m, modal->name) : std::nullopt;
  if (pattern.next >= pattern.at.size() || !found) {
    memory.pattern.reset();
    return true;
  }
  const Vec2 at = pattern.at[pattern.next++];
  const PlaneAxes plane = m.modal.axes;
  Axes to = m.position.programmed;
  to[plane.first] = at.x;
  to[plane.second] = at.y;
  const ModalCall called = *modal;
  const auto stop = [&](const Alarm& fault) -> Result<bool> {
    memory.pattern.reset();
    return fail(fault);
  };
  if (const Status moved = m.straight(MotionKind::rapid, to, AxisMask{1} << plane.first | AxisMask{1} << plane.second); !moved)
    return stop(moved.error());
  if (const Status begun = call(m, *found, called.name, called.arguments, {}, !called.arguments.empty(), 1, m.block->where); !begun)
    return stop(begun.error());
  return true;
}

Result<bool> Sinumerik::finish(Interpreter& m) {
  if (has_open_parts()) {
    const auto ended = end_part(m);
    if (!ended || *ended) return ended;
  }
  return loops_ && memory.macros.empty() && m.runs_unseen() && calculation_.run(m);
}

/// Ends a repeated part, or a program whose last block was executed. Returns false if the next block follows.
Result<bool> Sinumerik::end_part(Interpreter& m) {
  if (memory.pattern && memory.pattern->depth == m.program().depth()) return next_position(m);
  const Position next = m.program().position();
  if (!memory.repeated.empty() && memory.repeated.back().depth == m.program().depth()) {
    if (next.offset < memory.repeated.back().end.offset && next.offset >= memory.repeated.back().begin.offset) return false;
    const auto left = m.flow.end_subprogram({});
    if (!left) return fail(left.error());
    if (*left != nullptr) memory.repeated.pop_back();
    return true;
  }
  const ProgramIndex& all = index(m);
  if (m.program().depth() == 0) {
    if (all.programs().size() < 2 || next.offset < all.programs().front().end.offset) return false;
    m.flow.end();
    return true;
  }
  if (m.program().in_entered()) return false;
  const ProgramRow& program = all.program_at(m.flow.innermost()->start);
  if (next.offset < program.end.offset) return false;
  KADR_TRY(leave(m, {}));
  return true;
}

}  // namespace kadr::sinumerik
