// Conversions between the types of a Sinumerik program. Used by control/sinumerik.

#include "control/sinumerik/value.h"

#include <fmt/format.h>

#include <cmath>

namespace kadr::sinumerik {

std::string_view name_of(Type type) {
  switch (type) {
    case Type::integer: return "INT";
    case Type::real: return "REAL";
    case Type::boolean: return "BOOL";
    case Type::character: return "CHAR";
    case Type::text: return "STRING";
    case Type::axis: return "AXIS";
    case Type::frame: return "FRAME";
  }
  return {};
}

Type type_named(std::string_view name) {
  for (const Type type : {Type::integer, Type::boolean, Type::character, Type::text, Type::axis, Type::frame})
    if (name_of(type) == name) return type;
  return Type::real;
}

Value initial_value(Type type) {
  Value value;
  value.type = type;
  if (type == Type::frame) value.frame = std::make_shared<const Frame>();
  return value;
}

Result<Value> converted(const Value& value, Type to, Span where) {
  const auto impossible = [&] { return fail(alarm(AlarmId::conversion_impossible, where, name_of(value.type), name_of(to))); };
  if (value.type == to) return value;
  constexpr double largest = 2147483647;
  switch (to) {
    case Type::integer:
      if (!value.is_number()) return impossible();
      // INFERRED: halves are rounded away from zero
      if (!(std::fabs(std::round(value.number)) <= largest)) return fail(alarm(AlarmId::value_limit, where, value.number));
      return integer(std::round(value.number));
    case Type::real:
      if (!value.is_number()) return impossible();
      return real(value.number);
    case Type::boolean:
      if (value.is_number()) return boolean(value.number != 0);
      if (value.type == Type::text) return boolean(!value.text.empty());
      return impossible();
    case Type::character: {
      Value letter = initial_value(Type::character);
      if (value.type == Type::text && value.text.size() == 1) letter.number = static_cast<unsigned char>(value.text[0]);
      else if (value.is_number() && value.number >= 0 && value.number <= 255) letter.number = std::round(value.number);
      else return impossible();
      return letter;
    }
    case Type::text:
      if (value.type == Type::character) return text_value(std::string(1, static_cast<char>(static_cast<int>(value.number))));
      return impossible();
    case Type::axis:
    case Type::frame: return impossible();
  }
  return impossible();
}

std::string joined_text(const Value& value) {
  switch (value.type) {
    case Type::text:
    case Type::axis: return value.text;
    case Type::character: return std::string(1, static_cast<char>(static_cast<int>(value.number)));
    case Type::integer:
    case Type::boolean: return fmt::format("{:.0f}", value.number);
    case Type::real: {
      std::string text = fmt::format("{:.10f}", value.number);
      while (text.back() == '0') text.pop_back();
      if (text.back() == '.') text.pop_back();
      return text == "-0" ? "0" : text;
    }
    case Type::frame: return {};
  }
  return {};
}

}  // namespace kadr::sinumerik
