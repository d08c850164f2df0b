// Conversions between the types of a Sinumerik program. Used by control/sinumerik.

#include "control/sinumerik/value.h"

#include <fmt/format.h>

#include "control/sinumerik/number.h"

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
  switch (to) {
    case Type::integer:
    case Type::real:
    case Type::boolean:
    case Type::character: {
      if (value.type == Type::text && to == Type::boolean) return boolean(!value.text.empty());
      Value made = initial_value(to);
      if (value.type == Type::text && to == Type::character && value.text.size() == 1) {
        made.number = static_cast<unsigned char>(value.text[0]);
        return made;
      }
      const auto number = value.is_number() ? number_as(to, value.number) : std::nullopt;
      if (!number && value.is_number() && to == Type::integer) return fail(alarm(AlarmId::value_limit, where, value.number));
      if (!number) return impossible();
      made.number = *number;
      return made;
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
