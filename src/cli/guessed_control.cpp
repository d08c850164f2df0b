// For cli/job, cli/check; tests/guess.py.

#include "cli/guessed_control.h"

#include <fmt/core.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <set>
#include <system_error>

#include "cli/program_files.h"
#include "config/program_names.h"
#include "config/read_file.h"
#include "config/remembered_control.h"
#include "config/told.h"
#include "config/toml_tools.h"
#include "lang/text/utf16.h"
#include "session/guess_trial.h"

namespace kadr::cli {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t whole_sample = 256 << 10;
constexpr std::size_t short_sample = 16 << 10;  // of a neighbour

/// The beginning of a program as text.
std::optional<std::string> sample_of(const std::string& file, const std::string& encoding_name, std::size_t most = whole_sample) {
  SaidEncoding said;
  (void)read_encoding(encoding_name, said);  // a name that nobody knows is refused later
  OpenedText opened = open_text(file, said);
  if (!opened.source) return std::nullopt;
  LineReader reader(std::move(opened.source));
  const std::string_view sample = reader.sample().substr(0, most);
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

/// "/folder/part.nc": what it and the folder it lies in are called.
std::string called(const std::string& file) {
  std::error_code error;
  const fs::path whole = fs::absolute(file, error).lexically_normal();
  return "/" + whole.parent_path().filename().string() + "/" + whole.filename().string();
}

/// Programs of the folder beside those of `but`, those named next to them.
std::vector<std::string> others_beside(const std::string& folder, const std::vector<std::string>& but) {
  constexpr std::size_t most_looked_at = 2000, most = 12;
  std::vector<std::string> names;
  std::error_code error;
  for (fs::directory_iterator entry(folder.empty() ? fs::path(".") : fs::path(folder), error);
       !error && entry != fs::directory_iterator() && names.size() < most_looked_at; entry.increment(error)) {
    const std::string file = (fs::path(folder) / entry->path().filename()).string();
    if (std::error_code none; entry->is_regular_file(none) && has_program_name(file)) names.push_back(file);
  }
  std::sort(names.begin(), names.end());
  const auto here = std::lower_bound(names.begin(), names.end(), but.front());
  const auto before = std::min<std::ptrdiff_t>(here - names.begin(), most / 2);
  std::vector<std::string> near;
  for (auto at = here - before; at != names.end() && near.size() < most; ++at)
    if (std::find(but.begin(), but.end(), *at) == but.end()) near.push_back(*at);
  return near;
}

void say_guess(const Options& options, const std::string& file, const Guess& guess) {
  const bool ru = language(options) == Lang::ru;
  if (guess.control.empty())
    return complain(
        ru ? fmt::format("{}: УЧПУ неизвестно ({}); если это УП: --control", file, guess.reason_ru)
           : fmt::format("{}: unknown, no program of a control that Kadr knows ({}); if it is one: --control", file, guess.reason_en));
  if (options.guesses_silently) return;
  if (guess.decisive)
    return complain(ru ? fmt::format("{}: похоже на {} ({}); иначе: --control", file, guess.control, guess.reason_ru)
                       : fmt::format("{}: looks like {} ({}); otherwise: --control", file, guess.control, guess.reason_en));
  const std::string next = guess.runner_up();
  const std::string then = next.empty() ? "" : fmt::format(fmt::runtime(ru ? "; затем {}" : "; next comes {}"), next);
  complain(ru ? fmt::format("{}: может быть, {}: догадка слабая, решающего признака нет ({}){}; иначе: --control", file, guess.control,
                            guess.reason_ru, then)
              : fmt::format("{}: perhaps {}: a weak guess, nothing decides ({}){}; otherwise: --control", file, guess.control,
                            guess.reason_en, then));
}

/// --remember.
bool remembers(const Options& options, const std::string& file) {
  const bool can = !options.control.empty() && file != "-";
  const std::string error = can ? remember_control(options.control, file)
                                : std::string(told("--remember: --control says what", "--remember: что запомнить, скажет --control"));
  if (!error.empty()) complain(error);
  return error.empty();
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

GuessedControls::GuessedControls(const Options& options, const std::vector<std::string>& files) : options_(options) {
  std::map<std::string, std::vector<std::string>> of_folder;
  std::set<std::string> remembering;
  for (const std::string& file : files) {
    if (options.remembers && remembering.insert(folder_of(file)).second && !remembers(options, file)) forgotten_.insert(file);
    if (!named_control(options, file).empty()) continue;
    take(file, whole_sample);
    if (guesses_.contains(file)) of_folder[folder_of(file)].push_back(file);
  }
  for (const auto& [folder, its_files] : of_folder) take_neighbours(folder, its_files);
  std::map<std::string, std::vector<std::string>> below;  // files of a folder, and of those below it
  for (const auto& [file, guess] : guesses_)
    for (fs::path folder = folder_of(file);; folder = folder.parent_path()) {
      below[folder.string()].push_back(file);
      if (!folder.has_relative_path() || folder == folder.parent_path()) break;
    }
  for (const auto& [folder, its_files] : below) take_folder(folder, its_files);
}

void GuessedControls::take(const std::string& file, std::size_t most_bytes) {
  const auto text = sample_of(file, options_.encoding, most_bytes);
  if (!text) return;
  const std::string folder = folder_of(file);
  if (!rows_.contains(folder)) rows_[folder] = own_rows(folder);
  Guess& guess = guesses_[file] = guess_control(*text, called(file), rows_[folder]);
  if (most_bytes == whole_sample) try_guess(guess, *text);
}

/// Of a folder of which few programs are named, and one is not sure: others that lie there.
void GuessedControls::take_neighbours(const std::string& folder, const std::vector<std::string>& of) {
  constexpr std::size_t many = 12;
  const bool sure = std::all_of(of.begin(), of.end(), [this](const std::string& file) { return guesses_[file].decisive; });
  if (sure || of.size() >= many || of.front() == "-") return;
  for (const std::string& file : others_beside(folder, of))
    if (named_control(options_, file).empty()) take(file, short_sample);
}

void GuessedControls::take_folder(const std::string& folder, const std::vector<std::string>& files) {
  std::vector<Guess> guesses;
  for (const std::string& file : files) guesses.push_back(guesses_[file]);
  Neighbours found{common_guess(guesses), {}, {}, {}};
  const CommonGuess& common = found.common;
  if (common.control.empty() && common.dialect.empty()) return;
  const auto shows = std::find_if(files.begin(), files.end(), [&](const std::string& file) {
    const Guess& guess = guesses_[file];
    return guess.decisive && guess.control == common.control && guess.dialect == common.dialect;
  });
  if (shows != files.end()) found.file = *shows, found.reason_en = guesses_[*shows].reason_en, found.reason_ru = guesses_[*shows].reason_ru;
  folders_[folder] = found;
}

/// Decided by a file of the same folder or of one above; else what the folder as a whole is like.
std::optional<GuessedControls::Neighbours> GuessedControls::neighbours_of(const std::string& file) const {
  const std::string own = folder_of(file);
  for (fs::path folder = own;; folder = folder.parent_path()) {
    const auto found = folders_.find(folder.string());
    if (found == folders_.end()) return std::nullopt;  // its files do not agree
    if (!found->second.file.empty()) return found->second;
    if (!folder.has_relative_path() || folder == folder.parent_path()) break;
  }
  return folders_.at(own);
}

void GuessedControls::say(const std::string& file, const Neighbours& neighbours) const {
  const bool ru = language(options_) == Lang::ru;
  const auto& [common, shown_by, reason_en, reason_ru] = neighbours;
  if (!common.dialect.empty())
    return complain(ru ? fmt::format("{}: УЧПУ неизвестно ({}, как и {}); если это УП: --control", file, reason_ru, shown_by)
                       : fmt::format("{}: unknown, no program of a control that Kadr knows ({}, as in {}); if it is one: --control", file,
                                     reason_en, shown_by));
  if (options_.guesses_silently) return;
  if (shown_by.empty())
    return complain(
        ru ? fmt::format("{}: как и вся папка, может быть, {}: догадка слабая; иначе: --control", file, common.control)
           : fmt::format("{}: perhaps {}, like its folder as a whole: a weak guess; otherwise: --control", file, common.control));
  complain(ru ? fmt::format("{}: может быть, {}, как и {} ({}); своего решающего признака нет; иначе: --control", file, common.control,
                            shown_by, reason_ru)
              : fmt::format("{}: perhaps {}, as {} is ({}); nothing of its own decides; otherwise: --control", file, common.control,
                            shown_by, reason_en));
}

/// A lathe's program, of a control that Kadr reads as a mill's. Told.
bool GuessedControls::refuses(const std::string& file, const std::string& control) const {
  if (control.ends_with(".toml")) return false;
  const auto text = sample_of(file, options_.encoding);
  const std::string why = text ? refused_by_control(*text, control, language(options_) == Lang::ru) : std::string();
  if (!why.empty()) complain(fmt::format("{}: {}", file, why));
  return !why.empty();
}

std::optional<std::string> GuessedControls::of(const std::string& file) const {
  if (forgotten_.contains(file)) return std::nullopt;
  if (std::string named = named_control(options_, file); !named.empty()) return refuses(file, named) ? std::string() : named;
  const auto found = guesses_.find(file);
  if (found == guesses_.end()) {
    if (!sample_of(file, options_.encoding)) complain(fmt::format("{}: {}", file, told_errno(errno)));
    return std::nullopt;
  }
  const Guess& guess = found->second;
  const auto neighbours = guess.decisive ? std::nullopt : neighbours_of(file);
  const bool alike = neighbours && fs::path(file).extension() == fs::path(neighbours->file).extension();
  if (!neighbours || neighbours->common.control == guess.control || !may_be(guess, neighbours->common, alike)) {
    say_guess(options_, file, guess);
    return guess.control;
  }
  say(file, *neighbours);
  return neighbours->common.control;
}

}  // namespace kadr::cli
