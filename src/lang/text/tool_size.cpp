// Finds the number in a comment that is the size of its tool. Used by lang/text/tool_comment; tested by tests/lang/tool_comment_test.cpp.

#include "lang/text/tool_size.h"

#include <algorithm>
#include <cmath>

#include "base/ascii.h"
#include "base/units.h"
#include "lang/text/drill_sizes.h"

namespace kadr {
namespace {

using enum WordHints;

// The limits for a number without a unit. A number beyond them is in the other unit, or is not a size.
constexpr double max_inches = 3, most_inches_wide = 8;  // greatest size in inches of a tool, and of a face mill or saw
constexpr std::uint8_t decimals_of_inches = 4;          // a number with four decimals, such as 0.5000, is in inches
// Least and greatest size of a tool, mm; a number below the least size is mostly in inches (.375).
constexpr double least_mm = 0.5, max_mm = 160;
constexpr double max_drill_mm = 80;  // greatest size of a drill, mm
// Least whole number that is a size in mm; a smaller one counts tools: 1 END MILL is the first end mill.
constexpr double least_whole_mm = 3;
constexpr double most_of_any = 400;     // greatest size of any tool, mm, even for a number with a unit
constexpr double least_chamfer_mm = 3;  // least size of a chamfer mill, mm; a smaller number is the size of the chamfer
// Greatest difference, as a fraction of the size and in mm, at which two sizes in one comment count as the same size, as 27/64 and .422.
constexpr double alike_part = 0.01, alike_mm = 0.05;
// Greatest difference, as a fraction of the size, between 10 in D10 and the size in the tool's name. If the difference is greater, 10 is an
// offset number.
constexpr double roughly_part = 0.1;
constexpr std::size_t max_strangers = 2;  // greatest number of unknown words between a size and the tool: 2" MITSUBISHI FACE MILL

bool agree(double a, double b, double part) { return std::fabs(a - b) <= std::max(alike_mm, part * std::max(a, b)); }

std::optional<double> only_one(const std::vector<double>& sizes) {
  for (const double size : sizes)
    if (!agree(size, sizes.front(), alike_part)) return std::nullopt;
  return sizes.empty() ? std::nullopt : std::optional(sizes.front());
}

/// Returns true for usual point angles in degrees: 90 in 90 SPOT DRILL.
bool is_usual_angle(double value) {
  constexpr double angles[] = {45, 60, 82, 90, 100, 118, 120, 130, 135, 140, 142, 145};
  return std::find(std::begin(angles), std::end(angles), value) != std::end(angles);
}

/// Recognises inches by the spelling. Numbers such as .375 and 0.5000 are not used for millimetres.
bool looks_like_inches(const CommentPiece& f) { return f.leads_point || (f.decimals == decimals_of_inches && f.value <= max_inches); }

}  // namespace

ToolSize::ToolSize(const std::vector<CommentPiece>& pieces, const ToolNames& names, bool inch)
    : pieces_(pieces), names_(names), inch_(inch), kind_(names.kind()) {
  const bool centres = names.any(centre) && kind_ == ToolWord::drill;
  const bool mills_threads = names.any(threads) && kind_ != ToolWord::tap && kind_ != ToolWord::drill;
  const bool pipes = kind_ == ToolWord::tap && names.any(pipe);
  has_no_size_ = centres || mills_threads || pipes || names.any(rounds | not_nominal) || names_two_works();
  is_wide_ = names_.any(wide);
  is_disc_ = names_.any(disc);
}

/// Returns true for comments such as DRILL AND TAP 1/4-20, or 8-32 TAP #29 DRILL. Their tool may be the drill or the tap.
bool ToolSize::names_two_works() const {
  bool drills = false, taps = false;
  for (const ToolName& name : names_.all()) drills = drills || name.kind == ToolWord::drill, taps = taps || name.kind == ToolWord::tap;
  return drills && taps;
}

double ToolSize::mm(const CommentPiece& f) const {
  const double unit = f.unit != 0 ? f.unit : f.is_fraction || inch_ ? mm_per_inch : 1;
  return f.value * unit;
}

bool ToolSize::is_measured(const CommentPiece& f) const { return f.unit != 0 || f.is_fraction; }
bool ToolSize::is_whole(const CommentPiece& f) const { return !f.has_point && !f.is_fraction; }

/// Returns true if the number, as written, can be the size of a tool of this type.
bool ToolSize::is_likely(const CommentPiece& f) const {
  if (!(f.value > 0) || mm(f) > most_of_any) return false;
  if (is_measured(f)) return true;
  if (inch_) return !is_whole(f) && f.value <= (is_wide_ ? most_inches_wide : max_inches);
  const bool fits = f.value >= least_mm && f.value <= (kind_ == ToolWord::drill ? max_drill_mm : max_mm);
  return fits && !looks_like_inches(f) && (!is_whole(f) || f.value >= least_whole_mm);
}

std::optional<double> ToolSize::diameter() const {
  const Sizes called = this->called();
  if (!called.empty()) return only_one(called);
  if (has_no_size_) return std::nullopt;
  Sizes sizes = in_names();
  if (sizes.empty()) sizes = after_names();
  if (sizes.empty()) sizes = without_name();
  return only_one(sizes);
}

// ---- numbers that the comment calls the diameter

ToolSize::Sizes ToolSize::called() const {
  Sizes sizes;
  for (std::size_t i = 0; i < pieces_.size(); ++i)
    if (is(i, FigureIs::diameter) && is_called(i)) sizes.push_back(mm(pieces_[i]));
  return sizes;
}

bool ToolSize::is_called(std::size_t i) const {
  const CommentPiece& f = pieces_[i];
  if (f.of_another || !(f.value > 0) || is_of_part(i) || is_offset(i) || !speaks_of_tool(i)) return false;
  if (f.named || is_measured(f)) return true;
  if (inch_) return is_whole(f) ? f.value <= max_inches : f.value <= most_inches_wide;
  return f.value >= least_mm && f.value <= most_of_any && !looks_like_inches(f);
}

/// Returns true if the number after D is an offset number, as in T1 H1 D1. In this case D has neither `=` nor a decimal point, and the
/// comment has an H with the same number, or with a number that is not the tool number.
bool ToolSize::is_offset(std::size_t i) const {
  const CommentPiece& d = pieces_[i];
  const bool is_d = i > 0 && (pieces_[i - 1].text == "D" || pieces_[i - 1].text == "Д");
  if (!is_d || !is_whole(d) || d.named || d.unit != 0) return false;
  for (std::size_t at = 0; at < i; ++at)
    if (means(at, offset) && pieces_[at].clause == d.clause) return true;
  const auto tool = std::find_if(pieces_.begin(), pieces_.end(), [](const CommentPiece& p) { return p.figure == FigureIs::tool; });
  bool has_h = false;
  for (std::size_t at = 1; at < pieces_.size(); ++at) {
    const bool is_fit = at == i + 2 && kind_ == ToolWord::reamer;  // in the comment D10 H7, H7 is the tolerance of a reamer
    if (!pieces_[at].is_figure() || pieces_[at - 1].text != "H" || is_fit) continue;
    has_h = true;
    const bool of_tool_alone = tool != pieces_.end() && pieces_[at].value == tool->value && pieces_[at].value != d.value;
    if (!of_tool_alone || names_.all().empty()) return true;
  }
  const Sizes sizes = has_h ? in_names() : Sizes();
  return std::any_of(sizes.begin(), sizes.end(), [&](double size) { return !agree(size, mm(d), roughly_part); });
}

/// Returns true if the number describes the workpiece. The sign of this is a word before the number in its clause, or the word after the
/// number: DRILL .25 HOLES.
bool ToolSize::is_of_part(std::size_t figure) const {
  for (std::size_t i = 0; i < figure; ++i)
    if (pieces_[i].clause == pieces_[figure].clause && means(i, of_part)) return true;
  std::size_t after = figure + 1;
  while (has(after) && !pieces_[after].is_word()) ++after;
  if (means(after, means_diameter)) ++after;
  while (has(after) && !pieces_[after].is_word()) ++after;
  return means(after, of_part) && pieces_[after].clause == pieces_[figure].clause;
}

/// Returns false for comments that are not about a tool, such as (.500 DIAMETER), (STOCK D50).
bool ToolSize::speaks_of_tool(std::size_t figure) const {
  if (!names_.all().empty() || names_.any(of_tool)) return true;
  // true: the comment is a row of a tool library, such as 25 = name d=10
  const bool listed = pieces_.size() > 1 && pieces_[0].is_figure() && pieces_[1].is_sign('=');
  const auto names_tool = [](const CommentPiece& p) { return p.meaning.is(tool_number) && p.text.size() > 2; };
  std::size_t word = figure;
  while (word > 0 && !pieces_[word].is_word()) --word;
  const bool is_d = pieces_[word].text == "D" || pieces_[word].text == "Д";
  // In the comment (D1 - TOOL IN SPINDLE), only the part before the number is searched for the name of a tool.
  const auto end = is_d ? pieces_.begin() + static_cast<std::ptrdiff_t>(figure) : pieces_.end();
  const bool is_stated = std::any_of(pieces_.begin(), end, names_tool) && !names_.any(of_part);
  const bool next_to_number = is_d && std::any_of(pieces_.begin(), end, [](const CommentPiece& p) { return p.figure == FigureIs::tool; });
  return listed || is_stated || next_to_number;
}

// ---- numbers in the name of the tool

ToolSize::Sizes ToolSize::in_names() const {
  Sizes sizes;
  for (std::size_t i = 0; i < pieces_.size(); ++i)
    if (is(i, FigureIs::open) && pieces_[i].braced && is_measured(pieces_[i]) && !names_.all().empty()) return {mm(pieces_[i])};
  add_threads(sizes);
  add_named_drills(sizes);
  for (const ToolName& name : names_.all())
    if (const auto figure = before(name)) sizes.push_back(mm(pieces_[*figure]));
  return sizes;
}

/// Returns the index of the next open number before the name. Words that describe a tool and a few unknown words may be between the number
/// and the name.
std::optional<std::size_t> ToolSize::before(const ToolName& name) const {
  std::size_t strangers = 0;
  for (std::size_t i = name.first; i-- > 0;) {
    const CommentPiece& p = pieces_[i];
    if (p.of_another) return std::nullopt;
    if (p.is_figure()) {
      if (p.figure == FigureIs::open) return fits_before(i, name, strangers > 0) ? std::optional(i) : std::nullopt;
      if (p.figure == FigureIs::tool) return std::nullopt;
    } else if (p.is_word()) {
      const bool goes_on =
          p.meaning.is(describes | part_of_name | other_before | other_after | degrees | times | unit_mm | means_diameter | means_corner);
      const bool is_name = p.meaning.is(tool);
      if (p.meaning.is(ends_phrase | of_part | another) || is_name) return std::nullopt;
      const bool is_fit =
          // In the comment 8H7, H7 is a tolerance.
          p.joined && pieces_[i - 1].is_figure() && has(i + 1) && pieces_[i + 1].joined && pieces_[i + 1].is_figure();
      if (!goes_on && !is_fit && ++strangers > max_strangers) return std::nullopt;
    } else if (std::string_view("-\"*#.]})'").find(p.text[0]) == std::string_view::npos) {
      return std::nullopt;
    }
  }
  return std::nullopt;
}

bool ToolSize::fits_before(std::size_t at, const ToolName& name, bool strangers) const {
  const CommentPiece& f = pieces_[at];
  if (name.only_called || is_of_part(at) || !is_likely(f)) return false;
  if (name.no_bare_size && !is_measured(f)) return false;
  // In the comment 1/4 TAP DRILL the number is the size of the tap.
  if (name.is_tap_drill && (f.is_fraction || (is_whole(f) && f.unit == 0))) return false;
  const bool of_two =
      means(at - 1, joins) || means(at + 1, joins) || (at > 1 && pieces_[at - 1].is_sign('/') && is(at - 2, FigureIs::open));
  if (of_two) return false;  // the comment 3/8 OR 1/2 gives the sizes of two tools
  const CommentPiece* const second = has(at + 2) && means(at + 1, times) && pieces_[at + 2].is_figure() ? &pieces_[at + 2] : nullptr;
  if (name.kind == ToolWord::chamfer && (mm(f) < least_chamfer_mm || (second != nullptr && second->value == 45))) return false;
  if (second != nullptr && is_disc_ && mm(*second) >= mm(f)) return false;  // the larger size of a slot mill or key cutter is its diameter
  if (is_measured(f) || !is_whole(f)) return true;
  const bool angle = is_usual_angle(f.value) && (name.kind == ToolWord::drill || name.kind == ToolWord::chamfer);
  // In the comment 3 - ENDMILL, 3 is a number in a list.
  const bool listed = has(at + 1) && (pieces_[at + 1].is_sign('-') || pieces_[at + 1].is_sign('.'));
  const bool after_stranger = at > 0 && pieces_[at - 1].is_word() && pieces_[at - 1].meaning.means == no_meaning;
  return !angle && !listed && !strangers && !after_stranger && name.kind != ToolWord::tap;
}

void ToolSize::add_threads(Sizes& sizes) const {
  if (kind_ != ToolWord::tap) return;
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    const CommentPiece& f = pieces_[i];
    if (!f.is_figure() || f.of_another || is_of_part(i)) continue;
    if (f.figure == FigureIs::metric && is_metric_thread(f.value)) sizes.push_back(f.value);
    if (f.figure != FigureIs::inch_thread) continue;
    if (const auto size = inch_thread(f.value, f.threads)) sizes.push_back(*size);
  }
}

