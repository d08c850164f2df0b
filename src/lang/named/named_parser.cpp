// Reads the text of a block with names into a NamedBlock. Used by control/sinumerik; tested by tests/lang/named_test.cpp.

#include "lang/named/named_parser.h"

#include <algorithm>

#include "base/ascii.h"
#include "lang/named/named_declaration.h"

namespace kadr {
namespace {

constexpr std::string_view jumps[] = {"GOTOF", "GOTOB", "GOTO", "GOTOC", "GOTOS"};

bool is_jump(std::string_view name) { return std::find(std::begin(jumps), std::end(jumps), name) != std::end(jumps); }

class BlockParser : public NamedDeclarations {
 public:
  using NamedDeclarations::NamedDeclarations;

  Status run() {
    skip();
    if (at_end()) return {};
    const std::string first = name_here();
    if (first == "DEF" || first == "DEFINE" || first == "PROC" || first == "EXTERN") return declaration(first);
    // REDEF changes who may read and write global data (spec/sinumerik 6.1); SETINT waits for an input of the machine (8.4)
    if (first == "REDEF" || first == "SETINT") {
      block_.kind = NamedKind::passed_over;
      return {};
    }
    // Synchronised actions have a syntax of their own (spec/sinumerik 8.4).
    for (const std::string_view refused : {"WHEN", "WHENEVER", "FROM", "EVERY", "DO", "ID", "IDS"})
      if (first == refused) return fail(alarm(AlarmId::not_available, span(at_, at_ + refused.size()), refused));
    while (!at_end()) KADR_TRY(item());
    return {};
  }

 private:
  // ---- items

  Status item() {
    skip();
    if (at_end()) return {};
    const char c = peek();
    if (c == '$') return system_word();
    if (!begins_name(c)) return unexpected();
    const std::size_t begin = at_;
    const char next = at_ + 1 < text_.size() ? text_[at_ + 1] : '\0';
    // A letter with a digit, a sign or a point behind it is an address with its number (spec/sinumerik 3.1).
    if (c != '_' && !begins_name(next)) return letter_word(begin);
    const std::string name = take_name();
    if (is_jump(name)) return jump(name, begin);
    if (name == "IF" || name == "WHILE" || name == "UNTIL") return condition(name, begin);
    if (name == "CASE") return choice(begin);
    if (name == "FOR") return counted_loop(begin);
    skip();
    if (peek() == '=' && !at("==")) return value_word(name, -1, begin);
    if (peek() == '[') return indexed_word(name, begin);
    return plain_name(name, begin);
  }

  Status letter_word(std::size_t begin) {
    NamedItem item;
    item.kind = NamedItem::Kind::word;
    item.name = std::string(1, to_upper(text_[at_++]));
    skip();
    if (peek() == '=') return value_word(item.name, -1, begin);
    if (peek() == '[') return indexed_word(item.name, begin);
    const std::size_t number = at_;
    std::size_t look = at_;
    while (look < text_.size() && is_digit(text_[look])) ++look;
    std::size_t equals = look;
    while (equals < text_.size() && is_blank_sign(text_[equals])) ++equals;
    if (look > number && equals < text_.size() && text_[equals] == '=' && !(equals + 1 < text_.size() && text_[equals + 1] == '=')) {
      if (look - number > 9) return fail(alarm(AlarmId::number_damaged, span(number, look)));
      const std::int32_t extension = static_cast<std::int32_t>(std::stol(std::string(text_.substr(number, look - number))));
      at_ = equals;
      return value_word(item.name, extension, begin);
    }
    const char sign = peek() == '-' || peek() == '+' ? text_[at_++] : '\0';
    skip();
    if (!is_digit(peek()) && peek() != '.') {
      if (sign == '\0' && at_ == number) return plain_name(item.name, begin);
      return fail(alarm(AlarmId::number_missing, span(begin, at_ + 1), item.name[0]));
    }
    double value = 0;
    bool whole = false;
    const std::size_t digits = at_;
    KADR_TRY(number_here(value, whole));
    item.number = sign == '-' ? -value : value;
    item.text = std::string(text_.substr(digits, at_ - digits));
    item.where = span(begin, at_);
    block_.items.push_back(std::move(item));
    return {};
  }

