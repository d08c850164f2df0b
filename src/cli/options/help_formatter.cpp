// Formats the help. CLI11 counts bytes for its columns and prints "TEXT:{a,b} REQUIRED" for the value of an option. This formatter counts
// characters and prints only the name of the value.

#include <fmt/core.h>

#include <CLI/CLI.hpp>

#include "cli/options/help_text.h"
#include "cli/options/option_values.h"
#include "out/text/source_line.h"
#include "texts/help.h"
#include "texts/values.h"

namespace kadr::cli {
namespace {

constexpr std::size_t second_column = 30;
constexpr std::size_t line_width = 110;  // characters

std::size_t characters(const std::string& text) { return characters_before(text, text.size()); }

/// Returns name and description in two columns. The description is wrapped at blanks.
std::string two_columns(const std::string& name, const std::string& description) {
  std::string page = "  " + name;
  std::size_t at = characters(page);
  if (at + 2 > second_column) page += "\n", at = 0;
  page += std::string(second_column - at, ' ');
  at = second_column;
  for (std::size_t i = 0; i < description.size();) {
    const std::size_t blank = std::min(description.find(' ', i), description.size());
    const std::string word = description.substr(i, blank - i);
    const bool first = at == second_column;
    if (!first && at + 1 + characters(word) > line_width) page += "\n" + std::string(second_column, ' ') + word, at = second_column;
    else page += (first ? "" : " ") + word, at += first ? 0 : 1;
    at += characters(word);
    i = blank + 1;
  }
  return page + "\n";
}

class HelpFormatter : public CLI::Formatter {
 public:
  std::string make_usage(const CLI::App* app, std::string) const override {
    std::string usage = translated(texts::help::usage, whole_name(*app));
    for (const CLI::Option* const option : app->get_options([](const CLI::Option* o) { return o->get_positional(); }))
      usage += " " + make_option_usage(option);
    if (!app->get_subcommands([](const CLI::App*) { return true; }).empty())
      usage += fmt::format(" {}", plain_text(texts::values::command));
    return usage + "\n";
  }

  std::string make_group(std::string, bool is_positional, std::vector<const CLI::Option*> options) const override {
    std::string page = fmt::format("\n{}\n", plain_text(is_positional ? texts::help::arguments : texts::help::options));
    for (const CLI::Option* const option : options) page += make_option(option, is_positional);
    return page;
  }

  std::string make_subcommands(const CLI::App* app, CLI::AppFormatMode) const override {
    std::string page;
    for (const CLI::App* const sub : app->get_subcommands([](const CLI::App*) { return true; }))
      page += two_columns(sub->get_name(), sub->get_description());
    return page.empty() ? page : fmt::format("\n{}\n{}", plain_text(texts::help::commands), page);
  }

  std::string make_option(const CLI::Option* option, bool is_positional) const override {
    std::string name = is_positional ? option->get_name(true, false) : names_of(*option);
    const bool takes_value = !takes_nothing(*option);
    if (!is_positional && takes_value) name += " " + option->get_type_name();
    std::string description = option->get_description();
    if (takes_value && !option->get_default_str().empty())
      description = translated(texts::help::with_default, description, option->get_default_str());
    if (takes_value && !is_positional && option->get_required()) description = translated(texts::help::is_required, description);
    return two_columns(name, description);
  }

 private:
  /// Returns the names of an option, e.g. "-q, --quiet".
  static std::string names_of(const CLI::Option& option) {
    std::string names;
    for (const std::string& name : option.get_snames()) names += (names.empty() ? "-" : ", -") + name;
    for (const std::string& name : option.get_lnames()) names += (names.empty() ? "--" : ", --") + name;
    return names;
  }
};

}  // namespace

std::shared_ptr<CLI::FormatterBase> help_formatter() { return std::make_shared<HelpFormatter>(); }

std::string whole_name(const CLI::App& command) {
  const CLI::App* const above = command.get_parent();
  return (above == nullptr ? "" : whole_name(*above) + " ") + command.get_name();
}

}  // namespace kadr::cli
