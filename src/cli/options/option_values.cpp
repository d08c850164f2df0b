// Defines the values of options: their names in the help, and their checks. This file is used by the rest of cli.

#include "cli/options/option_values.h"

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>

#include "config/control/control_file.h"
#include "config/machine/machine_profile.h"
#include "config/nearest.h"
#include "lang/text/utf16.h"
#include "texts/option_values.h"
#include "texts/values.h"

namespace kadr::cli {
namespace {

std::string joined(const std::vector<std::string>& words, const char* between) {
  std::string list;
  for (const std::string& word : words) list += (list.empty() ? "" : between) + word;
  return list;
}

std::string none_of(const std::string& word, const std::vector<std::string>& words) {
  return translated(texts::option_values::none_of, word, joined(words, ", ")) + did_you_mean(word, words);
}

/// Returns a check that accepts one of the words in small or capital letters, and replaces the value by the word as it is in the list.
CLI::Validator among(std::vector<std::string> words) {
  const auto find = [words = std::move(words)](std::string& word) {
    for (const std::string& known : words)
      if (same_letters(word, known)) {
        word = known;
        return std::string();
      }
    return none_of(word, words);
  };
  return CLI::Validator(find, "");
}

/// Makes the option accept an id, which is converted to small letters. The name of a user's file is not changed; if the file is missing,
/// the function that reads it reports the error. `further_names` is called only if the word is no id, since it unpacks all built-in files.
CLI::Option* id_of(CLI::Option* option, std::vector<std::string> (*ids)(), std::vector<std::string> (*further_names)()) {
  const auto find = [=](std::string& word) {
    for (const auto names : {ids, further_names}) {
      if (names == nullptr) continue;
      for (const std::string& name : names()) {
        if (!same_letters(word, name)) continue;
        word = name;
        return std::string();
      }
    }
    return std::string();
  };
  return takes(option, translated(texts::option_values::id))->transform(CLI::Validator(find, ""));
}

/// Returns the message for a word that is not a number within the limits.
std::string number_error(const std::string& word, bool whole, double least, double most) {
  namespace wanted = texts::option_values;
  const auto text = [](double n) { return std::abs(n) < 1e15 ? fmt::format("{:.15g}", n) : fmt::format("{}", n); };
  if (std::isinf(least) && std::isinf(most)) return translated(whole ? wanted::whole_number : wanted::number, word);
  if (std::isinf(most)) return translated(whole ? wanted::whole_number_from : wanted::number_from, word, text(least));
  return translated(whole ? wanted::whole_number_between : wanted::number_between, word, text(least), text(most));
}

CLI::Option* limited(CLI::Option* option, bool whole, double least, double most) {
  const auto check = [=](std::string& word) {
    char* end = nullptr;
    const double value = std::strtod(word.c_str(), &end);
    const bool is_one = end != word.c_str() && *end == '\0' && !std::isnan(value) &&
                        (!whole || word.find_first_not_of("+-0123456789") == std::string::npos);
    if (is_one && value >= least && value <= most) return std::string();
    return number_error(word, whole, least, most);
  };
  return option->check(CLI::Validator(check, ""));
}

}  // namespace

CLI::Option* takes(CLI::Option* option, const std::string& name) { return option->type_name(name); }
CLI::Option* takes_file(CLI::Option* option) { return takes(option, plain_text(texts::values::file)); }

CLI::Option* writes_file(CLI::Option* option) {
  const auto check = [option](std::string& name) {
    const auto means = [&](const char* word) { return same_letters(name, word); };
    const std::vector<const char*> words_for_none = {"off", "no", "none", "false"};
    const bool is_word = std::any_of(words_for_none.begin(), words_for_none.end(), means);
    const bool is_option = name.size() > 1 && name.front() == '-';
    if (!is_word && !is_option) return std::string();
    if (is_word) return translated(texts::option_values::no_file_without_option, name, option->get_name());
    return translated(texts::option_values::file_named_like_option, name);
  };
  return takes_file(option)->check(CLI::Validator(check, ""));
}

CLI::Option* one_of(CLI::Option* option, const std::vector<std::string>& words) {
  return option->type_name(joined(words, "|"))->transform(among(words));
}

CLI::Option* known_by(CLI::Option* option, const std::string& name, bool (*knows)(std::string_view),
                      const std::vector<std::string>& words) {
  const auto check = [=](std::string& word) { return knows(word) ? std::string() : none_of(word, words); };
  return takes(option, name)->check(CLI::Validator(check, ""));
}

bool takes_nothing(const CLI::Option& option) { return option.get_items_expected_max() == 0; }

CLI::Option* number(CLI::Option* option, const std::string& name, double least, double most) {
  return limited(takes(option, name), false, least, most);
}

CLI::Option* whole_number(CLI::Option* option, double least, double most) { return limited(takes(option, "N"), true, least, most); }

CLI::Option* control_id(CLI::Option* option) { return id_of(option, built_in_controls, control_names); }
CLI::Option* machine_id(CLI::Option* option) { return id_of(option, built_in_machines, nullptr); }

CLI::Option* encoding(CLI::Option* option) {
  const auto knows = [](std::string_view word) {
    GivenEncoding given;
    return read_encoding(word, given);
  };
  return known_by(option, translated(texts::option_values::encoding_name), knows, encodings());
}

CLI::Option* written_letters(CLI::Option* option) {
  return known_by(option, translated(texts::option_values::encoding_name),
                  [](std::string_view word) { return written_letters_named(word).has_value(); },
                  {"ascii", "utf-8", "cp1251", "koi8-r", "cp866", "iso7", "eia"});
}

const std::vector<std::string>& encodings() {
  static const std::vector<std::string> names = {"utf-8", "cp1251", "koi8-r", "cp866", "utf-16", "utf-16le", "utf-16be", "iso7", "eia"};
  return names;
}

}  // namespace kadr::cli
