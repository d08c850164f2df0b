// The names in one line of a program. Used by view/structure/outline and lsp/document_names; tested by tests/lsp/document_names_test.cpp
// and tests/view/outline_test.cpp.

#include "view/structure/line_names.h"

#include <algorithm>
#include <array>

#include "base/ascii.h"
#include "lang/block/lexer.h"
#include "lang/named/named_parser.h"
#include "out/text/explain/name_text.h"
#include "view/structure/klartext_names.h"

namespace kadr {
namespace {

constexpr std::size_t longest_line = 10'000;                               // bytes; the rest of a longer line is not searched for names
constexpr std::int32_t first_figure_cycle = 700, last_figure_cycle = 739;  // G70 to G73, in tenths
constexpr std::array jumps = {"GOTO", "GOTOF", "GOTOB", "GOTOC", "REPEAT", "REPEATB"};  // spec/sinumerik 8

/// The letters of the words of a code that name blocks, and of those that name programs.
struct Naming {
  std::string_view blocks, programs;
};

Naming naming_of(const CodeRow& row) {
  switch (row.function) {
    case Function::return_program:
    case Function::call_local:
    case Function::jump_by_input: return {"P", ""};
    case Function::turning_cycle: return {row.tenth >= first_figure_cycle && row.tenth <= last_figure_cycle ? "PQ" : "", ""};
    case Function::call_program:
    case Function::call_numbered:
    case Function::macro_call:
    case Function::macro_modal: return {"", "P"};
    default: return {};
  }
}

bool calls_cycle(const CodeRow& row) {
  switch (row.function) {
    case Function::cycle:
    case Function::canned_cycle:
    case Function::drilling:
    case Function::turning_cycle:
    case Function::turning_simple:
    case Function::profile_cycle:
    case Function::threading_cycle:
    case Function::circular_pocket:
    case Function::circular_bore:
    case Function::hole_pattern:
    case Function::engraved_text: return true;
    default: return row.cycle != 0;
  }
}

bool changes_tool(const CodeRow& row) {
  return row.function == Function::change_tool || row.function == Function::exchange_tool || row.function == Function::load_tool;
}

std::string without_zeros(std::string_view digits) {
  while (digits.size() > 1 && digits.front() == '0') digits.remove_prefix(1);
  return std::string(digits);
}

std::string in_small_letters(std::string_view text) {
  std::string small;
  for (const char c : text)
    if (c != ' ' && c != '\t') small += to_lower(c);
  return small;
}

/// Reads the names of one block.
class BlockNames {
 public:
  BlockNames(const ControlDef& def, const Block& block, std::vector<NamedPlace>& to) : def_(def), block_(block), to_(to) {}

  void find() {
    if (block_.has_number) add_number(NameKind::block, true, block_.number_where);
    if (block_.marker == Marker::label) add_number(NameKind::program, true, block_.where);
    take_statement();
    Naming naming;
    for (std::uint32_t i = 0; i < block_.word_count; ++i) take_code(block_.words[i], naming);
    for (std::uint32_t i = 0; i < block_.word_count; ++i) take_word(block_.words[i], naming);
    take_variables();
    if (!block_.comments.empty()) take_comment();
  }

 private:
  /// Adds the first comment: a heading if it is alone in its line, a structure block (* - Outline), else a remark.
  void take_comment() {
    const Span where = block_.comments.front();
    const bool is_section = def_.grammar.klartext_blocks && where.begin > 0 && block_.text[where.begin - 1] == '*';
    std::string_view text = block_.text_of(where);
    while (!text.empty() && (text.front() == ' ' || (is_section && text.front() == '-'))) text.remove_prefix(1);
    while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
    const bool is_heading = block_.empty() && block_.comments.size() == 1;
    add(is_section ? NameKind::section : is_heading ? NameKind::heading : NameKind::remark, false, where, std::string(text));
  }

