// Determines the meaning of each number (in the code: figure) in a comment. Used by lang/text/tool_comment; tested by
// tests/lang/tool_comment_test.cpp.
//
// Each function of FigureMarker searches the whole comment for one pattern, and marks the numbers whose meaning is certain. A number that
// no function has marked stays open.

#include "lang/text/tool_figures.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string>

#include "base/ascii.h"
#include "base/units.h"

namespace kadr {
namespace {

using Is = CommentToken::Is;
using enum WordHints;

constexpr double max_wholes = 6;           // greatest number of whole inches before a fraction, as in 1 1/4
constexpr std::size_t longest_size = 3;    // greatest number of digits of a whole size; 1234 is not a size
constexpr std::size_t longest_number = 8;  // greatest number of digits of a tool number T

class FigureMarker {
 public:
  explicit FigureMarker(std::vector<CommentPiece> pieces) : all_(std::move(pieces)) {}

  std::vector<CommentPiece> marked() {
    read_abbreviations();
    take_units();
    mark_names();
    mark_tool_numbers();
    mark_next_to_words();
    join_wholes_and_fractions();
    mark_threads();
    mark_chains_of_numbers();
    mark_signed();
    mark_diameters();
    mark_corners();
    mark_angles();
    mark_second_sizes();
    mark_numbers_of_drills();
    mark_clauses();
    return std::move(all_);
  }

 private:
  std::size_t count() const { return all_.size(); }
  // Returns true if the index is that of a piece; the index before the first piece wraps around, so it is too large.
  bool has(std::size_t i) const { return i < all_.size(); }
  bool is_figure(std::size_t i) const { return has(i) && all_[i].is_figure(); }
  bool is_open(std::size_t i) const { return has(i) && all_[i].is_open(); }
  bool is_sign(std::size_t i, char c) const { return has(i) && all_[i].is_sign(c); }
  bool means(std::size_t i, WordHints what) const { return has(i) && all_[i].meaning.is(what); }
  bool joined(std::size_t i) const { return has(i) && all_[i].joined; }
  static bool is_letter(const CommentPiece& p) { return p.is_word() && (p.text.size() == 1 || (p.text.size() == 2 && is_high(p.text[0]))); }
  /// Returns true for a dash between blanks.
  bool is_free_dash(std::size_t i) const { return is_sign(i, '-') && !joined(i) && !joined(i + 1); }

  /// Returns the index of the next piece after `i`, skipping signs in `between`.
  std::size_t index_after(std::size_t i, std::string_view between) const {
    for (++i; has(i) && all_[i].is == Is::sign && between.find(all_[i].text[0]) != std::string_view::npos;) ++i;
    return i;
  }

  void read_abbreviations();
  void take_units();
  bool is_unit(std::size_t figure, std::size_t at) const;
  void mark_names();
  bool is_part_of_name(std::size_t i) const;
  void mark_tool_numbers();
  void mark_next_to_words();
  void mark_by_word(std::size_t word);
  bool is_called(std::size_t figure) const;
  void join_wholes_and_fractions();
  void mark_threads();
  void mark_inch_thread(std::size_t size);
  void mark_chains_of_numbers();
  void mark_signed();
  void mark_diameters();
  std::size_t figure_called_by(std::size_t word) const;
  void mark_corners();
  void mark_angles();
  void mark_second_sizes();
  void mark_numbers_of_drills();
  void mark_clauses();

