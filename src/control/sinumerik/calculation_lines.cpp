// Compiles lines (calculation.h). Used by control/sinumerik/calculation.

#include <algorithm>
#include <utility>

#include "base/code_literals.h"
#include "control/sinumerik/calculation.h"
#include "control/sinumerik/sinumerik.h"
#include "lang/named/named_parser.h"

namespace kadr::sinumerik {
namespace {

/// Returns the place of the block, without its number in the order of execution.
Origin origin_of(const Interpreter& m, const Block& block) {
  Origin origin;
  origin.line = block.position.line;
  origin.column = block.where.begin + 1;
  origin.block = block.number;
  origin.has_block = block.has_number;
  origin.main_block = block.main_block;
  origin.block_digits = block.number_digits;
  origin.file = m.program().reader();
  return origin;
}

}  // namespace

/// Returns the number of the line, which is compiled if it was not met before.
std::int32_t Calculation::line_at(Interpreter& m, const Position& at) {
  File& file = files_[m.program().reader()];
  if (lines_.empty()) lines_.emplace_back();  // the line of everything that is not compiled because there is too much of it
  if (lines_.size() >= most_lines && !file.lines.contains(at.offset)) return 0;
  const auto [found, added] = file.lines.try_emplace(at.offset, static_cast<std::int32_t>(lines_.size()));
  if (!added) return found->second;
  Line& line = lines_.emplace_back();
  line.at = line.after = at;
  const ProgramFile& of = m.program().file(m.program().reader());
  if (!file.reader) file.reader = std::make_unique<BlockReader>(of.source(), of.grammar(), of.reader().encoding());
  file.reader->seek(at);
  const auto block = std::make_unique<Block>();
  const auto got = file.reader->next(*block);
  if (!got || *got == BlockReader::Got::end) return found->second;
  line.at = block->position;
  line.after = file.reader->position();
  compile(m, own_.index(m), line, *block);
  return found->second;
}

void Calculation::compile(Interpreter& m, const ProgramIndex& index, Line& line, Block& block) {
  if (block.skip != 0 || !block.warnings.empty()) return;
  if (block.statement.kind != StatementKind::named) {
    if (block.empty() && block.comments.empty()) line.kind = Kind::nothing;
    const bool returns = block.word_count == 1 && block.words[0].address == 'M' && block.words[0].code == 17_m && block.comments.empty();
    if (returns) line.kind = Kind::leave;
    return;
  }
  if (block.word_count != 0) return;
  const std::string_view text = block.text_of(block.statement.text);
  if (!text.empty() && text[0] == '%') return;
  const auto read = read_named_block(block.text, block.statement.text);
  if (!read || read->kind == NamedKind::definition || read->kind == NamedKind::macro) return;
  if (read->kind == NamedKind::procedure) {
    const bool numbers = std::all_of(read->definitions.begin(), read->definitions.end(), [](const NamedDefinition& row) {
      return row.sizes.empty() && row.initial.empty() && !row.by_reference;
    });
    if (!numbers || !read->attributes.empty()) return;
    line.kind = Kind::parameters;
    line.call = std::make_shared<const Call>(Call{{}, *read, {}, {}, {}, {}});
    return;
  }
  if (read->kind != NamedKind::items) return;
  if (read->items.empty()) {
    line.kind = Kind::nothing;
    return;
  }
  const std::size_t begin = code_.size();
  const Keyword keyword = structure_of(text);
  const bool done = keyword != Keyword::none ? structure(index, *read, keyword, line)
                    : read->items[0].kind == NamedItem::Kind::condition || read->items[0].kind == NamedItem::Kind::jump
                        ? conditional(index, *read, line)
                    : read->items.size() == 1 && !read->items[0].has_equals ? call_of(m, read->items[0], *read, origin_of(m, block), line)
                                                                            : assignments(*read, line);
  if (done) return;
  code_.resize(begin);
  line.kind = Kind::other;
}

bool Calculation::structure(const ProgramIndex& index, const NamedBlock& read, Keyword keyword, Line& line) {
  const StructureRow* const row = index.structure_at(line.at);
  if (row == nullptr || row->misplaced || row->depth >= deepest_structure || row->partner < 0) return false;
  const StructureRow& partner = index.row(row->partner);
  line.target = partner.after;
  switch (keyword) {
    case Keyword::endif:
    case Keyword::loop:
    case Keyword::repeat: line.kind = Kind::nothing; return true;
    case Keyword::endwhile: line.target = partner.at; [[fallthrough]];
    case Keyword::else_:
    case Keyword::endloop: line.kind = Kind::jump; return true;
    case Keyword::endfor:
      line.target = partner.at;
      line.kind = Kind::count_on;
      return true;
    case Keyword::for_: return counted(read, line);
    default: break;
  }
  if (read.items.size() != 1 || read.items[0].kind != NamedItem::Kind::condition || read.items[0].name == "FOR") return false;
  const auto condition = compiled(read, read.items[0].value);
  if (!condition) return false;
  line.condition = *condition;
  line.kind = Kind::jump_unless;
  return true;
}

bool Calculation::counted(const NamedBlock& read, Line& line) {
  if (read.items.size() != 1 || read.items[0].name != "FOR") return false;
  const NamedItem& item = read.items[0];
  NamedItem variable;
  variable.name = item.text;
  if (item.value) variable.arguments.push_back(item.value);
  const bool by_number = item.text.size() > 1 && item.text[0] == 'R' && item.text.find_first_not_of("0123456789", 1) == std::string::npos;
  if (by_number) {
    if (item.text.size() > 5) return false;
    variable.name = "R";
    variable.extension = static_cast<std::int32_t>(std::stol(item.text.substr(1)));
  }
  variable.value = item.arguments[0];
  Target target;
  const auto last = compiled(read, item.arguments[1]);
  if (!last || !target_of(read, variable, target)) return false;
  line.targets.push_back(std::move(target));
  line.condition = *last;
  line.kind = Kind::count;
  return true;
}

/// IF … GOTOF LABEL, and GOTOF LABEL.
bool Calculation::conditional(const ProgramIndex& index, const NamedBlock& read, Line& line) {
  const bool always = read.items[0].kind == NamedItem::Kind::jump;
  if (always) {
    line.kind = Kind::jump;
    return read.items.size() == 1 && to_label(index, read.items[0], line);
  }
  if (read.items.size() != 2 || read.items[0].name != "IF" || read.items[1].kind != NamedItem::Kind::jump) return false;
  const auto condition = compiled(read, read.items[0].value);
  if (!condition || !to_label(index, read.items[1], line)) return false;
  line.condition = *condition;
  line.kind = Kind::jump_if;
  return true;
}

bool Calculation::to_label(const ProgramIndex& index, const NamedItem& item, Line& line) {
  if (item.name == "GOTOS" || item.value) return false;
  const LabelRow* const target = jump_target(index, item.name, item.text, line.at);
  if (target == nullptr) return false;
  line.target = target->at;
  line.label_slot = slot_of(item.text);
  line.acts = true;
  return true;
}

/// A line that only calls a program with numbers as arguments, or returns: NAME(1,R2), M17, RET.
bool Calculation::call_of(Interpreter& m, const NamedItem& item, const NamedBlock& read, const Origin& origin, Line& line) {
  Call call;
  call.origin = origin;
  const bool returns = (item.kind == NamedItem::Kind::word && item.name == "M" && item.number == 17 && item.extension < 0) ||
                       (item.kind == NamedItem::Kind::name && item.name == "RET" && item.arguments.empty());
  line.kind = returns ? Kind::leave : Kind::call;
  if (!returns) {
    if (item.kind != NamedItem::Kind::name || item.value || !item.text.empty() || Sinumerik::is_frame_statement(item.name)) return false;
    const auto found = own_.find_program(m, item.name);
    if (!found) return false;
    call.program = *found;
    call.name = item.name;
    for (const NamedExpression& each : item.arguments) {
      const bool one_name = each.end == each.begin + 1 && read.code[each.begin].kind == NamedStep::Kind::name;
      call.references.push_back(one_name ? read.code[each.begin].name : std::string());
      const auto argument = compiled(read, each);
      if (!argument) return false;
      call.arguments.push_back(*argument);
    }
  }
  line.call = std::make_shared<const Call>(std::move(call));
  return true;
}

bool Calculation::assignments(const NamedBlock& read, Line& line) {
  for (const NamedItem& item : read.items) {
    Target target;
    if (item.kind != NamedItem::Kind::word || !item.has_equals || item.form != WordForm::plain || !target_of(read, item, target))
      return false;
    line.targets.push_back(std::move(target));
  }
  line.kind = Kind::assign;
  return true;
}

bool Calculation::target_of(const NamedBlock& read, const NamedItem& item, Target& target) {
  if (item.name.empty() || item.name[0] == '$') return false;
  if (item.name == "R") {
    if (item.extension < 0 && item.arguments.size() != 1) return false;
    if (item.extension >= 0 && !item.arguments.empty()) return false;
    target.parameter = item.extension < 0 ? 0 : static_cast<std::uint32_t>(item.extension);
  } else {
    if (item.extension >= 0) return false;
    target.slot = slot_of(item.name);
  }
  for (const NamedExpression& each : item.arguments) {
    const auto index = compiled(read, each);
    if (!index) return false;
    target.indices.push_back(*index);
  }
  const auto value = compiled(read, item.value);
  if (!value) return false;
  target.value = *value;
  return true;
}

std::optional<Calculation::Code> Calculation::compiled(const NamedBlock& read, NamedExpression expression) {
  Code code{static_cast<std::uint32_t>(code_.size()), 0};
  std::size_t depth = 0;
  for (std::uint32_t i = expression.begin; i < expression.end; ++i)
    if (!step(read.code[i], depth) || depth > most_values) return std::nullopt;
  code.end = static_cast<std::uint32_t>(code_.size());
  return depth == 1 ? std::optional(code) : std::nullopt;
}

/// Compiles a step. `depth`: the number of values on the stack. Returns false for a step that is not for numbers.
bool Calculation::step(const NamedStep& from, std::size_t& depth) {
  Step to;
  to.operands = from.operands;
  to.op = from.op;
  const auto number = [&](Type type) {
    to.number = {from.number, type};
    return true;
  };
  bool known = true;
  switch (from.kind) {
    case NamedStep::Kind::real: known = number(Type::real); break;
    case NamedStep::Kind::integer: known = number(Type::integer); break;
    case NamedStep::Kind::boolean: known = number(Type::boolean); break;
    case NamedStep::Kind::parameter:
      to.kind = from.operands == 1 ? Step::Kind::parameter_at : Step::Kind::parameter;
      if (from.operands == 0 && !(from.number >= 0 && from.number < double{parameter_count})) return false;
      to.index = static_cast<std::uint32_t>(from.number);
      break;
    case NamedStep::Kind::name:
      known = from.name[0] != '$';
      to.kind = Step::Kind::variable;
      if (known) to.index = slot_of(from.name);
      break;
    case NamedStep::Kind::apply:
      to.kind = from.operands == 1 ? Step::Kind::apply_one : Step::Kind::apply_two;
      known = from.op != NamedOp::join && from.op != NamedOp::chain;
      break;
    case NamedStep::Kind::call:
      to.kind = Step::Kind::function;
      to.function = number_function(from.name);
      known = to.function != nullptr && to.function->operands == from.operands;
      break;
    default: known = false;
  }
  if (!known || depth < from.operands) return false;
  depth = depth - from.operands + 1;
  code_.push_back(to);
  return true;
}

std::uint32_t Calculation::slot_of(const std::string& name) {
  const auto [found, added] = slot_by_name_.try_emplace(name, static_cast<std::uint32_t>(names_.size()));
  if (added) {
    names_.push_back(name);
    slots_.push_back(&unknown_);
  }
  return found->second;
}

}  // namespace kadr::sinumerik
