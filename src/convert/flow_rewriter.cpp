// FlowRewriter: rewrites O lines as macro statements. Used by convert/block_rewriter; tested by tests/convert.

#include "convert/flow_rewriter.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>

#include "out/program/codes.h"

namespace kadr {
namespace {

constexpr int max_nested = 3;                // greatest nesting depth of loops: DO1 to DO3
constexpr std::uint32_t first_named = 8000;  // label of the first named subprogram
// Variable numbers of macros: local #1 to #33, global #100 to #199 (spec/fanuc 5.1).
constexpr std::uint32_t last_local = 33, first_global = 100, last_global = 199;

Status no_code(std::string_view what) { return fail(alarm(AlarmId::function_has_no_code, {}, what)); }

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
  while (!text.empty() && (text.back() == ' ' || text.back() == '\t' || text.back() == '\r')) text.remove_suffix(1);
  return text;
}

/// Returns the rest of an O line: the text after its keyword, such as `if` or `call`.
std::string_view after_keyword(const Block& block) {
  std::string_view rest = block.text.substr(block.statement.label_where.end, block.where.end - block.statement.label_where.end);
  rest = rest.substr(0, rest.find_first_of("(;"));
  rest = trimmed(rest);
  if (!rest.empty() && rest.front() == '>') rest = trimmed(rest.substr(1));
  while (!rest.empty() && std::isalpha(static_cast<unsigned char>(rest.front())) != 0) rest.remove_prefix(1);
  return trimmed(rest);
}

/// Returns the label of an O word: "12" for o12, "<name>" for O< Name >. Upper and lower case are equal, and blanks are ignored.
std::string label_of(std::string_view word) {
  std::string label;
  for (const char c : word.substr(std::min<std::size_t>(1, word.size())))
    if (c != ' ' && c != '\t') label += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return label;
}

/// Returns the position after the bracket expression at the start of the text.
std::size_t end_of_bracket(std::string_view text) {
  int depth = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    depth += text[i] == '[' ? 1 : text[i] == ']' ? -1 : 0;
    if (depth == 0) return i + 1;
  }
  return text.size();
}

}  // namespace

bool FlowRewriter::begins_subprogram(const Block& block) {
  return block.statement.kind == StatementKind::o_word && block.statement.o_word == OWord::sub;
}
bool FlowRewriter::ends_subprogram(const Block& block) {
  return block.statement.kind == StatementKind::o_word && block.statement.o_word == OWord::endsub;
}

Status FlowRewriter::write(const Block& block, BlockMaker& out) {
  const Statement& s = block.statement;
  const std::string_view label = block.text_of(s.label_where), rest = after_keyword(block);
  const bool has_macros = to_.grammar.has_statements();
  switch (s.o_word) {
    case OWord::label:
      if (has_sections()) return no_code("O");
      return line(out.program_label(number_of(label)), out);
    case OWord::sub:
      scope_ = label;
      if (has_sections()) return begin_section(label_of(label), out);
      return line(out.program_label(number_of(label)), out);
    case OWord::endsub:
    case OWord::return_: {
      if (s.o_word == OWord::endsub) scope_.clear(), open_.clear();
      if (!rest.empty()) return no_code("return [ ]");
      return out.code({{Function::return_program, any_argument},
                       {Function::subprogram_return, any_argument},
                       {Function::subprogram_end, any_argument}});
    }
    case OWord::call: return call(label, rest, out);
    default: break;
  }
  if (!has_macros) return no_code("WHILE");
  switch (s.o_word) {
    case OWord::do_:
    case OWord::while_:
      if (s.o_word == OWord::while_ && !open_.empty() && open_.back().word == OWord::do_) return end_loop(rest, out);
      [[fallthrough]];
    case OWord::repeat:
    case OWord::if_: return begin_loop({s.o_word}, rest, out);
    case OWord::elseif:
    case OWord::else_: return branch(s.o_word, rest, out);
    case OWord::endwhile:
    case OWord::endrepeat:
    case OWord::endif: return end_loop({}, out);
    case OWord::break_: return leave(false, out);
    case OWord::continue_: return leave(true, out);
    default: return no_code("O");
  }
}

Status FlowRewriter::line(const std::string& text, BlockMaker& out) const {
  out.text(text);
  return out.end();
}
Status FlowRewriter::label_line(std::uint32_t label, BlockMaker& out) const {
  return label == 0 ? Status() : line(fmt::format("N{}", label), out);
}

