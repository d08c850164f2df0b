#pragma once
// Texts of alarms: controls/alarms.toml in English and Russian, and the control's own numbers and wording, which take precedence.

#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "base/alarm.h"
#include "config/control/control_def.h"

namespace kadr {

enum class Lang : std::uint8_t { en, ru };

class AlarmTexts {
 public:
  /// Creates an object without texts. For every alarm, such an object returns only the id and the arguments.
  AlarmTexts() : rows_(static_cast<std::size_t>(AlarmId::count) + 1) {}

  /// Loads the common texts, then replaces those for which `def.alarms` has other texts. With nullptr, loads the common texts only.
  ///   returns  an error sentence if controls/alarms.toml is damaged: unknown id, wrong key
  static tl::expected<AlarmTexts, std::string> load(const ControlDef* def);

  /// Returns the text of the alarm with its arguments inserted for {0} {1} {2}. If the alarm has no text, returns the id and the arguments.
  std::string sentence(const Alarm& alarm, Lang lang) const;

  /// Returns the advice on how to correct the fault, with the arguments inserted; an empty text if the alarm has no advice.
  std::string hint(const Alarm& alarm, Lang lang) const;

  /// Returns the text of the alarm from its file, with the placeholders {0} {1} {2}.
  const std::string& pattern(AlarmId id, Lang lang) const;

  /// Returns the advice of the alarm from its file, with the placeholders.
  const std::string& hint_pattern(AlarmId id, Lang lang) const;

  /// Returns the number that the control itself gives this alarm; empty if it gives none.
  const std::string& number(AlarmId id) const { return row(id).number; }
  /// Returns the number of an alarm that a program has caused. An alarm that the program itself raises (#3000) has the number that the
  /// program states; any other alarm has the number that the control gives it.
  std::string number(const Alarm& alarm) const;

 private:
  const AlarmText& row(AlarmId id) const { return rows_[static_cast<std::size_t>(id)]; }

  std::vector<AlarmText> rows_;  // texts of the alarms, one row per alarm, indexed by AlarmId
};

/// Formats a number for people: as short as possible, with up to `decimals` decimals, never -0.
std::string number_text(double value, int decimals = 6);

}  // namespace kadr