  Status value_word(const std::string& name, std::int32_t extension, std::size_t begin, std::vector<NamedExpression> indices = {}) {
    NamedItem item;
    item.kind = NamedItem::Kind::word;
    item.has_equals = true;
    item.name = name;
    item.extension = extension;
    item.arguments = std::move(indices);
    ++at_;  // =
    KADR_TRY(form_and_value(item));
    item.where = span(begin, at_);
    block_.items.push_back(std::move(item));
    return {};
  }

  Status form_and_value(NamedItem& item) {
    skip();
    constexpr std::pair<std::string_view, WordForm> forms[] = {{"AC", WordForm::absolute},  {"IC", WordForm::incremental},
                                                               {"DC", WordForm::direct},    {"ACP", WordForm::positive},
                                                               {"ACN", WordForm::negative}, {"QU", WordForm::quick}};
    const std::string name = name_here();
    for (const auto& [text, form] : forms) {
      if (name != text) continue;
      std::size_t look = at_ + text.size();
      while (look < text_.size() && is_blank_sign(text_[look])) ++look;
      if (look >= text_.size() || text_[look] != '(') break;
      const std::size_t open = look;
      at_ = look + 1;
      item.form = form;
      KADR_TRY(expression(item.value));
      skip();
      if (peek() != ')') return at_end() ? not_closed(open) : syntax();
      ++at_;
      return {};
    }
    for (const std::string_view coded : {"CAC", "CIC", "CDC", "CACP", "CACN"})
      if (name == coded) return fail(alarm(AlarmId::not_available, span(at_, at_ + coded.size()), coded));
    return expression(item.value);
  }

  Status indexed_word(const std::string& name, std::size_t begin) {
    std::vector<NamedExpression> list;
    KADR_TRY(indices(list));
    skip();
    if (peek() != '=' || at("==")) return syntax();
    return value_word(name, -1, begin, std::move(list));
  }

  Status system_word() {
    const std::size_t begin = at_++;
    const std::string name = "$" + take_name();
    skip();
    if (peek() == '[') return indexed_word(name, begin);
    if (peek() != '=' || at("==")) return syntax();
    return value_word(name, -1, begin);
  }

  Status plain_name(const std::string& name, std::size_t begin) {
    NamedItem item;
    item.kind = NamedItem::Kind::name;
    item.name = name;
    skip();
    if (peek() == '(') {
      item.has_arguments = true;
      KADR_TRY(arguments(item.arguments));
    }
    item.where = span(begin, at_);
    const bool text_follows = name == "CALL" || name == "PCALL" || name == "EXTCALL" || name == "ISOCALL";
    skip();
    const bool by_path = name == "PCALL" && !at_end() && peek() != '"';
    if (by_path) {  // PCALL /_N_SPF_DIR/_N_NAME_SPF(args): the path is written without quotation marks
      const std::size_t from = at_;
      while (!at_end() && (continues_name(peek()) || peek() == '/' || peek() == '.')) ++at_;
      item.text = std::string(text_.substr(from, at_ - from));
    } else if (text_follows && !at_end() && name_here() != "BLOCK") {
      KADR_TRY(expression(item.value));
    }
    if (skip(); name == "PCALL" && peek() == '(') {
      item.has_arguments = true;
      KADR_TRY(arguments(item.arguments));
      item.where = span(begin, at_);
    }
    const bool labels = name == "REPEAT" || name == "REPEATB" || name == "BLOCK" || name == "TO";
    if (labels) {
      for (skip(); begins_name(peek()); skip()) {
        const std::size_t place = at_;
        const std::string label = take_name();
        if (label.size() == 1 || label == "TO") {  // P=3
          at_ = place;
          break;
        }
        item.text += (item.text.empty() ? "" : " ") + label;
        item.where.end = static_cast<std::uint32_t>(at_);
      }
    }
    block_.items.push_back(std::move(item));
    return {};
  }

  Status jump(const std::string& name, std::size_t begin) {
    NamedItem item;
    item.kind = NamedItem::Kind::jump;
    item.name = name;
    KADR_TRY(target(item, begin));
    block_.items.push_back(std::move(item));
    return {};
  }

