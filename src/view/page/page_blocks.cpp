// Answers the request `write_blocks`: blocks of the open program's control, written from figures: drilling cycles, an arc by three points,
// a corner with a chamfer or a rounding, with block numbers and end marks as the program has them. Nothing is inserted here. Used by
// view/page/page_session; tested by tests/serve_edit.py.

#include <algorithm>
#include <cmath>

#include "edit/block_style.h"
#include "out/program/codes.h"
#include "out/program/words.h"
#include "texts/page.h"
#include "view/page/page_inside.h"

namespace kadr {
namespace {

constexpr std::size_t most_holes = 1000;
constexpr double most_value = 1e6;                        // of any figure
constexpr std::size_t max_styled = std::size_t{8} << 20;  // greatest size of a program whose blocks are looked at, bytes
constexpr double least_sine = 1e-9;                       // sine of the angle at which three points count as a line
using Lines = tl::expected<std::vector<std::string>, std::string>;

bool is_cycle(const CodeRow& row) {
  return row.letter == 'G' && row.works &&
         (row.function == Function::cycle || row.function == Function::canned_cycle || row.function == Function::drilling);
}

/// The words of a drilling cycle that the page asks for, besides the positions; the others keep their defaults.
constexpr std::string_view asked_words = "ZRQPF";

PageJson cycles_json(const ControlDef& def, Lang lang) {
  PageJson cycles = PageJson::array(), retract = PageJson::array();
  for (const CodeRow& row : def.codes) {
    if (row.function == Function::retract_initial || row.function == Function::retract_level)
      retract.push_back({{"code", with_digits(def, row)}, {"title", lang == Lang::ru ? row.text.ru : row.text.en}});
    if (!is_cycle(row)) continue;
    const std::uint64_t needs = row.needs | (row.cycle != 0 ? def.cycles[row.cycle - 1U].needs : 0);
    PageJson words = PageJson::array();
    for (const char letter : asked_words) {
      const bool takes = (row.takes & letter_bit(letter)) != 0 || letter == 'F' || letter == 'Z';
      if (takes) words.push_back({{"letter", std::string(1, letter)}, {"needed", (needs & letter_bit(letter)) != 0 || letter == 'Z'}});
    }
    cycles.push_back(
        {{"code", with_digits(def, row)}, {"title", lang == Lang::ru ? row.text.ru : row.text.en}, {"words", std::move(words)}});
  }
  return {{"cycles", std::move(cycles)}, {"retract", std::move(retract)}, {"lines", PageJson::array()}};
}

std::optional<Vec2> point_in(const PageJson& question, const char* key) {
  const auto found = question.find(key);
  if (found == question.end() || !found->is_array() || found->size() != 2 || !(*found)[0].is_number() || !(*found)[1].is_number())
    return std::nullopt;
  const Vec2 point{(*found)[0].get<double>(), (*found)[1].get<double>()};
  if (!(std::abs(point.x) <= most_value && std::abs(point.y) <= most_value)) return std::nullopt;
  return point;
}

/// Writes the words of blocks. Values are in the unit of the program.
class BlockText {
 public:
  BlockText(const ControlDef& def, bool inch) : def_(def), inch_(inch) {}

  void code(const std::string& text) { add(text); }
  void function(Function function) {
    if (const auto found = code_of(def_, {{function, any_argument}})) add(*found);
  }
  void word(char letter, double value) {
    const Words words(def_, letter, inch_ ? 1 : 0);
    std::string text;
    if (!words.append(text, value * def_.address(letter).scale))
      fault_ = translated(texts::page::no_room_for_word, fmt::format("{}{:g}", letter, value));
    add(text);
  }
  void place(Vec2 at) { word('X', at.x), word('Y', at.y); }
  void end() {
    lines_.push_back(std::move(line_));
    line_.clear();
  }
  Lines lines() {
    if (!fault_.empty()) return tl::unexpected(fault_);
    return std::move(lines_);
  }

