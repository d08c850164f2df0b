// The members of BlockRewriter for assignments and macro statements. Tested by tests/convert.

#include <fmt/format.h>

#include <algorithm>

#include "convert/block_rewriter.h"

namespace kadr {

/// Writes an assignment. RS274/NGC needs brackets around a value with operators; controls with macros do not.
std::string BlockRewriter::assignment(std::string_view text) const {
  const std::size_t equals = text.find('=');
  if (!from_.grammar.sums_without_brackets() || to_.grammar.sums_without_brackets() || equals == std::string_view::npos)
    return std::string(text);
  std::string_view value = text.substr(equals + 1);
  while (!value.empty() && value.front() == ' ') value.remove_prefix(1);
  const bool has_operators = value.find_first_of("+-*/ABCDEFGHIJKLMNOPQRSTUVWXYZ", 1) != std::string_view::npos;
  return has_operators ? fmt::format("{}[{}]", text.substr(0, equals + 1), value) : std::string(text);
}

/// Writes an expression or an assignment. Each named variable becomes a numbered one if the target control has no named variables.
Status BlockRewriter::slice(std::string_view text, BlockMaker& out) {
  const auto made = flow_.expression(text);
  if (!made) return fail(made.error());
  out.text(*made);
  return {};
}

/// Writes a macro statement unchanged, because all controls with macro statements write them in the same form (spec/fanuc 5, spec/haas 2,
/// nct 23).
Status BlockRewriter::statement(const Block& block, BlockMaker& out) {
  if (block.statement.kind == StatementKind::o_word && from_.grammar.o_words && !to_.grammar.o_words &&
      (to_.grammar.has_statements() || to_.grammar.label_address != 0 || flow_.has_sections()))
    return flow_.write(block, out);
  const bool is_assignment = block.statement.kind == StatementKind::assign && !block.statement.with_if;
  const bool both = from_.grammar.has_statements() && to_.grammar.has_statements() && block.statement.kind != StatementKind::o_word &&
                    block.statement.kind != StatementKind::system;
  if (!both && !(is_assignment && to_.grammar.expressions)) return cannot(block.text_of(block.statement.where));
  std::size_t begin = block.has_number ? block.number_where.end : block.where.begin;
  std::string_view text = block.text.substr(begin, block.where.end - begin);
  if (block.skip != 0 && !block.has_number) text.remove_prefix(std::min(text.size(), text.find_first_not_of("/0123456789 ")));
  if (block.statement.kind != StatementKind::message)
    if (const std::size_t comment = text.find_first_of("(;"); comment != std::string_view::npos) text = text.substr(0, comment);
  while (!text.empty() && (text.back() == ' ' || text.back() == '\r')) text.remove_suffix(1);
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  return slice(is_assignment ? assignment(text) : std::string(text), out);
}

}  // namespace kadr
