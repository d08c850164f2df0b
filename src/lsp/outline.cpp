// The structure of a program for an editor: programs, operations and tools, folds, times, end points. Used by lsp/language_server; tested
// by tests/lsp.py.

#include <fmt/format.h>

#include <algorithm>

#include "base/ascii.h"
#include "config/texts.h"
#include "lsp/features.h"
#include "texts/lsp.h"

namespace kadr {
namespace {

constexpr int kind_module = 2, kind_function = 12, kind_event = 24;  // LSP 3.17, "SymbolKind"
constexpr std::size_t max_symbols = 5000, max_hints = 2000;

/// A part of the program: a program of the file, or what one tool does in it.
struct Part {
  std::string name;
  int kind = kind_module;
  std::size_t first = 0, last = 0;
  Span where;
  std::vector<Part> inside;
};

bool is_readable(const std::string& heading) {
  return std::any_of(heading.begin(), heading.end(), [](char c) { return is_capital(to_upper(c)) || static_cast<unsigned char>(c) > 127; });
}

/// Returns the name of a program as people write it: O200, O<pocket>, PART.
std::string shown_name(const NamedPlace& place) {
  if (place.name.empty() || is_digit(place.name.front()) || place.kind == NameKind::label) return "O" + place.name;
  std::string name = place.name;
  for (char& c : name) c = to_upper(c);
  return name;
}

/// Divides the program into its programs, and each of them into its tools. A heading directly before a tool gives it its name.
std::vector<Part> parts_of(const OpenDocument& document) {
  const DocumentNames& names = *document.names();
  std::vector<Part> programs;
  std::string heading;
  std::size_t count = 0, heading_line = 0;
  const auto end_before = [](std::vector<Part>& parts, std::size_t line) {
    if (!parts.empty()) parts.back().last = line == 0 ? 0 : line - 1;
  };
  const auto program = [&]() -> Part& {
    if (programs.empty()) programs.push_back({translated_in(document.lang(), texts::lsp::main_program), kind_module, 0, 0, {}, {}});
    return programs.back();
  };
  for (std::size_t n = 0; n < names.lines() && count < max_symbols; ++n)
    for (const NamedPlace& place : names.line(n)) {
      const bool begins = place.defines && (place.kind == NameKind::program || place.kind == NameKind::label);
      if (begins) {
        end_before(programs, n);
        if (!programs.empty()) end_before(programs.back().inside, n);
        programs.push_back({shown_name(place), place.kind == NameKind::label ? kind_function : kind_module, n, n, place.where, {}});
        ++count;
      } else if (place.kind == NameKind::heading && is_readable(place.name)) {
        heading = place.name, heading_line = n;
      } else if (place.kind == NameKind::tool) {
        Part& of = program();
        const std::string tool = "T" + place.name;
        if (!of.inside.empty() && of.inside.back().name.starts_with(tool + ' ')) continue;
        const bool named = !heading.empty() && n - heading_line <= 2;
        const std::size_t first = named ? heading_line : n;
        end_before(of.inside, first);
        of.inside.push_back({named ? fmt::format("{} {}", tool, heading) : tool + ' ', kind_event, first, n, place.where, {}});
        heading.clear();
        ++count;
      }
    }
  end_before(programs, names.lines());
  for (Part& one : programs)
    if (!one.inside.empty()) one.inside.back().last = std::max(one.last, one.inside.back().first);
  return programs;
}

LspJson symbol_json(const OpenDocument& document, const Part& part) {
  const TextDocument& text = document.text();
  LspJson inside = LspJson::array();
  for (const Part& one : part.inside) inside.push_back(symbol_json(document, one));
  std::string name = part.name;
  while (name.ends_with(' ')) name.pop_back();
  const std::uint32_t first = std::uint32_t(part.first), last = std::uint32_t(std::max(part.first, part.last));
  return {{"name", name},
          {"kind", part.kind},
          {"range", range_json({{first, 0}, text.range_of_line(last).end})},
          {"selectionRange", range_json(text.range_of_line(first))},
          {"children", std::move(inside)}};
}

}  // namespace

LspJson symbols_json(const OpenDocument& document, bool nested) {
  LspJson all = LspJson::array();
  if (document.names() == nullptr) return all;
  const auto add_flat = [&](const LspJson& symbol, const std::string& container) {
    LspJson flat = {{"name", symbol["name"]}, {"kind", symbol["kind"]}, {"location", {{"uri", document.uri}, {"range", symbol["range"]}}}};
    if (!container.empty()) flat["containerName"] = container;
    all.push_back(std::move(flat));
  };
  for (const Part& part : parts_of(document)) {
    LspJson symbol = symbol_json(document, part);
    if (nested) {
      all.push_back(std::move(symbol));
      continue;
    }
    add_flat(symbol, {});
    for (const LspJson& inside : symbol["children"]) add_flat(inside, symbol["name"]);
  }
  return all;
}

void add_workspace_symbols(const OpenDocument& document, const std::string& query, LspJson& to) {
  if (document.names() == nullptr) return;
  for (const Part& part : parts_of(document)) {
    if (to.size() >= max_symbols) return;
    if (part.where.end == 0 || in_lower_case(part.name).find(in_lower_case(query)) == std::string::npos) continue;
    const LspJson range = range_json(document.text().range_of(part.first, part.where));
    to.push_back({{"name", part.name}, {"kind", part.kind}, {"location", {{"uri", document.uri}, {"range", range}}}});
  }
}

void add_file_symbols(const ProgramFileNames& file, const std::string& query, LspJson& to) {
  for (const ProgramPlace& one : file.places) {
    const std::string name = shown_name(one.place);
    if (!one.place.defines || to.size() >= max_symbols || in_lower_case(name).find(in_lower_case(query)) == std::string::npos) continue;
    const int kind = one.place.kind == NameKind::label ? kind_function : kind_module;
    to.push_back({{"name", name}, {"kind", kind}, {"location", {{"uri", file.uri}, {"range", range_json(one.range)}}}});
  }
}

LspJson folding_json(const OpenDocument& document) {
  LspJson all = LspJson::array();
  if (document.names() == nullptr) return all;
  const auto add = [&](std::size_t first, std::size_t last) {
    if (last > first && all.size() < max_symbols) all.push_back({{"startLine", first}, {"endLine", last}});
  };
  for (const Part& part : parts_of(document)) {
    if (part.where.end != 0) add(part.first, part.last);
    for (const Part& one : part.inside) add(one.first, one.last);
  }
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
  const auto add = [&](const Part& part) {
    double seconds = 0;
    for (std::size_t n = part.first; n <= part.last; ++n)
      if (const LineResult* const result = document.result(n)) seconds += result->seconds;
    if (seconds <= 0) return;
    const auto whole = static_cast<std::uint64_t>(seconds + 0.5);
    const std::string title = translated_in(document.lang(), texts::lsp::takes, fmt::format("{}:{:02}", whole / 60, whole % 60));
    all.push_back({{"range", range_json(document.text().range_of_line(part.first))}, {"command", {{"title", title}, {"command", ""}}}});
  };
  for (const Part& part : parts_of(document)) {
    add(part);
    for (const Part& one : part.inside) add(one);
  }
  return all;
}

}  // namespace kadr
