// Executes the words and assignments of a block with names. Used by control/sinumerik.

#include "control/sinumerik/block_run.h"

#include <cmath>
#include <utility>

#include "base/ascii.h"

namespace kadr::sinumerik {
namespace {

/// Words of several letters that change nothing in the path of the tool.
constexpr std::string_view accepted_words[] = {"ADIS", "ADISPOS", "CTOL", "OTOL", "ATOL", "ACC", "VELOLIM", "JERKLIM"};

}  // namespace

Result<bool> BlockRun::run() {
  if (read_.kind == NamedKind::procedure) return done(own_.procedure(m_, read_));
  if (read_.kind == NamedKind::external || read_.kind == NamedKind::passed_over) return true;
  if (read_.kind == NamedKind::definition) return done(own_.define(m_, read_));
  if (read_.kind == NamedKind::macro) {
    own_.memory.macros[read_.name] = read_.text;
    return true;
  }
  KADR_TRY(own_.begin_pass(m_));
  if (read_.items.empty()) return true;
  const Keyword keyword = structure_of(block_.text_of(block_.statement.text));
  if (block_.statement.kind == StatementKind::named && keyword != Keyword::none) return own_.structure(m_, read_, keyword);
  const NamedItem& first = read_.items.front();
  if (first.kind == NamedItem::Kind::condition && first.name == "CASE") return done(own_.choose(m_, read_));
  if (first.kind == NamedItem::Kind::name && first.name == "EXECSTRING" && read_.items.size() == 1) return executed_text();
  if (first.kind == NamedItem::Kind::name && first.name == "CALL" && read_.items.size() > 1 && read_.items[1].name == "BLOCK")
    return done(own_.call_part(m_, read_));
  if (first.kind == NamedItem::Kind::name) {
    if (first.name == "REPEAT" || first.name == "REPEATB") return done(own_.repeat_part(m_, read_));
    if (Sinumerik::is_frame_statement(first.name)) return done(own_.frame_statement(m_, read_));
  }
  for (std::size_t i = 0; i < read_.items.size(); ++i) {
    const auto more = item(i);
    if (!more) return fail(more.error());
    if (!*more) return true;
  }
  return finish();
}

Result<bool> BlockRun::executed_text() {
  const NamedItem& item = read_.items.front();
  if (item.arguments.size() != 1) return fail(alarm(AlarmId::expression_syntax, item.where, "EXECSTRING"));
  const auto text = own_.evaluate(m_, read_, item.arguments[0]);
  if (!text) return fail(text.error());
  if (text->type != Type::text) return fail(alarm(AlarmId::operand_type, item.where, "EXECSTRING"));
  return own_.execute_text(m_, text->text, item.where);
}

Result<bool> BlockRun::item(std::size_t& i) {
  const NamedItem& item = read_.items[i];
  switch (item.kind) {
    case NamedItem::Kind::word: return all_right(word(item));
    case NamedItem::Kind::jump: {
      KADR_TRY(own_.jump(m_, read_, item));
      return false;
    }
    case NamedItem::Kind::condition: {
      if (item.name != "IF" || i + 1 >= read_.items.size() || read_.items[i + 1].kind != NamedItem::Kind::jump)
        return fail(alarm(AlarmId::statement_not_alone, item.where));
      const auto on = own_.number(m_, read_, item.value, item.where);
      if (!on) return fail(on.error());
      if (*on == 0) ++i;
      return true;
    }
    case NamedItem::Kind::name: return name(item, i);
  }
  return true;
}

Result<double> BlockRun::number_of(const NamedItem& item) {
  if (!item.has_equals) return item.number;
  return own_.number(m_, read_, item.value, item.where);
}

Status BlockRun::word(const NamedItem& item) {
  const std::string& name = item.name;
  const std::string whole = item.extension >= 0 ? name + std::to_string(item.extension) : name;
  if (name[0] == '$') return system_word(item);
  if (item.has_equals && item.extension < 0)
    if (const auto found = own_.variable(name); found != nullptr) return assign(item, found);
  if (name == "R") return parameter(item);
  if (name.size() > 1) return long_word(item);
  const auto value = item.has_equals && item.name == "T" ? Result<double>(0.0) : number_of(item);
  if (!value) return fail(value.error());
  const char letter = name[0];
  const bool extended = item.extension >= 0;
  if (!item.arguments.empty()) return bracketed(item, *value);
  switch (letter) {
    case 'G': return extended ? unknown(item) : code_word(item, 'G', *value);
    case 'M': return m_word(item, *value);
    case 'T': return tool(item);
    case 'D':
      if (extended) return unknown(item);
      return edge(item, *value);
    case 'H': m_.emit(AuxiliaryFunction{'H', *value}); return {};
    case 'L': return extended || item.has_equals ? unknown(item) : numbered_call(item);
    case 'P': times_ = *value; return {};
    case 'I':
    case 'J':
    case 'K':
      if (item.extension == 1) return store(whole, *value, item);
      break;
    case 'A':
    case 'B':
    case 'C':
      if (item.extension == 3) return store(whole, *value, item);
      break;
    default: break;
  }
  if (letter == 'S' && item.extension > 1) return spindle_word(item, *value);
  if (extended && !(letter == 'S' && item.extension == 1)) {
    if (axis_of(letter) && (reference_ || fixed_point_)) return add(letter, *value, item);  // G74 X1=0: a machine axis
    return fail(alarm(AlarmId::not_available, item.where, std::string_view(whole + "=")));
  }
  constexpr std::string_view further = "ABCUVW";  // axes that only some machines have
  if (further.find(letter) != std::string_view::npos && !axis_of(letter)) return fail(alarm(AlarmId::axis_not_named, item.where, letter));
  if (!m_.def.grammar.word(letter).known || m_.def.address(letter).function == Function::count) return unknown(item);
  if (letter == 'F' && !(*value > 0) && !in_dwell_) return fail(alarm(AlarmId::value_out_of_range, item.where, 'F', *value));
  return add(letter, *value, item);
}

bool BlockRun::axis_of(char letter) const { return (m_.letters.axes & ~own_.missing_axes & letter_bit(letter)) != 0; }

Status BlockRun::unknown(const NamedItem& item) const { return fail(alarm(AlarmId::name_unknown, item.where, block_.text_of(item.where))); }

Status BlockRun::system_word(const NamedItem& item) {
  std::vector<Value> indices;
  for (const NamedExpression& each : item.arguments) {
    auto value = own_.evaluate(m_, read_, each);
    if (!value) return fail(value.error());
    indices.push_back(std::move(*value));
  }
  const auto value = own_.evaluate(m_, read_, item.value);
  if (!value) return fail(value.error());
  return own_.write_system(m_, item.name, indices, *value, item.where);
}

Status BlockRun::assign(const NamedItem& item, const std::shared_ptr<Variable>& variable) {
  const Variable& to = *variable;
  if (to.type == Type::frame && item.arguments.size() == to.sizes.size() + 2) return assign_component(item, variable);
  if (to.type == Type::text && to.sizes.empty() && item.arguments.size() == 1) return assign_sign(item, variable);
  const NamedStep& last = read_.code[item.value.end - 1];
  if (!to.sizes.empty() && last.kind == NamedStep::Kind::call && (last.name == "SET" || last.name == "REP"))
    return assign_list(item, variable, last);
  const auto at = own_.element(m_, read_, item.name, to, item.arguments, item.where);
  if (!at) return fail(at.error());
  const auto value = own_.evaluate(m_, read_, item.value);
  if (!value) return fail(value.error());
  auto fits = converted(*value, to.type, item.where);
  if (!fits) return fail(fits.error());
  fits->omitted = false;
  own_.assign(variable, *at, std::move(*fits));
  return {};
}

/// FRAME1[X,TR]=5: a component of a frame.
Status BlockRun::assign_component(const NamedItem& item, const std::shared_ptr<Variable>& to) {
  const std::size_t first = to->sizes.size();
  const std::vector<NamedExpression> indices(item.arguments.begin(), item.arguments.begin() + static_cast<std::ptrdiff_t>(first));
  const auto at = own_.element(m_, read_, item.name, *to, indices, item.where);
  if (!at) return fail(at.error());
  const auto axis = own_.evaluate(m_, read_, item.arguments[first]), part = own_.evaluate(m_, read_, item.arguments[first + 1]);
  if (!axis) return fail(axis.error());
  if (!part) return fail(part.error());
  const auto of = axis->type == Type::axis ? own_.axis_named(m_, axis->text) : std::nullopt;
  if (!of) return fail(alarm(AlarmId::frame_component, item.where, std::string_view(axis->text)));
  const auto value = own_.number(m_, read_, item.value, item.where);
  if (!value) return fail(value.error());
  Frame frame = *to->values[*at].frame;
  KADR_TRY(set_component_of(frame, *of, part->text, *value, item.where));
  own_.assign(to, *at, frame_value(frame));
  return {};
}

/// A=SET(1,,3) assigns consecutive elements, from A[n] on if an index is written; REP(v) assigns all of them (spec/sinumerik 6.1).
Status BlockRun::assign_list(const NamedItem& item, const std::shared_ptr<Variable>& variable, const NamedStep& last) {
  const Variable& to = *variable;
  std::size_t first = 0;
  if (!item.arguments.empty()) {
    const auto at = own_.element(m_, read_, item.name, to, item.arguments, item.where);
    if (!at) return fail(at.error());
    first = *at;
  }
  const auto values = own_.evaluate_all(m_, read_, {item.value.begin, item.value.end - 1});
  if (!values) return fail(values.error());
  const bool repeats = last.name == "REP";
  if (values->empty() || (repeats && values->size() != 1))
    return fail(alarm(AlarmId::not_available, item.where, std::string_view(last.name)));
  if (!repeats && first + values->size() > to.values.size())
    return fail(alarm(AlarmId::initial_values_too_many, item.where, std::string_view(item.name), double(values->size())));
  const std::size_t end = repeats ? to.values.size() : first + values->size();
  for (std::size_t i = first; i < end; ++i) {
    const Value& each = (*values)[repeats ? 0 : i - first];
    if (each.omitted) continue;
    const auto fits = converted(each, to.type, item.where);
    if (!fits) return fail(fits.error());
    own_.assign(variable, i, *fits);
  }
  return {};
}

Status BlockRun::assign_sign(const NamedItem& item, const std::shared_ptr<Variable>& to) {
  const auto at = own_.number(m_, read_, item.arguments[0], item.where);
  if (!at) return fail(at.error());
  const auto value = own_.evaluate(m_, read_, item.value);
  if (!value) return fail(value.error());
  const auto letter = converted(*value, Type::character, item.where);
  if (!letter) return fail(letter.error());
  std::string text = to->values[0].text;
  const double place = std::round(*at);
  if (!(place >= 0) || place >= static_cast<double>(text.size()))
    return fail(alarm(AlarmId::index_range, item.where, std::string_view(item.name), place));
  text[static_cast<std::size_t>(place)] = static_cast<char>(static_cast<int>(letter->number));
  own_.assign(to, 0, text_value(std::move(text)));
  return {};
}

Status BlockRun::parameter(const NamedItem& item) {
  double index = item.extension;
  if (item.arguments.size() == 1) {
    const auto read = own_.number(m_, read_, item.arguments[0], item.where);
    if (!read) return fail(read.error());
    index = std::round(*read);
  }
  if (!item.has_equals) return fail(alarm(AlarmId::expression_syntax, item.where, block_.text_of(item.where)));
  if (!(index >= 0) || index >= double{parameter_count}) return fail(alarm(AlarmId::index_range, item.where, "R", index));
  const auto value = own_.evaluate(m_, read_, item.value);
  if (!value) return fail(value.error());
  const auto fits = converted(*value, Type::real, item.where);
  if (!fits) return fail(fits.error());
  own_.assign_parameter(static_cast<std::size_t>(index), fits->number);
  return {};
}

Status BlockRun::store(const std::string& name, double value, const NamedItem& item) {
  BlockWords& words = own_.words;
  if (words.has(name)) return fail(alarm(AlarmId::address_twice, item.where, std::string_view(name)));
  words.numbers[name] = value;
  words.number_forms[name] = item.form;
  words.places[name] = item.where;
  return {};
}

Status BlockRun::long_word(const NamedItem& item) {
  const std::string& name = item.name;
  if (is_refused_name(name)) return fail(alarm(AlarmId::not_available, item.where, std::string_view(name)));
  if (name == "POS" || name == "POSA" || name == "FA") return positioning(item);
  if (name == "AX") return axis_by_variable(item);
  if (name == "OVR" || name == "FB" || name == "LIMS" || name == "FRC" || name == "FRCM") return feed_word(item);
  if (name == "OFFN") return normal_offset(item);
  if (name == "MEAS") return measure(item);
  if (name == "SPOS" || name == "SPOSA") {
    const auto value = number_of(item);
    if (!value) return fail(value.error());
    orient(*value);
    return {};
  }
  if (among(accepted_words, name)) {
    const auto value = own_.evaluate(m_, read_, item.value);
    if (!value) return fail(value.error());
    if (name == "CTOL") own_.memory.tolerance = std::max(0.0, value->number) * m_.unit_scale();
    return {};
  }
  constexpr std::string_view stored[] = {"CR", "AR",  "AP",   "RP",   "TURN", "CHR",  "CHF",   "RND", "RNDM",
                                         "FP", "ANG", "ANG1", "ANG2", "SF",   "DISR", "DISCL", "FAD"};
  if (!among(stored, name)) return fail(alarm(AlarmId::name_unknown, item.where, std::string_view(name)));
  if (!item.arguments.empty()) return unknown(item);
  const auto value = number_of(item);
  if (!value) return fail(value.error());
  if ((name == "RND" || name == "CHR" || name == "CHF" || name == "RNDM") && *value < 0)
    return fail(alarm(AlarmId::value_out_of_range, item.where, std::string_view(name), *value));
  return store(name, *value, item);
}

Status BlockRun::bracketed(const NamedItem& item, double value) {
  if (item.name == "G" && item.arguments.size() == 1) {
    const auto group = own_.number(m_, read_, item.arguments[0], item.where);
    if (!group) return fail(group.error());
    if (const auto code = code_at_place(*group, value)) return code_word(item, 'G', *code);
  }
  if ((item.name == "S" || item.name == "M") && item.arguments.size() == 1) {  // S[2]=500: the spindle by an expression
    const auto spindle = own_.number(m_, read_, item.arguments[0], item.where);
    if (!spindle) return fail(spindle.error());
    NamedItem numbered = item;
    numbered.extension = static_cast<std::int32_t>(std::lround(std::clamp(*spindle, 0.0, 99.0)));
    if (numbered.extension != 1) return spindle_word(numbered, value);
    return item.name == "M" ? m_word(numbered, value) : add('S', value, numbered);
  }
  return fail(alarm(AlarmId::not_available, item.where, std::string_view(item.name + "[ ]=")));
}

Status BlockRun::add(char letter, double value, const NamedItem& item) {
  if (block_.has(letter) && letter != 'M' && letter != 'G') return fail(alarm(AlarmId::address_twice, item.where, letter));
  if (block_.word_count >= limits::block_words) return fail(alarm(AlarmId::too_many_words, item.where, double{limits::block_words}));
  Word& w = block_.words[block_.word_count];
  w = Word{};
  w.value = value;
  w.where = item.where;
  w.address = w.written = letter;
  w.has_point = true;
  if (!block_.has(letter)) {
    block_.letters |= letter_bit(letter);
    block_.at[static_cast<std::size_t>(letter - 'A')] = static_cast<std::uint8_t>(block_.word_count);
  }
  if (letter >= 'A' && letter <= 'Z') own_.words.forms[static_cast<std::size_t>(letter - 'A')] = item.form;
  ++block_.word_count;
  return {};
}

Status BlockRun::add_code(char letter, double code, const NamedItem& item) {
  KADR_TRY(add(letter, code, item));
  block_.words[block_.word_count - 1].code = static_cast<std::int32_t>(std::lround(code * 10));
  return {};
}

Status BlockRun::tool(const NamedItem& item) {
  double number = item.number;
  if (item.has_equals) {
    const auto value = own_.evaluate(m_, read_, item.value);
    if (!value) return fail(value.error());
    if (value->type == Type::text) {
      std::uint32_t& known = own_.memory.tools[value->text];
      constexpr std::uint32_t first_name = 10'000;  // tools with names are numbered in the order of their first call
      if (known == 0) known = first_name + static_cast<std::uint32_t>(own_.memory.tools.size());
      number = known;
    } else {
      number = std::round(value->number);
    }
  }
  if (item.extension > 1)
    return fail(alarm(AlarmId::not_available, item.where, std::string_view("T" + std::to_string(item.extension) + "=")));
  if (!own_.knows_tool(m_, number)) return fail(alarm(AlarmId::tool_not_found, item.where, number));
  NamedItem plain = item;
  plain.form = WordForm::plain;
  return add('T', number, plain);
}

Status BlockRun::edge(const NamedItem& item, double value) const {
  if (!(value >= 0 && value <= 9) || value != std::round(value))
    return fail(alarm(AlarmId::edge_missing, item.where, double(m_.modal.tool), value));
  own_.words.edge = static_cast<std::uint32_t>(value);
  own_.words.edge_where = item.where;
  return {};
}

Status BlockRun::numbered_call(const NamedItem& item) {
  NamedItem named = item;
  named.kind = NamedItem::Kind::name;
  named.name = "L" + item.text;
  call_ = named;
  return {};
}

}  // namespace kadr::sinumerik