 private:
  void add(const std::string& text) {
    if (!text.empty()) line_ += (line_.empty() ? "" : " ") + text;
  }
  const ControlDef& def_;
  bool inch_;
  std::string line_, fault_;
  std::vector<std::string> lines_;
};

/// Returns the code of a rapid or a line, "G1" or "G01", as this control writes it; nullopt for any other code.
std::optional<std::string> motion_code(const ControlDef& def, const std::string& code) {
  constexpr std::int32_t tenths = 10;
  if (code.size() < 2 || code.size() > 3 || code.find_first_not_of("0123456789", 1) != std::string::npos) return std::nullopt;
  for (const CodeRow& row : def.codes)
    if ((row.function == Function::rapid || row.function == Function::linear) && row.letter == code.front() &&
        row.tenth == tenths * std::stoi(code.substr(1)))
      return with_digits(def, row);
  return std::nullopt;
}

tl::unexpected<std::string> wrong_figure(const char* name) { return tl::unexpected(translated(texts::page::figure_wanted, name)); }

Lines cycle_lines(const ControlDef& def, const PageJson& question, bool inch) {
  const std::string code = value_in<std::string>(question, "code", ""), retract = value_in<std::string>(question, "retract", "");
  const auto row =
      std::find_if(def.codes.begin(), def.codes.end(), [&](const CodeRow& r) { return is_cycle(r) && with_digits(def, r) == code; });
  if (row == def.codes.end()) return wrong_figure("code");
  const auto holes = question.find("holes"), values = question.find("values");
  if (holes == question.end() || !holes->is_array() || holes->empty() || holes->size() > most_holes) return wrong_figure("holes");
  if (values == question.end() || !values->is_object()) return wrong_figure("values");
  BlockText text(def, inch);
  text.function(Function::absolute);
  for (const CodeRow& one : def.codes)
    if ((one.function == Function::retract_initial || one.function == Function::retract_level) && with_digits(def, one) == retract)
      text.code(retract);
  text.code(code);
  bool is_first = true;
  for (const PageJson& hole : *holes) {
    const auto at = point_in({{"at", hole}}, "at");
    if (!at) return wrong_figure("holes");
    text.place(*at);
    for (const char letter : asked_words) {
      const auto value = values->find(std::string(1, letter));
      if (!is_first || value == values->end()) continue;
      if (!value->is_number() || !(std::abs(value->get<double>()) <= most_value)) return wrong_figure("values");
      text.word(letter, value->get<double>());
    }
    text.end();
    is_first = false;
  }
  const auto off = code_of(def, {{Function::drilling_off, any_argument}, {Function::no_motion, any_argument}});
  if (off) text.code(*off), text.end();
  return text.lines();
}

void add_arc(BlockText& text, const ControlDef& def, Vec2 from, Vec2 to, Vec2 centre, bool is_cw) {
  text.function(is_cw ? Function::arc_cw : Function::arc_ccw);
  text.place(to);
  const bool is_absolute = def.behaviour.arc_centers == ArcCenters::as_distance;
  const Vec2 by = is_absolute ? centre : centre - from;
  text.word('I', by.x), text.word('J', by.y);
  text.end();
}

Lines arc_lines(const ControlDef& def, const PageJson& question, bool inch) {
  const auto from = point_in(question, "from"), through = point_in(question, "through"), to = point_in(question, "to");
  if (!from || !through || !to) return wrong_figure("from, through, to");
  const Vec2 a = *through - *from, b = *to - *from;
  const double turn = cross(a, b), size = length(a) * length(b);
  if (!(std::abs(turn) > least_sine * size) || size == 0) return tl::unexpected(translated(texts::page::points_in_line));
  const Vec2 centre = *from + (1 / (2 * turn)) * Vec2{b.y * dot(a, a) - a.y * dot(b, b), a.x * dot(b, b) - b.x * dot(a, a)};
  BlockText text(def, inch);
  text.function(Function::absolute);
  add_arc(text, def, *from, *to, centre, turn < 0);
  return text.lines();
}

/// Two lines with a chamfer (leg `size`) or a rounding (radius `size`) between them.
Lines corner_lines(const ControlDef& def, const PageJson& question, bool inch) {
  const auto from = point_in(question, "from"), corner = point_in(question, "corner"), to = point_in(question, "to");
  const double size = value_in<double>(question, "size", 0);
  if (!from || !corner || !to) return wrong_figure("from, corner, to");
  if (!(size > 0 && size <= most_value)) return wrong_figure("size");
  const Vec2 back = *from - *corner, on = *to - *corner;
  const double first = length(back), second = length(on);
  if (first == 0 || second == 0) return wrong_figure("corner");
  const Vec2 u = (1 / first) * back, v = (1 / second) * on;
  const double sine = std::abs(cross(u, v)), cosine = dot(u, v);
  const bool rounds = value_in<std::string>(question, "kind", "") == "rounding";
  if (!(sine > least_sine)) return tl::unexpected(translated(texts::page::points_in_line));
  const double leg = rounds ? size * (1 + cosine) / sine : size;  // size / tan(half of the angle between the lines)
  if (leg > first || leg > second) return tl::unexpected(translated(texts::page::corner_too_large, leg));
  const Vec2 begin = *corner + leg * u, end = *corner + leg * v;
  BlockText text(def, inch);
  text.function(Function::absolute);
  text.function(Function::linear);
  text.place(begin);
  text.end();
  if (rounds) {
    const Vec2 middle = u + v;
    const Vec2 centre = *corner + (std::sqrt(size * size + leg * leg) / length(middle)) * middle;
    add_arc(text, def, begin, end, centre, cross(back, on) > 0);
    text.function(Function::linear);
  } else {
    text.place(end);
    text.end();
  }
  text.place(*to);
  text.end();
  return text.lines();
}

}  // namespace

PageSession::Inside::Answer PageSession::Inside::write_blocks(const PageJson& question) {
  const ControlDef& def = *run->opened().def;
  const std::string what = value_in<std::string>(question, "what", "");
  const bool inch = value_in<std::string>(question, "unit", "mm") == "inch";
  if (what == "cycles") return cycles_json(def, lang);
  Lines made = what == "cycle"    ? cycle_lines(def, question, inch)
               : what == "arc"    ? arc_lines(def, question, inch)
               : what == "corner" ? corner_lines(def, question, inch)
                                  : Lines(wrong_figure("what"));
  if (!made) return refused(made.error());
  if (const std::string motion = value_in<std::string>(question, "motion", ""); !motion.empty()) {
    auto code = motion_code(def, motion);
    if (!code) return refused(translated(texts::page::figure_wanted, "motion"));
    made->push_back(std::move(*code));
  }
  if (source->bytes() <= max_styled) {
    const double after = value_in<double>(question, "after", -1);
    const bool is_line = after >= 0 && after <= max_styled;
    BlockStyle style = BlockStyle::of(text_source(source->whole()), Encoding::utf8, def,
                                      is_line ? std::optional(std::uint32_t(after)) : std::nullopt, token());
    for (std::string& one : *made) one = style.block(one);
  }
  return PageJson{{"cycles", PageJson::array()}, {"retract", PageJson::array()}, {"lines", *made}};
}

}  // namespace kadr