/// Adds the sizes of drills that are named by number or letter: #7 DRILL, DRILL #4, LETTER F DRILL, B DRILL, DRILL Q. This is done only in
/// inch programs, in which such drills are used.
void ToolSize::add_named_drills(Sizes& sizes) const {
  if (!inch_ || kind_ == ToolWord::tap) return;
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    if (pieces_[i].of_another) continue;
    std::optional<double> size;
    if (is(i, FigureIs::drill_number) && names_drill(i)) size = numbered_drill(static_cast<std::uint32_t>(pieces_[i].value));
    if (const auto letter = letter_of_drill(i)) size = lettered_drill(pieces_[*letter].text[0]);
    if (size) sizes.push_back(*size);
  }
}

/// Returns true if the word DRILL is after the piece `at`, with or without words that describe a drill between them, or before this piece
/// at the end of a clause.
bool ToolSize::names_drill(std::size_t at) const {
  const auto is_drill = [&](std::size_t i) { return has(i) && pieces_[i].meaning.kind == ToolWord::drill && means(i, tool); };
  const bool is_letter = pieces_[at].is_word();
  std::size_t after = at + 1;
  while (has(after) && (pieces_[after].is_sign('"') || (((is(after, FigureIs::open) && !is_letter) || means(after, describes) ||
                                                         pieces_[after].meaning.kind == ToolWord::tap))))
    ++after;
  if (is_drill(after)) return true;
  const std::size_t before = at > 0 && means(at - 1, number | letter) ? at - 2 : at - 1;
  const bool ends = !has(at + 1) || pieces_[at + 1].clause != pieces_[at].clause;
  return ends && is_drill(before);
}

