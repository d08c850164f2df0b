// Alarms as data: id, arguments, span of text. Used by action, base, config, lang, out; tested by tests/base/alarm_test.cpp.

#include "base/alarm.h"

#include <algorithm>
#include <array>
#include <iterator>

namespace kadr {
namespace {

constexpr std::string_view names[] = {
#define KADR_ALARM_NAME(name) #name,
    KADR_ALARMS(KADR_ALARM_NAME)
#undef KADR_ALARM_NAME
};

/// The alarms in the alphabetical order of their names, so that a name is found by bisection.
constexpr auto by_name = [] {
  std::array<AlarmId, std::size(names)> ids{};
  for (std::size_t i = 0; i < ids.size(); ++i) ids[i] = static_cast<AlarmId>(i);
  std::sort(ids.begin(), ids.end(),
            [](AlarmId a, AlarmId b) { return names[static_cast<std::size_t>(a)] < names[static_cast<std::size_t>(b)]; });
  return ids;
}();

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
  const auto* const found =
      std::lower_bound(by_name.begin(), by_name.end(), name, [](AlarmId id, std::string_view wanted) { return name_of(id) < wanted; });
  return found != by_name.end() && name_of(*found) == name ? *found : AlarmId::count;
}

AlarmArg::AlarmArg(std::string_view text) {
  std::size_t size = std::min(text.size(), text_.size());
  if (size < text.size())
    while (size > 0 && continues_character(text[size])) --size;
  std::copy_n(text.begin(), size, text_.begin());
  size_ = static_cast<std::uint8_t>(size);
}

}  // namespace kadr
