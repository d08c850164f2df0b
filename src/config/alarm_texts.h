#pragma once
// Texts of alarms: controls/alarms.toml in English and Russian, overridden by the control's own numbers and wording.

#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "base/alarm.h"
#include "config/control/control_def.h"

namespace kadr {

enum class Lang : std::uint8_t { en, ru };

class AlarmTexts {
 public:
  /// An object without texts, which prints ids and arguments only.
  AlarmTexts() : rows_(static_cast<std::size_t>(AlarmId::count) + 1) {}

  /// Loads the common texts and overrides them by `def.alarms`; with nullptr, loads the common texts only.
  ///   returns  an error sentence if controls/alarms.toml is damaged: unknown id, wrong key
  static tl::expected<AlarmTexts, std::string> load(const ControlDef* def);

  /// Returns the text with its arguments inserted for {0} {1} {2}. Without a text, returns the id and the arguments.
  std::string sentence(const Alarm& alarm, Lang lang) const;

  /// Returns the advice on what to do, arguments inserted; may be empty.
  std::string hint(const Alarm& alarm, Lang lang) const;

  /// Returns the text as the file has it, with its placeholders {0} {1} {2}.
  const std::string& pattern(AlarmId id, Lang lang) const;

  /// Returns the hint as the file has it, with its placeholders.
  const std::string& hint_pattern(AlarmId id, Lang lang) const;

  /// Returns the control's own number of this alarm; empty if it has none.
  const std::string& number(AlarmId id) const { return row(id).number; }
  /// Like number(AlarmId), for one alarm: an alarm raised by the program itself (#3000) has the number that the program gave.
  std::string number(const Alarm& alarm) const;

 private:
  const AlarmText& row(AlarmId id) const { return rows_[static_cast<std::size_t>(id)]; }

  std::vector<AlarmText> rows_;  // one row per alarm, indexed by AlarmId
};

/// Formats a number for people: as short as possible, with up to `decimals` decimals, never -0.
std::string number_text(double value, int decimals = 6);

}  // namespace kadr
