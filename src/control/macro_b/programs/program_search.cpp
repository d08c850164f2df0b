// Finds a called program in three steps (spec/fanuc 9.2, spec/haas 1.1): in the caller's own file, then by the names of files, then by the
// first word in each file. Used by control/macro_b/calls; tested by tests/cases/fanuc/programs.cases.

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <functional>

#include "base/ascii.h"
#include "control/interpreter.h"
#include "control/macro_b/programs/programs.h"
#include "lang/text/utf16.h"

namespace kadr::macro_b {
namespace {

namespace fs = std::filesystem;
using Files = std::vector<fs::path>;

constexpr std::size_t max_searched_files = 10'000;  // greatest number of files of one folder that are searched
constexpr std::size_t max_heading = 4096;           // number of bytes at the start of a file that are searched for its first word
constexpr std::size_t max_named = 3;                // greatest number of files that an alarm lists
constexpr std::size_t digits_of_haas = 5, digits_of_fanuc = 4, max_name_digits = 8;

std::string in_capitals(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), to_upper);
  return text;
}

/// Returns the number of digits after the O in a file's name if these digits are the given program number; 0 for any other name.
std::size_t digits_of(const fs::path& file, std::uint32_t number) {
  const std::string stem = in_capitals(file.stem().string());
  const std::size_t digits = stem.size() - 1;
  if (stem.size() < 2 || stem[0] != 'O' || digits > max_name_digits || stem.find_first_not_of("0123456789", 1) != std::string::npos)
    return 0;
  return std::stoul(stem.substr(1)) == number ? digits : 0;
}

