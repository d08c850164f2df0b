// Describes an error in the command line, and suggests what the user may have meant. This file is used by cli/main.

#include "cli/options/usage_error.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <optional>

#include "cli/options/help_text.h"
#include "cli/options/option_values.h"
#include "config/nearest.h"
#include "out/text/source_line.h"
#include "texts/usage.h"

namespace kadr::cli {
namespace {

/// Returns the innermost command that the command line names, e.g. `decode` for `kadr tape decode`.
const CLI::App& called(const CLI::App& app) {
  const auto parsed = app.get_subcommands();
  return parsed.empty() ? app : called(*parsed.front());
}

std::vector<std::string> commands_of(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* const sub : app.get_subcommands([](const CLI::App*) { return true; })) names.push_back(sub->get_name());
  return names;
}

std::vector<std::string> options_of(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* const option : app.get_options({}))
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  return names;
}

/// Returns the message for a word that is not a command.
std::string no_command(const CLI::App& app, const std::string& word) {
  const auto names = commands_of(app);
  const std::string meant = did_you_mean(word, names);
  if (!meant.empty()) return translated(texts::usage::no_command, word) + meant;
  return translated(texts::usage::no_command_among, word, fmt::format("{}", fmt::join(names, ", ")));
}

/// Returns the message for the first argument that no command accepts. An unknown option is reported before other arguments, since the
/// parser does not accept its value either.
std::optional<std::string> left_over(const CLI::App& app, const CLI::App& command) {
  const std::vector<std::string> words = app.remaining(true);
  const auto is_option = [](const std::string& word) { return word.size() > 1 && word[0] == '-' && word != "--"; };
  const auto option = std::find_if(words.begin(), words.end(), is_option);
  if (option != words.end()) {
    const std::string name = option->substr(0, option->find('='));
    return translated(texts::usage::no_option, name, whole_name(command)) + did_you_mean(name, options_of(command));
  }
  const auto word = std::find_if(words.begin(), words.end(), [](const std::string& w) { return w != "--"; });
  if (word == words.end()) return std::nullopt;
  if (!commands_of(command).empty()) return no_command(command, *word);
  return translated(texts::usage::too_many_arguments, *word, whole_name(command));
}

/// Returns the message for a required option or command that is missing.
std::string missing(const CLI::App& command) {
  for (const CLI::Option* const option : command.get_options({}))
    if (option->get_required() && option->count() == 0)
      return translated(texts::usage::option_missing, option->get_name(), option->get_description());
  return translated(texts::usage::command_missing, fmt::format("{}", fmt::join(commands_of(command), ", ")));
}

/// Returns the option to which a message of CLI11 refers. The message names the option at its beginning, or after the first ": ".
const CLI::Option* option_of(const CLI::App& command, const std::string& sentence) {
  const CLI::Option* found = nullptr;
  std::size_t first = std::string::npos;
  for (const CLI::Option* const option : command.get_options({})) {
    const std::size_t at = sentence.find(option->get_name());
    // If --plot and --plot-speed both match at the same position, the message refers to the longer name.
    if (at < first || (at != std::string::npos && at == first && option->get_name().size() > found->get_name().size()))
      first = at, found = option;
  }
  return found;
}

/// Returns the message for too few values, for too many values, or for a value of an option that has none.
std::string wrong_count(const CLI::App& command, const std::string& sentence) {
  const CLI::Option* const option = option_of(command, sentence);
  if (option == nullptr) return sentence;
  const std::string name = option->get_name();
  if (takes_nothing(*option)) return translated(texts::usage::takes_no_value, name);
  const int wanted = option->get_items_expected_min();
  if (static_cast<int>(option->count()) > std::max(wanted, 1)) return translated(texts::usage::given_more_than_once, name);
  if (wanted > 1) return translated(texts::usage::several_values_wanted, name, wanted, option->get_description());
  return translated(texts::usage::value_missing, name, option->get_type_name());
}

std::string sentence_of(const CLI::App& app, const CLI::App& command, const CLI::ParseError& error) {
  const bool required = dynamic_cast<const CLI::RequiredError*>(&error) != nullptr;
  if (required || dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr)
    if (const auto word = left_over(app, command)) return *word;
  if (required) return missing(command);
  if (dynamic_cast<const CLI::ValidationError*>(&error) != nullptr)
    return error.what();  // the message comes from Kadr's own checks (cli/options/option_values), so it is already clear
  return wrong_count(command, error.what());
}

}  // namespace

std::string usage_error(const CLI::App& app, const CLI::ParseError& error) {
  const CLI::App& command = called(app);
  const std::string help = translated(texts::usage::help, whole_name(command) + " --help");
  return fmt::format("kadr: {}\n{}\n", visible(sentence_of(app, command, error)), help);
}

}  // namespace kadr::cli
