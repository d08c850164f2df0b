// What a comment says of a tool: "(T1 D8 ENDMILL)", «ФРЕЗА 8», "T01 FREZA D=10 R0.5". For cli/setup_command; tested by
// tests/lang/tool_comment_test.cpp.

#include "lang/text/tool_comment.h"

#include <algorithm>
#include <array>
#include <charconv>

#include "base/ascii.h"
#include "base/units.h"

namespace kadr {
namespace {

/// Capital letters, Russian ones too (UTF-8: а…п are D0 B0…BF, р…я D1 80…8F).
std::string capitals(std::string_view text) {
  std::string out(text);
  for (std::size_t i = 0; i < out.size(); ++i) {
    const auto c = static_cast<unsigned char>(out[i]);
    if (is_lower(out[i])) out[i] = to_upper(out[i]);
    if (i + 1 >= out.size()) continue;
    const auto next = static_cast<unsigned char>(out[i + 1]);
    if (c == 0xD0 && next >= 0xB0 && next <= 0xBF) out[i + 1] = static_cast<char>(next - 0x20);
    if (c == 0xD1 && next >= 0x80 && next <= 0x8F) out[i] = static_cast<char>(0xD0), out[i + 1] = static_cast<char>(next + 0x20);
  }
  return out;
}

bool is_name_letter(char c) { return is_capital(c) || is_high(c); }

/// Words and numbers of a comment, in order.
struct Piece {
  std::string word;  // letters; empty: a number
  double number = 0;
  bool joined = false;  // it follows the piece before without a blank, or after `=`
  bool equals = false;  // after `=`
};

std::vector<Piece> pieces_of(std::string_view text) {
  std::vector<Piece> pieces;
  bool joined = false, equals = false;
  for (std::size_t i = 0; i < text.size();) {
    const char c = text[i];
    const bool point = (c == '.' || c == ',') && i + 1 < text.size() && is_digit(text[i + 1]);
    if (is_digit(c) || point) {
      std::string digits;
      for (bool seen = false; i < text.size() && (is_digit(text[i]) || (!seen && (text[i] == '.' || text[i] == ','))); ++i) {
        const bool is_point = !is_digit(text[i]);
        if (is_point && text[i] == ',' && !(i + 1 < text.size() && is_digit(text[i + 1]))) break;  // D8, R0.5
        seen = seen || is_point;
        digits += is_point ? '.' : text[i];
      }
      double value = 0;
      std::from_chars(digits.data(), digits.data() + digits.size(), value);
      pieces.push_back({"", value, joined, equals});
      joined = true, equals = false;
    } else if (is_name_letter(c) || c == '"') {
      std::string word;
      if (c == '"') word = text[i++];
      else
        for (; i < text.size() && is_name_letter(text[i]); ++i) word += text[i];
      pieces.push_back({word, 0, joined, false});
      joined = true, equals = false;
    } else {
      joined = c == '=' || c == '.' || c == ':' || (joined && equals);
      equals = c == '=' || c == ':';
      ++i;
    }
  }
  return pieces;
}

bool is_among(std::string_view word, std::initializer_list<std::string_view> words) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

bool names_tool_number(std::string_view w) { return is_among(w, {"T", "Т", "TOOL", "ИНСТРУМЕНТ", "ИНСТР"}); }
bool names_diameter(std::string_view w) {
  return is_among(w, {"D", "Д", "DIA", "DIAM", "DIAMETER", "Ø", "ø", "⌀", "Ф", "ДИАМ", "ДИАМЕТР", "DIAMETR"});
}
/// A figure after such a word is its diameter.
bool names_kind(std::string_view w) {
  return is_among(w, {"ФРЕЗА",   "СВЕРЛО", "МЕТЧИК", "ЗЕНКЕР", "РАЗВЕРТКА", "РАЗВЁРТКА", "ЦЕКОВКА",  "FREZA", "SVERLO",  "METCHIK",
                      "ENDMILL", "MILL",   "DRILL",  "TAP",    "REAMER",    "CUTTER",    "BALLNOSE", "BALL",  "CHAMFER", "ФАСОЧНАЯ"});
}
bool names_degrees(std::string_view w) { return is_among(w, {"°", "DEG", "DEGREE", "DEGREES", "ГРАД", "ГРАДУСОВ"}); }

struct KindWord {
  ToolWord kind;
  std::initializer_list<std::string_view> words;
};
/// The first that is found counts: "BALL END MILL", "SPOT DRILL", "CHAMFER MILL".
const KindWord kind_words[] = {
    {ToolWord::ball, {"BALL", "BALLNOSE", "ШАРОВАЯ", "СФЕРИЧЕСКАЯ", "СФЕР", "ШАР"}},
    {ToolWord::chamfer, {"CHAMFER", "CHAMF", "VBIT", "ФАСОЧНАЯ", "ЗЕНКОВКА", "COUNTERSINK"}},
    {ToolWord::taper, {"TAPERED", "КОНИЧЕСКАЯ"}},
    {ToolWord::tap, {"TAP", "TAPPING", "МЕТЧИК", "METCHIK"}},
    {ToolWord::reamer, {"REAMER", "REAM", "РАЗВЕРТКА", "РАЗВЁРТКА"}},
    {ToolWord::drill, {"DRILL", "DRILLING", "СВЕРЛО", "SVERLO", "ЦЕНТРОВКА"}},
    {ToolWord::mill, {"MILL", "ENDMILL", "CUTTER", "ФРЕЗА", "FREZA", "КОНЦЕВАЯ", "SLOTDRILL"}},
};

ToolWord kind_of_pieces(const std::vector<Piece>& pieces) {
  for (const KindWord& k : kind_words)
    for (const Piece& p : pieces)
      if (!p.word.empty() && is_among(p.word, k.words)) return k.kind;
  return ToolWord::none;
}

/// Of the whole point: CAM systems write TAPER=45DEG of a chamfer mill for the half of it.
std::optional<double> angle_of(const std::vector<Piece>& pieces, ToolWord kind) {
  for (std::size_t i = 0; i + 1 < pieces.size(); ++i) {
    if (!pieces[i].word.empty() || !names_degrees(pieces[i + 1].word)) continue;
    const bool is_half = i > 0 && pieces[i - 1].word == "TAPER" && kind != ToolWord::drill;
    const double angle = pieces[i].number * (is_half ? 2 : 1);
    if (angle > 0 && angle < 180) return angle;
  }
  return std::nullopt;
}

/// Factor of the unit that follows, if one does.
std::optional<double> unit_behind(const std::vector<Piece>& pieces, std::size_t at) {
  if (at + 1 >= pieces.size()) return std::nullopt;
  const std::string& unit = pieces[at + 1].word;
  if (is_among(unit, {"MM", "ММ"})) return 1;
  if (is_among(unit, {"IN", "INCH", "\"", "ДЮЙМ"})) return mm_per_inch;
  return std::nullopt;
}

}  // namespace

ToolComment read_tool_comment(std::string_view text, bool inch) {
  const std::vector<Piece> pieces = pieces_of(capitals(text));
  ToolComment found;
  bool has_h = false, diameter_is_number = false;
  found.kind = kind_of_pieces(pieces);
  found.angle = angle_of(pieces, found.kind);
  std::optional<double> radius, of_kind, with_unit;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    if (!pieces[i].word.empty()) continue;
    const double value = pieces[i].number, mm = value * unit_behind(pieces, i).value_or(inch ? mm_per_inch : 1);
    const std::string before = i == 0 ? "" : pieces[i - 1].word;  // ("10mm flat endmill")
    const bool whole = value == static_cast<double>(static_cast<std::uint32_t>(std::min(value, 1e8)));
    if (names_tool_number(before) && whole && !found.tool) found.tool = static_cast<std::uint32_t>(value);
    else if (names_diameter(before) && !found.diameter) {
      found.diameter = mm;
      diameter_is_number = before == "D" && !pieces[i].equals && whole;
    } else if (before == "H") has_h = true;
    else if (is_among(before, {"R", "CR"}) && !radius) radius = mm;
    else if ((names_kind(before) || before == "M" || before == "М") && !of_kind) of_kind = mm;
    else if (unit_behind(pieces, i) && !with_unit) with_unit = mm;
  }
  // (T1 H1 D1): numbers of offsets
  if (diameter_is_number && has_h && found.tool && *found.diameter == *found.tool * (inch ? mm_per_inch : 1)) found.diameter.reset();
  if (!found.diameter) found.diameter = of_kind ? of_kind : with_unit;
  if (!found.diameter && found.kind == ToolWord::ball && radius) found.diameter = 2 * *radius;
  if (radius && (found.diameter || found.tool)) found.corner = radius;
  if (found.diameter && !(*found.diameter > 0)) found.diameter.reset();
  return found;
}

std::vector<std::string> comments_of(std::string_view line) {
  std::vector<std::string> comments;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == ';') {
      comments.emplace_back(line.substr(i + 1));
      break;
    }
    if (line[i] != '(') continue;
    const std::size_t end = std::min(line.find(')', i), line.size());
    comments.emplace_back(line.substr(i + 1, end - i - 1));
    i = end;
  }
  return comments;
}

std::string without_comments(std::string_view line) {
  std::string rest;
  for (std::size_t i = 0; i < line.size() && line[i] != ';'; ++i) {
    if (line[i] == '(') {
      i = std::min(line.find(')', i), line.size() - 1);
      continue;
    }
    rest += line[i];
  }
  const auto from = rest.find_first_not_of(" \t\r"), to = rest.find_last_not_of(" \t\r");
  return from == std::string::npos ? std::string() : rest.substr(from, to - from + 1);
}

}  // namespace kadr
