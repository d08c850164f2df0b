#pragma once
// The values of a Sinumerik program: numbers, texts, axes, frames, and variables that hold them (spec/sinumerik 6).

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "base/result.h"
#include "control/sinumerik/frame.h"

namespace kadr::sinumerik {

enum class Type : std::uint8_t { integer, real, boolean, character, text, axis, frame };
std::string_view name_of(Type type);
Type type_named(std::string_view name);

struct Value {
  Type type = Type::real;
  bool omitted = false;  // an argument that a call leaves out
  double number = 0;     // integer, real, boolean (0 or 1), character (its code)
  std::string text;      // text; name of an axis
  std::shared_ptr<const Frame> frame;

  bool is_number() const { return type <= Type::character; }
  bool is_true() const { return number != 0; }
};

inline Value real(double number) { return {Type::real, false, number, {}, {}}; }
inline Value integer(double number) { return {Type::integer, false, number, {}, {}}; }
inline Value boolean(bool on) { return {Type::boolean, false, on ? 1.0 : 0.0, {}, {}}; }
inline Value text_value(std::string text) { return {Type::text, false, 0, std::move(text), {}}; }
inline Value axis_value(std::string name) { return {Type::axis, false, 0, std::move(name), {}}; }
inline Value frame_value(Frame frame) { return {Type::frame, false, 0, {}, std::make_shared<const Frame>(std::move(frame))}; }
Value initial_value(Type type);

/// Returns the value as the type of a variable (spec/sinumerik 6.2): REAL is rounded for INT, any number other than 0 is TRUE.
///   alarms  conversion_impossible, value_limit
Result<Value> converted(const Value& value, Type to, Span where);

/// Returns the text of a value after <<: whole numbers without a point, other numbers with up to ten decimals (spec/sinumerik 6.3).
std::string joined_text(const Value& value);

/// A variable of DEF or a formal parameter. An array has its elements one after the other.
struct Variable {
  Type type = Type::real;
  std::vector<std::uint32_t> sizes;  // empty: not an array
  std::vector<Value> values;
};

}  // namespace kadr::sinumerik
