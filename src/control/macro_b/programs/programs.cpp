// Finds programs by number and by name in the program memory, which consists of folders on the disk (spec/nct/14 14.4.1, 14.4.2). Used by
// control/macro_b/calls/calls, control/macro_b/memory.

#include "control/macro_b/programs/programs.h"

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>

#include "base/ascii.h"
#include "control/interpreter.h"
#include "lang/text/utf16.h"

namespace kadr::macro_b {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t max_name = 60;  // greatest number of characters of a program name between < and > (14.4.2)
constexpr int max_parents = 16;       // greatest number of folders above the program that are searched for SystemMacros
constexpr std::uint32_t most_short = 9999;
constexpr std::size_t max_files = 10'000;  // greatest number of files of one folder that are examined
constexpr std::size_t max_head = 512;      // number of bytes at the start of a file that are searched for its program number

bool alike(std::string a, std::string b) {
  const auto small = [](std::string& s) { std::transform(s.begin(), s.end(), s.begin(), to_lower); };
  small(a);
  small(b);
  return a == b;
}

/// Returns the file with a name in a folder. INFERRED: capital and small letters in names are equal.
std::optional<fs::path> in_folder(const fs::path& folder, const std::string& name) {
  std::error_code error;
  if (fs::is_regular_file(folder / name, error)) return folder / name;
  for (const auto& entry :
       fs::directory_iterator(folder.empty() ? fs::path(".") : folder, fs::directory_options::skip_permission_denied, error))
    if (entry.is_regular_file(error) && alike(entry.path().filename().string(), name)) return folder / entry.path().filename();
  return std::nullopt;
}

/// Returns true if the file's real path, with links followed, is below the folder. A program must not read any other file.
bool is_below(const fs::path& file, const fs::path& folder) {
  std::error_code error;
  const fs::path real = fs::canonical(file, error);
  if (error) return false;
  const fs::path root = fs::canonical(folder.empty() ? fs::path(".") : folder, error);
  if (error) return false;
  const auto parted = std::mismatch(root.begin(), root.end(), real.begin(), real.end());
  return parted.first == root.end();
}

/// Returns true if the file is in the program memory: in the main program's folder, or in the folder that the option --files gives.
bool is_inside(const BlockContext& m, const fs::path& file) {
  const std::string& given = m.program().limits().files;
  return is_below(file, fs::path(m.program().main_file()).parent_path()) || (!given.empty() && is_below(file, given));
}

/// Returns the file of a program number in a folder. The name with four digits has priority over the name with eight digits.
std::optional<fs::path> numbered(const fs::path& folder, std::uint32_t number, const std::string& extension) {
  if (number <= most_short)
    if (auto found = in_folder(folder, fmt::format("O{:04}{}", number, extension))) return found;
  return in_folder(folder, fmt::format("O{:08}{}", number, extension));
}

std::size_t characters(std::string_view text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

/// Converts a file name written in a program, such as "\subs\x.prg" or " ..\x.prg", to a path relative to the caller's folder.
fs::path path_of(std::string_view name) {
  std::string text(name);
  std::replace(text.begin(), text.end(), '\\', '/');
  text.erase(0, text.find_first_not_of(" /"));
  while (!text.empty() && text.back() == ' ') text.pop_back();
  return fs::path(text).lexically_normal();
}

/// Reads a number in any of the forms "O00020", "0020", "20".
std::optional<std::uint32_t> number_in(std::string_view text) {
  if (!text.empty() && (text[0] == 'O' || text[0] == 'o')) text.remove_prefix(1);
  if (text.empty() || text.size() > 8 || text.find_first_not_of("0123456789") != std::string_view::npos) return std::nullopt;
  return static_cast<std::uint32_t>(std::stoul(std::string(text)));
}

/// Returns true for .nct and .prg, the extensions of the NCT. Names of files with these extensions must follow 14.4.1 (O1, O01234 are
/// invalid). Files with another extension, such as `.nc` of another workshop, may have any name.
bool names_are_strict(const std::string& extension) { return alike(extension, ".nct") || alike(extension, ".prg"); }

/// The program number at the start of a file, after `O` or `:`. A line with % and empty lines may come before it.
struct Heading {
  std::uint32_t number = 0;
  Position start;  // start of the program: the second line if the first line has `:`, which this control does not read
};

std::optional<Heading> heading_of(const fs::path& path, const FileAccess* door) {
  const auto source = open_text(path.string(), {}, door).source;
  std::string head(max_head, '\0');
  head.resize(source ? source->read(0, head.data(), head.size()) : 0);
  const auto first_not_of = [&](const char* passed, std::size_t from) {
    return std::min(head.find_first_not_of(passed, from), head.size());
  };
  const auto line_end = [&](std::size_t from) { return std::min(head.find('\n', from), head.size()); };
  std::size_t at = first_not_of(" \t\r\n", head.starts_with("\xEF\xBB\xBF") ? 3 : 0);
  if (at < head.size() && head[at] == '%') at = first_not_of(" \t\r\n", line_end(at));
  if (at == head.size() || (head[at] != 'O' && head[at] != 'o' && head[at] != ':')) return std::nullopt;
  const std::size_t digits = first_not_of(" ", at + 1);
  const auto number = number_in(std::string_view(head).substr(digits, first_not_of("0123456789", digits) - digits));
  if (!number) return std::nullopt;
  Heading heading{*number, {}};
  const std::size_t next = line_end(digits) + 1;
  if (head[at] == ':' && next <= head.size())
    heading.start = {next, 1 + static_cast<std::uint32_t>(std::count(head.begin(), head.begin() + static_cast<std::ptrdiff_t>(next), '\n')),
                     0};
  return heading;
}

bool begins_with(const fs::path& path, std::uint32_t number, const FileAccess* door) {
  const auto heading = heading_of(path, door);
  return heading && heading->number == number;
}

/// Finds the file of a program number. If `by_word` is false, the file's name must be the number in another form ("0020" or "O00020" for
/// 20). If `by_word` is true, the number must be the first word in the file. Searches the caller's folder, then the folder of --files.
///   returns  "" if no such file exists
///   alarms  label_twice
Result<std::string> other_file(BlockContext& m, std::uint32_t number, const fs::path& caller, bool by_word, Span where) {
  const std::string extension = caller.extension().string();
  if (!by_word && names_are_strict(extension)) return std::string();
  const fs::path own = caller.parent_path();
  for (const fs::path& folder : {own.empty() ? fs::path(".") : own, fs::path(m.program().limits().files)}) {
    if (folder.empty()) continue;
    std::vector<std::string> files;
    std::error_code error;
    std::size_t left = max_files;
    for (const auto& entry : fs::directory_iterator(folder, fs::directory_options::skip_permission_denied, error)) {
      if (left-- == 0) break;
      const fs::path& path = entry.path();
      // 14.4.1: the program's number is in the file's name, so the file's first word does not count
      const bool of_name = number_of_file(path.filename().string()) != 0;
      if (by_word ? of_name : number_in(path.stem().string()) != number || !alike(path.extension().string(), extension)) continue;
      if (!entry.is_regular_file(error) || (by_word && !begins_with(path, number, m.program().limits().door)) || !is_inside(m, path))
        continue;
      files.push_back(path.string());
    }
    if (files.size() > 1) return fail(alarm(AlarmId::label_twice, where, double(number)));
    if (!files.empty()) return files.front();
  }
  return std::string();
}

}  // namespace

std::string program_name(std::uint32_t number) {
  return number <= most_short ? fmt::format("O{:04}", number) : fmt::format("O{:08}", number);
}

std::uint32_t number_of_file(const std::string& path) {
  std::string stem = fs::path(path).stem().string();
  stem.resize(std::min(stem.size(), stem.find(' ')));  // drops a remark in the name: the control's own form is "O9999 (macros)"
  if (stem.size() < 2 || stem.size() > 9 || (stem[0] != 'O' && stem[0] != 'o')) return 0;
  if (stem.find_first_not_of("0123456789", 1) != std::string::npos) return 0;
  return static_cast<std::uint32_t>(std::stoul(stem.substr(1)));
}

Result<ProgramLocation> Programs::by_number(Interpreter& m, std::uint32_t number, Span where, NextTo next_to) {
  if (m.def.grammar.programs_by_label) return by_steps(m, number, where);
  const bool of_main = next_to == NextTo::main_program;
  const std::pair key{of_main ? 0 : std::uint32_t{m.program().reader()}, number};
  if (const auto known = numbers_.find(key); known != numbers_.end()) return known->second;
  const fs::path caller(of_main ? m.program().main_file() : m.program().file());
  const std::string extension = caller.extension().string();
  ProgramLocation place;
  const auto open = [&](const fs::path& file) -> Status {
    const std::string name = file.filename().string();
    if (!is_inside(m, file)) return fail(alarm(AlarmId::file_outside, where, std::string_view(name)));
    const auto reader = m.flow.open_program(file.string());
    if (!reader) return fail(alarm(AlarmId::file_missing, where, std::string_view(name)));
    place.reader = *reader;
    return {};
  };
  if (const auto file = numbered(caller.parent_path(), number, extension)) {
    KADR_TRY(open(*file));
  } else if (const auto label = m.flow.label_of(number)) {
    place.start = *label;
  } else {
    auto other = other_file(m, number, caller, false, where);
    if (!other) return fail(other.error());
    const auto built_in = other->empty() ? m.flow.open_built_in(program_name(number)) : std::nullopt;
    if (built_in) {  // 23.6: the program is built into the control, such as P9999 of G65
      place.reader = *built_in;
    } else {
      const bool by_word = other->empty();
      if (by_word) other = other_file(m, number, caller, true, where);
      if (!other) return fail(other.error());
      const std::string name = program_name(number) + extension;
      if (other->empty()) return fail(alarm(AlarmId::program_missing, where, std::string_view(name)));
      KADR_TRY(open(*other));
      if (const auto heading = heading_of(*other, m.program().limits().door); heading && by_word) place.start = heading->start;
    }
  }
  numbers_.emplace(key, place);
  return place;
}

Result<ProgramLocation> Programs::opened(Interpreter& m, const std::string& path, Span where) {
  const std::string name = fs::path(path).filename().string();
  if (!is_inside(m, path)) return fail(alarm(AlarmId::file_outside, where, std::string_view(name)));
  const auto reader = m.flow.open_program(path);
  if (!reader) return fail(alarm(AlarmId::file_missing, where, std::string_view(name)));
  return ProgramLocation{*reader, {}};
}

Result<ProgramLocation> Programs::by_name(Interpreter& m, std::string_view name, Span where, NextTo next_to) {
  if (name.empty() || characters(name) > max_name || name.find('/') != std::string_view::npos)
    return fail(alarm(AlarmId::file_name, where, name));
  const fs::path caller(next_to == NextTo::main_program ? m.program().main_file() : m.program().file());
  const fs::path folder = caller.parent_path();
  const fs::path relative = path_of(name);
  const fs::path whole = (folder / relative).lexically_normal();
  auto file = in_folder(whole.parent_path(), whole.filename().string());
  // spec/fanuc 9.2: the extension may be missing in the call, or the first word in a file is the name
  if (!file && m.def.grammar.programs_by_label) {
    file = in_folder(whole.parent_path(), whole.filename().string() + caller.extension().string());
    if (!file) {
      const auto headed = by_heading(m, name, where);
      if (!headed) return fail(headed.error());
      if (*headed) return **headed;
    }
  }
  if (file && !is_inside(m, *file)) return fail(alarm(AlarmId::file_outside, where, name));
  const auto reader = file ? m.flow.open_program(file->string()) : std::nullopt;
  if (!reader) return fail(alarm(AlarmId::file_missing, where, name));
  return ProgramLocation{*reader, {}};
}

Result<ProgramLocation> Programs::system(Interpreter& m, std::uint32_t number, Span where) {
  if (const auto known = systems_.find(number); known != systems_.end()) return known->second;
  const std::string folder = fmt::format("SystemMacros/Channel{}", m.def.channel);
  fs::path base = fs::path(m.program().main_file()).parent_path();
  for (int i = 0; i < max_parents; ++i, base = base.empty() ? fs::path("..") : base / "..") {
    if (const FileAccess* const door = m.program().limits().door; door != nullptr && !door->reaches((base / folder).string())) break;
    const auto file = in_folder(base / folder, fmt::format("O{:04}.nct", number));
    const auto reader = file ? m.flow.open_program(file->string()) : std::nullopt;
    if (!reader) continue;
    const ProgramLocation place{*reader, {}};
    systems_.emplace(number, place);
    return place;
  }
  const std::string name = folder + "/" + fmt::format("O{:04}.nct", number);
  return fail(alarm(AlarmId::program_missing, where, std::string_view(name)));
}

}  // namespace kadr::macro_b
