// For cli/job, cli/check; tests/guess.py.

#include "cli/guessed_control.h"

#include <fmt/core.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <system_error>

#include "cli/program_files.h"
#include "config/read_file.h"
#include "config/toml_tools.h"
#include "lang/text/utf16.h"

namespace kadr::cli {
namespace {

namespace fs = std::filesystem;

/// The beginning of a program as text.
std::optional<std::string> sample_of(const std::string& file, const std::string& encoding_name) {
  SaidEncoding said;
  (void)read_encoding(encoding_name, said);  // a name that nobody knows is refused later
  OpenedText opened = open_text(file, said);
  if (!opened.source) return std::nullopt;
  LineReader reader(std::move(opened.source));
  const std::string_view sample = reader.sample();
  const auto encoding = opened.encoding ? opened.encoding : detect_encoding(sample);
  std::string text;
  if (encoding) (void)append_utf8(sample, *encoding, text);  // up to the first damaged byte
  else text = sample;
  return text;
}

/// Rows of [guess] of the control files that lie in the folder: a factory's own control is told from others, too.
std::vector<GuessRows> own_rows(const fs::path& folder) {
  constexpr std::size_t most_files = 100;
  std::vector<GuessRows> all;
  std::error_code error;
  std::vector<std::string> files;
  for (fs::directory_iterator entry(folder.empty() ? fs::path(".") : folder, error); !error && entry != fs::directory_iterator();
       entry.increment(error))
    if (std::error_code none; entry->path().extension() == ".toml" && entry->is_regular_file(none) && files.size() < most_files)
      files.push_back((folder / entry->path().filename()).string());
  std::sort(files.begin(), files.end());
  for (const std::string& file : files) {
    const auto text = read_file(file);
    if (!text || text->find("[guess]") == std::string::npos) continue;
    const auto table = toml_tools::parsed(*text, file);  // whoever runs it is told what is wrong with the file
    const toml::table* const guess = table && table->contains("id") ? (*table)["guess"].as_table() : nullptr;
    auto rows = guess == nullptr ? tl::unexpected<std::string>("") : guess_rows_of(*guess, file);
    if (!rows) continue;
    rows->control = file;
    all.push_back(std::move(*rows));
  }
  return all;
}

std::string folder_of(const std::string& file) { return fs::path(file).parent_path().string(); }

void say_guess(const Options& options, const std::string& file, const Guess& guess) {
  const bool ru = language(options) == Lang::ru;
  if (guess.control.empty())
    return complain(
        ru ? fmt::format("{}: УЧПУ неизвестно ({}); если это УП: --control", file, guess.reason_ru)
           : fmt::format("{}: unknown, no program of a control that Kadr knows ({}); if it is one: --control", file, guess.reason_en));
  if (options.guesses_silently) return;
  if (guess.decisive)
    complain(ru ? fmt::format("{}: похоже на {} ({}); иначе: --control", file, guess.control, guess.reason_ru)
                : fmt::format("{}: looks like {} ({}); otherwise: --control", file, guess.control, guess.reason_en));
  else
    complain(
        ru ? fmt::format("{}: может быть, {}: догадка слабая, решающего признака нет ({}); иначе: --control", file, guess.control,
                         guess.reason_ru)
           : fmt::format("{}: perhaps {}: a weak guess, nothing decides ({}); otherwise: --control", file, guess.control, guess.reason_en));
}

}  // namespace

std::string control_by_pattern(const Options& options, const std::string& file) {
  for (const std::string& rule : options.control_for) {
    const std::size_t equals = rule.rfind('=');
    if (equals != std::string::npos && is_like(file, rule.substr(0, equals))) return rule.substr(equals + 1);
  }
  return options.control;
}

std::optional<std::string> control_of(const Options& options, const std::string& file) { return GuessedControls(options, {file}).of(file); }

GuessedControls::GuessedControls(const Options& options, const std::vector<std::string>& files) : options_(options) {
  std::map<std::string, std::vector<GuessRows>> rows;
  std::map<std::string, std::vector<std::string>> below;  // files of a folder, and of those below it
  for (const std::string& file : files) {
    if (!control_by_pattern(options, file).empty()) continue;
    const auto text = sample_of(file, options.encoding);
    if (!text) continue;
    const std::string own = folder_of(file);
    if (!rows.contains(own)) rows[own] = own_rows(own);
    guesses_[file] = guess_control(*text, rows[own]);
    for (fs::path folder = own;; folder = folder.parent_path()) {
      below[folder.string()].push_back(file);
      if (!folder.has_relative_path() || folder == folder.parent_path()) break;
    }
  }
  for (const auto& [folder, its_files] : below) {
    std::vector<Guess> guesses;
    for (const std::string& file : its_files) guesses.push_back(guesses_[file]);
    Neighbour neighbour{common_control(guesses), {}, {}, {}};
    const auto shows = std::find_if(its_files.begin(), its_files.end(), [&](const std::string& file) {
      return guesses_[file].decisive && guesses_[file].control == neighbour.control;
    });
    if (neighbour.control.empty()) continue;
    if (shows != its_files.end())
      neighbour.file = *shows, neighbour.reason_en = guesses_[*shows].reason_en, neighbour.reason_ru = guesses_[*shows].reason_ru;
    folders_[folder] = neighbour;
  }
}

/// Decided by a file of the same folder or of one above; else what the folder as a whole is like.
std::optional<GuessedControls::Neighbour> GuessedControls::neighbour_of(const std::string& file) const {
  const std::string own = folder_of(file);
  for (fs::path folder = own;; folder = folder.parent_path()) {
    const auto found = folders_.find(folder.string());
    if (found == folders_.end()) return std::nullopt;  // its files do not agree
    if (!found->second.file.empty()) return found->second;
    if (!folder.has_relative_path() || folder == folder.parent_path()) break;
  }
  return folders_.at(own);
}

std::optional<std::string> GuessedControls::of(const std::string& file) const {
  if (std::string named = control_by_pattern(options_, file); !named.empty()) return named;
  const auto found = guesses_.find(file);
  if (found == guesses_.end()) {
    if (!sample_of(file, options_.encoding)) complain(fmt::format("{}: {}", file, told_errno(errno)));
    return std::nullopt;
  }
  const Guess& guess = found->second;
  const auto neighbour = guess.decisive ? std::nullopt : neighbour_of(file);
  if (!neighbour || neighbour->control == guess.control) {
    say_guess(options_, file, guess);
    return guess.control;
  }
  const bool ru = language(options_) == Lang::ru;
  const auto& [control, shown_by, reason_en, reason_ru] = *neighbour;
  if (options_.guesses_silently) return control;
  if (shown_by.empty())
    complain(ru ? fmt::format("{}: как и вся папка, может быть, {}: догадка слабая; иначе: --control", file, control)
                : fmt::format("{}: perhaps {}, like its folder as a whole: a weak guess; otherwise: --control", file, control));
  else
    complain(
        ru ? fmt::format("{}: {}, как и {} ({}); своего решающего признака нет; иначе: --control", file, control, shown_by, reason_ru)
           : fmt::format("{}: {}, as {} is ({}); nothing of its own decides; otherwise: --control", file, control, shown_by, reason_en));
  return control;
}

}  // namespace kadr::cli