  Status target(NamedItem& item, std::size_t begin) {
    skip();
    const std::size_t from = at_;
    if (peek() == '"' || peek() == '(' || peek() == '$') {
      KADR_TRY(expression(item.value));
    } else if (peek() == ':' || is_digit(peek())) {
      if (peek() == ':') ++at_;
      while (is_digit(peek())) item.text += text_[at_++];
      item.text = "N" + item.text;
    } else if (begins_name(peek())) {
      const std::string label = take_name();
      skip();
      if (peek() == '<' || peek() == '[') {
        at_ = from;
        KADR_TRY(expression(item.value));
      } else {
        item.text = label;
      }
    } else if (item.name != "GOTOS") {
      return syntax();
    }
    item.where = span(begin, at_);
    return {};
  }

  Status condition(const std::string& name, std::size_t begin) {
    NamedItem item;
    item.kind = NamedItem::Kind::condition;
    item.name = name;
    KADR_TRY(expression(item.value));
    item.where = span(begin, at_);
    block_.items.push_back(std::move(item));
    return {};
  }

  /// CASE(expr) OF c1 GOTOF t1 c2 GOTOF t2 DEFAULT GOTOF t3.
  Status choice(std::size_t begin) {
    KADR_TRY(condition("CASE", begin));
    skip();
    if (take_name() != "OF") return syntax();
    for (skip(); !at_end(); skip()) {
      const std::size_t from = at_;
      NamedItem item;
      item.kind = NamedItem::Kind::jump;
      if (name_here() == "DEFAULT") {
        at_ += 7;
      } else {
        NamedExpression constant;
        KADR_TRY(expression(constant));
        item.arguments.push_back(constant);
      }
      skip();
      item.name = take_name();
      if (!is_jump(item.name)) return syntax();
      KADR_TRY(target(item, from));
      block_.items.push_back(std::move(item));
    }
    return {};
  }

  /// FOR v=a TO b: a condition with the name FOR, whose indices are a and b; `text` is the name of the variable, with its index in `value`.
  Status counted_loop(std::size_t begin) {
    NamedItem item;
    item.kind = NamedItem::Kind::condition;
    item.name = "FOR";
    skip();
    item.text = take_name();
    if (item.text.empty()) return syntax();
    if (peek() == '[') {
      std::vector<NamedExpression> index;
      KADR_TRY(indices(index));
      if (index.size() != 1) return syntax();
      item.value = index[0];
    }
    skip();
    if (peek() != '=') return syntax();
    ++at_;
    NamedExpression from, to;
    KADR_TRY(expression(from));
    skip();
    if (take_name() != "TO") return syntax();
    KADR_TRY(expression(to));
    item.arguments = {from, to};
    item.where = span(begin, at_);
    block_.items.push_back(std::move(item));
    return {};
  }
};

}  // namespace

Result<NamedBlock> read_named_block(std::string_view line, Span text) {
  NamedBlock block;
  BlockParser parser(line.substr(0, text.end), text.begin, block);
  KADR_TRY(parser.run());
  return block;
}

std::string leading_name(std::string_view text) {
  std::size_t begin = 0;
  while (begin < text.size() && is_blank_sign(text[begin])) ++begin;
  std::size_t end = begin;
  while (end < text.size() && continues_name(text[end])) ++end;
  if (end < begin + 2 || !begins_name(text[begin]) || !begins_name(text[begin + 1])) return {};
  std::string name(text.substr(begin, end - begin));
  for (char& c : name) c = to_upper(c);
  return name;
}

bool has_name(std::string_view text, std::string_view name) {
  bool quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '"') quoted = !quoted;
    if (quoted || !begins_name(text[i]) || (i > 0 && begins_name(text[i - 1]))) continue;
    std::size_t n = 0;
    while (n < name.size() && i + n < text.size() && to_upper(text[i + n]) == name[n]) ++n;
    if (n == name.size() && (i + n == text.size() || !continues_name(text[i + n]))) return true;
  }
  return false;
}

}  // namespace kadr