  void add(NameKind kind, bool defines, Span where, std::string name) {
    if (where.end > where.begin) to_.push_back({kind, defines, where, std::move(name)});
  }

  /// Adds the digits of a span; the letter before them is no part of a name that the editor may change.
  void add_number(NameKind kind, bool defines, Span where) {
    const std::string_view text = block_.text_of(where);
    const std::size_t begin = text.find_first_of("0123456789");
    if (begin == std::string_view::npos) return;
    const std::size_t end = std::min(text.find_first_not_of("0123456789", begin), text.size());
    add(kind, defines, {where.begin + std::uint32_t(begin), where.begin + std::uint32_t(end)},
        without_zeros(text.substr(begin, end - begin)));
  }

  void take_statement() {
    const Statement& statement = block_.statement;
    switch (statement.kind) {
      case StatementKind::named:
        take_named();
        take_named_parts();
        break;
      case StatementKind::go_to:
        if (statement.value.end - statement.value.begin == 1 && block_.code[statement.value.begin].op == Op::number)
          add_number(NameKind::block, false, block_.code[statement.value.begin].where);
        break;
      case StatementKind::loop: add(NameKind::opens, false, statement.where, loop_name()); break;
      case StatementKind::loop_end: add(NameKind::closes, false, statement.where, loop_name()); break;
      case StatementKind::o_word: take_label(); break;
      default: break;
    }
  }

  /// Finds the programs in a block with names (spec/sinumerik 1, 9): %_N_PART_SPF and PROC PART define one; PART, PART(5), L10,
  /// MCALL PART, CALL "PART" and EXTCALL "PART" call one.
  void take_named() {
    const Span span = block_.statement.text;
    const std::string_view text = block_.text_of(span);
    std::size_t at = text.find_first_not_of(" \t");
    const auto word = [&]() -> Span {
      while (at < text.size() && (text[at] == ' ' || text[at] == '\t' || text[at] == '"')) ++at;
      const std::size_t begin = at;
      while (at < text.size() && continues_name(text[at])) ++at;
      return {std::uint32_t(begin), std::uint32_t(at)};
    };
    if (at >= text.size()) return;
    const bool heads = text[at] == '%';
    if (heads) ++at;
    const Span first = word();
    const std::string name = in_small_letters(text.substr(first.begin, first.end - first.begin));
    if (heads || name == "proc") return add_program(true, heads ? first : word());
    if (name == "msg") return take_message(text, at);
    if (name == "mcall" || name == "call" || name == "extcall" || name == "pcall") return add_program(false, word());
    const bool by_number = name.size() > 1 && name[0] == 'l' && name.find_first_not_of("0123456789", 1) == std::string::npos;
    const bool by_name = name.size() > 1 && begins_name(name[0]) && begins_name(name[1]) && name[0] != '_';
    while (at < text.size() && (text[at] == ' ' || text[at] == '\t')) ++at;
    const bool is_call = at == text.size() || text[at] == '(' || text[at] == 'P' || text[at] == 'p';
    if (!is_call || (!by_number && !by_name)) return;
    bool known = false;  // a name of the control itself: STOPRE, CYCLE81
    each_part(def_, block_.text, span, [&](const StatementPart& part) { known = known || part.name != nullptr; });
    if (!known) add_program(false, first);
  }

  /// MSG("DRILL 6.8") stands before a tool like a comment.
  void take_message(std::string_view text, std::size_t at) {
    const std::size_t open = text.find('"', at), close = text.find('"', open + 1);
    if (open == std::string_view::npos || close == std::string_view::npos) return;
    const std::uint32_t begin = block_.statement.text.begin;
    add(NameKind::heading, false, {begin + std::uint32_t(open + 1), begin + std::uint32_t(close)},
        std::string(text.substr(open + 1, close - open - 1)));
  }

