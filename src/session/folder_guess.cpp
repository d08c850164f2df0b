// FolderGuess: guesses the controls of programs from their texts and from the programs in their folders. It is used by
// cli/job/guessed_control and view/opening, and tested by tests/guess.py and tests/serve_guess.py.

#include "session/folder_guess.h"

#include <algorithm>
#include <filesystem>
#include <system_error>

#include "config/control/guess_section.h"
#include "config/program_names.h"
#include "config/read_file.h"
#include "config/tools/toml_tools.h"
#include "session/guess_trial.h"
#include "texts/guess.h"

namespace kadr {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t whole_sample = 256 << 10;
constexpr std::size_t short_sample = 16 << 10;  // number of bytes that are read from a neighbouring program

std::optional<std::string> sample_of(OpenedText opened, std::size_t most) {
  if (!opened.source) return std::nullopt;
  LineReader reader(std::move(opened.source));
  const std::string_view sample = reader.sample().substr(0, most);
  const auto encoding = opened.encoding ? opened.encoding : detect_encoding(sample);
  std::string text;
  // a failure is ignored: the converted text then ends before the first byte that is not valid in this encoding
  if (encoding) (void)append_utf8(sample, *encoding, text);
  else text = sample;
  return text;
}

/// Returns the paths of the regular files of a folder, sorted. The paths begin with `folder` in the form in which the caller states it.
std::vector<std::string> files_of(const std::string& folder, std::size_t most, const std::function<bool(const fs::path&)>& fits) {
  std::vector<std::string> names;
  std::error_code error;
  for (fs::directory_iterator entry(folder.empty() ? fs::path(".") : fs::path(folder), error);
       !error && entry != fs::directory_iterator() && names.size() < most; entry.increment(error))
    if (std::error_code none; entry->is_regular_file(none) && fits(entry->path()))
      names.push_back((fs::path(folder) / entry->path().filename()).string());
  std::sort(names.begin(), names.end());
  return names;
}

/// Returns the rows of section [guess] in the control files of the folder. With these rows a factory's own control can be guessed too.
std::vector<GuessRows> own_rows(const std::string& folder, const FileAccess* door) {
  constexpr std::size_t max_files = 100;
  std::vector<GuessRows> all;
  for (const std::string& file : files_of(folder, max_files, [](const fs::path& path) { return path.extension() == ".toml"; })) {
    const auto text = read_file(file, limits::config_file_bytes, door);
    if (!text || text->find("[guess]") == std::string::npos) continue;
    // Errors of a control file in the folder are ignored here. They are reported when the user selects the file as a control.
    const auto table = toml_tools::parsed(*text, file);
    const toml::table* const guess = table && table->contains("id") ? (*table)["guess"].as_table() : nullptr;
    auto rows = guess == nullptr ? tl::unexpected<std::string>("") : guess_rows_of(*guess, file);
    if (!rows) continue;
    rows->control = file;
    add_rows_of_language(*rows, (*table)["extends"].value_or(std::string_view()));
    all.push_back(std::move(*rows));
  }
  return all;
}

std::string folder_of(const std::string& file) { return fs::path(file).parent_path().string(); }

/// Returns the last two names of a path, which may be evidence for a control: folder and file, as in "/folder/part.nc".
std::string called(const std::string& file) {
  std::error_code error;
  const fs::path whole = fs::absolute(file, error).lexically_normal();
  return "/" + whole.parent_path().filename().string() + "/" + whole.filename().string();
}

/// Returns some programs of the folder that are not in the list `but`. They are the neighbours, in alphabetical order, of the first file of
/// `but`.
std::vector<std::string> others_near(const std::string& folder, const std::vector<std::string>& but) {
  constexpr std::size_t max_looked_at = 2000, most = 12;
  const auto names = files_of(folder, max_looked_at, [](const fs::path& path) {
    return !path.filename().string().starts_with('.') && judge_name(path.string()) != NameVerdict::other;
  });
  const auto here = std::lower_bound(names.begin(), names.end(), but.front());
  const auto before = std::min<std::ptrdiff_t>(here - names.begin(), most / 2);
  std::vector<std::string> near;
  for (auto at = here - before; at != names.end() && near.size() < most; ++at)
    if (std::find(but.begin(), but.end(), *at) == but.end()) near.push_back(*at);
  return near;
}

}  // namespace

