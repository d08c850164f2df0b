// Reads the description of a turning tool in a comment. Used by session/insert_proposals; tested by tests/lang/insert_comment_test.cpp.
//
// A designation of an indexable insert (ISO 1832: CNMG120408; ANSI B212.4: CNMG 432, also shortened, CCGT 3-1) tells shape, edge and nose.
// Words tell what the tool does; a width is a number next to a word such as WIDE, or the only size of a grooving tool.

#include "lang/text/insert_comment.h"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "base/ascii.h"
#include "lang/text/shop_words.h"
#include "lang/text/stock_numbers.h"

namespace kadr {
namespace {

constexpr double greatest_width = 20, least_width = 0.3;  // mm; no grooving insert is wider or narrower
constexpr double greatest_nose = 6.5;                     // mm
constexpr double metric_thread = 60;                      // degrees

struct InsertShape {
  char letter;
  double angle;
  double edge_by_circle;  // length of the edge, as a multiple of the inscribed circle
};
constexpr std::array<InsertShape, 12> insert_shapes = {{{'C', 80, 1.0154},
                                                        {'D', 55, 1.2208},
                                                        {'E', 75, 1.0353},
                                                        {'K', 55, 1.2208},
                                                        {'M', 86, 1.0024},
                                                        {'R', 0, 1},
                                                        {'S', 90, 1},
                                                        {'T', 60, 1.7321},
                                                        {'V', 35, 1.7434},
                                                        {'W', 80, 0.6840},
                                                        {'L', 90, 1},
                                                        {'A', 85, 1.0038}}};

/// Reads the designation of an insert anywhere in a text in capitals.
class CodeReading {
 public:
  explicit CodeReading(std::string text) : text_(std::move(text)) {}

  bool into(InsertComment& found) {
    for (std::size_t i = 0; i + 4 <= text_.size(); ++i) {
      if (!starts_code(i)) continue;
      if (!sizes(i, found)) found.edge.reset();  // CNMG alone tells the shape
      return true;
    }
    return false;
  }

 private:
  char at(std::size_t i) const { return i < text_.size() ? text_[i] : ' '; }
  static bool is_in(std::string_view letters, char c) { return letters.find(c) != std::string_view::npos; }

  bool starts_code(std::size_t i) const {
    const bool alone = i == 0 || !(is_capital(at(i - 1)) || is_digit(at(i - 1)));
    return alone && shape(at(i)) != nullptr && is_in("ABCDEFGNOP", at(i + 1)) && is_in("ACEFGHJKLMNU", at(i + 2)) &&
           is_in("ABCFGHJMNPQRTUWX", at(i + 3)) && !is_capital(at(i + 4));
  }
  static const InsertShape* shape(char letter) {
    const auto* const found =
        std::find_if(insert_shapes.begin(), insert_shapes.end(), [&](const InsertShape& s) { return s.letter == letter; });
    return found == insert_shapes.end() ? nullptr : found;
  }

  /// Reads the figures of the sizes: 120408, 09T304, 12 04 08, 432, 3-2, 32.51.
  bool sizes(std::size_t i, InsertComment& found) const {
    std::string figures;
    bool divided = false;
    std::size_t k = i + 4;
    while (k < text_.size() && is_in(" -.", at(k)) && !is_digit(at(k))) ++k;
    for (; k < text_.size() && figures.size() < 8; ++k) {
      const char c = at(k);
      if (is_digit(c) || (c == 'T' && figures.size() == 2 && is_digit(at(k + 1)))) figures += c;
      else if (is_in(" -.", c) && is_digit(at(k + 1)) && figures.size() < 6) divided = divided || c != '.';
      else break;
    }
    const InsertShape& s = *shape(at(i));
    found.angle = s.angle;
    if (figures.size() >= 6) return metric(figures, s, found);
    if (figures.size() == 4 && s.angle == 0) return metric(figures + "00", s, found);  // RCMT 1204M0
    if (figures.size() == 4 && figures[2] == '5') figures.erase(2, 1);                 // 32.51: thickness 2.5/16
    if (figures.size() == 3) return ansi(figures[0] - '0', figures[2] - '0', s, found);
    if (figures.size() == 2 && divided) return ansi(figures[0] - '0', figures[1] - '0', s, found);
    return false;
  }

