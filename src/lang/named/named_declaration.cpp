// Reads DEF, PROC and EXTERN. Used by lang/named/named_parser; tested by tests/lang/named_test.cpp.

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

Status NamedDeclarations::definition() {
  block_.kind = NamedKind::definition;
  std::string type;
  for (;;) {
    skip();
    const std::size_t begin = at_;
    type = take_name();
    if (is_type(type)) break;
    if (type == "NCK" || type == "CHAN") return fail(alarm(AlarmId::not_available, span(begin, at_), std::string_view("DEF " + type)));
    if (type == "SYNR" || type == "SYNW" || type == "SYNRW") continue;
    at_ = begin;
    return syntax();
  }
  block_.types.push_back(type);
  skip();
  if (type == "STRING" && peek() == '[') KADR_TRY(indices(ignored_));
  for (;;) {
    skip();
    NamedDefinition row;
    const std::size_t begin = at_;
    row.name = take_name();
    if (row.name.empty()) return syntax();
    row.where = span(begin, at_);
    skip();
    if (peek() == '[') KADR_TRY(indices(row.sizes));
    skip();
    if (peek() == '=') KADR_TRY(initial_values(row));
    block_.definitions.push_back(std::move(row));
    skip();
    if (at_end()) return {};
    if (peek() != ',') return syntax();
    ++at_;
  }
}

Status NamedDeclarations::initial_values(NamedDefinition& row) {
  ++at_;
  skip();
  const std::size_t set = at_;
  if (!row.sizes.empty() && name_here() == "SET") at_ += 3;
  skip();
  if (!row.sizes.empty() && peek() == '(') return arguments(row.initial);
  at_ = set;
  NamedExpression value;
  KADR_TRY(expression(value));
  row.initial.push_back(value);
  return {};
}

}  // namespace kadr
