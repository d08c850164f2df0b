// OLineRewriter: rewrites macro statements as O lines. Used by convert/block_rewriter; tested by tests/convert.

#include "convert/o_line_rewriter.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace kadr {
namespace {

Status no_line(std::string_view what) { return fail(alarm(AlarmId::function_has_no_code, {}, what)); }

/// Returns the first expression in square brackets in a text, and stores in `end` the position after the expression.
std::string_view first_bracket(std::string_view text, std::size_t& end) {
  const std::size_t begin = text.find('[');
  if (begin == std::string_view::npos) {
    end = text.size();
    return {};
  }
  int depth = 0;
  for (std::size_t i = begin; i < text.size(); ++i) {
    depth += text[i] == '[' ? 1 : text[i] == ']' ? -1 : 0;
    if (depth == 0) {
      end = i + 1;
      return text.substr(begin, i + 1 - begin);
    }
  }
  end = text.size();
  return {};
}

/// True if the text compares with the vacant variable #0, which is not expressible because its value is not a number on the target control.
bool asks_for_vacant(std::string_view text) {
  for (std::size_t at = text.find("#0"); at != std::string_view::npos; at = text.find("#0", at + 1))
    if (at + 2 >= text.size() || std::isdigit(static_cast<unsigned char>(text[at + 2])) == 0) return true;
  return false;
}

}  // namespace

Status OLineRewriter::line(std::string text, BlockMaker& out) const {
  out.set_number(0);
  out.text(text);
  return out.end();
}

Status OLineRewriter::number(std::uint32_t number, BlockMaker& out) {
  while (!skips_.empty() && skips_.back().to == number) {
    KADR_TRY(line(fmt::format("o{} endif", skips_.back().label), out));
    skips_.pop_back();
  }
  if (shape_.jumped_back.count(number) == 0) return {};
  const std::uint32_t label = backs_[number] = next_label();
  return line(fmt::format("o{} do", label), out);
}

Status OLineRewriter::write(const Block& block, const std::function<Status()>& words, BlockMaker& out) {
  const Statement& s = block.statement;
  std::string_view text = block.text_of(block.where);
  if (asks_for_vacant(text) || s.condition_count > 1) return no_line("#0");
  std::size_t end = 0;
  const auto condition = flow_.expression(s.condition_count != 0 ? first_bracket(text, end) : std::string_view());
  if (!condition) return fail(condition.error());
  switch (s.kind) {
    case StatementKind::loop:
      loops_.push_back(next_label());
      return line(fmt::format("o{} while {}", loops_.back(), s.condition_count != 0 ? *condition : "[1]"), out);
    case StatementKind::loop_end: {
      if (loops_.empty()) return no_line("END");
      const std::uint32_t label = loops_.back();
      loops_.pop_back();
      return line(fmt::format("o{} endwhile", label), out);
    }
    case StatementKind::go_to: {
      const std::size_t digits = text.find_last_not_of("0123456789 ");
      const std::string_view target = text.substr(digits + 1);
      if (target.find_first_of("0123456789") == std::string_view::npos || target.size() > 8) return no_line("GOTO");
      const auto to = static_cast<std::uint32_t>(std::stoul(std::string(target)));
      if (const auto back = backs_.find(to); back != backs_.end()) {
        const std::uint32_t label = back->second;
        backs_.erase(back);
        return line(fmt::format("o{} while {}", label, s.condition_count != 0 ? *condition : "[1]"), out);
      }
      if (shape_.leaves.count(block.position.line) != 0 && !loops_.empty()) {
        const std::uint32_t label = next_label();
        KADR_TRY(line(fmt::format("o{} if {}", label, s.condition_count != 0 ? *condition : "[1]"), out));
        KADR_TRY(line(fmt::format("o{} break", loops_.back()), out));
        return line(fmt::format("o{} endif", label), out);
      }
      skips_.push_back({to, next_label()});
      return line(fmt::format("o{} if {}", skips_.back().label, s.condition_count != 0 ? "[" + *condition + " EQ 0]" : "[0]"), out);
    }
    case StatementKind::words:
    case StatementKind::assign: {
      if (!s.with_if) return no_line(text);
      const std::uint32_t label = next_label();
      KADR_TRY(line(fmt::format("o{} if {}", label, *condition), out));
      KADR_TRY(words());
      KADR_TRY(out.end());
      return line(fmt::format("o{} endif", label), out);
    }
    default: return no_line(text.substr(0, 20));
  }
}

Status OLineRewriter::call(const Block& block, const std::function<Status(const Word&, std::string&)>& value, BlockMaker& out) {
  const Word* const p = block.find('P');
  if (p == nullptr || p->expression || block.has('L')) return no_line("G65");
  std::vector<std::string> arguments;
  for (std::uint32_t i = 0; i < block.word_count; ++i) {
    const Word& word = block.words[i];
    if (word.code >= 0 || word.address == 'P') continue;
    const std::size_t index = argument_letters.find(word.address);
    if (index == std::string_view::npos || word.address > 'Z') return no_line("G65");
    if (arguments.size() <= index) arguments.resize(index + 1, "0");
    KADR_TRY(value(word, arguments[index]));
  }
  std::string text = fmt::format("o{:.0f} call", p->value);
  for (const std::string& argument : arguments) text += " [" + argument + "]";
  return line(std::move(text), out);
}

Status OLineRewriter::begin(std::uint32_t label, BlockMaker& out) {
  macro_ = label;
  return line(fmt::format("o{} sub", label), out);
}

Status OLineRewriter::end(std::uint32_t at, BlockMaker& out) {
  const std::uint32_t label = macro_;
  if (const auto found = shape_.macros.find(label); found != shape_.macros.end() && found->second != at)
    return line(fmt::format("o{} return", label), out);
  macro_ = 0;
  return line(fmt::format("o{} endsub", label), out);
}

}  // namespace kadr