  static bool metric(const std::string& figures, const InsertShape& s, InsertComment& found) {
    const double size = (figures[0] - '0') * 10 + (figures[1] - '0'), nose = ((figures[4] - '0') * 10 + (figures[5] - '0')) / 10.0;
    if (size < 3 || nose > greatest_nose) return false;
    found.edge = size;
    found.corner = s.angle == 0 ? size / 2 : nose;
    return true;
  }
  static bool ansi(int eighths, int sixtyfourths, const InsertShape& s, InsertComment& found) {
    if (eighths < 1) return false;
    const double circle = eighths * inch_in_mm / 8;
    found.edge = circle * s.edge_by_circle;
    found.corner = s.angle == 0 ? circle / 2 : sixtyfourths == 0 ? 0.2 : sixtyfourths * inch_in_mm / 64;
    return true;
  }

  const std::string text_;
};

class InsertReading {
 public:
  InsertReading(std::string_view text, bool inch)
      : tokens_(comment_tokens(text)), numbers_(stock_numbers(tokens_)), unit_(inch ? inch_in_mm : 1) {
    for (const CommentToken& t : tokens_) text_ += (t.joined || text_.empty() ? "" : " ") + t.text;
  }

  InsertComment read() const {
    InsertComment found;
    found.has_code = CodeReading(text_).into(found);
    if (!found.has_code && has(not_of_turning)) return {};
    found.work = work(found.has_code);
    if (found.work == InsertWork::none) return {};
    found.inside = has(insert_inside_words);
    found.face = found.work == InsertWork::grooving && has(insert_face_words);
    if (const auto nose = named(insert_nose_after, insert_nose_before, greatest_nose)) found.corner = nose;
    if (found.work == InsertWork::grooving) read_groove(found);
    if (found.work == InsertWork::threading && !found.has_code) found.angle = thread_angle();
    return found;
  }

 private:
  bool has(std::string_view words) const {
    return std::any_of(tokens_.begin(), tokens_.end(),
                       [&](const CommentToken& t) { return t.is == CommentToken::Is::word && is_one_of(words, t.text); });
  }
  bool is_word(std::size_t i, std::string_view words) const {
    return i < tokens_.size() && tokens_[i].is == CommentToken::Is::word && is_one_of(words, tokens_[i].text);
  }
  bool is_sign(std::size_t i, std::string_view signs) const {
    return i < tokens_.size() && tokens_[i].is == CommentToken::Is::sign && signs.find(tokens_[i].text[0]) != std::string_view::npos;
  }
  bool is_pair(std::string_view first, std::string_view second) const {
    for (std::size_t i = 0; i + 1 < tokens_.size(); ++i) {
      const std::size_t next = tokens_[i + 1].is == CommentToken::Is::sign && tokens_[i + 1].text == "-" ? i + 2 : i + 1;
      if (is_word(i, first) && is_word(next, second)) return true;
    }
    return false;
  }

  /// The work of a tool without a designation must be named together with the tool: "OD TURN" alone is an operation, "T1 OD TURN" is a
  /// tool.
  InsertWork work(bool has_code) const {
    const bool names_tool = has_code || has(insert_tool_words) || names_number();
    const bool parts = is_pair("PART", "OFF") || is_pair("CUT", "OFF");
    if (!names_tool && !has(insert_grooving_words) && !parts) return InsertWork::none;
    if (has(insert_threading_words)) return names_tool ? InsertWork::threading : InsertWork::none;
    if (has(insert_grooving_words) || parts) return InsertWork::grooving;
    if (has(insert_boring_words) || (has(insert_id_words) && names_tool)) return InsertWork::boring;
    return has_code || has(insert_turning_words) ? InsertWork::turning : InsertWork::none;
  }
  /// True if the comment names a tool by its number: T1212.
  bool names_number() const {
    for (std::size_t i = 0; i + 1 < tokens_.size(); ++i)
      if (is_word(i, "T") && tokens_[i + 1].is == CommentToken::Is::figure && tokens_[i + 1].joined) return true;
    return false;
  }

