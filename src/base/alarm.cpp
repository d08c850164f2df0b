// Alarms as data: id, arguments, span of text. Used by action, base, config, lang, out; tested by tests/base/alarm_test.cpp.

#include "base/alarm.h"

#include <algorithm>

namespace kadr {
namespace {

constexpr std::string_view names[] = {
#define KADR_ALARM_NAME(name) #name,
    KADR_ALARMS(KADR_ALARM_NAME)
#undef KADR_ALARM_NAME
};

bool continues_character(char byte) { return (static_cast<unsigned char>(byte) & 0xC0) == 0x80; }

}  // namespace

std::string_view name_of(AlarmId id) { return names[static_cast<std::size_t>(id)]; }

std::string_view name_of(Severity severity) {
  switch (severity) {
    case Severity::alarm: return "alarm";
    case Severity::warning: return "warning";
    case Severity::note: return "note";
    case Severity::advice: break;
  }
  return "advice";
}

AlarmId alarm_named(std::string_view name) {
  const auto* found = std::find(std::begin(names), std::end(names), name);
  return static_cast<AlarmId>(found - std::begin(names));
}

AlarmArg::AlarmArg(std::string_view text) {
  std::size_t size = std::min(text.size(), text_.size());
  if (size < text.size())
    while (size > 0 && continues_character(text[size])) --size;
  std::copy_n(text.begin(), size, text_.begin());
  size_ = static_cast<std::uint8_t>(size);
}

}  // namespace kadr
