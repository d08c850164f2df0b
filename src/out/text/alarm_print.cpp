// Formats alarms for people (text with the position underlined) and for programs (JSON, SARIF 2.1.0). This file is used by cli and out, and
// tested by tests/out/alarm_print_test.cpp.

#include "out/text/alarm_print.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

#include "base/ascii.h"
#include "config/json_text.h"
#include "out/text/source_line.h"
#include "texts/alarm_print.h"

namespace kadr {
namespace {

using Json = nlohmann::ordered_json;

PlainText severity_word(Severity severity) {
  if (severity == Severity::note) return texts::alarm_print::note;
  if (severity == Severity::advice) return texts::alarm_print::advice;
  return severity == Severity::warning ? texts::alarm_print::warning : texts::alarm_print::alarm;
}

/// Returns the level of a finding as SARIF 2.1.0, 3.27.10 defines it. SARIF has no level for advice.
const char* sarif_level(Severity severity) {
  if (severity == Severity::alarm) return "error";
  return severity == Severity::warning ? "warning" : "note";
}

constexpr const char* green = "32";

const char* colour_of(Severity severity) {
  if (severity == Severity::note) return "1;36";    // bold cyan
  if (severity == Severity::advice) return "1;35";  // bold magenta
  return severity == Severity::warning ? "1;33" : "1;31";
}

std::string coloured(const std::string& text, const char* colour, Colours colours) {
  return colours == Colours::none || text.empty() ? text : fmt::format("\033[{}m{}\033[0m", colour, text);
}

/// Returns the program line, and below it the underline in colour.
std::string marked(std::string_view line, Span place, Colours colours) {
  const std::string text = marked_line(line, place);
  const std::size_t second = text.find('\n') + 1;
  if (second == 0 || second >= text.size()) return text;
  return text.substr(0, second) + coloured(text.substr(second, text.size() - second - 1), green, colours) + "\n";
}

std::string call_text(const AlarmReport::Call& call, Lang lang) {
  const std::string line = fmt::format("{}", call.line) + (call.has_block ? fmt::format(" N{}", call.block) : "");
  return call.file.empty() ? translated_in(lang, texts::alarm_print::called, call.what, line)
                           : translated_in(lang, texts::alarm_print::called_in_file, call.what, line, call.file);
}

std::string dumped(const Json& json) { return json_text(json, 1) + "\n"; }

/// Returns a path as a URI reference. Slashes remain, and bytes that a URI must not contain are replaced by %XX.
std::string uri_of(const std::string& file) {
  std::string uri;
  for (const char c : file) {
    const bool plain = is_letter(c) || is_digit(c) || std::string_view("-._~/").find(c) != std::string_view::npos;
    if (plain) uri += c;
    else if (c == '\\') uri += '/';
    else uri += fmt::format("%{:02X}", static_cast<unsigned char>(c));
  }
  return uri;
}

Json rule_json(const Finding& finding) {
  Json rule = {{"id", name_of(finding.id)}, {"shortDescription", {{"text", finding.rule}}}};
  if (!finding.hint.empty()) rule["help"] = {{"text", finding.hint}};
  return rule;
}

Json result_json(const Finding& finding, std::size_t rule) {
  const Json region = {{"startLine", finding.line},
                       {"startColumn", finding.column},
                       {"endColumn", finding.end_column},
                       {"snippet", {{"text", finding.line_text}}}};
  const Json place = {{"physicalLocation", {{"artifactLocation", {{"uri", uri_of(finding.file)}}}, {"region", region}}}};
  Json result = {{"ruleId", name_of(finding.id)},
                 {"ruleIndex", rule},
                 {"level", sarif_level(finding.severity)},
                 {"message", {{"text", finding.text}}},
                 {"locations", Json::array({place})}};
  if (const AlarmReport::Line& other = finding.other; other.number != 0) {
    const Json line = {{"startLine", other.number}, {"snippet", {{"text", other.text}}}};
    const Json there = {{"physicalLocation", {{"artifactLocation", {{"uri", uri_of(other.file)}}}, {"region", line}}}};
    result["relatedLocations"] = Json::array({there});
  }
  return result;
}

/// Returns the text of the second location of a finding: its program line with the position underlined.
std::string other_place(const Finding& finding, Lang lang, Colours colours) {
  const AlarmReport::Line& other = finding.other;
  if (other.number == 0) return {};
  const std::string place = other.file == finding.file
                                ? translated_in(lang, texts::alarm_print::see_line, other.number)
                                : translated_in(lang, texts::alarm_print::see_line_of_file, other.file, other.number);
  std::string text = "  " + place + "\n";
  if (!other.text.empty()) text += marked(other.text, other.where, colours);
  return text;
}

/// Replaces control characters in the texts of a finding, since a terminal would execute them.
Finding shown(Finding f) {
  for (std::string* const text : {&f.number, &f.text, &f.hint, &f.file, &f.other.file}) *text = visible_name(*text);
  for (std::string& call : f.calls) call = visible_name(call);
  return f;
}

}  // namespace

std::string block_text(const Origin& origin) {
  return origin.has_block ? fmt::format("{}{:0{}}", origin.main_block ? ':' : 'N', origin.block, origin.block_digits) : "";
}

std::string sentence_of(const AlarmReport& report, const AlarmTexts& texts, Lang lang) {
  std::string sentence = texts.sentence(report.alarm, lang);
  if (report.own_text.empty() || report.alarm.arg_count == 0) return sentence;
  const AlarmArg& cut = report.alarm.args[report.alarm.arg_count - 1u];
  const std::size_t at = cut.is_number() || cut.text().empty() ? std::string::npos : sentence.rfind(cut.text());
  return at == std::string::npos ? sentence : sentence.replace(at, cut.text().size(), report.own_text);
}

Finding finding_of(const AlarmReport& report, const AlarmTexts& texts, Lang lang) {
  const Alarm& alarm = report.alarm;
  Finding f{alarm.id,
            alarm.severity,
            texts.number(alarm),
            sentence_of(report, texts, lang),
            texts.hint(alarm, lang),
            texts.pattern(alarm.id, lang),
            report.file,
            report.line_text,
            report.origin.line,
            1,
            2,
            block_text(report.origin),
            {},
            report.other};
  if (f.rule.empty()) f.rule = name_of(alarm.id);
  f.column = report.line_text.empty() ? std::max(report.origin.column, 1U) : characters_before(report.line_text, alarm.where.begin) + 1;
  f.end_column = std::max(f.column + 1, characters_before(report.line_text, alarm.where.end) + 1);
  for (const AlarmReport::Call& call : report.calls) f.calls.push_back(call_text(call, lang));
  return f;
}

std::string alarm_text(const AlarmReport& report, const AlarmTexts& texts, Lang lang, Colours colours) {
  const Finding f = shown(finding_of(report, texts, lang));
  const std::string word = coloured(plain_text(severity_word(f.severity), lang), colour_of(f.severity), colours);
  std::string text = fmt::format("{}:{}:{}: {} {}: {}", f.file, f.line, f.column, word, name_of(f.id), f.text);
  if (!f.number.empty()) text += fmt::format(" [{}]", f.number);
  text += '\n';
  if (!f.line_text.empty()) text += marked(f.line_text, report.alarm.where, colours);
  text += other_place(f, lang, colours);
  if (!f.hint.empty()) text += fmt::format("  {}: {}\n", plain_text(texts::alarm_print::hint, lang), f.hint);
  for (auto call = f.calls.rbegin(); call != f.calls.rend(); ++call) text += fmt::format("  {}\n", *call);
  return text;
}

std::string findings_json(const std::vector<Finding>& findings) {
  Json all = Json::array();
  for (const Finding& f : findings) {
    all.push_back({{"file", f.file},
                   {"line", f.line},
                   {"column", f.column},
                   {"end_column", f.end_column},
                   {"severity", name_of(f.severity)},
                   {"id", name_of(f.id)},
                   {"number", f.number.empty() ? Json() : Json(f.number)},
                   {"text", f.text},
                   {"hint", f.hint},
                   {"block", f.block.empty() ? Json() : Json(f.block)},
                   {"line_text", f.line_text},
                   {"calls", f.calls}});
    if (f.other.number != 0) all.back()["other"] = {{"file", f.other.file}, {"line", f.other.number}, {"line_text", f.other.text}};
  }
  return dumped(all);
}

std::string findings_sarif(const std::vector<Finding>& findings, const Invocation& invocation) {
  Json rules = Json::array(), results = Json::array();
  std::map<AlarmId, std::size_t> known;
  for (const Finding& f : findings) {
    const auto [rule, is_new] = known.emplace(f.id, rules.size());
    if (is_new) rules.push_back(rule_json(f));
    results.push_back(result_json(f, rule->second));
  }
  const Json driver = {{"name", "Kadr"}, {"version", invocation.version}, {"rules", rules}};
  Json notifications = Json::array();
  for (const auto& [file, reason] : invocation.unreadable) {
    const Json place = {{"physicalLocation", {{"artifactLocation", {{"uri", uri_of(file)}}}}}};
    notifications.push_back({{"level", "error"}, {"message", {{"text", reason}}}, {"locations", Json::array({place})}});
  }
  const Json how = {{"executionSuccessful", invocation.unreadable.empty()},
                    {"exitCode", invocation.exit_code},
                    {"toolExecutionNotifications", notifications}};
  const Json run = {
      {"tool", {{"driver", driver}}}, {"invocations", Json::array({how})}, {"columnKind", "unicodeCodePoints"}, {"results", results}};
  return dumped({{"$schema", "https://json.schemastore.org/sarif-2.1.0.json"}, {"version", "2.1.0"}, {"runs", Json::array({run})}});
}

}  // namespace kadr
