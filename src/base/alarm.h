#pragma once
// What went wrong, as data: id, arguments, the piece of text. Nothing above `out` turns it into a sentence.

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

/// Stands for the id where nothing is wrong. It is one of the values, so that an Alarm, which each Result has room for, stays as small as
/// it is.
inline constexpr AlarmId no_alarm = AlarmId::count;

/// The id as it is printed and as the rows of controls/alarms.toml name it.
std::string_view name_of(AlarmId id);

/// The id of that name; no_alarm: there is none.
AlarmId alarm_named(std::string_view name);

/// A note is what a user wants to know, but nothing is wrong: it does not count. Advice is what no control would stop at, but a shop would
/// not run (docs/checklist.md): it counts by itself.
enum class Severity : std::uint8_t { alarm, warning, note, advice };
/// As programs read it: "alarm", "warning", "note", "advice".
std::string_view name_of(Severity severity);

/// One argument of an alarm's text: a number, or a short piece of text (longer ones are cut, at a whole character).
class AlarmArg {
 public:
  AlarmArg() = default;
  AlarmArg(double number) : is_number_(true), number_(number) {}     // NOLINT: a number is an argument
  AlarmArg(std::string_view text);                                   // NOLINT: so is a piece of text
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

/// Plain value without allocation, so that a Result costs nothing while all goes well.
struct Alarm {
  AlarmId id = no_alarm;
  Severity severity = Severity::alarm;
  std::uint8_t arg_count = 0;
  Span where;  // in the text of the block's line
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