  std::vector<CommentPiece> all_;
};

/// Merges the point of NO.17 into the word NO.
void FigureMarker::read_abbreviations() {
  for (std::size_t i = 1; i < count(); ++i) {
    CommentPiece& f = all_[i];
    if (!is_figure(i) || !f.leads_point || !f.joined || !means(i - 1, number | tool_number)) continue;
    f.text.erase(0, 1);
    f.value = 0;
    std::from_chars(f.text.data(), f.text.data() + f.text.size(), f.value);
    f.has_point = f.leads_point = false;
  }
}

/// Returns true if the word at `at` is the unit of the number at `figure`. IN is a unit only if it cannot be the preposition: not in "4 IN
/// VISE", but in "1/4 IN DRILL" and ".5IN".
bool FigureMarker::is_unit(std::size_t figure, std::size_t at) const {
  if (!means(at, unit_mm | unit_inch)) return false;
  if (all_[at].text == "\"") return joined(at) || !joined(at + 1);  // in T5 "F" DRILL the sign is a quotation mark, not inches
  if (all_[at].text != "IN" || joined(at)) return true;
  const CommentPiece& f = all_[figure];
  const bool goes_on_with_tool = !has(at + 1) || all_[at + 1].is == Is::sign || means(at + 1, tool | part_of_name | describes);
  return f.is_fraction || f.has_point || goes_on_with_tool;
}

/// Merges units into their numbers: 6MM, 4-INCH, {6 mm}, 1/2". A number with the unit of a speed (250 MM/MIN) is not a length.
void FigureMarker::take_units() {
  bool braced = false;
  for (std::size_t i = 0; i < count(); ++i) {
    braced = is_sign(i, '{') || (braced && !is_sign(i, '}'));
    if (!is_figure(i)) continue;
    all_[i].braced = braced;
    const bool hyphen = is_sign(i + 1, '-') && joined(i + 1) && joined(i + 2);
    const std::size_t at = i + (hyphen ? 2 : 1);
    if (!is_unit(i, at)) continue;
    all_[i].unit = means(at, unit_mm) ? 1 : mm_per_inch;
    if (is_sign(at + 1, '/')) all_[i].figure = FigureIs::other;
    const bool mm_of_fraction = all_[i].is_fraction && all_[i].unit == 1;  // in 1/2MM the mm is not a unit, because no tool has this size
    if (mm_of_fraction) all_[i].figure = FigureIs::other;
    all_.erase(all_.begin() + static_cast<std::ptrdiff_t>(i) + 1, all_.begin() + static_cast<std::ptrdiff_t>(at) + 1);
  }
}

/// Returns true for a number that belongs to a name: EM10, 635BIT, 1_2MM, ENDMILL001, 6061AL. A fraction or a leading decimal point
/// separates a number from a word: DRILL.828, BAR5/8.
bool FigureMarker::is_part_of_name(std::size_t i) const {
  const CommentPiece& f = all_[i];
  if (f.is_broken) return true;
  const bool whole = !f.has_point && !f.is_fraction;
  const bool zeros = whole && f.text.size() > 1 && f.text[0] == '0';
  const bool too_long = whole && f.text.size() > longest_size && f.unit == 0;
  const bool after_t = i > 0 && means(i - 1, tool_number);
  if ((zeros || too_long) && !after_t) return true;
  const bool chained = (f.underscored && is_figure(i - 1)) || (has(i + 1) && all_[i + 1].underscored && is_figure(i + 1));
  if (chained || (f.underscored && whole && f.unit == 0)) return true;
  const WordHints called = means_diameter | means_corner | number | tool_number | times | other_before | other_after | degrees | unit_mm;
  if (f.joined && i > 0 && all_[i - 1].is_word() && !is_letter(all_[i - 1]) && !means(i - 1, called) && !f.is_fraction && !f.leads_point &&
      f.unit == 0)
    return true;
  if (!joined(i + 1) || !all_[i + 1].is_word() || f.unit != 0) return false;
  const bool tolerance = all_[i + 1].text == "H" || all_[i + 1].text == "Н";  // in the comment 10H7, H7 is a tolerance
  return !tolerance && !means(i + 1, called | describes | of_tool) &&
         !(is_letter(all_[i + 1]) && (all_[i + 1].text == "F" || all_[i + 1].text == "Z"));
}

void FigureMarker::mark_names() {
  for (std::size_t i = 0; i < count(); ++i)
    if (is_open(i) && is_part_of_name(i)) all_[i].figure = FigureIs::other;
}

/// Marks tool numbers: T1, T 1, TOOL 4, TOOL #2, TOOL - 6, TOOL -3-. Numbers in X-T3, TOOL 1/2 and TOOL 6MM are not marked.
void FigureMarker::mark_tool_numbers() {
  for (std::size_t i = 0; i < count(); ++i) {
    if (!means(i, tool_number) || !all_[i].is_word()) continue;
    const bool is_t = is_letter(all_[i]);
    const bool in_name = joined(i) && i > 0 && !all_[i - 1].is_sign('|') && !all_[i - 1].is_sign('(') && !all_[i - 1].is_sign(',');
    std::size_t at = index_after(i, is_t ? "" : "-#:=.");
    if (!is_t && means(at, number)) at = index_after(at, ".#");
    // In the comment DEFAULT TOOL001, 001 is a part of a name, not a tool number.
    const bool zeros = !is_t && joined(at) && at == i + 1 && all_[at].text.starts_with("00");
    const bool is_turned = means(at + 1, degrees);  // in the comment ENGRAVING TOOL 30 DEGREE, 30 is an angle
    const bool is_number = !zeros && !is_turned && is_open(at) && !all_[at].has_point && !all_[at].is_fraction && all_[at].unit == 0 &&
                           all_[at].text.size() <= longest_number;
    if (!in_name && is_number) all_[at].figure = FigureIs::tool;
  }
}

/// Marks numbers by the words next to them, which define their meaning: 4FL, LOC 1.5, S2000, ZMIN=-5.
void FigureMarker::mark_next_to_words() {
  for (std::size_t i = 0; i < count(); ++i)
    if (means(i, other_before | other_after | is_numbered)) mark_by_word(i);
  for (std::size_t i = 0; i < count(); ++i) {
    const CommentPiece& word = all_[i];
    if (!word.is_word()) continue;
    const WordHints known =
        means_diameter | means_corner | tool_number | tool | letter | number | is_numbered | times | other_after | degrees;
    const bool is_address = is_letter(word) && !word.meaning.is(known) && word.text != "M" && word.text != "М" && word.text != "F";
    const std::size_t at = index_after(i, is_address ? "=-" : "-");
    // In the comments S2000, Z-.5, H7 the letter is the address of a word, so the number is not a size.
    if (is_address && is_open(at) && joined(i + 1)) all_[at].figure = FigureIs::other;
    const bool is_f = word.text == "F" && i > 0 && !means(i - 1, tool);  // F gives a feed, but in SVERLO F8.5 a diameter
    if (is_f && is_open(i + 1) && joined(i + 1)) all_[i + 1].figure = FigureIs::other;
    // In the comments 3F and 2Z the number is a count of flutes.
    const bool counts = (word.text == "F" || word.text == "Z") && word.joined && i > 0 && is_open(i - 1);
    if (counts) all_[i - 1].figure = FigureIs::other;
    if (is_sign(i + 1, '=') && !word.meaning.is(known))  // after an unknown word, as in L=75 and ID=7, the number is not a size
      if (const std::size_t value = index_after(i, "=-+"); is_open(value)) all_[value].figure = FigureIs::other;
  }
}

/// Returns true if the word before the number already gives the meaning of the number. In DIA .5 LOC 1.0 the .5 does not belong to LOC.
bool FigureMarker::is_called(std::size_t figure) const {
  std::size_t i = figure - 1;
  while (has(i) && all_[i].is == Is::sign && !is_sign(i, '|') && !is_sign(i, ',')) --i;
  return means(i, means_diameter | means_corner | other_after) && !is_figure(i - 1);
}

void FigureMarker::mark_by_word(std::size_t word) {
  // Index of the number that is before the word, with or without a hyphen between them, as in 2-FLUTE.
  const std::size_t before = is_sign(word - 1, '-') && joined(word) && joined(word - 1) ? word - 2 : word - 1;
  const std::size_t at = index_after(word, ".:=-#");
  const bool is_equal = is_sign(word + 1, '=') && is_open(at);
  if (means(word, other_before) && is_open(before) && !is_called(before) && !is_equal) {
    all_[before].figure = FigureIs::other;
    return;
  }
  if (!is_open(at)) return;
  const bool whole = !all_[at].has_point && !all_[at].is_fraction;
  const bool divided = is_sign(word + 1, ':');  // in the comment OPERATION: 1.5MM ENDMILL the colon separates both
  const bool is_number = all_[at].unit == 0 && (whole || !divided);
  if (means(word, other_after) || (means(word, is_numbered) && is_number)) all_[at].figure = FigureIs::other;
}

/// Joins a whole number and the fraction after it: 1 1/4, 1-1/4.
void FigureMarker::join_wholes_and_fractions() {
  for (std::size_t i = 0; i < count(); ++i) {
    const CommentPiece whole = all_[i];
    if (!is_open(i) || whole.has_point || whole.is_fraction || whole.unit != 0 || whole.value > max_wholes || whole.value < 1) continue;
    const bool hyphen = is_sign(i + 1, '-') && joined(i + 1) && joined(i + 2);
    const std::size_t at = i + (hyphen ? 2 : 1);
    if (!is_open(at) || !all_[at].is_fraction || means(i - 1, number)) continue;
    all_[at].value += whole.value;
    all_[at].joined = whole.joined;
    all_.erase(all_.begin() + static_cast<std::ptrdiff_t>(i), all_.begin() + static_cast<std::ptrdiff_t>(at));
  }
}

/// Marks threads: M8, 1/4-20, .250-20, #8-32, NO. 6-32.
void FigureMarker::mark_threads() {
  for (std::size_t i = 0; i < count(); ++i) {
    if (!is_open(i)) continue;
    const bool is_metric = joined(i) && i > 0 && (all_[i - 1].text == "M" || all_[i - 1].text == "М") && all_[i].unit == 0;
    const bool is_counted = i > 1 && means(i - 2, times) && i > 2 && is_figure(i - 3);  // in the comment 4 X M6, 4 is a count
    if (is_metric) all_[i].figure = is_counted ? FigureIs::other : FigureIs::metric;
    else mark_inch_thread(i);
  }
}

void FigureMarker::mark_inch_thread(std::size_t size) {
  const bool hyphen = is_sign(size + 1, '-') && joined(size + 1) && joined(size + 2);
  const bool ends = !is_sign(size + 3, '-') || !joined(size + 3);
  if (!hyphen || !is_open(size + 2) || !ends || all_[size].unit == 1 || all_[size + 2].unit != 0) return;
  if (is_sign(size - 1, '-') && joined(size)) return;  // in the comment 3-10-32 no number is marked as a thread
  // In the comment 4.00-0.7 the size is not in inches.
  const bool is_inches = all_[size].is_fraction || all_[size].leads_point || !all_[size].has_point;
  if (!is_inches || all_[size + 2].is_fraction || all_[size + 2].leads_point) return;
  all_[size].figure = FigureIs::inch_thread;
  all_[size].threads = all_[size + 2].value;
  all_[size + 2].figure = FigureIs::other;
}

/// Marks chains of numbers that are not sizes, such as 03-0086, 2016-01-30, 10:30, A881-02. A dash next to a word about a tool is only a
/// separator: DIA-0.5, .500-DRILL.
void FigureMarker::mark_chains_of_numbers() {
  for (std::size_t i = 1; i + 1 < count(); ++i) {
    if (!(is_sign(i, '-') || is_sign(i, ':')) || !joined(i) || !joined(i + 1)) continue;
    const bool both = is_figure(i - 1) && is_figure(i + 1);
    const bool thread = both && all_[i - 1].figure == FigureIs::inch_thread;
    if (both && !thread)
      for (const std::size_t at : {i - 1, i + 1})
        if (is_open(at)) all_[at].figure = FigureIs::other;
    const bool divides = means(i - 1, means_diameter | means_corner | tool) || all_[i].is_sign(':');
    if (is_open(i + 1) && all_[i - 1].is_word() && !divides) all_[i + 1].figure = FigureIs::other;
  }
}

/// Marks numbers with a sign, such as -.0002 and +.0005, which are differences. In -1/2 the sign is only a dash before a size.
void FigureMarker::mark_signed() {
  for (std::size_t i = 1; i < count(); ++i) {
    const bool sign = is_sign(i - 1, '+') || (is_sign(i - 1, '-') && !joined(i - 1));
    if (sign && joined(i) && is_open(i) && !all_[i].is_fraction) all_[i].figure = FigureIs::other;
  }
}

/// Returns the index of the number that the word DIA refers to. It is the number after DIA in DIA 20, DIA-0.5, DIA. - .75, D=8.; if there
/// is none, the number before DIA: .828 DIA.
std::size_t FigureMarker::figure_called_by(std::size_t word) const {
  const bool is_single = is_letter(all_[word]);
  const std::size_t at = index_after(word, is_single ? "=:." : "=:.-");
  const bool by_sign = is_open(at) && (is_sign(at - 1, '=') || is_sign(at - 1, ':') || is_sign(at - 1, '-') || joined(at));
  const bool before_is_free = word > 0 && is_open(word - 1) && !is_single;
  // In the comment 1" IN DIAMETER the word IN is a preposition, not a unit.
  const bool in_diameter = word > 1 && all_[word - 1].text == "IN" && is_open(word - 2);
  if (by_sign || (is_open(at) && !before_is_free)) return at;
  return before_is_free ? word - 1 : in_diameter ? word - 2 : count();
}

void FigureMarker::mark_diameters() {
  for (std::size_t i = 0; i < count(); ++i) {
    const bool is_f = all_[i].text == "F" && i > 0 && means(i - 1, tool);  // in SVERLO F8.5 the F is a diameter sign
    if (!means(i, means_diameter) && !is_f) continue;
    if (all_[i].text == "SIZE" && !means(i - 1, tool)) continue;
    if (is_letter(all_[i]) && joined(i) && is_sign(i - 1, '-')) continue;  // A881-D0812 is a part of a name, so D is not a diameter sign
    const std::size_t at = figure_called_by(i);
    if (!has(at)) continue;
    all_[at].figure = means(i - 1, no_diameter) ? FigureIs::other : FigureIs::diameter;
    all_[at].named = is_sign(at - 1, '=');
  }
}

/// Marks corner radii: CR=0.5, R.06, .030R, 0.125 RAD, TIP RAD.: 4.
void FigureMarker::mark_corners() {
  for (std::size_t i = 0; i < count(); ++i) {
    if (!means(i, means_corner) || !all_[i].is_word()) continue;
    const bool is_single = is_letter(all_[i]);
    const std::size_t at = index_after(i, "=:.");
    const bool by_sign = is_open(at) && (is_sign(at - 1, '=') || is_sign(at - 1, ':') || joined(at));
    const bool before = i > 0 && is_open(i - 1) && (!is_single || joined(i));
    if (by_sign) all_[at].figure = FigureIs::corner;
    else if (before) all_[i - 1].figure = FigureIs::corner;
    else if (is_open(at) && !is_single) all_[at].figure = FigureIs::corner;
  }
}

/// Marks point angles: 90 DEG, 90-DEG.
void FigureMarker::mark_angles() {
  for (std::size_t i = 1; i < count(); ++i) {
    if (!means(i, degrees)) continue;
    const std::size_t at = is_sign(i - 1, '-') ? i - 2 : i - 1;
    if (is_figure(at) && (is_open(at) || means(at - 1, times) || is_sign(at - 1, '='))) all_[at].figure = FigureIs::angle;
  }
}

/// Marks second sizes. In A X B the second number is a length, an angle or a width; in 4X the number is a count.
void FigureMarker::mark_second_sizes() {
  for (std::size_t i = 1; i + 1 < count(); ++i) {
    if (!means(i, times) && !is_sign(i, '*')) continue;
    const bool counts = is_open(i - 1) && joined(i) && !joined(i + 1) && all_[i - 1].unit == 0 && !all_[i - 1].is_fraction;
    if (counts) all_[i - 1].figure = FigureIs::other;
    else if (is_open(i + 1)) all_[i + 1].figure = FigureIs::other;
  }
}

/// Marks numbers of drills: #7, NO. 7, NUMBER 7. The 26 in "No. 26: …" is not marked.
void FigureMarker::mark_numbers_of_drills() {
  for (std::size_t i = 0; i < count(); ++i) {
    if (!means(i, number)) continue;
    const std::size_t at = index_after(i, ".#");
    if (!is_open(at)) continue;
    const bool is_plain = !all_[at].has_point && !all_[at].is_fraction && all_[at].unit == 0 && !is_sign(at + 1, ':');
    const bool is_of_part = i > 0 && means(i - 1, of_part | is_numbered);  // in the comment PART NO. 7, 7 is not a drill number
    all_[at].figure = is_plain && !is_of_part ? FigureIs::drill_number : FigureIs::other;
  }
}

void FigureMarker::mark_clauses() {
  std::uint32_t clause = 0;
  bool another_begun = false;
  for (std::size_t i = 0; i < count(); ++i) {
    const bool divides = all_[i].is == Is::sign && std::string_view("|,;").find(all_[i].text[0]) != std::string_view::npos;
    if (divides || is_free_dash(i)) another_begun = false;
    if (divides || is_free_dash(i) || is_sign(i, ':')) ++clause;
    another_begun = another_begun || (means(i, another) && !is_sign(i + 1, '='));
    all_[i].clause = clause, all_[i].of_another = another_begun;
  }
}

/// Splits the last letter off a word if the rest of the word names a tool. ENDMILLD10 becomes ENDMILL D10, and СВЕРЛОФ8,5 becomes СВЕРЛО
/// Ф8,5.
std::vector<CommentToken> with_letters_divided(std::vector<CommentToken> tokens) {
  for (std::size_t i = 0; i + 1 < tokens.size(); ++i) {
    std::string& word = tokens[i].text;
    if (tokens[i].is != Is::word || tokens[i + 1].is != Is::figure || !tokens[i + 1].joined || meaning_of(word).means != no_meaning)
      continue;
    const std::size_t letter = is_high(word.back()) ? 2 : 1;  // length of the letter in bytes
    if (word.size() <= letter || !meaning_of(word.substr(0, word.size() - letter)).is(tool)) continue;
    CommentToken last{Is::word, word.substr(word.size() - letter)};
    last.joined = true;
    word.resize(word.size() - letter);
    tokens.insert(tokens.begin() + static_cast<std::ptrdiff_t>(i) + 1, std::move(last));
  }
  return tokens;
}

}  // namespace

std::vector<CommentPiece> comment_pieces(std::string_view text) {
  std::vector<CommentPiece> pieces;
  for (const CommentToken& token : with_letters_divided(comment_tokens(text))) {
    CommentPiece piece;
    static_cast<CommentToken&>(piece) = token;
    if (!piece.is_figure()) piece.meaning = meaning_of(piece.text);
    pieces.push_back(std::move(piece));
  }
  return FigureMarker(std::move(pieces)).marked();
}

}  // namespace kadr
