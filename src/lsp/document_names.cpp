// DocumentNames: what a document names, and where. Used by lsp/navigation and lsp/outline; tested by tests/lsp/document_names_test.cpp.

#include "lsp/document_names.h"

#include <algorithm>
#include <charconv>

namespace kadr {
namespace {

constexpr std::uint32_t first_shared_variable = 100;  // #1 to #33 are local to a program (nct 23.1)

}  // namespace

void DocumentNames::read(const TextDocument& document) { update(document, {0, lines_.size(), document.lines()}); }

void DocumentNames::update(const TextDocument& document, const TextDocument::ChangedLines& changed) {
  std::vector<std::vector<NamedPlace>> read(changed.added);
  for (std::size_t n = 0; n < changed.added; ++n) read[n] = names_of_line(*def_, document.line(changed.first + n));
  const auto at = lines_.begin() + static_cast<std::ptrdiff_t>(changed.first);
  const auto kept = lines_.erase(at, at + static_cast<std::ptrdiff_t>(changed.removed));
  lines_.insert(kept, std::make_move_iterator(read.begin()), std::make_move_iterator(read.end()));
}

const NamedPlace* DocumentNames::at(std::size_t number, std::size_t byte) const {
  if (number >= lines_.size()) return nullptr;
  const auto& names = lines_[number];
  const auto found = std::find_if(names.begin(), names.end(), [&](const NamedPlace& place) {
    const bool is_name = place.kind <= NameKind::tool;
    return is_name && place.where.begin <= byte + 1 && byte <= place.where.end;  // the cursor may stand before the letter of N10 or #100
  });
  return found == names.end() ? nullptr : &*found;
}

std::pair<std::size_t, std::size_t> DocumentNames::scope(std::size_t line, const NamedPlace& place) const {
  std::uint32_t number = 0;
  std::from_chars(place.name.data(), place.name.data() + place.name.size(), number);
  const bool local = place.kind == NameKind::block ||
                     (place.kind == NameKind::variable && number != 0 && number < first_shared_variable && !def_->has_parameter_file());
  if (!local) return {0, lines_.empty() ? 0 : lines_.size() - 1};
  const auto begins_program = [&](std::size_t n) {
    return std::any_of(lines_[n].begin(), lines_[n].end(), [](const NamedPlace& p) { return p.kind == NameKind::program && p.defines; });
  };
  std::size_t first = line, last = line;
  while (first > 0 && !begins_program(first)) --first;
  while (last + 1 < lines_.size() && !begins_program(last + 1)) ++last;
  return {first, last};
}

std::vector<DocumentNames::Found> DocumentNames::all_of(std::size_t line, const NamedPlace& place) const {
  std::vector<Found> found;
  const auto [first, last] = scope(line, place);
  for (std::size_t n = first; n <= last && n < lines_.size(); ++n)
    for (const NamedPlace& other : lines_[n])
      if (other.kind == place.kind && other.name == place.name) found.push_back({n, &other});
  return found;
}

}  // namespace kadr
