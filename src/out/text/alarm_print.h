#pragma once
// Formats alarms for people (text with the position underlined) and for programs (JSON, SARIF 2.1.0).

#include <cstdint>
#include <string>
#include <vector>

#include "action/action.h"
#include "config/alarm_texts.h"

namespace kadr {

/// Colours of a terminal, as ECMA-48 sequences: the word "alarm" is red, "warning" is yellow, "note" is cyan, and the underline is green.
enum class Colours : std::uint8_t { none, terminal };

/// Returns `file:line:column: alarm ID: text`, then the source line with the position underlined, the hint and the calls. The text ends in
/// '\n'.
///   law  columns count characters; tabs remain tabs; other control characters are shown as symbols (␀ …); long lines are shortened
std::string alarm_text(const AlarmReport& report, const AlarmTexts& texts, Lang lang, Colours colours = Colours::none);

/// Returns the sentence of the alarm. If the program itself defines the message, the message is not shortened.
std::string sentence_of(const AlarmReport& report, const AlarmTexts& texts, Lang lang);

/// An alarm with all its texts, for lists of findings on several controls.
struct Finding {
  AlarmId id;
  Severity severity;
  std::string number;  // alarm number of the control itself; may be empty
  std::string text;
  std::string hint;
  std::string rule;  // text of the alarm with placeholders, which is the same for every occurrence
  std::string file;
  std::string line_text;
  std::uint32_t line;
  std::uint32_t column;  // column in the line, counted in characters from 1
  std::uint32_t end_column;
  std::string block;  // block number, e.g. "N10"; empty: the block has no number
  std::vector<std::string> calls;
  AlarmReport::Line other{};  // second program line to which the finding refers
};

Finding finding_of(const AlarmReport& report, const AlarmTexts& texts, Lang lang);

/// Returns the findings as a JSON array of objects.
std::string findings_json(const std::vector<Finding>& findings);

/// The result of a call of the command `kadr` itself.
struct Invocation {
  std::string version;
  int exit_code = 0;
  std::vector<std::pair<std::string, std::string>> unreadable;  // names of files that could not be read, each with the reason
};
/// Returns the findings as a SARIF 2.1.0 log with one run of the tool Kadr.
std::string findings_sarif(const std::vector<Finding>& findings, const Invocation& invocation);

/// Returns the block number as the program states it, e.g. "N010"; empty if the block has no number.
std::string block_text(const Origin& origin);

}  // namespace kadr
