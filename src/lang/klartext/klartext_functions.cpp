// Reads assignments to Q parameters, and the functions FN. Used by lang/klartext; tested by tests/lang/klartext_test.cpp.

#include "lang/klartext/klartext_functions.h"

#include <algorithm>
#include <string>
#include <utility>

namespace kadr {

Status KlartextFunctions::name_of(KlartextKind kind, std::string_view name) {
  block_.kind = kind;
  block_.name = std::string(name);
  return {};
}

/// Passes several words with any number of blanks between them.
bool KlartextFunctions::take_spaced(std::string_view what) {
  const std::size_t begin = at_;
  for (std::size_t from = 0; from < what.size();) {
    const std::size_t gap = std::min(what.find(' ', from), what.size());
    if (!(gap == what.size() ? take(what.substr(from)) : take_prefix(what.substr(from, gap - from)))) {
      at_ = begin;
      return false;
    }
    from = gap + 1;
  }
  return true;
}

Status KlartextFunctions::label(KlartextKind kind) {
  block_.kind = kind;
  skip();
  if (peek() == '"') {
    auto name = quoted();
    if (!name) return fail(name.error());
    block_.name = '"' + *name;
    return {};
  }
  if (at_parameter()) {
    const auto step = parameter();
    if (!step) return fail(step.error());
    block_.target = *step;
    return {};
  }
  const auto number = unsigned_number();
  if (!number || !(*number < 65'536)) return syntax();
  block_.name = std::to_string(static_cast<unsigned>(*number));
  return {};
}

Status KlartextFunctions::assignment() {
  auto step = parameter();
  if (!step) return fail(step.error());
  block_.target = *step;
  if (!take("=")) return syntax();
  if (step->family == ParameterFamily::qs) return text_value();
  block_.kind = KlartextKind::assignment;
  if (take("MAX") || take("AUTO") || take("PREDEF")) return name_of(KlartextKind::passed_over, {});
  KADR_TRY(formula(block_.value));
  return at_end() ? Status() : Status(syntax());
}

Status KlartextFunctions::text_assignment() {
  auto step = parameter();
  if (!step) return fail(step.error());
  block_.target = *step;
  if (step->family != ParameterFamily::qs || !take("=")) return syntax();
  return text_value();
}

Status KlartextFunctions::text_value() {
  block_.kind = KlartextKind::text_assignment;
  do KADR_TRY(text_piece());
  while (take("||"));
  return at_end() ? Status() : Status(syntax());
}

Status KlartextFunctions::text_piece() {
  TextPiece piece;
  skip();
  const auto numbers = [&](std::string_view name, KlartextExpression& to) -> Status {
    if (!take_prefix(name)) return {};
    to.begin = code_end();
    KADR_TRY(operand());
    to.end = code_end();
    return {};
  };
  const std::size_t begin = at_;
  if (peek() == '"') {
    auto text = quoted();
    if (!text) return fail(text.error());
    piece.text = std::move(*text);
  } else if (take("SUBSTR")) {
    piece.kind = TextPiece::Kind::part;
    if (!take("(") || !take_prefix("SRC_")) return syntax();
    const auto source = parameter();
    if (!source) return fail(source.error());
    piece.index = source->index;
    KADR_TRY(numbers("BEG", piece.first));
    KADR_TRY(numbers("LEN", piece.second));
    if (!take(")")) return fail(alarm(AlarmId::bracket_not_closed, span(begin, begin + 1)));
  } else if (take("TOCHAR")) {
    piece.kind = TextPiece::Kind::number;
    if (!take("(")) return syntax();
    KADR_TRY(numbers("DAT", piece.first));
    KADR_TRY(numbers("DECIMALS", piece.second));
    if (!take(")")) return fail(alarm(AlarmId::bracket_not_closed, span(begin, begin + 1)));
  } else if (looks_like("SYSSTR") || looks_like("CFGREAD")) {
    return name_of(KlartextKind::not_available, "SYSSTR, CFGREAD");
  } else {
    const auto source = parameter();
    if (!source) return fail(source.error());
    if (source->family != ParameterFamily::qs) return syntax();
    piece.kind = TextPiece::Kind::parameter;
    piece.index = source->index;
  }
  block_.pieces.push_back(std::move(piece));
  return {};
}

Status KlartextFunctions::function() {
  const auto number = unsigned_number();
  if (!number || !(*number < 100)) return syntax();
  block_.number = static_cast<std::uint16_t>(*number);
  if (!take(":")) return syntax();
  const unsigned n = block_.number;
  if (n <= 8 || n == 13) return computed(n);
  if (n >= 9 && n <= 12) return condition();
  if (n == 14) {
    block_.kind = KlartextKind::error;
    if (!take("ERROR")) return syntax();
    (void)take("=");
    block_.value.begin = code_end();
    KADR_TRY(operand());
    block_.value.end = code_end();
    return {};
  }
  if (n == 15 || n == 16) {
    block_.kind = KlartextKind::print;
    block_.name = std::string(text_.substr(at_));
    return {};
  }
  if (n == 18) return system_value();
  if (n == 23 || n == 24) return circle_data();
  if (n == 37) return exported();
  if (n == 19 || n == 20 || n == 29 || n == 38) return name_of(KlartextKind::passed_over, {});
  return name_of(KlartextKind::not_available, "FN " + std::to_string(n));
}

Status KlartextFunctions::computed(unsigned n) {
  block_.kind = KlartextKind::assignment;
  auto step = parameter();
  if (!step) return fail(step.error());
  block_.target = *step;
  if (n == 0 && take_spaced("SET UNDEFINED")) {
    block_.part = 1;
    return {};
  }
  if (!take("=")) return syntax();
  block_.value.begin = code_end();
  if (n >= 5 && n <= 7) {
    constexpr std::string_view names[] = {"SQRT", "SIN", "COS"};
    if (!take(names[n - 5])) return syntax();
    KADR_TRY(operand());
    push(n == 5 ? KlartextOp::square_root : n == 6 ? KlartextOp::sin : KlartextOp::cos);
  } else {
    KADR_TRY(operand());
    if (n != 0) KADR_TRY(second_operand(n));
  }
  block_.value.end = code_end();
  return at_end() ? Status() : Status(syntax());
}

Status KlartextFunctions::second_operand(unsigned n) {
  const bool there = n == 1    ? take("+")
                     : n == 2  ? take("-")
                     : n == 3  ? take("*")
                     : n == 8  ? take("LEN")
                     : n == 13 ? take("ANG")
                               : take("DIV") || take("/");
  if (!there) return syntax();
  KADR_TRY(operand());
  push(n == 1   ? KlartextOp::add
       : n == 2 ? KlartextOp::subtract
       : n == 3 ? KlartextOp::multiply
       : n == 4 ? KlartextOp::divide
       : n == 8 ? KlartextOp::length
                : KlartextOp::angle);
  return {};
}

Status KlartextFunctions::condition() {
  const unsigned n = block_.number;
  if (!take_prefix("IF")) return syntax();
  block_.value.begin = code_end();
  skip();
  if (peek() == '+') ++at_;
  const std::size_t first = block_.code.size();
  KADR_TRY(operand());
  if (take("IS")) {
    const bool undefined = take("UNDEFINED");
    if (!undefined && !take("DEFINED")) return syntax();
    KlartextStep& step = block_.code[first];
    if (step.op != KlartextOp::parameter) return syntax();
    step.op = KlartextOp::undefined;
    block_.value.end = code_end();
    block_.second = {block_.value.end, block_.value.end};
    block_.part = undefined ? 1 : 0;
  } else {
    block_.value.end = code_end();
    constexpr std::string_view names[] = {"EQU", "NE", "GT", "LT"};
    if (!take_prefix(names[n - 9])) return syntax();
    block_.second.begin = code_end();
    KADR_TRY(operand());
    block_.second.end = code_end();
  }
  if (!take_spaced("GOTO LBL")) {
    if (!take("GOTO") || !take_prefix("LBL")) return syntax();
  }
  return label(KlartextKind::jump);
}

Status KlartextFunctions::system_value() {
  block_.kind = KlartextKind::read_system;
  if (!take("SYSREAD")) return syntax();
  auto step = parameter();
  if (!step) return fail(step.error());
  block_.target = *step;
  if (!take("=")) return syntax();
  for (const std::string_view name : {"ID", "NR", "IDX"}) {
    if (!take_prefix(name)) continue;
    KlartextWord word;
    word.name = word_name(name);
    const auto read = value(word.number, word.value);
    if (!read) return fail(read.error());
    if (!*read) return syntax();
    block_.words.push_back(std::move(word));
  }
  return {};
}

/// FN 37: EXPORT QL5 QL6: parameters of a called program that its caller gets.
Status KlartextFunctions::exported() {
  block_.kind = KlartextKind::export_locals;
  if (!take("EXPORT")) return syntax();
  do {
    const auto step = parameter();
    if (!step) return fail(step.error());
    block_.code.push_back(*step);
    (void)take(",");
  } while (!at_end());
  return {};
}

Status KlartextFunctions::circle_data() {
  block_.kind = KlartextKind::circle_data;
  auto step = parameter();
  if (!step) return fail(step.error());
  block_.target = *step;
  if (!take("=") || !take("CDATA")) return syntax();
  auto source = parameter();
  if (!source) return fail(source.error());
  block_.part = static_cast<std::int16_t>(source->index);
  return {};
}

}  // namespace kadr