  bool has_word_after(const StockNumber& number, std::string_view words) const { return is_word(number.end, words); }
  bool has_word_before(const StockNumber& number, std::string_view words) const {
    std::size_t word = number.first;
    while (word > 0 && is_sign(word - 1, "=:.")) --word;
    return word > 0 && is_word(word - 1, words);
  }
  /// Returns the number that stands before or after one of the words and is at most `most` mm.
  std::optional<double> named(std::string_view after, std::string_view before, double most) const {
    for (const bool is_after : {true, false})
      for (const StockNumber& number : numbers_) {
        const double mm = number.mm(unit_of(number));
        if (mm > 0 && mm <= most && (is_after ? has_word_after(number, after) : has_word_before(number, before))) return mm;
      }
    return std::nullopt;
  }
  /// A number without a unit that begins with a point is in inches (.125 W); metric comments write 0.125 or 3.
  double unit_of(const StockNumber& number) const { return tokens_[number.first].leads_point ? inch_in_mm : unit_; }

  /// Reads the width of a grooving insert: a number next to a word such as WIDE, the designation of an Iscar insert, or the only size.
  void read_groove(InsertComment& found) const {
    found.width = named(insert_width_after, insert_width_before, greatest_width);
    if (!found.width && !read_grip(found)) found.width = only_size();
    if (found.width && *found.width < least_width) found.width.reset();
  }

  /// GRIP 3003Y: 3.0 mm wide, nose radius 0.3; GRIP 318-040Y: 3.18 mm.
  bool read_grip(InsertComment& found) const {
    for (std::size_t i = 0; i + 1 < tokens_.size(); ++i) {
      const std::string& figures = tokens_[i + 1].text;
      if (!is_word(i, "GRIP GRIF DGN DGR DGL HFPR HFPL TGMF") || tokens_[i + 1].is != CommentToken::Is::figure) continue;
      if (figures.size() == 4) {
        found.width = std::stoi(figures.substr(0, 2)) / 10.0;
        if (!found.corner) found.corner = std::stoi(figures.substr(2)) / 10.0;
        return true;
      }
      if (figures.size() == 3) {
        found.width = std::stoi(figures) / 100.0;
        return true;
      }
    }
    return false;
  }

  std::optional<double> only_size() const {
    std::optional<double> only;
    for (const StockNumber& number : numbers_) {
      const CommentToken& token = tokens_[number.first];
      const bool is_word_before = number.first > 0 && tokens_[number.first - 1].is == CommentToken::Is::word;
      const bool is_number_of_tool = number.unit == 0 && is_word_before && is_word(number.first - 1, number_of_tool_words);
      const bool is_nose = has_word_after(number, "NR TNR") || has_word_before(number, insert_nose_before);
      if (is_number_of_tool || (token.joined && is_word_before) || is_nose) continue;
      const double mm = number.mm(unit_of(number));
      const bool is_size = number.unit > 0 || token.has_point || unit_ == 1;
      if (!is_size || mm < least_width || mm > greatest_width) continue;
      if (only) return std::nullopt;
      only = mm;
    }
    return only;
  }

  double thread_angle() const {
    for (const StockNumber& number : numbers_)
      if (number.unit == 0 && (number.value == 55 || number.value == 60 || number.value == 30 || number.value == 29)) return number.value;
    return metric_thread;
  }

  const std::vector<CommentToken> tokens_;
  const std::vector<StockNumber> numbers_;
  const double unit_;  // mm per unit of a number without a unit
  std::string text_;   // the comment in capitals
};

}  // namespace

InsertComment read_insert_comment(std::string_view text, bool inch) { return InsertReading(text, inch).read(); }

}  // namespace kadr
