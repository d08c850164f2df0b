#pragma once
// An Alarm is data: an id, up to three arguments, and the span of text that it is about. Only the room `out` turns it into a sentence.

#include <array>
#include <cstdint>
#include <string_view>

#include "base/alarm_ids.h"
#include "base/span.h"

namespace kadr {

enum class AlarmId : std::uint16_t {
#define KADR_ALARM_ENUM(name) name,
  KADR_ALARMS(KADR_ALARM_ENUM)
#undef KADR_ALARM_ENUM
      count
};

/// The id that means "no alarm". It is a value of AlarmId instead of a separate flag, so that an Alarm, and a Result that contains one,
/// stay small.
inline constexpr AlarmId no_alarm = AlarmId::count;

/// Returns the name of the id, in the spelling of messages and of the rows in controls/alarms.toml.
std::string_view name_of(AlarmId id);

/// Returns the id with this name; no_alarm if no id has this name.
AlarmId alarm_named(std::string_view name);

/// How serious an alarm is. A note informs the user of something that is not wrong, and is not counted. Advice reports what no control
/// stops at but a shop would not run (docs/checklist.md); advice is counted separately.
enum class Severity : std::uint8_t { alarm, warning, note, advice };
/// Returns the name of the severity in machine-readable output: "alarm", "warning", "note", "advice".
std::string_view name_of(Severity severity);

/// An argument of an alarm's text: a number, or a short text. A text that does not fit is cut at a character boundary.
class AlarmArg {
 public:
  AlarmArg() = default;
  AlarmArg(double number) : is_number_(true), number_(number) {}     // NOLINT: not explicit, so that a caller passes a number
  AlarmArg(std::string_view text);                                   // NOLINT: not explicit, so that a caller passes a text
  AlarmArg(const char* text) : AlarmArg(std::string_view(text)) {}   // NOLINT
  AlarmArg(char letter) : AlarmArg(std::string_view(&letter, 1)) {}  // NOLINT

  bool is_number() const { return is_number_; }
  double number() const { return number_; }
  std::string_view text() const { return {text_.data(), size_}; }

 private:
  bool is_number_ = false;
  std::uint8_t size_ = 0;
  double number_ = 0;
  std::array<char, 30> text_{};
};

/// An alarm as a plain value. An Alarm never allocates memory, so returning a Result (a value or an Alarm) costs nothing as long as no
/// alarm occurs.
struct Alarm {
  AlarmId id = no_alarm;
  Severity severity = Severity::alarm;
  std::uint8_t arg_count = 0;
  Span where;  // range of bytes, in the line of the block, that the alarm is about
  std::array<AlarmArg, 3> args;
};

template <class... Args>
Alarm alarm(AlarmId id, Span where, Args... args) {
  static_assert(sizeof...(Args) <= 3);
  return {id, Severity::alarm, sizeof...(Args), where, {AlarmArg(args)...}};
}

template <class... Args>
Alarm warning(AlarmId id, Span where, Args... args) {
  static_assert(sizeof...(Args) <= 3);
  return {id, Severity::warning, sizeof...(Args), where, {AlarmArg(args)...}};
}

template <class... Args>
Alarm note(AlarmId id, Span where, Args... args) {
  static_assert(sizeof...(Args) <= 3);
  return {id, Severity::note, sizeof...(Args), where, {AlarmArg(args)...}};
}

template <class... Args>
Alarm advice(AlarmId id, Span where, Args... args) {
  static_assert(sizeof...(Args) <= 3);
  return {id, Severity::advice, sizeof...(Args), where, {AlarmArg(args)...}};
}

}  // namespace kadr
