#pragma once
// The texts that people read, by id. They are in texts/en.toml and texts/ru.toml. The build makes a header for each section of these files
// (dev/embed_texts.cpp), so that a misspelt id or a wrong number of arguments does not compile:
//
//   // with the header texts/mesh.h
//   translated(texts::mesh::no_such_point, triangle, n)  // no_such_point = "triangle {}: no point has the number {}"
//   counted(texts::check_command::errors, n)             // errors = ["{} error", "{} errors"]
//
// Texts of alarms and of the control files are in controls/*.toml. Tested by tests/texts.py and tests/config/texts_test.cpp.

#include <fmt/format.h>

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "config/language.h"
#include "config/text_id.h"

namespace kadr {

/// The rule by which a language selects the form of a text for a number (Unicode CLDR, "Language Plural Rules", whole numbers).
enum class PluralRule : std::uint8_t {
  none,       // the language has one form for all numbers
  one_other,  // English, two forms: for 1; for all other numbers
  slavic,     // Russian, three forms: for 1, 21, …; for 2 … 4, 22, …; for all other numbers
};

/// Returns the index, from 0, of the form that the rule selects for `n`.
std::size_t plural_form(PluralRule rule, std::uint64_t n);

/// The texts of one language, with its id and plural rule.
struct TextLanguage {
  const char *id, *name;  // id and name of the language: "ru", "Русский"
  PluralRule plurals;
  // Texts by section and row; the forms of a plural text follow one another, each with a NUL at its end
  const char* const* const* sections;
};

/// Returns the languages of texts/, English first. A value of Lang is the index.
std::span<const TextLanguage> text_languages();

/// Returns the language whose id is the beginning of a name: "ru" and "ru_RU.UTF-8" are Russian. Returns nullopt for an unknown language.
std::optional<Lang> language_named(std::string_view name);
/// Returns the id of a language: "ru".
inline const char* id_of(Lang lang) { return text_languages()[static_cast<std::size_t>(lang)].id; }

/// Returns the text from its file, with its placeholders, in the language `lang`. The text exists as long as the process.
const char* text_pattern(std::uint16_t section, std::uint16_t row, Lang lang);
inline const char* plain_text(PlainText id, Lang lang = thread_language()) { return text_pattern(id.section, id.row, lang); }

/// Returns the form of a text for the number `n`.
const char* plural_pattern(std::uint16_t section, std::uint16_t row, std::uint64_t n, Lang lang);

/// Returns a text in the language `lang`, with its arguments inserted. A text without placeholders is not formatted, so its braces are
/// printed.
template <std::size_t Holes, typename... Args>
requires(sizeof...(Args) == Holes) std::string translated_in(Lang lang, TextId<Holes> id, const Args&... args) {
  const char* const pattern = text_pattern(id.section, id.row, lang);
  if constexpr (Holes == 0) return pattern;
  else return fmt::vformat(pattern, fmt::make_format_args(args...));
}

/// Returns a text in the language of the thread, with its arguments inserted.
template <std::size_t Holes, typename... Args>
requires(sizeof...(Args) == Holes) std::string translated(TextId<Holes> id, const Args&... args) {
  return translated_in(thread_language(), id, args...);
}

/// Returns a text in the form for the number `n`, in the language `lang`. The first argument of the text is `n`.
template <std::size_t Holes, typename... Args>
requires(sizeof...(Args) == Holes) std::string counted_in(Lang lang, PluralId<Holes> id, std::uint64_t n, const Args&... args) {
  return fmt::vformat(plural_pattern(id.section, id.row, n, lang), fmt::make_format_args(n, args...));
}

/// Returns a text in the form for the number `n`, in the language of the thread.
template <std::size_t Holes, typename... Args>
requires(sizeof...(Args) == Holes) std::string counted(PluralId<Holes> id, std::uint64_t n, const Args&... args) {
  return counted_in(thread_language(), id, n, args...);
}

}  // namespace kadr
