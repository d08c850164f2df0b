// Definitions, references and new names in a program. Used by lsp/language_server; tested by tests/lsp.py.

#include <algorithm>

#include "base/ascii.h"
#include "config/texts.h"
#include "lsp/features.h"
#include "texts/lsp.h"

namespace kadr {
namespace {

using Found = DocumentNames::Found;

LspJson location_json(const OpenDocument& document, const Found& found) {
  return {{"uri", document.uri}, {"range", range_json(document.text().range_of(found.line, found.place->where))}};
}

const NamedPlace* place_at(const OpenDocument& document, const TextPosition& position) {
  if (document.names() == nullptr || position.line >= document.text().lines()) return nullptr;
  return document.names()->at(position.line, document.text().byte_of(position));
}

std::vector<Found> all_at(const OpenDocument& document, const TextPosition& position) {
  const NamedPlace* const place = place_at(document, position);
  return place == nullptr ? std::vector<Found>() : document.names()->all_of(position.line, *place);
}

bool is_number(const std::string& text) {
  constexpr std::size_t most_digits = 9;
  return !text.empty() && text.size() <= most_digits && std::all_of(text.begin(), text.end(), is_digit);
}

/// Returns the new name as it is written at the places of the old one: without the letter or sign that the user may have typed before it.
std::string name_to_write(const NamedPlace& place, std::string name) {
  const auto has = [&](char first) { return !name.empty() && to_upper(name.front()) == first; };
  if (place.kind == NameKind::variable && has('#')) name.erase(0, 1);
  if (place.kind == NameKind::block && has('N')) name.erase(0, 1);
  if (place.kind == NameKind::program && has('O')) name.erase(0, 1);
  if (place.kind == NameKind::tool && has('T')) name.erase(0, 1);
  const bool by_name = place.name.starts_with('<');
  if (by_name && !name.starts_with('<')) name = '<' + name + '>';
  return name;
}

bool is_name(const std::string& name) {
  if (name.size() < 3 || name.front() != '<' || name.back() != '>') return false;
  return std::all_of(name.begin() + 1, name.end() - 1, [](char c) { return is_digit(c) || is_capital(to_upper(c)) || c == '_'; });
}

}  // namespace

LspJson definition_json(const OpenDocument& document, const TextPosition& position) {
  LspJson all = LspJson::array();
  const std::vector<Found> found = all_at(document, position);
  const bool of_variable = !found.empty() && found.front().place->kind == NameKind::variable;
  for (const Found& one : found) {
    if (!one.place->defines) continue;
    all.push_back(location_json(document, one));
    if (of_variable) break;  // the first assignment
  }
  return all;
}

LspJson references_json(const OpenDocument& document, const TextPosition& position) {
  LspJson all = LspJson::array();
  for (const Found& one : all_at(document, position)) all.push_back(location_json(document, one));
  return all;
}

LspJson highlights_json(const OpenDocument& document, const TextPosition& position) {
  constexpr int read = 2, write = 3;  // LSP 3.17, "DocumentHighlightKind"
  LspJson all = LspJson::array();
  for (const Found& one : all_at(document, position))
    all.push_back(
        {{"range", range_json(document.text().range_of(one.line, one.place->where))}, {"kind", one.place->defines ? write : read}});
  return all;
}

LspJson renamed_place_json(const OpenDocument& document, const TextPosition& position) {
  const NamedPlace* const place = place_at(document, position);
  if (place == nullptr) return nullptr;
  const TextRange range = document.text().range_of(position.line, place->where);
  return {
      {"range", range_json(range)},
      {"placeholder", std::string(document.text().line(position.line).substr(place->where.begin, place->where.end - place->where.begin))}};
}

LspJson rename_json(const OpenDocument& document, const TextPosition& position, const std::string& name) {
  const NamedPlace* const place = place_at(document, position);
  if (place == nullptr) throw LspFault{LspFault::request_failed, translated(texts::lsp::nothing_to_rename)};
  const std::string written = name_to_write(*place, name);
  const bool by_name = place->name.starts_with('<');
  if (by_name ? !is_name(written) : !is_number(written))
    throw LspFault{LspFault::request_failed, translated(by_name ? texts::lsp::no_name : texts::lsp::no_number, name)};
  NamedPlace other = *place;
  other.name = written;
  if (!by_name) other.name.erase(0, std::min(other.name.find_first_not_of('0'), other.name.size() - 1));
  for (char& c : other.name) c = to_lower(c);
  if (const auto taken = document.names()->all_of(position.line, other); other.name != place->name && !taken.empty())
    throw LspFault{LspFault::request_failed, translated(texts::lsp::name_is_taken, name, taken.front().line + 1)};
  LspJson edits = LspJson::array();
  for (const Found& one : document.names()->all_of(position.line, *place))
    edits.push_back({{"range", range_json(document.text().range_of(one.line, one.place->where))}, {"newText", written}});
  return {{"changes", {{document.uri, std::move(edits)}}}};
}

}  // namespace kadr