Status FlowRewriter::begin_loop(Open open, std::string_view condition, BlockMaker& out) {
  const auto nested = [this] {
    return 1 + static_cast<int>(std::count_if(open_.begin(), open_.end(), [](const Open& one) { return one.loop != 0; }));
  };
  if (open.word == OWord::if_) {
    const auto otherwise = not_that(condition);
    if (!otherwise) return fail(otherwise.error());
    open.next = ++next_label_;
    open_.push_back(open);
    return line(fmt::format("IF {} GOTO {}", *otherwise, open.next), out);
  }
  if (open.word == OWord::do_) {
    open.next = ++next_label_;
    open_.push_back(open);
    return label_line(open.next, out);
  }
  open.loop = nested();
  if (open.loop > max_nested) return no_code("DO4");
  auto text = expression(condition);
  if (!text) return fail(text.error());
  if (open.word == OWord::repeat) {
    open.variable = free_variable(last_local, 1, -1);
    if (open.variable == 0) return no_code("#33");
    KADR_TRY(line(fmt::format("#{}={}", open.variable, *text), out));
    *text = fmt::format("[#{} GT 0]", open.variable);
  }
  open_.push_back(open);
  return line(fmt::format("WHILE {} DO{}", *text, open.loop), out);
}

Status FlowRewriter::branch(OWord word, std::string_view condition, BlockMaker& out) {
  if (open_.empty() || open_.back().word != OWord::if_) return no_code("ELSE");
  Open& open = open_.back();
  if (open.over == 0) open.over = ++next_label_;
  KADR_TRY(line(fmt::format("GOTO {}", open.over), out));
  KADR_TRY(label_line(open.next, out));
  open.next = 0;
  if (word == OWord::else_) return {};
  const auto otherwise = not_that(condition);
  if (!otherwise) return fail(otherwise.error());
  open.next = ++next_label_;
  return line(fmt::format("IF {} GOTO {}", *otherwise, open.next), out);
}

Status FlowRewriter::end_loop(std::string_view condition, BlockMaker& out) {
  if (open_.empty()) return no_code("END");
  const Open open = open_.back();
  open_.pop_back();
  if (open.word == OWord::do_) {
    const auto text = expression(condition);
    if (!text) return fail(text.error());
    KADR_TRY(line(fmt::format("IF {} GOTO {}", *text, open.next), out));
    return label_line(open.over, out);
  }
  if (open.word != OWord::if_) {
    KADR_TRY(label_line(open.next, out));
    if (open.variable != 0) {
      KADR_TRY(line(fmt::format("#{0}=#{0}-1", open.variable), out));
      used_.erase(open.variable);
    }
    KADR_TRY(line(fmt::format("END{}", open.loop), out));
    return label_line(open.over, out);
  }
  KADR_TRY(label_line(open.next, out));
  return label_line(open.over, out);
}

Status FlowRewriter::leave(bool goes_on, BlockMaker& out) {
  for (auto open = open_.rbegin(); open != open_.rend(); ++open) {
    if (open->word == OWord::if_) continue;
    if (open->word == OWord::do_ && goes_on) return no_code("continue");
    std::uint32_t& label = goes_on ? open->next : open->over;
    if (label == 0) label = ++next_label_;
    return line(fmt::format("GOTO {}", label), out);
  }
  return no_code(goes_on ? "continue" : "break");
}

Status FlowRewriter::call(std::string_view label, std::string_view arguments, BlockMaker& out) {
  if (arguments.empty() && has_sections()) return call_in_section(label_of(label), 1, out);
  if (arguments.empty() && !to_.grammar.has_statements()) {
    KADR_TRY(out.code({{Function::call_subprogram, any_argument}, {Function::call_program, any_argument}}));
    out.text(fmt::format("P{}", number_of(label)));
    return {};
  }
  KADR_TRY(out.code({{Function::macro_call, 0}}));
  out.text(fmt::format("P{}", number_of(label)));
  for (std::size_t i = 0; !arguments.empty(); ++i) {
    const std::size_t end = end_of_bracket(arguments);
    const auto text = expression(arguments.substr(0, end));
    if (!text) return fail(text.error());
    if (i >= argument_letters.size() || argument_letters[i] == '\0') return no_code("call");
    out.text(argument_letters[i] + *text);
    arguments = trimmed(arguments.substr(end));
  }
  return {};
}

Status FlowRewriter::begin_section(const std::string& label, BlockMaker& out) {
  const auto number = sections_.of(label);
  if (!number) return no_code("L");
  out.begin_section(*number);
  return {};
}

/// Writes the call of a subprogram in the section. The block's other words are written first, so that they take effect before the call
/// (spec/s2c42 3).
Status FlowRewriter::call_in_section(const std::string& label, std::uint32_t times, BlockMaker& out) {
  const auto call = sections_.call(label, times);
  if (!call) return no_code("L");
  out.text(*call);
  return out.end();
}

