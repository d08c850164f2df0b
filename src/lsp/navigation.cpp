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

/// True for a program such as PART, whose name is that of a file.
bool is_by_name(const NamedPlace& place) { return place.kind == NameKind::program && !is_number(place.name); }

bool is_name(const std::string& name) {
  if (name.size() < 3 || name.front() != '<' || name.back() != '>') return false;
  return std::all_of(name.begin() + 1, name.end() - 1, [](char c) { return is_digit(c) || is_capital(to_upper(c)) || c == '_'; });
}

}  // namespace

namespace {

LspJson location_in(const ProgramFileNames& file, const TextRange& range) { return {{"uri", file.uri}, {"range", range_json(range)}}; }

bool is_of_folder(const NamedPlace* place) {
  return place != nullptr && (place->kind == NameKind::program || place->kind == NameKind::label);
}

/// Adds the definitions of the name in other programs of the folder. A file that is found by its name alone is its own definition.
void add_definitions(const FolderView& folder, const NamedPlace& place, LspJson& to) {
  for (const std::size_t i : files_called(folder.programs, folder.own, place)) {
    if (i == folder.own) continue;
    const ProgramFileNames& file = *folder.programs[i];
    const auto found = std::find_if(file.places.begin(), file.places.end(), [&](const ProgramPlace& one) {
      return one.place.defines && one.place.kind == place.kind && one.place.name == place.name;
    });
    to.push_back(location_in(file, found == file.places.end() ? TextRange() : found->range));
  }
}

/// Adds the calls of the same program in other programs of the folder.
void add_calls(const FolderView& folder, const NamedPlace& place, LspJson& to) {
  const std::vector<std::size_t> targets = files_called(folder.programs, folder.own, place);
  for (std::size_t i = 0; i < folder.programs.size(); ++i) {
    if (i == folder.own) continue;
    const ProgramFileNames& file = *folder.programs[i];
    std::optional<bool> same;  // known at the first place
    for (const ProgramPlace& one : file.places) {
      if (one.place.defines || one.place.kind != place.kind || one.place.name != place.name) continue;
      if (!same) {
        const std::vector<std::size_t> called = files_called(folder.programs, i, place);
        same = std::any_of(called.begin(), called.end(),
                           [&](std::size_t at) { return std::find(targets.begin(), targets.end(), at) != targets.end(); });
      }
      if (*same) to.push_back(location_in(file, one.range));
    }
  }
}

LspJson own_definitions(const OpenDocument& document, const std::vector<Found>& found) {
  LspJson all = LspJson::array();
  const bool of_variable = !found.empty() && found.front().place->kind == NameKind::variable;
  for (const Found& one : found) {
    if (!one.place->defines) continue;
    all.push_back(location_json(document, one));
    if (of_variable) break;  // the first assignment
  }
  return all;
}

}  // namespace

LspJson definition_json(const OpenDocument& document, const TextPosition& position, const FolderOf& folder) {
  LspJson all = own_definitions(document, all_at(document, position));
  const NamedPlace* const place = place_at(document, position);
  for (const bool wide : {false, true})
    if (all.empty() && is_of_folder(place)) add_definitions(folder(wide), *place, all);
  return all;
}

LspJson references_json(const OpenDocument& document, const TextPosition& position, bool with_definition, const FolderOf& folder) {
  const std::vector<Found> found = all_at(document, position);
  const LspJson definitions = own_definitions(document, found);
  LspJson all = LspJson::array();
  for (const Found& one : found) {
    LspJson location = location_json(document, one);
    if (with_definition || std::find(definitions.begin(), definitions.end(), location) == definitions.end())
      all.push_back(std::move(location));
  }
  const NamedPlace* const place = place_at(document, position);
  if (!is_of_folder(place)) return all;
  const FolderView view = folder(true);
  if (with_definition && definitions.empty()) add_definitions(view, *place, all);
  add_calls(view, *place, all);
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
  if (place == nullptr || is_by_name(*place)) return nullptr;
  const TextRange range = document.text().range_of(position.line, place->where);
  return {
      {"range", range_json(range)},
      {"placeholder", std::string(document.text().line(position.line).substr(place->where.begin, place->where.end - place->where.begin))}};
}

LspJson rename_json(const OpenDocument& document, const TextPosition& position, const std::string& name) {
  const NamedPlace* const place = place_at(document, position);
  if (place == nullptr || is_by_name(*place)) throw LspFault{LspFault::request_failed, translated(texts::lsp::nothing_to_rename)};
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