  /// Finds the tools, the cycles, the labels and the jumps to labels of a block with names: T1, T="DRILL", CYCLE81(…), CIRCLE6:, GOTOF END.
  /// Of a part of the program that is repeated only the first label counts.
  void take_named_parts() {
    const Span label = block_.statement.label_where;
    if (label.end > label.begin) add(NameKind::mark, true, label, in_small_letters(block_.text_of(label)));
    bool cancels = false, calls = false;
    each_part(def_, block_.text, block_.statement.text, [&](const StatementPart& part) {
      if (part.parameter != nullptr) return;
      const std::size_t end = part.where.end;
      if (part.code == "T") take_named_tool(part.where);
      if (part.code == "M6" || part.code == "M06") add(NameKind::change, false, part.where, {});
      if (part.name == nullptr) return;
      cancels = cancels || part.code == "MCALL";
      if (std::find(jumps.begin(), jumps.end(), part.code) != jumps.end()) take_jump(end);
      if (part.name->parameters.empty()) return;
      calls = true;
      add(NameKind::cycle, true, part.where, part.code);
    });
    if (cancels && !calls) add(NameKind::no_cycle, false, block_.statement.text, {});
  }

  std::size_t past_blanks(std::size_t at) const {
    while (at < block_.text.size() && (block_.text[at] == ' ' || block_.text[at] == '\t')) ++at;
    return at;
  }

  void take_named_tool(Span where) {
    if (where.end > where.begin + 1) return add_number(NameKind::tool, false, where);
    std::size_t begin = past_blanks(where.end);
    const std::string_view text = block_.text;
    if (begin >= text.size() || text[begin] != '=') return;
    begin = past_blanks(begin + 1);
    if (begin < text.size() && text[begin] == '"') {
      const std::size_t close = std::min(text.find('"', begin + 1), text.size());
      return add(NameKind::tool, false, {std::uint32_t(begin + 1), std::uint32_t(close)},
                 std::string(text.substr(begin + 1, close - begin - 1)));
    }
    const std::size_t end = std::min(text.find_first_not_of("0123456789", begin), text.size());
    if (end > begin) add(NameKind::tool, false, {std::uint32_t(begin), std::uint32_t(end)}, without_zeros(text.substr(begin, end - begin)));
  }

  void take_jump(std::size_t from) {
    const std::size_t begin = past_blanks(from);
    std::size_t end = begin;
    while (end < block_.text.size() && continues_name(block_.text[end])) ++end;
    add(NameKind::mark, false, {std::uint32_t(begin), std::uint32_t(end)}, in_small_letters(block_.text.substr(begin, end - begin)));
  }

  /// Adds a program by its name, without the parts by which the control stores it: _N_PART_SPF is PART. `where` counts from the statement.
  void add_program(bool defines, Span where) {
    std::string_view text = block_.text_of(block_.statement.text).substr(where.begin, where.end - where.begin);
    std::string name = in_small_letters(text);
    if (name.starts_with("_n_")) name.erase(0, 3), where.begin += 3;
    for (const std::string_view ending : {"_mpf", "_spf"})
      if (name.size() > ending.size() && name.ends_with(ending)) {
        name.erase(name.size() - ending.size());
        where.end -= std::uint32_t(ending.size());
        break;
      }
    const std::uint32_t begin = block_.statement.text.begin;
    add(NameKind::program, defines, {begin + where.begin, begin + where.end}, std::move(name));
  }

  std::string loop_name() const { return "do" + std::to_string(block_.statement.loop); }

  /// Adds the first and the last line of a loop, a condition or a subprogram. All lines of one of them have the same label. A loop that
  /// begins with DO ends with WHILE, which looks like the beginning of another loop; folding_ranges() knows it by its label.
  void take_label() {
    const Statement& statement = block_.statement;
    const Span where{statement.label_where.begin + 1, statement.label_where.end};  // without the letter O
    if (where.end <= where.begin) return;
    const std::string label = in_small_letters(block_.text_of(where));
    switch (statement.o_word) {
      case OWord::sub:
      case OWord::do_:
      case OWord::while_:
      case OWord::repeat:
      case OWord::if_: add(NameKind::opens, false, statement.where, label); break;
      case OWord::endsub:
      case OWord::endwhile:
      case OWord::endrepeat:
      case OWord::endif: add(NameKind::closes, false, statement.where, label); break;
      default: break;
    }
    const bool defines = statement.o_word == OWord::sub || statement.o_word == OWord::label;
    add(NameKind::label, defines, where, label);
  }