Status FlowRewriter::call_in_section(const Block& block, BlockMaker& out) {
  constexpr double max_label = 9999;  // greatest label; a greater number in P consists of repetitions and label (spec/fanuc 9.1)
  std::optional<std::uint32_t> label;
  std::uint32_t times = 1;
  for (std::uint32_t i = 0; i < block.word_count; ++i) {
    const Word& one = block.words[i];
    const bool is_count = one.code < 0 && !one.expression && one.value >= 0 && one.value <= max_label;
    if (is_count && one.address == 'P') label = static_cast<std::uint32_t>(one.value);
    else if (is_count && one.address == 'L') times = static_cast<std::uint32_t>(one.value);
    else if (one.address != 'M' && one.address != 'N') return no_code(block.text_of(block.where));
  }
  if (!label || block.word_count > 3 + (block.has('N') ? 1U : 0U)) return no_code(block.text_of(block.where));
  return call_in_section(std::to_string(*label), times, out);
}

/// Returns the negation of a condition. For a comparison it is the opposite comparison; for any other expression it is the condition that
/// the expression equals 0.
Result<std::string> FlowRewriter::not_that(std::string_view condition) {
  auto text = expression(condition);
  if (!text) return text;
  constexpr std::array<std::array<std::string_view, 2>, 6> opposite = {
      {{"EQ", "NE"}, {"NE", "EQ"}, {"GT", "LE"}, {"LE", "GT"}, {"LT", "GE"}, {"GE", "LT"}}};
  int depth = 0;
  std::size_t found = std::string::npos;
  const std::array<std::string_view, 2>* by = nullptr;
  for (std::size_t i = 0; i + 1 < text->size(); ++i) {
    depth += (*text)[i] == '[' ? 1 : (*text)[i] == ']' ? -1 : 0;
    if (depth != 1) continue;
    const std::string_view two = std::string_view(*text).substr(i, 2);
    if (two == "AN" || two == "OR" || two == "XO") {
      text->insert(0, "[");
      return *text += " EQ 0]";
    }
    for (const auto& one : opposite)
      if (two == one[0]) found = i, by = &one;
  }
  if (by == nullptr) {
    text->insert(0, "[");
    return *text += " EQ 0]";
  }
  return text->replace(found, 2, (*by)[1]);
}

std::uint32_t FlowRewriter::number_of(std::string_view word) {
  const std::string label = label_of(word);
  if (std::all_of(label.begin(), label.end(), [](unsigned char c) { return std::isdigit(c) != 0; }) && !label.empty() && label.size() < 6)
    return static_cast<std::uint32_t>(std::stoul(label));
  return labels_.emplace(label, first_named + static_cast<std::uint32_t>(labels_.size())).first->second;
}

std::uint32_t FlowRewriter::free_variable(std::uint32_t from, std::uint32_t to, int step) {
  for (std::uint32_t n = from; n != to; n = static_cast<std::uint32_t>(static_cast<int>(n) + step))
    if (used_.insert(n).second) return n;
  return 0;
}

Result<std::uint32_t> FlowRewriter::variable_of(std::string_view name) {
  const bool is_global = !name.empty() && name.front() == '_';
  const std::string key = (is_global ? std::string() : scope_) + "<" + std::string(name);
  if (const auto found = variables_.find(key); found != variables_.end()) return found->second;
  const std::uint32_t number = is_global ? free_variable(first_global, last_global, 1) : free_variable(last_local, 1, -1);
  if (number == 0) return fail(alarm(AlarmId::function_has_no_code, {}, name));
  return variables_[key] = number;
}

Result<std::string> FlowRewriter::expression(std::string_view text) {
  const bool has_names = to_.grammar.named_variables != nullptr, raises = from_.grammar.o_words && !to_.grammar.o_words;
  std::string made;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool is_variable = !made.empty() && made.back() == '#';
    if (is_variable && text[i] == '<' && !has_names) {
      const std::size_t end = std::min(text.find('>', i), text.size());
      std::string name;
      for (const char c : text.substr(i + 1, end - i - 1))
        if (c != ' ') name += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
      const auto number = variable_of(name);
      if (!number) return fail(number.error());
      made += std::to_string(*number);
      i = end;
    } else if (is_variable && std::isdigit(static_cast<unsigned char>(text[i])) != 0) {
      const std::size_t end = std::min(text.find_first_not_of("0123456789", i), text.size());
      constexpr std::size_t max_digits = 8;
      const std::string digits(text.substr(i, end - i));
      const auto number = digits.size() > max_digits ? std::nullopt : numbers_.of(static_cast<std::uint32_t>(std::stoul(digits)));
      if (!number) return fail(alarm(AlarmId::function_has_no_code, {}, "#" + digits));
      made += std::to_string(*number);
      i = end - 1;
    } else if (text.substr(i, 2) == "**" && !to_.grammar.expression.operators.has("**")) {
      return fail(alarm(AlarmId::function_has_no_code, {}, "**"));
    } else {
      made += raises ? static_cast<char>(std::toupper(static_cast<unsigned char>(text[i]))) : text[i];
    }
  }
  return made;
}

}  // namespace kadr
