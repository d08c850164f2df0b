// Findings and their corrections for an editor. Used by lsp/language_server; tested by tests/lsp.py.

#include <fmt/core.h>

#include "lsp/features.h"

namespace kadr {
namespace {

constexpr int error = 1, warning = 2, information = 3, hint = 4;  // LSP 3.17, "DiagnosticSeverity"

int severity_of(Severity severity) {
  switch (severity) {
    case Severity::alarm: return error;
    case Severity::warning: return warning;
    case Severity::advice: return information;
    case Severity::note: return hint;
  }
  return error;
}

std::string message_of(const Finding& finding) {
  std::string text = finding.text;
  if (!finding.number.empty()) text += fmt::format(" [{}]", finding.number);
  return finding.hint.empty() ? text : text + '\n' + finding.hint;
}

LspJson diagnostic_of(const OpenDocument& document, const DocumentFinding& one) {
  const Finding& finding = one.finding;
  LspJson json = {{"range", range_json(one.range)},
                  {"severity", severity_of(finding.severity)},
                  {"code", std::string(name_of(finding.id))},
                  {"source", "kadr"},
                  {"message", message_of(finding)}};
  LspJson related = LspJson::array();
  const auto add = [&](const std::string& path, std::uint32_t line, const std::string& text) {
    const std::uint32_t at = line == 0 ? 0 : line - 1;
    const bool own = path.empty() || path == document.path;
    related.push_back({{"location", {{"uri", own ? document.uri : uri_of_path(path)}, {"range", range_json({{at, 0}, {at + 1, 0}})}}},
                       {"message", text}});
  };
  if (!finding.file.empty() && finding.file != document.path) add(finding.file, finding.line, finding.line_text);
  if (finding.other.number != 0) add(finding.other.file, finding.other.number, finding.other.text);
  if (!related.empty()) json["relatedInformation"] = std::move(related);
  return json;
}

bool touches(const TextRange& a, const TextRange& b) { return a.start <= b.end && b.start <= a.end; }

}  // namespace

LspJson diagnostics_json(const OpenDocument& document) {
  LspJson all = LspJson::array();
  if (!document.no_control().empty())
    all.push_back({{"range", range_json(document.text().range_of_line(0))},
                   {"severity", information},
                   {"source", "kadr"},
                   {"message", document.no_control()}});
  for (const DocumentFinding& one : document.findings()) all.push_back(diagnostic_of(document, one));
  return all;
}

LspJson actions_json(const OpenDocument& document, const TextRange& range) {
  LspJson all = LspJson::array();
  if (!document.is_checked()) return all;  // the findings belong to an earlier text
  for (const DocumentFinding& one : document.findings()) {
    if (!one.fix || !one.fixed || !touches(one.range, range)) continue;
    const LspJson edit = {{"range", range_json(*one.fixed)}, {"newText", one.fix->insert}};
    all.push_back({{"title", one.fix->text},
                   {"kind", "quickfix"},
                   {"diagnostics", LspJson::array({diagnostic_of(document, one)})},
                   {"isPreferred", true},
                   {"edit", {{"changes", {{document.uri, LspJson::array({edit})}}}}}});
  }
  return all;
}

}  // namespace kadr
