// The texts that people read, by id: finds a text, and selects the plural form for a number. Used by every room from config on; tested by
// tests/config/texts_test.cpp.

#include "config/texts.h"

#include <cstring>

namespace kadr {
namespace {

const TextLanguage& language_of(Lang lang) {
  const std::span<const TextLanguage> all = text_languages();
  const auto nth = static_cast<std::size_t>(lang);
  return all[nth < all.size() ? nth : 0];
}

}  // namespace

std::size_t plural_form(PluralRule rule, std::uint64_t n) {
  if (rule == PluralRule::none) return 0;
  if (rule == PluralRule::one_other) return n == 1 ? 0 : 1;
  const std::uint64_t ten = n % 10, hundred = n % 100;
  const bool teen = hundred >= 11 && hundred <= 14;
  return teen ? 2 : ten == 1 ? 0 : ten >= 2 && ten <= 4 ? 1 : 2;
}

std::optional<Lang> language_named(std::string_view name) {
  const std::span<const TextLanguage> all = text_languages();
  for (std::size_t i = 0; i < all.size(); ++i)
    if (name.starts_with(all[i].id)) return static_cast<Lang>(i);
  return std::nullopt;
}

const char* text_pattern(std::uint16_t section, std::uint16_t row, Lang lang) { return language_of(lang).sections[section][row]; }

const char* plural_pattern(std::uint16_t section, std::uint16_t row, std::uint64_t n, Lang lang) {
  const TextLanguage& language = language_of(lang);
  const char* form = language.sections[section][row];
  for (std::size_t skip = plural_form(language.plurals, n); skip > 0; --skip) form += std::strlen(form) + 1;
  return form;
}

}  // namespace kadr
