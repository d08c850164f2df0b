#pragma once
// Formats alarms for people (text with the position underlined) and for programs (JSON, SARIF 2.1.0).

#include <cstdint>
#include <string>
#include <vector>

#include "action/action.h"
#include "config/alarm_texts.h"

namespace kadr {

/// Colours of a terminal, as ECMA-48 sequences: the word "alarm" is red, "warning" yellow, "note" cyan, the underline green.
enum class Colours : std::uint8_t { none, terminal };

/// Returns `file:line:column: alarm ID: text`, then the source line with the position underlined, the hint and the calls. Ends in '\n'.
///   law  columns count characters; tabs stay tabs, other control characters are shown as symbols (␀ …); long lines are shortened
std::string alarm_text(const AlarmReport& report, const AlarmTexts& texts, Lang lang, Colours colours = Colours::none);

/// Returns the sentence of the alarm. A message that the program itself defines is not shortened.
std::string sentence_of(const AlarmReport& report, const AlarmTexts& texts, Lang lang);

/// An alarm with all its texts, for lists that cover several controls.
struct Finding {
  AlarmId id;
  Severity severity;
  std::string number;  // the control's own alarm number; may be empty
  std::string text;
  std::string hint;
  std::string rule;  // the alarm's text with placeholders, the same for every occurrence
  std::string file;
  std::string line_text;
  std::uint32_t line;
  std::uint32_t column;  // in characters, from 1
  std::uint32_t end_column;
  std::string block;  // block number "N10"; empty: the block has no number
  std::vector<std::string> calls;
  AlarmReport::Line other{};  // a second program line that the finding refers to
};

Finding finding_of(const AlarmReport& report, const AlarmTexts& texts, Lang lang);

/// A JSON array of objects.
std::string findings_json(const std::vector<Finding>& findings);

/// The outcome of the Kadr command itself.
struct Invocation {
  std::string version;
  int exit_code = 0;
  std::vector<std::pair<std::string, std::string>> unreadable;  // file name, and why the file could not be read
};
/// A SARIF 2.1.0 log with one run of the tool Kadr.
std::string findings_sarif(const std::vector<Finding>& findings, const Invocation& invocation);

/// Returns the block number as it was written, "N010"; empty if the block has none.
std::string block_text(const Origin& origin);

}  // namespace kadr
