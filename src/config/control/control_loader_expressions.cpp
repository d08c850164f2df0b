// Reads the section [expressions] of a control file: operators, functions and relations as rows (docs/own-control.md). Used by
// control_loader_words; tested by tests/config/expression_rows_test.cpp.

#include <algorithm>

#include "base/ascii.h"
#include "config/control/control_loader.h"
#include "texts/control_file.h"
#include "texts/control_file_grammar.h"

namespace kadr {

using toml_tools::place;

namespace {

// Characters that an operator may consist of. No operand begins with one of these characters, and none of them closes a bracket or ends a
// block.
constexpr std::string_view signs = "*/+-^<>=!&|~";
constexpr std::size_t longest_text = 16;
constexpr std::uint32_t most_binding = 9;

bool is_of_letters(std::string_view text) {
  return std::all_of(text.begin(), text.end(), [](char c) { return c >= 'A' && c <= 'Z'; });
}

/// Returns true if the text can be the name of an operator: it consists of letters or, if `only_letters` is false, of characters of
/// `signs`.
bool can_be_written(std::string_view text, bool only_letters) {
  if (text.empty() || text.size() > longest_text) return false;
  return is_of_letters(text) || (!only_letters && text.find_first_not_of(signs) == std::string_view::npos);
}

std::vector<std::string_view> operations(int operands) {
  std::vector<std::string_view> names;
  for (std::string_view name = operation_name(0, operands); !name.empty(); name = operation_name(names.size(), operands))
    names.push_back(name);
  return names;
}

}  // namespace

Done ControlLoader::expressions() {
  const toml::table* const t = section("expressions");
  if (t == nullptr) return {};
  KADR_LOAD(known_keys(*t, {"operators", "functions", "relations"}));
  if (!def_.grammar.expressions) KADR_LOAD(no_effect(file_, "expressions", translated(texts::control_file_grammar::without_expressions)));
  KADR_LOAD(expression_rows(*t, "operators", def_.grammar.expression.operators));
  KADR_LOAD(expression_rows(*t, "functions", def_.grammar.expression.functions));
  return expression_rows(*t, "relations", def_.grammar.expression.relations);
}

Done ControlLoader::expression_rows(const toml::table& of, std::string_view key, ExpressionRows& to) {
  const toml::node* const node = of.get(key);
  if (node == nullptr) return {};
  if (!node->is_table()) return Failed(place(name_, *node) + translated(texts::control_file::must_be_table, key));
  for (const auto& [text, row] : *node->as_table()) {
    if (!row.is_table()) return Failed(place(name_, row) + translated(texts::control_file::must_be_table, text.str()));
    auto read = expression_row(key, text.str(), row);
    if (!read) return Failed(read.error());
    if (to.has(read->text)) return Failed(place(name_, row) + translated(texts::control_file_grammar::stands_twice, text.str()));
    if (to.all().size() == ExpressionRows::most)
      return Failed(place(name_, row) + translated(texts::control_file_grammar::too_many_rows, key, ExpressionRows::most));
    to.add(std::move(*read));
  }
  return {};
}

tl::expected<ExpressionRow, std::string> ControlLoader::expression_row(std::string_view key, std::string_view written,
                                                                       const toml::node& node) {
  const toml::table& row = *node.as_table();
  const bool function = key == "functions", op = key == "operators";
  ExpressionRow read;
  for (const char c : written) read.text += to_upper(c);
  if (!can_be_written(read.text, function))
    return Failed(place(name_, node) + translated(texts::control_file_grammar::operation_letters, written, signs));
  KADR_LOAD(known_keys(row, op         ? std::vector<std::string_view>{"does", "binding"}
                            : function ? std::vector<std::string_view>{"does", "operand", "of_two"}
                                       : std::vector<std::string_view>{"does"}));
  const std::string operand = function && row.contains("operand") ? text(row, "operand") : "bracket";
  if (operand != "bracket" && operand != "value" && operand != "pair")
    return Failed(place(name_, row, "operand") + translated(texts::control_file_grammar::operand_values));
  read.operand = operand == "value" ? Operand::value : operand == "pair" ? Operand::pair : Operand::bracket;
  const int operands = !function || read.operand == Operand::pair ? 2 : 1;
  const std::string does = text(row, "does");
  const auto found = operation_named(does, operands);
  if (!found || (key == "relations" && !is_comparison(*found))) {
    return Failed(place(name_, row, "does") + translated(texts::control_file_grammar::unknown_operation, does) +
                  nearest_hint(toml_tools::nearest(does, operations(operands))));
  }
  read.op = *found;
  if (const std::string of_two = text(row, "of_two"); !of_two.empty()) {
    const auto pair = operation_named(of_two, 2);
    if (!pair || read.operand != Operand::value)
      return Failed(place(name_, row, "of_two") + translated(texts::control_file_grammar::unknown_operation, of_two));
    read.of_two = *pair;
  }
  read.binding = static_cast<std::uint8_t>(whole(row, "binding", 1, most_binding));
  return read;
}

}  // namespace kadr
