// Decides which blocks are read by lang/named, reads them, and executes them. Used by control/sinumerik.

#include <algorithm>
#include <utility>

#include "control/sinumerik/block_run.h"
#include "lang/named/named_parser.h"
#include "lang/named/named_reader.h"

namespace kadr::sinumerik {
namespace {

/// G codes that the words of the table do not describe completely; a block with one of them is read by lang/named.
constexpr int own_codes[] = {140, 340, 341, 4,   25,  26,  33,  41,  42,  53,  58,  59,  63,  70,  71, 74,
                             75,  110, 111, 112, 147, 148, 153, 247, 248, 331, 332, 347, 348, 700, 710};
}  // namespace

bool is_own_code(double code) {
  return std::any_of(std::begin(own_codes), std::end(own_codes), [&](int own) { return own == code; });
}

bool Sinumerik::needs_names(const BlockContext& m) const {
  const Block& block = *m.block;
  if (block.statement.kind == StatementKind::named || !words_are_plain()) return true;
  for (std::uint32_t i = 0; i < block.word_count; ++i) {
    const Word& w = block.words[i];
    if (w.address == 'G' && is_own_code(w.code / 10.0)) return true;
    if (w.address == 'M' && (w.code == 170 || w.code == 190)) return true;
  }
  return false;
}

Result<bool> Sinumerik::takes_block(Interpreter& m) {
  if (!assumed_axes.empty()) [[unlikely]]
    m.warn(note(AlarmId::axes_assumed, m.block->where, std::string_view(std::exchange(assumed_axes, {}))));
  words = {};
  kept_ = circle_by_name_ = false;
  previous_ = m.position.work;
  if (takes_kept_words(m)) return false;
  if (!needs_names(m)) {
    if (m.block->word_count > 0) level().executing = level().acted = true;  // a line with a comment alone may stand before PROC and DEF
    if ((m.block->letters & missing_axes) != 0)
      for (std::uint32_t i = 0; i < m.block->word_count; ++i)
        if (const Word& w = m.block->words[i]; (missing_axes & letter_bit(w.address)) != 0)
          return fail(alarm(AlarmId::axis_not_named, w.where, w.address));
    if (const Word* const f = m.block->find('F'); f != nullptr && !(f->value > 0))
      return fail(alarm(AlarmId::value_out_of_range, f->where, 'F', f->value));
    KADR_TRY(m.take_words());
    return false;
  }
  return run_named(m);
}

/// Takes the words of a line that was executed before. Returns false if it is not kept.
bool Sinumerik::takes_kept_words(BlockContext& m) {
  Level& own = level();
  const bool begun = own.executing || own.took_arguments || !own.has_arguments;
  if (!m.block->repeated || !begun || !words_are_plain() || !memory.macros.empty()) return false;
  Block* const kept = word_lines_.words_of(m);
  if (kept == nullptr) return false;
  m.block = kept;
  own.executing = own.acted = true;
  return true;
}

/// Reads the block, and executes it in a copy, because its words depend on values that change.
Result<bool> Sinumerik::run_named(Interpreter& m) {
  if (m.block != scratch_.get()) *scratch_ = *m.block;
  m.block = scratch_.get();
  Block& block = *scratch_;
  if (block.statement.kind != StatementKind::named) {
    const Span where = block.where;
    block.statement = {};
    KADR_TRY(read_named_line(block.text, where.begin, block));
    block.where = where;
    block.statement.kind = StatementKind::named;
  }
  block.word_count = 0;
  block.letters = 0;
  block.shape = {};
  block.altered = block.codes_vary = true;
  m.keep_state();
  m.keep_flow_place();
  before_ = memory;
  written_.clear();
  kept_ = true;
  const std::string_view text = block.text_of(block.statement.text);
  if (!text.empty() && text[0] == '%') {
    if (memory.levels.size() == 1 && level().name.empty()) level().name = plain_program_name(text);
    return true;
  }
  load_globals(m);
  // Further edges need rows before the block notes any row that it changes.
  if (text.find("$TC_DP") != std::string_view::npos && m.tables.offsets.size() < edge_row(tool_rows, most_edges))
    m.tables.offsets.resize(edge_row(tool_rows, most_edges));
  const Span written = block.statement.text;
  const bool changed = put_macros(block);
  auto done = run_statement(m);
  if (done || !changed) return done;
  Alarm fault = done.error();
  fault.where = written;  // the place in the text of a macro is none in the program
  return fail(fault);
}

/// Replaces the macros in the statement of the block. Returns false if it has none.
bool Sinumerik::put_macros(Block& block) {
  const std::string_view text = block.text_of(block.statement.text);
  if (memory.macros.empty() || leading_name(text) == "DEFINE") return false;
  const auto replaced = with_macros(text, memory.macros);
  if (!replaced) return false;
  expanded_ = std::string(block.text.substr(0, block.statement.text.begin)) + *replaced;
  const auto end = static_cast<std::uint32_t>(expanded_.size());
  expanded_.append(block.text.size() > expanded_.size() ? block.text.size() - expanded_.size() : 0, ' ');
  block.text = expanded_;
  block.statement.text.end = end;
  return true;
}

Result<bool> Sinumerik::execute_text(Interpreter& m, const std::string& text, Span where) {
  if (executes_text_) return fail(alarm(AlarmId::not_available, where, "EXECSTRING"));
  Block& block = *scratch_;
  const Span written = block.statement.text;
  executed_ = std::string(written.begin, ' ') + text;
  block.text = executed_;
  block.statement.text.end = static_cast<std::uint32_t>(executed_.size());
  executes_text_ = true;
  auto done = run_statement(m);
  executes_text_ = false;
  if (done) return done;
  Alarm fault = done.error();
  fault.where = where;  // the place in the text is none in the program
  return fail(fault);
}

Result<bool> Sinumerik::run_statement(Interpreter& m) {
  Block& block = *scratch_;
  const std::string_view text = block.text_of(block.statement.text);
  std::string key(text);
  key += static_cast<char>(block.statement.text.begin & 0x7F);
  auto& kept = read_[key];
  if (kept == nullptr) {
    auto read = read_named_block(block.text, block.statement.text);
    if (!read) {
      read_.erase(key);
      return fail(read.error());
    }
    constexpr std::size_t most_kept = 20'000;
    auto made = std::make_shared<const NamedBlock>(std::move(*read));
    if (read_.size() > most_kept) read_.clear();
    read_[key] = made;
    return BlockRun(m, *this, *made).run();
  }
  const auto made = kept;
  auto done = BlockRun(m, *this, *made).run();
  if (done && !*done && block.repeated && words_are_plain() && memory.macros.empty() && !executes_text_) word_lines_.keep(m, *made, block);
  return done;
}

}  // namespace kadr::sinumerik
