// Reads the text of a conversational block into a KlartextBlock. Used by control/heidenhain; tested by tests/lang/klartext_test.cpp.

#include "lang/klartext/klartext_parser.h"

#include <utility>

#include "lang/block/grammar.h"
#include "lang/klartext/klartext_cycles.h"

namespace kadr {
namespace {

struct Motion {
  std::string_view text;
  KlartextKind kind;
};
constexpr Motion motions[] = {
    {"LP", KlartextKind::polar_line},     {"LN", KlartextKind::normal_line},   {"L", KlartextKind::line},
    {"CC", KlartextKind::centre},         {"CR", KlartextKind::radius_circle}, {"CTP", KlartextKind::polar_tangent_circle},
    {"CT", KlartextKind::tangent_circle}, {"CP", KlartextKind::polar_circle},  {"C", KlartextKind::circle}};

/// Statements that change neither the path nor the time of a run: the mode in which a mill works anyway, the counter of parts.
constexpr std::string_view passed_over[] = {"FUNCTION MODE MILL", "FUNCTION PROG PATH OFF", "FUNCTION COUNT", "PATTERN CLEAR",
                                            "POLARKIN OFF"};

constexpr std::string_view refused[] = {"SPL",
                                        "SEL CONTOUR",
                                        "CONTOUR DEF",
                                        "SQL",
                                        "CALL SELECTED CONTOUR",
                                        "POLARKIN",
                                        "FUNCTION MODE",
                                        "FUNCTION PROG PATH",
                                        "FUNCTION FEED",
                                        "FUNCTION DWELL",
                                        "FUNCTION S-PULSE",
                                        "FUNCTION"};

class KlartextParser : public KlartextCycles {
 public:
  using KlartextCycles::KlartextCycles;

  Status run() {
    skip();
    block_.where = span(at_, text_.size());
    if (at_end()) return {};
    if (at_parameter()) return assignment();
    if (peek() == 'F' && (peek(1) == 'N' || peek(1) == ' ')) {
      if (take_prefix("FN")) return function();
    }
    if (const auto done = keyword()) return *done;
    for (const std::string_view name : {"FLT", "FL", "FCT", "FC", "FPOL", "FSELECT"})
      if (take(name)) return free_contour(name);
    for (const Motion& motion : motions)
      if (take(motion.text)) {
        block_.kind = motion.kind;
        return words(Names::motion, block_.words);
      }
    for (const std::string_view name : passed_over)
      if (take_spaced(name)) {
        block_.kind = KlartextKind::passed_over;
        return {};
      }
    for (const std::string_view name : refused)
      if (take_spaced(name)) return name_of(KlartextKind::not_available, name);
    if (peek() == 'M' || peek() == 'S' || peek() == 'F') return words(Names::motion, block_.words);
    if (std::string_view("XYZABCUVWI").find(peek()) != std::string_view::npos && !name_here(Names::motion).empty())
      return name_of(KlartextKind::not_available, "R+, R-");  // paraxial positioning (spec/heidenhain 1.2)
    return unknown();
  }