  const CodeRow* row_of(const Word& word) const {
    const std::int32_t row = word.code < 0 ? -1 : def_.row_of(word.address, word.code);
    return row < 0 ? nullptr : &def_.codes[static_cast<std::size_t>(row)];
  }

  void take_code(const Word& word, Naming& naming) {
    const CodeRow* const row = row_of(word);
    if (row == nullptr) return;
    if (calls_cycle(*row)) add(NameKind::cycle, false, word.where, row->code);
    else if (changes_tool(*row)) add(NameKind::change, false, word.where, {});
    else if (row->function == Function::drilling_off || row->function == Function::no_motion)
      add(NameKind::no_cycle, false, word.where, {});
    const Naming of_code = naming_of(*row);
    if (!of_code.blocks.empty()) naming.blocks = of_code.blocks;
    if (!of_code.programs.empty()) naming.programs = of_code.programs;
  }

  void take_word(const Word& word, const Naming& naming) {
    if (word.address == 0 || word.expression || word.code >= 0) return;
    if (naming.blocks.find(word.address) != std::string_view::npos) add_number(NameKind::block, false, word.where);
    if (naming.programs.find(word.address) != std::string_view::npos) add_number(NameKind::program, false, word.where);
    if (word.address == 'T') add_number(NameKind::tool, false, word.where);
  }

  bool in_comment(std::size_t at) const {
    return std::any_of(block_.comments.begin(), block_.comments.end(), [&](Span s) { return s.begin <= at && at < s.end; });
  }

  /// Finds #100 and #<name>. A variable is defined where its value is assigned: at the beginning of an assignment.
  void take_variables() {
    const std::string_view text = block_.text;
    for (std::size_t at = text.find('#', block_.where.begin); at < block_.where.end; at = text.find('#', at + 1)) {
      if (in_comment(at)) continue;
      const std::size_t begin = at + 1;
      const bool named = begin < text.size() && text[begin] == '<';
      const std::size_t close = named ? text.find('>', begin) : text.find_first_not_of("0123456789", begin);
      const std::size_t end = named && close != std::string_view::npos ? close + 1 : std::min(close, text.size());
      if (end <= begin || (named && close == std::string_view::npos)) continue;
      std::size_t next = end;
      while (next < text.size() && (text[next] == ' ' || text[next] == '\t')) ++next;
      const std::string_view written = text.substr(begin, end - begin);
      const bool assigned = next < text.size() && text[next] == '=' && !(next + 1 < text.size() && text[next + 1] == '=');
      add(NameKind::variable, assigned, {std::uint32_t(begin), std::uint32_t(end)},
          named ? in_small_letters(written) : without_zeros(written));
    }
  }

  const ControlDef& def_;
  const Block& block_;
  std::vector<NamedPlace>& to_;
};

}  // namespace

std::vector<NamedPlace> names_of_line(const ControlDef& def, std::string_view line) {
  std::vector<NamedPlace> names;
  line = line.substr(0, longest_line);
  static thread_local Block block;  // its lists keep their memory from line to line
  for (std::size_t from = 0; from < line.size();) {
    block.clear();
    const auto lexed = lex_block(line, from, true, def.grammar, block);
    BlockNames(def, block, names).find();
    if (!lexed || lexed->next <= from) break;
    from = lexed->next;
  }
  if (def.grammar.klartext_blocks) add_klartext_names(line, names);
  return names;
}

}  // namespace kadr
