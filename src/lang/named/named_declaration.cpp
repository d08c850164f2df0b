// Reads DEF, DEFINE, PROC and EXTERN. Used by lang/named/named_parser; tested by tests/lang/named_test.cpp.

#include "lang/named/named_declaration.h"

#include <algorithm>
#include <utility>

namespace kadr {
namespace {

constexpr std::string_view types[] = {"INT", "REAL", "BOOL", "CHAR", "STRING", "AXIS", "FRAME"};

bool is_type(std::string_view name) { return std::find(std::begin(types), std::end(types), name) != std::end(types); }

}  // namespace

Status NamedDeclarations::declaration(const std::string& keyword) {
  at_ += keyword.size();
  if (keyword == "DEFINE") return macro();
  if (keyword == "DEF") return definition();
  block_.kind = keyword == "PROC" ? NamedKind::procedure : NamedKind::external;
  skip();
  block_.name = take_name();
  if (block_.name.empty()) return syntax();
  skip();
  if (peek() == '(') KADR_TRY(parameters(keyword == "PROC"));
  for (skip(); !at_end(); skip()) {
    const std::string attribute = take_name();
    if (attribute.empty()) return syntax();
    block_.attributes.push_back(attribute);
    skip();
    if (peek() == '=' || peek() == '(') return syntax();
  }
  return {};
}

Status NamedDeclarations::parameters(bool named) {
  const std::size_t open = at_++;
  for (skip(); peek() != ')'; skip()) {
    if (at_end()) return not_closed(open);
    if (peek() == ',') {
      ++at_;
      continue;
    }
    NamedDefinition parameter;
    std::string word = take_name();
    if (word == "VAR") {
      parameter.by_reference = true;
      skip();
      word = take_name();
    }
    if (!is_type(word)) return syntax();
    skip();
    if (word == "STRING" && peek() == '[') KADR_TRY(indices(ignored_));
    skip();
    if (named) {
      parameter.where = span(at_, at_ + 1);
      parameter.name = take_name();
      if (parameter.name.empty()) return syntax();
      parameter.where.end = static_cast<std::uint32_t>(at_);
    }
    skip();
    if (peek() == '[') KADR_TRY(open_indices(parameter.sizes));
    skip();
    if (peek() == '=') {
      ++at_;
      NamedExpression initial;
      KADR_TRY(expression(initial));
      parameter.initial.push_back(initial);
    }
    block_.types.push_back(word);
    block_.definitions.push_back(std::move(parameter));
  }
  ++at_;
  return {};
}

Status NamedDeclarations::open_indices(std::vector<NamedExpression>& to) {
  const std::size_t begin = at_;
  std::size_t look = at_ + 1;
  while (look < text_.size() && (text_[look] == ' ' || text_[look] == ',')) ++look;
  if (look < text_.size() && text_[look] == ']') {
    at_ = look + 1;
    NamedExpression any;
    any.begin = static_cast<std::uint32_t>(block_.code.size());
    KADR_TRY(push({NamedStep::Kind::integer, NamedOp::add, 0, -1, {}, span(begin, at_)}));
    any.end = static_cast<std::uint32_t>(block_.code.size());
    to.push_back(any);
    return {};
  }
  return indices(to);
}

/// Reads DEFINE NAME AS text. The text goes to the end of the block; a comment is no part of it.
Status NamedDeclarations::macro() {
  block_.kind = NamedKind::macro;
  skip();
  block_.name = take_name();
  if (block_.name.empty()) return syntax();
  skip();
  if (take_name() != "AS") return syntax();
  skip();
  block_.text = std::string(text_.substr(at_));
  at_ = text_.size();
  return {};
}

/// Passes over what a definition says about access, limits and units (spec/sinumerik 6.1): APR 3, PHU 24, LLI 0, ULI 10, SYNR, INIRE.
/// Returns false if the name at the place of reading is none of these.
Result<bool> NamedDeclarations::modifier() {
  constexpr std::string_view alone[] = {"SYNR", "SYNW", "SYNRW", "INIPO", "INIRE", "INICF", "PRLOC", "DCM", "DCI", "DCU"};
  constexpr std::string_view with_value[] = {"PHU", "LLI", "ULI", "APR", "APW", "APRP", "APWP", "APRB", "APWB"};
  const std::string name = name_here();
  if (name == "NCK" || name == "CHAN") block_.global = true;
  const bool is_alone = name == "NCK" || name == "CHAN" || std::find(std::begin(alone), std::end(alone), name) != std::end(alone);
  const bool has_value = std::find(std::begin(with_value), std::end(with_value), name) != std::end(with_value);
  if (!is_alone && !has_value) return false;
  at_ += name.size();
  if (!has_value) return true;
  NamedExpression value;
  skip();
  KADR_TRY(expression(value));
  return true;
}

Status NamedDeclarations::modifiers() {
  for (;;) {
    skip();
    const auto more = modifier();
    if (!more) return fail(more.error());
    if (!*more) return {};
  }
}

Status NamedDeclarations::definition() {
  block_.kind = NamedKind::definition;
  KADR_TRY(modifiers());
  const std::string type = name_here();
  if (!is_type(type)) return syntax();
  at_ += type.size();
  block_.types.push_back(type);
  skip();
  if (type == "STRING" && peek() == '[') KADR_TRY(indices(ignored_));
  for (;;) {
    KADR_TRY(modifiers());
    NamedDefinition row;
    const std::size_t begin = at_;
    row.name = take_name();
    if (row.name.empty()) return syntax();
    row.where = span(begin, at_);
    skip();
    if (peek() == '[') KADR_TRY(indices(row.sizes));
    KADR_TRY(modifiers());
    if (peek() == '=') KADR_TRY(initial_values(row));
    KADR_TRY(modifiers());
    block_.definitions.push_back(std::move(row));
    if (at_end()) return {};
    if (peek() != ',') return syntax();
    ++at_;
  }
}

Status NamedDeclarations::initial_values(NamedDefinition& row) {
  ++at_;
  skip();
  const std::size_t set = at_;
  const std::string function = name_here();
  const bool is_array = !row.sizes.empty();
  if (is_array && (function == "SET" || function == "REP")) at_ += function.size();
  skip();
  if (is_array && peek() == '(') {
    const std::size_t open = at_;
    KADR_TRY(arguments(row.initial));
    row.repeats = function == "REP";
    if (!row.repeats) return {};
    if (row.initial.empty() || row.initial.size() > 2) return fail(alarm(AlarmId::expression_syntax, span(open, at_), "REP"));
    if (row.initial.size() == 2) row.repeated = row.initial[1];
    row.initial.resize(1);
    return {};
  }
  at_ = set;
  NamedExpression value;
  KADR_TRY(expression(value));
  row.initial.push_back(value);
  return {};
}

}  // namespace kadr