 private:
  // NOLINTNEXTLINE(readability-function-size): one row for each statement
  std::optional<Status> keyword() {
    if (take_spaced("BEGIN PGM")) return frame(KlartextKind::begin_program);
    if (take_spaced("END PGM")) return frame(KlartextKind::end_program);
    if (take_spaced("BLK FORM")) return form();
    if (take_spaced("TOOL CALL")) return tool(KlartextKind::tool_call);
    if (take_spaced("TOOL DEF")) return tool(KlartextKind::tool_definition);
    if (take_spaced("CYCL DEF") || take_spaced("CYCLE DEF")) return cycle();
    if (take_spaced("GLOBAL DEF")) return global_definition();
    if (take_spaced("TCH PROBE")) return probe();
    if (take_spaced("SEL TABLE")) return path(KlartextKind::select_table);
    if (take_spaced("SEL PATTERN")) return path(KlartextKind::select_pattern);
    if (take_spaced("CYCL CALL") || take_spaced("CYCLE CALL")) return cycle_call();
    if (take_spaced("CALL LBL")) return call_label();
    if (take_spaced("CALL PGM")) return path(KlartextKind::call_program);
    if (take_spaced("CALL SELECTED PGM")) return name_of(KlartextKind::call_selected, {});
    if (take_spaced("SEL PGM")) return path(KlartextKind::select_program);
    if (take_prefix("LBL")) return label(KlartextKind::label);
    if (take("STOP")) {
      block_.kind = KlartextKind::stop;
      return words(Names::motion, block_.words);
    }
    if (take("RND")) return corner(KlartextKind::rounding, "R");
    if (take("CHF")) return corner(KlartextKind::chamfer, "CHF");
    if (take("APPR")) return approach(KlartextKind::approach);
    if (take("DEP")) return approach(KlartextKind::departure);
    if (take("PLANE")) return plane();
    if (take_spaced("FUNCTION RESET TCPM")) return name_of(KlartextKind::tip_control, "RESET");
    if (take_spaced("FUNCTION TCPM")) {
      block_.kind = KlartextKind::tip_control;
      return words(Names::plane, block_.words);
    }
    if (take_spaced("TRANS DATUM")) return datum();
    if (take_spaced("DECLARE STRING")) return text_assignment();
    if (take_spaced("PATTERN DEF")) return pattern();
    return std::nullopt;
  }

  Status frame(KlartextKind kind) {
    block_.kind = kind;
    std::string_view rest = text_.substr(at_);
    while (!rest.empty() && static_cast<unsigned char>(rest.back()) <= ' ') rest.remove_suffix(1);
    const std::size_t gap = rest.find_last_of(" \t");
    std::string last(gap == std::string_view::npos ? rest : rest.substr(gap + 1));
    for (char& c : last) c = to_upper(c);
    if (last == "INCH") block_.number = 1;
    block_.name = std::string(gap == std::string_view::npos ? rest : rest.substr(0, gap));
    return {};
  }

  Status form() {
    block_.kind = KlartextKind::blank_form;
    if (take("0.1")) block_.part = 1;
    else if (take("0.2")) block_.part = 2;
    else if (take("CYLINDER")) block_.part = 3;
    else return {};  // ROTATION, FILE: only for the graphics
    skip();
    if (block_.part != 2 && std::string_view("XYZ").find(peek()) != std::string_view::npos && static_cast<unsigned char>(peek(1)) <= ' ') {
      block_.name = peek();  // the tool axis
      ++at_;
    }
    return words(Names::form, block_.words);
  }

  Status tool(KlartextKind kind) {
    block_.kind = kind;
    KlartextWord word;
    skip();
    const std::size_t begin = at_;
    word.name = word_name("T");
    if (peek() == '"') {
      auto name = quoted();
      if (!name) return fail(name.error());
      word.text = std::move(*name);
      word.bare = true;
    } else if (at_parameter() || is_digit(peek()) || peek() == '+') {
      if (peek() == 'Q' && peek(1) == 'S') {
        auto step = parameter();
        if (!step) return fail(step.error());
        block_.target = *step;
        word.bare = true;
      } else {
        const auto read = value(word.number, word.value);
        if (!read) return fail(read.error());
      }
    } else {
      return words(Names::tool, block_.words);
    }
    word.where = span(begin, at_);
    block_.words.push_back(std::move(word));
    return words(Names::tool, block_.words);
  }

  Status cycle_call() {
    block_.kind = KlartextKind::cycle_call;
    if (take("POS")) block_.part = 1;
    else if (take("PAT")) block_.part = 2;
    return words(Names::motion, block_.words);
  }

  Status call_label() {
    KADR_TRY(label(KlartextKind::call_label));
    block_.part = -1;
    if (!take_prefix("REP")) return {};
    block_.part = 1;
    block_.value.begin = code_end();
    KADR_TRY(operand());
    block_.value.end = code_end();
    if (take("/")) (void)unsigned_number();  // the counter that the control shows
    return {};
  }

