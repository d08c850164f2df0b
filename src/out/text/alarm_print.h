#pragma once
// Alarms for people (text with the place marked) and for programs (JSON, SARIF 2.1.0).

#include <cstdint>
#include <string>
#include <vector>

#include "action/action.h"
#include "config/alarm_texts.h"

namespace kadr {

/// For a terminal: the alarm's word red, of a warning yellow, of a note cyan, the mark under the line green, by ECMA-48 sequences.
enum class Colours : std::uint8_t { none, terminal };

/// `file:line:column: alarm ID: text`, the source line with the place marked, the hint, the calls. Ends in '\n'.
///   law  columns count characters; tabs stay tabs, other control characters are shown as pictures; long lines are clipped
std::string alarm_text(const AlarmReport& report, const AlarmTexts& texts, Lang lang, Colours colours = Colours::none);

/// The alarm's sentence; a program's own words whole.
std::string sentence_of(const AlarmReport& report, const AlarmTexts& texts, Lang lang);

/// An alarm resolved to words, for lists over several controls.
struct Finding {
  AlarmId id;
  Severity severity;
  std::string number;  // the control's own, may be empty
  std::string text;
  std::string hint;
  std::string rule;  // the text's pattern
  std::string file;
  std::string line_text;
  std::uint32_t line;
  std::uint32_t column;  // in characters, from 1
  std::uint32_t end_column;
  std::string block;  // "N10", empty: none
  std::vector<std::string> calls;
  AlarmReport::Line other{};  // a second place that belongs to it
};

Finding finding_of(const AlarmReport& report, const AlarmTexts& texts, Lang lang);

/// A JSON array of objects.
std::string findings_json(const std::vector<Finding>& findings);

/// How the tool itself fared.
struct Invocation {
  std::string version;
  int exit_code = 0;
  std::vector<std::pair<std::string, std::string>> unreadable;  // file, reason
};
/// A SARIF 2.1.0 log with one run of the tool Kadr.
std::string findings_sarif(const std::vector<Finding>& findings, const Invocation& invocation);

/// "N010" as it was written; empty without a block number.
std::string block_text(const Origin& origin);

}  // namespace kadr