/// Returns the index of the letter of a drill. Letters that may have another meaning next to DRILL are excluded: A the article, C centre, S
/// spot, X and Z axes.
std::optional<std::size_t> ToolSize::letter_of_drill(std::size_t at) const {
  const auto is_letter_piece = [&](std::size_t i) {
    return has(i) && pieces_[i].is_word() && pieces_[i].text.size() == 1 && is_capital(pieces_[i].text[0]);
  };
  if (means(at, letter)) {
    std::size_t i = at + 1;
    while (has(i) && (pieces_[i].is_sign('.') || pieces_[i].is_sign('"'))) ++i;
    return is_letter_piece(i) && names_drill(i) ? std::optional(i) : std::nullopt;
  }
  if (!is_letter_piece(at)) return std::nullopt;
  const bool quoted = at > 0 && pieces_[at - 1].is_sign('"');
  const bool plain = !pieces_[at].joined && std::string_view("ACSXZ").find(pieces_[at].text[0]) == std::string_view::npos;
  const bool hyphen = has(at + 1) && pieces_[at + 1].joined && !pieces_[at + 1].is_sign('"');
  return (quoted || plain) && !hyphen && names_drill(at) ? std::optional(at) : std::nullopt;
}

// ---- numbers after the name of the tool

ToolSize::Sizes ToolSize::after_names() const {
  Sizes sizes;
  for (const ToolName& name : names_.all())
    if (const auto figure = figure_after(name)) sizes.push_back(mm(pieces_[*figure]));
  return sizes;
}