  Status path(KlartextKind kind) {
    block_.kind = kind;
    skip();
    if (peek() == '"') {
      auto name = quoted();
      if (!name) return fail(name.error());
      block_.name = std::move(*name);
      return {};
    }
    if (peek() == 'Q' && peek(1) == 'S' && at_parameter()) {
      const auto step = parameter();
      if (!step) return fail(step.error());
      block_.target = *step;
      return {};
    }
    std::string_view rest = text_.substr(at_);
    rest = rest.substr(0, rest.find(';'));
    while (!rest.empty() && static_cast<unsigned char>(rest.back()) <= ' ') rest.remove_suffix(1);
    block_.name = std::string(rest);
    return {};
  }

  Status corner(KlartextKind kind, std::string_view name) {
    block_.kind = kind;
    skip();
    if (kind == KlartextKind::rounding) (void)take_prefix("R");
    KlartextWord word;
    const std::size_t begin = at_;
    word.name = word_name(name);
    const auto read = value(word.number, word.value);
    if (!read) return fail(read.error());
    if (!*read) return syntax();
    word.where = span(begin, at_);
    block_.words.push_back(std::move(word));
    return words(Names::motion, block_.words);
  }

  /// FK: the words of an element; a form that Kadr does not solve is refused as a whole (spec/heidenhain 14).
  Status free_contour(std::string_view form) {
    if (form == "FPOL" || form == "FSELECT") return name_of(KlartextKind::not_available, "FK");
    KADR_TRY(name_of(KlartextKind::free_contour, form));
    const Status read = words(Names::free, block_.words);
    return !read && read.error().id == AlarmId::name_unknown ? name_of(KlartextKind::not_available, "FK") : read;
  }

  Status approach(KlartextKind kind) {
    for (const std::string_view form : {"PLCT", "PLT", "PLN", "PCT", "LCT", "LT", "LN", "CT"})
      if (take(form)) {
        KADR_TRY(name_of(kind, form));
        return words(Names::motion, block_.words);
      }
    return unknown();
  }

  Status plane() {
    for (const std::string_view form : {"SPATIAL", "PROJECTED", "EULER", "VECTOR", "POINTS", "RELATIVE", "RELATIV", "AXIAL", "RESET"})
      if (take(form)) {
        KADR_TRY(name_of(KlartextKind::plane, form));
        return words(Names::plane, block_.words);
      }
    return unknown();
  }

  Status datum() {
    block_.kind = KlartextKind::datum;
    if (take("RESET")) return name_of(KlartextKind::datum, "RESET");
    if (take("TABLE")) {
      block_.name = "TABLE";
      return words(Names::table, block_.words);
    }
    if (take("AXIS")) return words(Names::motion, block_.words);
    return unknown();
  }

  Status pattern() {
    block_.kind = KlartextKind::pattern;
    while (!at_end()) {
      PatternRow row;
      const std::size_t begin = at_;
      for (const std::string_view name : {"POS", "ROW", "PAT", "FRAME", "CIRC", "PITCHCIRC"})
        if (row.name.empty() && take_prefix(name)) row.name = std::string(name);
      if (row.name.empty() || block_.rows.size() >= limits::block_words) return unknown();
      (void)unsigned_number();
      if (!take("(")) return syntax();
      KADR_TRY(words(Names::pattern, row.words));
      if (!take(")")) return fail(alarm(AlarmId::bracket_not_closed, span(begin, begin + 1)));
      row.where = span(begin, at_);
      block_.rows.push_back(std::move(row));
    }
    return {};
  }
};

}  // namespace

Result<KlartextBlock> read_klartext_block(std::string_view text, Span statement) {
  KlartextBlock block;
  const Status done = KlartextParser(text, statement, block).run();
  if (!done) return fail(done.error());
  return block;
}

}  // namespace kadr
