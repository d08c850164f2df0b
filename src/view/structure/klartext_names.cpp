// Finds the names of conversational blocks. Used by view/structure/line_names; tested by tests/lsp/document_names_test.cpp.

#include "view/structure/klartext_names.h"

#include <algorithm>
#include <optional>

#include "base/ascii.h"

namespace kadr {
namespace {

bool is_blank(char c) { return c == ' ' || c == '\t'; }

class KlartextNames {
 public:
  KlartextNames(std::string_view line, std::vector<NamedPlace>& names) : line_(line), names_(names) {}

  void find() {
    const std::size_t end = end_of_code();
    line_ = line_.substr(0, end);
    skip_number();
    if (starts("LBL")) label(at_ + 3, true);
    else if (starts("CALL LBL")) label(at_ + 8, false);
    else if (const std::size_t jump = line_.find("GOTO LBL"); jump != std::string_view::npos) label(jump + 8, false);
    else if (starts("BEGIN PGM")) program(at_ + 9, true);
    else if (starts("CALL PGM")) program(at_ + 8, false);
    else if (starts("SEL PGM")) program(at_ + 7, false);
    else if (starts("TOOL CALL")) tool(at_ + 9, false);
    else if (starts("TOOL DEF")) tool(at_ + 8, true);
    else if (starts("CYCL DEF") || starts("CYCLE DEF")) cycle();
    parameters();
  }

 private:
  /// Returns where the comment begins: at ; outside quotation marks.
  std::size_t end_of_code() const {
    bool quoted = false;
    for (std::size_t i = 0; i < line_.size(); ++i) {
      if (line_[i] == '"') quoted = !quoted;
      else if (line_[i] == ';' && !quoted) return i;
    }
    return line_.size();
  }

  void skip_number() {
    while (at_ < line_.size() && (is_blank(line_[at_]) || line_[at_] == '/')) ++at_;
    while (at_ < line_.size() && is_digit(line_[at_])) ++at_;
    while (at_ < line_.size() && (is_blank(line_[at_]) || line_[at_] == '/')) ++at_;
  }

  bool starts(std::string_view what) const {
    if (line_.size() < at_ + what.size()) return false;
    return std::equal(what.begin(), what.end(), line_.begin() + static_cast<std::ptrdiff_t>(at_),
                      [](char a, char b) { return a == to_upper(b); });
  }

  void add(NameKind kind, bool defines, std::size_t begin, std::size_t end, std::string name) {
    if (end > begin) names_.push_back({kind, defines, {std::uint32_t(begin), std::uint32_t(end)}, std::move(name)});
  }

  std::size_t past_blanks(std::size_t at) const {
    while (at < line_.size() && is_blank(line_[at])) ++at;
    return at;
  }

  std::size_t past_digits(std::size_t at) const {
    while (at < line_.size() && is_digit(line_[at])) ++at;
    return at;
  }

  /// Adds a label by its number or its name. LBL 0 is the end of a subprogram, no label.
  void label(std::size_t from, bool defines) {
    const std::size_t begin = past_blanks(from);
    if (begin < line_.size() && line_[begin] == '"') {
      const std::size_t close = std::min(line_.find('"', begin + 1), line_.size());
      return add(NameKind::label, defines, begin + 1, close, std::string(line_.substr(begin + 1, close - begin - 1)));
    }
    const std::size_t end = past_digits(begin);
    std::string number(line_.substr(begin, end - begin));
    number.erase(0, std::min(number.find_first_not_of('0'), number.size()));
    if (!number.empty()) add(NameKind::label, defines, begin, end, std::move(number));
  }

  /// Adds a program by its name, without folder and without .H.
  void program(std::size_t from, bool defines) {
    std::size_t begin = past_blanks(from), end = line_.size();
    while (end > begin && (static_cast<unsigned char>(line_[end - 1]) <= ' ' || line_[end - 1] == '"')) --end;
    if (defines) {  // without the unit
      const std::size_t unit = line_.substr(0, end).find_last_of(" \t");
      if (unit == std::string_view::npos || unit < begin) return;
      for (end = unit; end > begin && is_blank(line_[end - 1]);) --end;
    }
    if (begin < end && line_[begin] == '"') ++begin;
    const std::size_t folder = line_.substr(0, end).find_last_of("\\/:");
    if (folder != std::string_view::npos && folder >= begin) begin = folder + 1;
    if (end > begin + 2 && line_[end - 2] == '.' && to_upper(line_[end - 1]) == 'H') end -= 2;
    std::string name;
    for (const char c : line_.substr(begin, end - begin)) name += to_lower(c);
    add(NameKind::program, defines, begin, end, std::move(name));
  }

  void tool(std::size_t from, bool defines) {
    const std::size_t begin = past_blanks(from);
    if (begin < line_.size() && line_[begin] == '"') {
      const std::size_t close = std::min(line_.find('"', begin + 1), line_.size());
      return add(NameKind::tool, defines, begin + 1, close, std::string(line_.substr(begin + 1, close - begin - 1)));
    }
    const std::size_t end = past_digits(begin);
    add(NameKind::tool, defines, begin, end, std::string(line_.substr(begin, end - begin)));
  }

  /// Adds a cycle with the name that the block states. Of an old cycle, which has several blocks, the first counts: CYCL DEF 7.0.
  void cycle() {
    const std::size_t number = past_blanks(line_.find_first_of("Ff", at_) + 1), after = past_digits(number);
    if (number == after) return;
    if (after + 1 < line_.size() && line_[after] == '.' && line_[after + 1] != '0') return;
    std::size_t end = line_.size();
    while (end > number && (static_cast<unsigned char>(line_[end - 1]) <= ' ' || line_[end - 1] == '~')) --end;
    const std::size_t words = line_.find(" Q", after);  // parameters in the same line
    if (words < end) end = words;
    add(NameKind::cycle, true, at_, end, std::string(line_.substr(at_, end - at_)));
  }

  /// Adds Q5, QL5, QR5, QS5; one before `=` gets a value.
  void parameters() {
    bool quoted = false;
    for (std::size_t i = at_; i + 1 < line_.size(); ++i) {
      if (line_[i] == '"') quoted = !quoted;
      if (quoted || to_upper(line_[i]) != 'Q') continue;
      std::size_t digits = i + 1;
      const char family = to_upper(line_[digits]);
      if (family == 'L' || family == 'R' || family == 'S') ++digits;
      const std::size_t end = past_digits(digits);
      if (end == digits) continue;
      const std::size_t next = past_blanks(end);
      std::string name;
      for (const char c : line_.substr(i, end - i)) name += to_lower(c);
      add(NameKind::variable, next < line_.size() && line_[next] == '=', i, end, std::move(name));
      i = end - 1;
    }
  }

  std::string_view line_;
  std::vector<NamedPlace>& names_;
  std::size_t at_ = 0;
};

}  // namespace

void add_klartext_names(std::string_view line, std::vector<NamedPlace>& names) { KlartextNames(line, names).find(); }

}  // namespace kadr
