#pragma once
// Writes alarms for people (text with the position marked) and for programs (JSON, SARIF 2.1.0).

#include <cstdint>
#include <string>
#include <vector>

#include "action/action.h"
#include "config/alarm_texts.h"

namespace kadr {

/// Colours for a terminal, as ECMA-48 sequences: the word "alarm" is red, "warning" yellow, "note" cyan, the mark under the line green.
enum class Colours : std::uint8_t { none, terminal };

/// Returns `file:line:column: alarm ID: text`, the source line with the position marked, the hint and the calls. Ends in '\n'.
///   law  columns count characters; tabs stay tabs, other control characters are shown as pictures; long lines are clipped
std::string alarm_text(const AlarmReport& report, const AlarmTexts& texts, Lang lang, Colours colours = Colours::none);

/// Returns the alarm's sentence; a text of the program's own is not shortened.
std::string sentence_of(const AlarmReport& report, const AlarmTexts& texts, Lang lang);

/// An alarm resolved to words, for lists over several controls.
struct Finding {
  AlarmId id;
  Severity severity;
  std::string number;  // the control's own, may be empty
  std::string text;
  std::string hint;
  std::string rule;  // the pattern of the text
  std::string file;
  std::string line_text;
  std::uint32_t line;
  std::uint32_t column;  // in characters, from 1
  std::uint32_t end_column;
  std::string block;  // "N10"; empty: none
  std::vector<std::string> calls;
  AlarmReport::Line other{};  // a second location that belongs to the finding
};

Finding finding_of(const AlarmReport& report, const AlarmTexts& texts, Lang lang);

/// A JSON array of objects.
std::string findings_json(const std::vector<Finding>& findings);

/// How the run of Kadr itself ended.
struct Invocation {
  std::string version;
  int exit_code = 0;
  std::vector<std::pair<std::string, std::string>> unreadable;  // file, reason
};
/// A SARIF 2.1.0 log with one run of the tool Kadr.
std::string findings_sarif(const std::vector<Finding>& findings, const Invocation& invocation);

/// Returns the block number as it was written, "N010"; empty if the block has none.
std::string block_text(const Origin& origin);

}  // namespace kadr
