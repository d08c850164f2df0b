// Explains the words of a program line. This file is used by view/page/page_check and tested by tests/out/line_words_test.cpp.

#include "out/text/explain/line_words.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>

#include "lang/block/lexer.h"
#include "out/text/explain/code_page.h"
#include "out/text/explain/name_text.h"
#include "out/text/explain/variable_text.h"
#include "out/text/explain/word_text.h"
#include "out/text/in_language.h"
#include "out/text/source_line.h"
#include "texts/explain_words.h"

namespace kadr {
namespace {

// greatest number of blocks that are read from one line; on some controls the word ПС ends a block within the line
constexpr std::size_t max_blocks = 100;
constexpr std::size_t max_words = 500;

class LineWords {
 public:
  LineWords(const ControlDef& def, const AlarmTexts& texts, std::string_view line, Lang lang)
      : def_(def), texts_(texts), line_(line), lang_(lang) {}

  std::vector<LineWord> all() {
    std::size_t from = 0;
    for (std::size_t n = 0; n < max_blocks && from < line_.size(); ++n) {
      Block block;
      const auto lexed = lex_block(line_, from, true, def_.grammar, block);
      take(block, std::max(from, std::size_t{block.where.begin}));
      if (!lexed || lexed->next <= from) break;
      from = lexed->next;
    }
    std::stable_sort(words_.begin(), words_.end(), [](const LineWord& a, const LineWord& b) { return a.from < b.from; });
    return std::move(words_);
  }

 private:
  void take(const Block& block, std::size_t begin) {
    block_ = &block;
    if (block.has_number)
      add(block.number_where, std::string(block.main_block ? ":" : "N"), plain_text(texts::explain_words::block_number, lang_), {});
    for (std::uint32_t i = 0; i < block.word_count; ++i) take(block.words[i]);
    if (block.statement.kind == StatementKind::named)
      each_part(def_, line_, block.statement.text, [this](const StatementPart& part) { take(part); });
    take_variables(begin, block.where.end > begin ? block.where.end : line_.size());
  }

  void take(const Word& word) {
    const char letter = word.address != 0 ? word.address : word.written;
    if (letter == 0) return;
    const std::int32_t row = word.code >= 0 ? def_.row_of(letter, word.code) : -1;
    if (row >= 0) {
      const CodeRow& code = def_.codes[std::size_t(row)];
      return add(word.where, code.code, in_language(code.text, lang_), explained(code.code));
    }
    if (const CycleRow* const cycle = cycle_of(letter, word))
      return add(word.where, cycle->name, in_language(cycle->text, lang_), explained(cycle->name));
    const AddressRow& address = def_.address(letter);
    const CodeRow* const of = code_with(letter);
    if (of == nullptr && address.function == Function::count) return;
    const std::string title =
        of != nullptr ? fmt::format("{}: {}", of->code, meaning_of(def_, *of, letter, lang_)) : in_language(address.text, lang_);
    const std::string name = address_written(letter);
    add(word.where, name, title, explained(name));
  }

  /// A part of a statement with names (spec/sinumerik 2, 3).
  void take(const StatementPart& part) {
    if (part.parameter != nullptr)
      return add(part.where, part.code, fmt::format("{}: {}: {}", part.name->name, part.code, in_language(part.parameter->text, lang_)),
                 {});
    if (part.name != nullptr) return add(part.where, part.code, in_language(part.name->text, lang_), explained(part.code));
    const bool is_code = part.code.size() > 1;
    const std::int32_t row = is_code && part.code.size() < 6 ? def_.row_of(part.code[0], std::atoi(part.code.c_str() + 1) * 10) : -1;
    if (row >= 0) return add(part.where, part.code, in_language(def_.codes[std::size_t(row)].text, lang_), explained(part.code));
    if (is_code || part.code[0] < 'A' || part.code[0] > 'Z') return;
    const AddressRow& address = def_.address(part.code[0]);
    if (address.function != Function::count) add(part.where, part.code, in_language(address.text, lang_), explained(part.code));
  }

  /// Returns the code of the block to which the word with this letter belongs; nullptr if there is none. The description of the code
  /// explains the word better than the description of the address does.
  const CodeRow* code_with(char letter) const {
    for (std::uint32_t i = 0; i < block_->word_count; ++i) {
      const Word& word = block_->words[i];
      if (word.code < 0) continue;
      const std::int32_t row = def_.row_of(word.address, word.code);
      if (row >= 0 && (def_.codes[std::size_t(row)].takes & letter_bit(letter)) != 0) return &def_.codes[std::size_t(row)];
    }
    return nullptr;
  }

  /// Returns the canned cycle that a word such as L81 names, on controls with such words (2С42).
  const CycleRow* cycle_of(char letter, const Word& word) const {
    if (letter != 'L' || word.expression || !(word.value >= 0 && word.value < 1e6) || word.value != std::floor(word.value)) return nullptr;
    const std::string name = fmt::format("L{}", std::int32_t(word.value));
    const auto found = std::find_if(def_.cycles.begin(), def_.cycles.end(), [&](const CycleRow& c) { return c.name == name; });
    return found == def_.cycles.end() ? nullptr : &*found;
  }

  /// Explains system variables: #5021, #_ABSIO[3] and #<_x>. Variables that the program itself defines have no description.
  void take_variables(std::size_t begin, std::size_t end) {
    for (std::size_t at = line_.find('#', begin); at < end; at = line_.find('#', at + 1)) {
      if (in_comment(at)) continue;
      const std::size_t last = end_of_variable(at + 1, end);
      const std::string name(line_.substr(at, last - at));
      const auto text = explain_variable(def_, name, lang_);
      if (text) add({std::uint32_t(at), std::uint32_t(last)}, name, text->substr(0, text->find('\n')), *text);
    }
  }
  std::size_t end_of_variable(std::size_t from, std::size_t end) const {
    const std::string_view digits = "0123456789", symbol = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_[]";
    const bool named = from < end && line_[from] == '_';
    return std::min(end, line_.find_first_not_of(named ? symbol : digits, from));
  }
  bool in_comment(std::size_t at) const {
    return std::any_of(block_->comments.begin(), block_->comments.end(), [&](Span s) { return s.begin <= at && at < s.end; });
  }

  std::string explained(const std::string& code) const { return explain_code(def_, texts_, code, lang_).value_or(""); }

  void add(Span where, std::string code, std::string title, std::string text) {
    if (words_.size() >= max_words || where.end <= where.begin || where.end > line_.size()) return;
    words_.push_back({characters_before(line_, where.begin) + 1, characters_before(line_, where.end) + 1, std::move(code), std::move(title),
                      std::move(text)});
  }

  const ControlDef& def_;
  const AlarmTexts& texts_;
  const std::string_view line_;
  const Lang lang_;
  const Block* block_ = nullptr;
  std::vector<LineWord> words_;
};

}  // namespace

std::vector<LineWord> words_of_line(const ControlDef& def, const AlarmTexts& texts, std::string_view line, Lang lang) {
  return LineWords(def, texts, line, lang).all();
}

}  // namespace kadr