std::optional<std::size_t> ToolSize::figure_after(const ToolName& name) const {
  bool divided = false;
  for (std::size_t i = name.last + 1; has(i); ++i) {
    const CommentPiece& p = pieces_[i];
    if (p.of_another) return std::nullopt;
    if (p.is_figure()) {
      if (p.figure == FigureIs::open) return fits_after(i, name, divided) ? std::optional(i) : std::nullopt;
      if (p.figure == FigureIs::tool) return std::nullopt;
    } else if (p.is_word()) {
      if (!p.meaning.is(describes | part_of_name | other_before | other_after | degrees | times)) return std::nullopt;
    } else if (std::string_view("-:,={.").find(p.text[0]) == std::string_view::npos) {
      return std::nullopt;
    } else {
      divided = divided || p.text[0] == ',' || p.text[0] == '-' || p.text[0] == '.';
    }
  }
  return std::nullopt;
}

bool ToolSize::fits_after(std::size_t at, const ToolName& name, bool divided) const {
  const CommentPiece& f = pieces_[at];
  const bool takes = name.size_after || name.work_too || name.kind == ToolWord::tap;
  // The comment MILL .5 OFF describes an operation, not a tool.
  const bool is_work = name.kind == ToolWord::chamfer || (name.kind == ToolWord::mill && !name.size_after);
  if (!takes || is_work || name.only_called || is_of_part(at) || !is_likely(f) || means(at + 1, joins)) return false;
  if (name.kind == ToolWord::tap) return is_measured(f);
  if (is_measured(f)) return true;
  if (name.no_bare_size) return false;
  const bool bare_whole = is_whole(f);
  // The comment DRILL 4 CORNERS describes an operation, not a tool.
  const bool goes_on = has(at + 1) && pieces_[at + 1].is_word() && pieces_[at + 1].meaning.means == no_meaning;
  // in the comment T3 DRILL 10, 10 is a size, not the number of an operation
  const bool of_number = is(name.first - 1, FigureIs::tool) && !goes_on;
  return !bare_whole || ((name.size_after || of_number) && !divided);
}

