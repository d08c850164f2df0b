// Reads the words of conversational blocks. Used by lang/klartext; tested by tests/lang/klartext_test.cpp.

#include "lang/klartext/klartext_words.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "lang/block/grammar.h"

namespace kadr {
namespace {

constexpr std::string_view motion_names[] = {"IX",  "IY", "IZ", "IA", "IB", "IC", "IU", "IV", "IW", "IPR", "IPA", "CCA", "LEN", "CCX",
                                             "CCY", "PR", "PA", "NX", "NY", "NZ", "TX", "TY", "TZ", "X",   "Y",   "Z",   "A",   "B",
                                             "C",   "U",  "V",  "W",  "R",  "DR", "F",  "M",  "RL", "RR",  "S",   "DL"};
constexpr std::string_view tool_names[] = {"DL", "DR2", "DR", "S", "F", "L", "R", "X", "Y", "Z", "U", "V", "W", "M"};
constexpr std::string_view plane_names[] = {"SPA", "SPB",  "SPC",   "PROPR", "PROMIN", "ROT",    "EULPR",   "EULNU", "EULROT", "BX",
                                            "BY",  "BZ",   "NX",    "NY",    "NZ",     "P1X",    "P1Y",     "P1Z",   "P2X",    "P2Y",
                                            "P2Z", "P3X",  "P3Y",   "P3Z",   "STAY",   "MOVE",   "TURN",    "MB",    "MAX",    "DIST",
                                            "SEQ", "SYM",  "TABLE", "COORD", "ABST",   "F",      "A",       "B",     "C",      "M",
                                            "TCP", "CONT", "AXIS",  "POS",   "SPAT",   "VECTOR", "PATHCTRL"};
constexpr std::string_view form_names[] = {"IX", "IY", "IZ", "X", "Y", "Z", "R", "L", "DIST", "RI", "DIM_R", "DIM_D", "LBL"};
constexpr std::string_view pattern_names[] = {"X",    "Y",    "Z",   "DX",    "DY",   "D",  "NUMX", "NUMY", "NUM",
                                              "ROTX", "ROTY", "ROT", "START", "STEP", "IX", "IY",   "IZ"};
constexpr std::string_view table_names[] = {"TABLINE", "FILE"};
constexpr std::string_view free_names[] = {"IX", "IY", "IZ", "IA", "IB", "IC", "PR", "PA", "AN", "LEN", "CCA", "CCX", "CCY",
                                           "X",  "Y",  "Z",  "A",  "B",  "C",  "R",  "DR", "F",  "M",   "RL",  "RR"};

}  // namespace

std::string_view KlartextWords::name_here(Names names) const {
  std::string_view best;
  const auto look = [&](const auto& list) {
    for (const std::string_view each : list)
      if (each.size() > best.size() && looks_like(each)) best = each;
  };
  switch (names) {
    case Names::motion: look(motion_names); break;
    case Names::tool: look(tool_names); break;
    case Names::plane: look(plane_names); break;
    case Names::form: look(form_names); break;
    case Names::pattern: look(pattern_names); break;
    case Names::table: look(table_names); break;
    case Names::free: look(free_names); break;
  }
  return best;
}

tl::unexpected<Alarm> KlartextWords::unknown() const {
  std::size_t end = at_;
  while (end < text_.size() && end < at_ + 32 && static_cast<unsigned char>(text_[end]) > ' ') ++end;
  return fail(alarm(AlarmId::name_unknown, span(at_, end), text_.substr(at_, end - at_)));
}

Status KlartextWords::words(Names names, std::vector<KlartextWord>& to) {
  while (!at_end() && peek() != ')') {
    if (to.size() >= limits::block_words) return fail(alarm(AlarmId::too_many_words, span(at_, at_ + 1), double{limits::block_words}));
    KADR_TRY(word(names, to));
  }
  return {};
}

Status KlartextWords::add(KlartextWord word, std::size_t begin, std::vector<KlartextWord>& to) {
  word.where = span(begin, at_);
  if (word.name != word_name("M"))
    for (const KlartextWord& other : to)
      if (other.name == word.name) return fail(alarm(AlarmId::address_twice, word.where, text_.substr(begin, at_ - begin)));
  to.push_back(std::move(word));
  return {};
}

/// F500, FQ2, FMAX, F AUTO, FU0.2, FZ0.1, FT2, FMAXT (spec/heidenhain 3.3); `of_function`: the F of M128 or M140.
Status KlartextWords::feed(std::vector<KlartextWord>& to, bool of_function) {
  const std::size_t begin = at_++;
  KlartextWord word;
  word.name = word_name(of_function ? "MF" : "F");
  if (take("MAXT")) word.name = word_name("FT");
  else if (take("MAX")) word.name = word_name(of_function ? "MFMAX" : "FMAX");
  else if (take("AUTO")) word.name = word_name("FAUTO");
  else if (take_prefix("U")) word.name = word_name("FU");
  else if (take_prefix("Z")) word.name = word_name("FZ");
  else if (take_prefix("T")) word.name = word_name("FT");
  if (word.name != word_name("FMAX") && word.name != word_name("MFMAX") && word.name != word_name("FAUTO")) {
    const auto read = value(word.number, word.value);
    if (!read) return fail(read.error());
    if (!*read) return syntax();
  }
  return add(std::move(word), begin, to);
}

/// The words that belong to an M function: M103 F20, M140 MB 50 F750, M120 LA30, M118 X1 Y1, M138 A C, M94 C, M128 F (spec/heidenhain 3.8).
Status KlartextWords::function_words(std::vector<KlartextWord>& to) {
  const double code = to.back().number;
  skip();
  if (code == 140) {
    if (take_prefix("MB")) {
      KlartextWord word;
      word.name = word_name("MB");
      const std::size_t begin = at_;
      if (take("MAX")) {
        word.name = word_name("MBMAX");
      } else {
        const auto read = value(word.number, word.value);
        if (!read) return fail(read.error());
        if (!*read) return syntax();
      }
      KADR_TRY(add(std::move(word), begin, to));
      skip();
    }
    if (peek() == 'F') return feed(to, true);
    return {};
  }
  if ((code == 103 || code == 128 || code == 124) && (peek() == 'F' || peek() == 'T')) return feed(to, true);
  if (code == 120 && take_prefix("LA")) {
    KlartextWord word;
    word.name = word_name("LA");
    const auto read = value(word.number, word.value);
    if (!read) return fail(read.error());
    return add(std::move(word), at_, to);
  }
  if (code == 118 || code == 138 || code == 94 || code == 112) {
    constexpr std::string_view axes = "XYZABCUVWE";
    for (skip(); axes.find(peek()) != std::string_view::npos && peek() != '\0' && !is_letter(peek(1)); skip()) {
      ++at_;
      double number = 0;
      KlartextExpression expression;
      const auto read = value(number, expression);
      if (!read) return fail(read.error());
    }
  }
  return {};
}

/// DR+, DR-, SEQ+, R+: a sign without a number; or the number itself.
Status KlartextWords::signed_word(KlartextWord& word, std::vector<KlartextWord>& to) {
  const std::size_t begin = at_;
  skip();
  const char sign = peek();
  const char next = peek(1);
  if ((sign == '+' || sign == '-') && !is_digit(next) && next != '.' && next != ',' && next != 'Q') {
    ++at_;
    word.number = sign == '+' ? 1 : -1;
    word.bare = true;
  } else {
    const auto read = value(word.number, word.value);
    if (!read) return fail(read.error());
    if (!*read) word.bare = true;
  }
  return add(std::move(word), begin, to);
}

Status KlartextWords::word(Names names, std::vector<KlartextWord>& to) {
  skip();
  const std::size_t begin = at_;
  const std::string_view name = name_here(names);
  if (name.empty()) return unknown();
  if (name == "F") return feed(to, false);
  KlartextWord word;
  const bool incremental = name.size() > 1 && name[0] == 'I';
  word.incremental = incremental;
  word.name = word_name(incremental ? name.substr(1) : name);
  at_ += name.size();
  if (name == "R" && (names == Names::motion || names == Names::free) && peek() == '0' && !is_digit(peek(1)) && peek(1) != '.' &&
      peek(1) != ',') {
    ++at_;
    word.name = word_name("R0");
    return add(std::move(word), begin, to);
  }
  if (name == "RL" || name == "RR") return add(std::move(word), begin, to);
  if (name == "S" && take("(")) {  // S( VC = 120 )
    if (!take_prefix("VC") || !take("=")) return syntax();
    word.name = word_name("VC");
    const auto read = value(word.number, word.value);
    if (!read) return fail(read.error());
    if (!*read || !take(")")) return syntax();
    return add(std::move(word), begin, to);
  }
  if (name == "MB" && take("MAX")) {  // PLANE … TURN MB MAX
    word.name = word_name("MBMAX");
    return add(std::move(word), begin, to);
  }
  if (name == "FILE") {  // TRANS DATUM TABLE TABLINE5 FILE "NAME.D"
    auto path = quoted();
    if (!path) return fail(path.error());
    word.text = *std::move(path);
    return add(std::move(word), begin, to);
  }
  constexpr std::string_view signed_names[] = {"DR", "SEQ", "SYM", "R"};
  if (std::find(std::begin(signed_names), std::end(signed_names), name) != std::end(signed_names)) return signed_word(word, to);
  constexpr std::string_view flags[] = {"STAY", "MOVE", "TURN", "MAX",  "TABLE",  "COORD",   "TCP",
                                        "CONT", "AXIS", "POS",  "SPAT", "VECTOR", "PATHCTRL"};
  if (std::find(std::begin(flags), std::end(flags), name) != std::end(flags)) {
    if (name == "TABLE" || name == "COORD") (void)take("ROT");
    word.bare = true;
    to.push_back(std::move(word));
    to.back().where = span(begin, at_);
    return {};
  }
  const auto read = value(word.number, word.value);
  if (!read) return fail(read.error());
  word.bare = !*read;
  const bool is_code = name == "M";
  if (!*read && names != Names::tool) return syntax();
  KADR_TRY(add(std::move(word), begin, to));
  return is_code ? function_words(to) : Status();
}

}  // namespace kadr