/// Returns the regular files of a folder, sorted by name.
Files files_in(const fs::path& folder) {
  Files files;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, fs::directory_options::skip_permission_denied, error)) {
    if (files.size() == max_searched_files) break;
    if (entry.is_regular_file(error)) files.push_back(folder == "." ? entry.path().filename() : entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

Files files_that(const Files& files, const std::function<bool(const fs::path&)>& wanted) {
  Files some;
  std::copy_if(files.begin(), files.end(), std::back_inserter(some), wanted);
  return some;
}

/// The O number or <NAME> of the program in a file, read from the first block that has more than a comment.
struct FirstWord {
  std::optional<std::uint32_t> number;
  std::string name;
  Position start;
};

FirstWord first_word(const fs::path& file, const Grammar& grammar, const FileAccess* door) {
  const auto source = open_text(file.string(), {}, door).source;
  if (!source) return {};
  std::string head(max_heading, '\0');
  head.resize(source->read(0, head.data(), head.size()));
  BlockReader reader(text_source(std::move(head)), grammar, std::nullopt);
  const auto block = std::make_unique<Block>();
  for (;;) {
    const auto got = reader.next(*block);
    if (!got || *got == BlockReader::Got::end) return {};
    if (block->marker == Marker::label) return {block->label, {}, block->position};
    if (block->file_name.end != 0 && block->word_count == 0) return {{}, std::string(block->text_of(block->file_name)), block->position};
    if (!block->empty() && block->marker != Marker::program_start) return {};
  }
}

/// Returns the only file in `files`, or nullopt if `files` is empty. Several files raise an alarm. `shown`: name of the program in the
/// alarm.
///   alarms  programs_alike
Result<std::optional<fs::path>> only_one(const Files& files, std::string_view shown, Span where) {
  if (files.empty()) return std::optional<fs::path>();
  if (files.size() == 1) return std::optional(files.front());
  std::string names;
  for (std::size_t i = 0; i < std::min(files.size(), max_named); ++i) names += (i == 0 ? "" : ", ") + files[i].filename().string();
  if (files.size() > max_named) names += ", …";
  return fail(alarm(AlarmId::programs_alike, where, shown, std::string_view(names)));
}

/// Searches for a program by file name. A file with the caller's extension has priority over files with other extensions. On a Haas, a name
/// of five digits has priority over a name of four.
Result<std::optional<fs::path>> by_file_name(const BlockContext& m, const Files& files, std::uint32_t number, Span where) {
  const std::string extension = in_capitals(fs::path(m.program().file()).extension().string());
  const std::string shown = "O" + std::to_string(number);
  for (const bool same_extension : {true, false}) {
    const auto of = [&](std::size_t digits) {
      return files_that(files, [&](const fs::path& file) {
        const std::size_t found = digits_of(file, number);
        return found != 0 && (digits == 0 || found == digits) && (in_capitals(file.extension().string()) == extension) == same_extension;
      });
    };
    if (m.def.behaviour.program_digits == digits_of_haas)
      for (const std::size_t digits : {digits_of_haas, digits_of_fanuc})
        if (const Files some = of(digits); !some.empty()) return only_one(some, shown, where);
    if (const Files some = of(0); !some.empty()) return only_one(some, shown, where);
  }
  return std::optional<fs::path>();
}

/// Returns the folders in which programs are searched: the folder of the main program, the folder of the caller, and the folder of the
/// option --files.
std::vector<fs::path> folders_of(const BlockContext& m) {
  std::vector<fs::path> folders;
  const auto add = [&](fs::path folder) {
    if (folder.empty()) folder = ".";
    if (std::find(folders.begin(), folders.end(), folder) == folders.end()) folders.push_back(folder);
  };
  add(fs::path(m.program().main_file()).parent_path());
  add(fs::path(m.program().file()).parent_path());
  if (!m.program().limits().files.empty()) add(m.program().limits().files);
  return folders;
}

}  // namespace

Result<std::optional<ProgramLocation>> Programs::in_own_file(Interpreter& m, std::uint32_t number, Span where) {
  const std::vector<Position> places = m.flow.program_file().programs_numbered(number);
  if (places.size() > 1) {
    const std::string lines = std::to_string(places[0].line) + ", " + std::to_string(places[1].line);
    const std::string shown = "O" + std::to_string(number);
    return fail(alarm(AlarmId::programs_alike, where, std::string_view(shown), std::string_view(lines)));
  }
  if (places.empty()) return std::optional<ProgramLocation>();
  if (m.program().reader() == 0) (void)m.flow.label_of(number);  // called only to record that the program is called; the label is not used
  return std::optional(ProgramLocation{m.program().reader(), places.front()});
}

Result<ProgramLocation> Programs::by_steps(Interpreter& m, std::uint32_t number, Span where) {
  const std::pair key{std::uint32_t{m.program().reader()}, number};
  if (const auto known = numbers_.find(key); known != numbers_.end()) return known->second;
  const auto own = in_own_file(m, number, where);
  if (!own) return fail(own.error());
  if (*own) return numbers_[key] = **own;
  const std::vector<fs::path> folders = folders_of(m);
  for (const bool by_word : {false, true})
    for (const fs::path& folder : folders) {
      const Files files = files_in(folder);
      const Files headed = by_word ? files_that(files,
                                                [&](const fs::path& file) {
                                                  return first_word(file, m.def.grammar, m.program().limits().door).number == number;
                                                })
                                   : Files();
      const auto found = by_word ? only_one(headed, "O" + std::to_string(number), where) : by_file_name(m, files, number, where);
      if (!found) return fail(found.error());
      if (!*found) continue;
      const auto place = opened(m, (**found).string(), where);
      if (!place) return fail(place.error());
      return numbers_[key] = *place;
    }
  if (const auto built_in = m.flow.open_built_in(program_name(number))) return numbers_[key] = ProgramLocation{*built_in, {}};
  const std::string name = m.def.behaviour.program_digits == digits_of_haas ? fmt::format("O{:05}", number) : program_name(number);
  return fail(alarm(AlarmId::program_missing, where, std::string_view(name)));
}

Result<std::optional<ProgramLocation>> Programs::by_heading(Interpreter& m, std::string_view name, Span where) {
  for (const fs::path& folder : folders_of(m)) {
    const Files files = files_that(
        files_in(folder), [&](const fs::path& file) { return first_word(file, m.def.grammar, m.program().limits().door).name == name; });
    const auto found = only_one(files, name, where);
    if (!found) return fail(found.error());
    if (!*found) continue;
    const auto place = opened(m, (**found).string(), where);
    if (!place) return fail(place.error());
    return std::optional(*place);
  }
  return std::optional<ProgramLocation>();
}

}  // namespace kadr::macro_b