/// Finds the size in a comment without a tool's name, such as 3MM CRB 2FL 12 LOC, or TOOL NAME : Topo 16 mm. The size is the only number
/// with a unit, and the comment has words that only tools have.
ToolSize::Sizes ToolSize::without_name() const {
  const bool called = std::any_of(pieces_.begin(), pieces_.end(), [](const CommentPiece& p) { return p.text == "TOOL"; }) &&
                      std::any_of(pieces_.begin(), pieces_.end(), [](const CommentPiece& p) { return p.text == "NAME"; });
  if (!names_.all().empty() || names_.any(of_part) || !(called || names_.any(of_tool))) return {};
  Sizes sizes;
  for (std::size_t i = 0; i < pieces_.size(); ++i)
    if (is(i, FigureIs::open) && !pieces_[i].of_another && is_measured(pieces_[i]) && is_likely(pieces_[i]))
      sizes.push_back(mm(pieces_[i]));
  return sizes;
}

// ---- corner radius

std::optional<double> ToolSize::corner(std::optional<double> diameter) const {
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    const CommentPiece& f = pieces_[i];
    if (!is(i, FigureIs::corner) || f.of_another) continue;
    const bool by_cam = i > 1 && pieces_[i - 2].text == "CR" && pieces_[i - 1].is_sign('=');
    const bool has_corner =
        kind_ == ToolWord::mill || kind_ == ToolWord::ball || kind_ == ToolWord::taper || (kind_ == ToolWord::none && diameter);
    if (!by_cam && (!has_corner || names_.any(rounds))) return std::nullopt;
    const double radius = mm(f);
    const bool fits = by_cam || !diameter || radius <= *diameter / 2 + alike_mm;
    return fits ? std::optional(radius) : std::nullopt;
  }
  return std::nullopt;
}

}  // namespace kadr
