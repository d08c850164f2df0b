#pragma once
// Alarms in words: controls/alarms.toml in English and Russian, over it the control's own numbers and wording.

#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "base/alarm.h"
#include "config/control_def.h"

namespace kadr {

enum class Lang : std::uint8_t { en, ru };

class AlarmTexts {
 public:
  /// Without texts: ids and arguments only.
  AlarmTexts() : rows_(static_cast<std::size_t>(AlarmId::count) + 1) {}

  /// The common texts, overlaid by `def.alarms`; without a control the common ones alone.
  ///   returns  an error sentence if controls/alarms.toml is damaged: unknown id, wrong key
  static tl::expected<AlarmTexts, std::string> load(const ControlDef* def);

  /// Text with its arguments put in for {0} {1} {2}; the id and the arguments where there is no text.
  std::string sentence(const Alarm& alarm, Lang lang) const;

  /// What to do about it, arguments put in; may be empty.
  std::string hint(const Alarm& alarm, Lang lang) const;

  /// The text as it stands in the file, {0} and all.
  const std::string& pattern(AlarmId id, Lang lang) const;

  /// The hint as it stands in the file.
  const std::string& hint_pattern(AlarmId id, Lang lang) const;

  /// The control's own number; empty: it has none.
  const std::string& number(AlarmId id) const { return row(id).number; }
  /// The same of one alarm: a program's own (#3000) has the number the program gave it.
  std::string number(const Alarm& alarm) const;

 private:
  const AlarmText& row(AlarmId id) const { return rows_[static_cast<std::size_t>(id)]; }

  std::vector<AlarmText> rows_;  // by AlarmId
};

/// A number for people: shortest, up to `decimals` places, no -0.
std::string number_text(double value, int decimals = 6);

}  // namespace kadr
