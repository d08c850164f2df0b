// The structure of a program for an editor: programs, operations and tools, folds, times, end points. Used by lsp/language_server; tested
// by tests/lsp.py.

#include "view/structure/outline.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/ascii.h"
#include "config/texts.h"
#include "lsp/features.h"
#include "texts/lsp.h"

namespace kadr {
namespace {

constexpr std::size_t max_symbols = Outliner::max_entries, max_hints = 2000;

/// Returns the kind of a symbol (LSP 3.17, "SymbolKind").
int symbol_kind(OutlineKind kind) {
  constexpr int module = 2, name_space = 3, method = 6, function = 12, key = 20, event = 24;
  switch (kind) {
    case OutlineKind::program: return module;
    case OutlineKind::subprogram: return function;
    case OutlineKind::tool: return event;
    case OutlineKind::cycle: return method;
    case OutlineKind::label: return key;
    case OutlineKind::section: break;
  }
  return name_space;
}

std::vector<OutlineEntry> outline_of(const OpenDocument& document) {
  const DocumentNames& names = *document.names();
  Outliner outliner(names.control());
  for (std::size_t n = 0; n < names.lines() && !outliner.full(); ++n) outliner.take(n, names.line(n));
  std::vector<OutlineEntry> entries = outliner.finish(names.lines());
  for (OutlineEntry& one : entries)
    if (one.name.empty()) one.name = translated_in(document.lang(), texts::lsp::main_program);
  return entries;
}

LspJson symbol_json(const OpenDocument& document, const OutlineEntry& entry) {
  const TextDocument& text = document.text();
  LspJson inside = LspJson::array();
  for (const OutlineEntry& one : entry.inside) inside.push_back(symbol_json(document, one));
  const std::uint32_t first = std::uint32_t(entry.first), last = std::uint32_t(entry.last);
  return {{"name", entry.name},
          {"kind", symbol_kind(entry.kind)},
          {"range", range_json({{first, 0}, text.range_of_line(last).end})},
          {"selectionRange", range_json(text.range_of_line(first))},
          {"children", std::move(inside)}};
}

/// Adds a symbol and those in it as one list, for editors without nested symbols.
void add_flat(const OpenDocument& document, const LspJson& symbol, const std::string& container, LspJson& to) {
  LspJson flat = {{"name", symbol["name"]}, {"kind", symbol["kind"]}, {"location", {{"uri", document.uri}, {"range", symbol["range"]}}}};
  if (!container.empty()) flat["containerName"] = container;
  to.push_back(std::move(flat));
  for (const LspJson& inside : symbol["children"]) add_flat(document, inside, symbol["name"], to);
}

/// Calls `take` with each entry, those inside after their own.
template <class Take>
void each_entry(const std::vector<OutlineEntry>& entries, const Take& take) {
  for (const OutlineEntry& one : entries) {
    take(one);
    each_entry(one.inside, take);
  }
}

}  // namespace

LspJson symbols_json(const OpenDocument& document, bool nested) {
  LspJson all = LspJson::array();
  if (document.names() == nullptr) return all;
  for (const OutlineEntry& entry : outline_of(document)) {
    LspJson symbol = symbol_json(document, entry);
    if (nested) all.push_back(std::move(symbol));
    else add_flat(document, symbol, {}, all);
  }
  return all;
}

void add_workspace_symbols(const OpenDocument& document, const std::string& query, LspJson& to) {
  if (document.names() == nullptr) return;
  each_entry(outline_of(document), [&](const OutlineEntry& entry) {
    if (entry.kind == OutlineKind::tool || entry.kind == OutlineKind::cycle || entry.kind == OutlineKind::section) return;
    if (to.size() >= max_symbols || entry.where.end == 0) return;
    if (in_lower_case(entry.name).find(in_lower_case(query)) == std::string::npos) return;
    const LspJson range = range_json(document.text().range_of(entry.first, entry.where));
    to.push_back({{"name", entry.name}, {"kind", symbol_kind(entry.kind)}, {"location", {{"uri", document.uri}, {"range", range}}}});
  });
}

void add_file_symbols(const ProgramFileNames& file, const std::string& query, LspJson& to) {
  for (const ProgramPlace& one : file.places) {
    const std::string name = shown_name(one.place);
    if (!one.place.defines || to.size() >= max_symbols || in_lower_case(name).find(in_lower_case(query)) == std::string::npos) continue;
    const int kind = symbol_kind(one.place.kind == NameKind::label ? OutlineKind::subprogram : OutlineKind::program);
    to.push_back({{"name", name}, {"kind", kind}, {"location", {{"uri", file.uri}, {"range", range_json(one.range)}}}});
  }
}

LspJson folding_json(const OpenDocument& document) {
  LspJson all = LspJson::array();
  if (document.names() == nullptr) return all;
  const auto add = [&](std::size_t first, std::size_t last) {
    if (last > first && all.size() < max_symbols) all.push_back({{"startLine", first}, {"endLine", last}});
  };
  each_entry(outline_of(document), [&](const OutlineEntry& entry) {
    if (entry.where.end != 0 && entry.kind != OutlineKind::cycle) add(entry.first, entry.last);
  });
  std::vector<std::pair<std::string, std::size_t>> open;  // name and first line of loops, conditions and subprograms
  const DocumentNames& names = *document.names();
  for (std::size_t n = 0; n < names.lines(); ++n)
    for (const NamedPlace& place : names.line(n)) {
      if (place.kind != NameKind::opens && place.kind != NameKind::closes) continue;
      const auto same = std::find_if(open.rbegin(), open.rend(), [&](const auto& one) { return one.first == place.name; });
      if (same == open.rend()) {
        if (place.kind == NameKind::opens) open.emplace_back(place.name, n);
        continue;
      }
      add(same->second, n);  // also for O100 WHILE after O100 DO, which is the last line of its loop
      open.erase(std::prev(same.base()), open.end());
    }
  return all;
}

LspJson hints_json(const OpenDocument& document, const TextRange& range) {
  LspJson all = LspJson::array();
  if (document.opened() == nullptr) return all;
  const ControlDef& def = *document.opened()->def;
  const std::size_t last = std::min<std::size_t>(range.end.line, document.text().lines() - 1);
  for (std::size_t n = range.start.line; n <= last && all.size() < max_hints; ++n) {
    const LineResult* const result = document.result(n);
    if (result == nullptr || result->runs != 1) continue;  // where a line moves several times, its last end point tells little
    std::string label;
    for (std::size_t axis = 0; axis < std::min(def.axes.size(), max_axes); ++axis)
      label += fmt::format("{}{}{:.4g}", label.empty() ? "" : " ", def.axes[axis], result->to[axis] + 0.0);
    const TextPosition end = document.text().range_of_line(n).end;
    all.push_back({{"position", {{"line", end.line}, {"character", end.column}}}, {"label", label}, {"paddingLeft", true}});
  }
  return all;
}

LspJson lenses_json(const OpenDocument& document) {
  LspJson all = LspJson::array();
  if (document.names() == nullptr) return all;
  each_entry(outline_of(document), [&](const OutlineEntry& part) {
    if (part.kind != OutlineKind::program && part.kind != OutlineKind::subprogram && part.kind != OutlineKind::tool) return;
    double seconds = 0;
    for (std::size_t n = part.first; n <= part.last; ++n)
      if (const LineResult* const result = document.result(n)) seconds += result->seconds;
    if (seconds <= 0) return;
    const auto whole = static_cast<std::uint64_t>(seconds + 0.5);
    const std::string title = translated_in(document.lang(), texts::lsp::takes, fmt::format("{}:{:02}", whole / 60, whole % 60));
    all.push_back({{"range", range_json(document.text().range_of_line(part.first))}, {"command", {{"title", title}, {"command", ""}}}});
  });
  return all;
}

}  // namespace kadr
