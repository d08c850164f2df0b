// Guesses the control of a program. This file is used by cli/job/job and cli/check, and tested by tests/guess.py.

#include "cli/job/guessed_control.h"

#include <fmt/core.h>

#include <cerrno>
#include <filesystem>

#include "config/control/remembered_control.h"
#include "config/program_names.h"
#include "config/read_file.h"
#include "texts/job.h"

namespace kadr::cli {
namespace {

GivenEncoding encoding_of(const Options& options) {
  GivenEncoding given;
  (void)read_encoding(options.encoding, given);  // an unknown encoding is ignored here, since make_job() reports it later
  return given;
}

void print_guess(const Options& options, const std::string& file, const Guess& guess) {
  const Lang lang = language(options);
  const std::string& reason = lang == Lang::ru ? guess.reason_ru : guess.reason_en;
  if (guess.control.empty()) return complain(translated_in(lang, texts::job::unknown_control, file, reason));
  if (options.guesses_silently) return;
  if (guess.decisive) return complain(translated_in(lang, texts::job::looks_like, file, guess.control, reason));
  const std::string next = guess.runner_up();
  complain(next.empty() ? translated_in(lang, texts::job::weak_guess, file, guess.control, reason)
                        : translated_in(lang, texts::job::weak_guess_before, file, guess.control, reason, next));
}

/// Stores the control that the command line names in the folder of the file (--remember). If this fails, the function prints an error and
/// returns false.
bool remembers(const Options& options, const std::string& file) {
  const bool can = !options.control.empty() && file != "-";
  const std::string error = can ? save_control_choice(options.control, file) : translated(texts::job::nothing_to_remember);
  if (!error.empty()) complain(error);
  return error.empty();
}

/// Stores the control once in each folder of the files, if the user has given --remember, before the first control is guessed. Returns the
/// files in whose folder the control could not be stored.
std::set<std::string> forgotten_of(const Options& options, const std::vector<std::string>& files) {
  std::set<std::string> forgotten, remembering;
  for (const std::string& file : files)
    if (options.remembers && remembering.insert(std::filesystem::path(file).parent_path().string()).second && !remembers(options, file))
      forgotten.insert(file);
  return forgotten;
}

}  // namespace

std::string named_control(const Options& options, const std::string& file) {
  for (const std::string& rule : options.control_for) {
    const std::size_t equals = rule.rfind('=');
    if (equals != std::string::npos && is_like(file, rule.substr(0, equals))) return rule.substr(equals + 1);
  }
  if (!options.control.empty() || file == "-") return options.control;
  static RememberedControls remembered(complain);
  return remembered.of(file);
}

std::optional<std::string> control_of(const Options& options, const std::string& file) { return GuessedControls(options, {file}).of(file); }

GuessedControls::GuessedControls(const Options& options, const std::vector<std::string>& files)
    : options_(options),
      forgotten_(forgotten_of(options, files)),
      guesses_({[&options](const std::string& file) { return named_control(options, file); }, encoding_of(options)}, files) {}

void GuessedControls::print_neighbours(const std::string& file, const FolderGuess::Neighbours& neighbours) const {
  const Lang lang = language(options_);
  const auto& [common, shown_by, reason_en, reason_ru] = neighbours;
  const std::string& reason = lang == Lang::ru ? reason_ru : reason_en;
  if (!common.dialect.empty()) return complain(translated_in(lang, texts::job::unknown_control_as_in, file, reason, shown_by));
  if (options_.guesses_silently) return;
  if (shown_by.empty()) return complain(translated_in(lang, texts::job::like_its_folder, file, common.control));
  complain(translated_in(lang, texts::job::like_its_neighbour, file, common.control, shown_by, reason));
}

/// Returns true if the file is a lathe program, and Kadr supports its control for milling only. Then the function also prints a message
/// with this reason.
bool GuessedControls::refuses(const std::string& file, const std::string& control) const {
  if (control.ends_with(".toml")) return false;
  const auto text = beginning_of_program(file, encoding_of(options_));
  const std::string why = text ? refused_by_control(*text, control, language(options_)) : std::string();
  if (!why.empty()) complain(fmt::format("{}: {}", file, why));
  return !why.empty();
}

std::optional<std::string> GuessedControls::of(const std::string& file) const {
  if (forgotten_.contains(file)) return std::nullopt;
  if (std::string named = named_control(options_, file); !named.empty()) return refuses(file, named) ? std::string() : named;
  const auto found = guesses_.of(file);
  if (!found) {
    if (!beginning_of_program(file, encoding_of(options_))) complain(fmt::format("{}: {}", file, errno_message(errno)));
    return std::nullopt;
  }
  if (found->neighbours) print_neighbours(file, *found->neighbours);
  else print_guess(options_, file, found->guess);
  return found->control();
}

}  // namespace kadr::cli
