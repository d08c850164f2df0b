// Finds the words of axes in a text, without reading it as blocks. Used by session/session; tested by tests/session/assumed_axes_test.cpp.

#include "session/assumed_axes.h"

#include <algorithm>
#include <string>
#include <string_view>

#include "base/ascii.h"

namespace kadr {
namespace {

constexpr std::size_t looked_at = 256U << 10U;

bool begins_value(std::string_view text) {
  const std::size_t sign = !text.empty() && (text[0] == '+' || text[0] == '-') ? 1 : 0;
  return sign < text.size() && (is_digit(text[sign]) || text[sign] == '.' || text[sign] == 'Q');
}

/// Returns true if a line of a conversational program moves along the axis: L … A+30, L … IB-5, LN … C+Q122.
bool moves_conversational(std::string_view line, char axis) {
  std::size_t at = line.find_first_not_of(" \t");
  if (at == std::string_view::npos) return false;
  while (at < line.size() && is_digit(line[at])) ++at;
  line.remove_prefix(std::min(line.find_first_not_of(" \t", at), line.size()));
  if (!line.starts_with("L ") && !line.starts_with("LN ")) return false;
  line = line.substr(0, line.find(';'));
  for (std::size_t i = 2; i < line.size(); ++i) {
    const bool apart = line[i - 1] == ' ' || (line[i - 1] == 'I' && line[i - 2] == ' ');
    if (apart && line[i] == axis && begins_value(line.substr(i + 1))) return true;
  }
  return false;
}

/// Returns true if the text begins with a name of at least three letters, such as TRANS, CYCLE800, DEF: its words are not those of a
/// motion.
bool names_statement(std::string_view text) {
  std::size_t letters = 0;
  while (letters < text.size() && is_capital(to_upper(text[letters]))) ++letters;
  return letters >= 3 && !text.starts_with("ACP(") && !text.starts_with("ACN(");
}

/// Returns true if a line of a program with names moves along the axis: A30, B-5, C=DC(10). `A=` of a variable is no word of an axis.
bool moves_named(std::string_view line, char axis, bool is_variable) {
  line = line.substr(0, line.find("GOTO"));  // a label may look like a word
  char quote = 0;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    if (quote != 0) {
      if (c == quote) quote = 0;
      continue;
    }
    if (c == ';') return false;
    if (c == '"' || c == '\'') quote = c;
    const char before = i == 0 ? ' ' : line[i - 1];
    const bool begins_name = is_capital(to_upper(c)) && !is_capital(to_upper(before));
    if (begins_name && names_statement(line.substr(i))) return false;
    const bool apart = !is_capital(to_upper(before)) && before != '_' && before != '$' && before != '[' && before != '(';
    if (!apart || to_upper(c) != axis || i + 1 >= line.size()) continue;
    const std::string_view rest = line.substr(i + 1);
    if (begins_value(rest) && rest[0] != 'Q') {
      const std::size_t end = rest.find_first_not_of("+-.0123456789");
      const bool other = end != std::string_view::npos && (rest[end] == ':' || rest[end] == '=');  // the label C1:, the word A3=
      if (!other) return true;
    }
    if (rest[0] == '=' && !is_variable && rest.size() > 1 && rest[1] != '=') return true;
  }
  return false;
}

/// Returns true if a row of DEF or PROC in the text may define a variable with the name of the axis.
bool defines(std::string_view text, char axis) {
  const auto is_letter = [](char c) { return is_capital(to_upper(c)) || c == '_'; };
  for (const std::string_view word : {"DEF ", "PROC "})
    for (std::size_t at = text.find(word); at != std::string_view::npos; at = text.find(word, at + 1)) {
      const std::string_view row = text.substr(at, text.substr(at).find('\n'));
      for (std::size_t i = 1; i < row.size(); ++i)
        if (row[i] == axis && !is_letter(row[i - 1]) && (i + 1 == row.size() || !is_letter(row[i + 1]))) return true;
    }
  return false;
}

/// Gives two assumed rotary axes the kinematics that most machines with them have, so that a tilted plane has rotary positions. Where the
/// axes are, and so where the machine's axes X, Y, Z go, remains unknown.
void assume_kinematics(KinematicsSetup& kinematics, const std::vector<std::string>& axes) {
  std::string rotary;
  for (const std::string& name : axes)
    if (name == "A" || name == "B" || name == "C") rotary += name;
  if (rotary == "AC") kinematics.type = "table-table", kinematics.axes = "AC", kinematics.reversed = "AC";
  else if (rotary == "BC") kinematics.type = "head-table", kinematics.axes = "BC", kinematics.reversed = "C";
}

}  // namespace

void assume_axes(Setup& setup, ByteSource* program, const ControlDef& control) {
  const bool named = control.grammar.named_blocks, conversational = control.grammar.klartext_blocks;
  if (program == nullptr || !(named || conversational) || !setup.axes.empty() || !setup.kinematics.type.empty()) return;
  std::string text(looked_at, '\0');
  text.resize(program->read(0, text.data(), text.size()));
  const std::string_view all = text;
  for (const std::string& name : control.axes) {
    if (name.size() != 1 || name == "X" || name == "Y" || name == "Z") continue;
    const bool is_variable = named && defines(all, name[0]);
    for (std::size_t at = 0; at < all.size();) {
      const std::size_t end = std::min(all.find('\n', at), all.size());
      const std::string_view line = all.substr(at, end - at);
      if (conversational ? moves_conversational(line, name[0]) : moves_named(line, name[0], is_variable)) {
        setup.axes_assumed.push_back(name);
        break;
      }
      at = end + 1;
    }
  }
  if (setup.axes_assumed.empty()) return;
  setup.axes = {"X", "Y", "Z"};
  setup.axes.insert(setup.axes.end(), setup.axes_assumed.begin(), setup.axes_assumed.end());
  assume_kinematics(setup.kinematics, setup.axes_assumed);
}

}  // namespace kadr