std::optional<std::string> beginning_of_program(const std::string& file, const GivenEncoding& encoding, const FileAccess* door) {
  return sample_of(open_text(file, encoding, door), whole_sample);
}

FolderGuess::FolderGuess(GuessAccess access, const std::vector<std::string>& files) : access_(std::move(access)) {
  std::map<std::string, std::vector<std::string>> of_folder;
  for (const std::string& file : files) {
    if (!named(file).empty()) continue;
    take(file, whole_sample);
    if (guesses_.contains(file)) of_folder[folder_of(file)].push_back(file);
  }
  for (const auto& [folder, its_files] : of_folder) take_neighbours(folder, its_files);
  std::map<std::string, std::vector<std::string>> below;  // folder → its files and the files of its subfolders
  for (const auto& [file, guess] : guesses_)
    for (fs::path folder = folder_of(file);; folder = folder.parent_path()) {
      below[folder.string()].push_back(file);
      if (!folder.has_relative_path() || folder == folder.parent_path()) break;
    }
  for (const auto& [folder, its_files] : below) take_folder(folder, its_files);
}

void FolderGuess::take(const std::string& file, std::size_t max_bytes) {
  const bool edited = access_.text && max_bytes == whole_sample;
  const auto text = sample_of(
      edited ? OpenedText{text_source(*access_.text), Encoding::utf8} : open_text(file, access_.encoding, access_.door), max_bytes);
  if (!text) return;
  const std::string folder = folder_of(file);
  if (!rows_.contains(folder)) rows_[folder] = own_rows(folder, access_.door);
  Guess& guess = guesses_[file] = guess_control(*text, called(file), rows_[folder]);
  if (max_bytes == whole_sample) try_guess(guess, *text);
}

/// Reads some other programs of the folder as evidence, unless many of its programs are given or the controls of all given programs are
/// certain. `of`: the programs of this folder that the user has given.
void FolderGuess::take_neighbours(const std::string& folder, const std::vector<std::string>& of) {
  constexpr std::size_t many = 12;
  const bool sure = std::all_of(of.begin(), of.end(), [this](const std::string& file) { return guesses_[file].decisive; });
  if (sure || of.size() >= many || of.front() == "-") return;
  for (const std::string& file : others_near(folder, of))
    if (named(file).empty()) take(file, short_sample);
}

void FolderGuess::take_folder(const std::string& folder, const std::vector<std::string>& files) {
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

/// Returns the control for which a single file is decisive evidence, in the folder of `file` or in the nearest folder above. Otherwise
/// returns the control that the files of the folder of `file` suggest together. Returns nullopt if the files of a folder disagree.
std::optional<FolderGuess::Neighbours> FolderGuess::neighbours_of(const std::string& file) const {
  const std::string own = folder_of(file);
  for (fs::path folder = own;; folder = folder.parent_path()) {
    const auto found = folders_.find(folder.string());
    if (found == folders_.end()) return std::nullopt;  // the files of the folder disagree, so no control is assumed
    if (!found->second.file.empty()) return found->second;
    if (!folder.has_relative_path() || folder == folder.parent_path()) break;
  }
  return folders_.at(own);
}

std::optional<FolderGuess::Answer> FolderGuess::of(const std::string& file) const {
  const auto found = guesses_.find(file);
  if (found == guesses_.end()) return std::nullopt;
  const Guess& guess = found->second;
  auto neighbours = guess.decisive ? std::nullopt : neighbours_of(file);
  const bool alike = neighbours && fs::path(file).extension() == fs::path(neighbours->file).extension();
  if (!neighbours || neighbours->common.control == guess.control || !may_be(guess, neighbours->common, alike)) neighbours.reset();
  return Answer{guess, std::move(neighbours)};
}

Guess with_neighbours(const FolderGuess::Answer& answer) {
  Guess guess = answer.guess;
  if (!answer.neighbours) return guess;
  const auto& [common, file, reason_en, reason_ru] = *answer.neighbours;
  const std::string name = fs::path(file).filename().string();
  guess.control = common.control;
  guess.decisive = false;
  const auto reason = [&, file = file](Lang lang, const std::string& its) {
    return file.empty() ? translated_in(lang, texts::guess::like_folder) : translated_in(lang, texts::guess::like_neighbour, name, its);
  };
  guess.reason_en = reason(Lang::en, reason_en);
  guess.reason_ru = reason(Lang::ru, reason_ru);
  return guess;
}

}  // namespace kadr
