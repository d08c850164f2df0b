#include "control/nct/programs.h"

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>

#include "control/machinery.h"

namespace kadr::nct {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_name = 60;  // characters between < and > (14.4.2)
constexpr int most_parents = 16;       // folders above the program that are looked at for SystemMacros
constexpr std::uint32_t most_short = 9999;

bool alike(std::string a, std::string b) {
  const auto small = [](std::string& s) { std::transform(s.begin(), s.end(), s.begin(), [](unsigned char c) { return std::tolower(c); }); };
  small(a);
  small(b);
  return a == b;
}

/// The file of that name in the folder; INFERRED: capital and small letters count as the same.
std::optional<fs::path> in_folder(const fs::path& folder, const std::string& name) {
  std::error_code error;
  if (fs::is_regular_file(folder / name, error)) return folder / name;
  for (const auto& entry :
       fs::directory_iterator(folder.empty() ? fs::path(".") : folder, fs::directory_options::skip_permission_denied, error))
    if (entry.is_regular_file(error) && alike(entry.path().filename().string(), name)) return folder / entry.path().filename();
  return std::nullopt;
}

/// Four digits, then eight.
std::optional<fs::path> numbered(const fs::path& folder, std::uint32_t number, const std::string& extension) {
  if (number <= most_short)
    if (auto found = in_folder(folder, fmt::format("O{:04}{}", number, extension))) return found;
  return in_folder(folder, fmt::format("O{:08}{}", number, extension));
}

std::size_t characters(std::string_view text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

/// "\subs\x.prg", " ..\x.prg" → a path from the folder.
fs::path path_of(std::string_view name) {
  std::string text(name);
  std::replace(text.begin(), text.end(), '\\', '/');
  text.erase(0, text.find_first_not_of(" /"));
  while (!text.empty() && text.back() == ' ') text.pop_back();
  return fs::path(text).lexically_normal();
}

}  // namespace

std::string program_name(std::uint32_t number) {
  return number <= most_short ? fmt::format("O{:04}", number) : fmt::format("O{:08}", number);
}

std::uint32_t number_of_file(const std::string& path) {
  std::string stem = fs::path(path).stem().string();
  stem.resize(std::min(stem.size(), stem.find(' ')));  // "O9999 (nct)", the control's own
  if (stem.size() < 2 || stem.size() > 9 || (stem[0] != 'O' && stem[0] != 'o')) return 0;
  if (stem.find_first_not_of("0123456789", 1) != std::string::npos) return 0;
  return static_cast<std::uint32_t>(std::stoul(stem.substr(1)));
}

Result<ProgramPlace> Programs::by_number(Machinery& m, std::uint32_t number, Span where) {
  const std::pair key{std::uint32_t{m.flow.reader()}, number};
  if (const auto known = numbers_.find(key); known != numbers_.end()) return known->second;
  const fs::path caller(m.flow.file());
  const std::string extension = caller.extension().string();
  ProgramPlace place;
  if (const auto file = numbered(caller.parent_path(), number, extension)) {
    if (const auto reader = m.flow.open_program(file->string())) place.reader = *reader;
    else return fail(alarm(AlarmId::file_missing, where, std::string_view(file->filename().string())));
  } else if (const auto label = m.flow.label_of(number)) {
    place.start = *label;
  } else if (const auto built_in = m.flow.open_built_in(program_name(number))) {  // the control's own: G65 P9999 (23.6)
    place.reader = *built_in;
  } else {
    const std::string name = program_name(number) + extension;
    return fail(alarm(AlarmId::program_missing, where, std::string_view(name)));
  }
  numbers_.emplace(key, place);
  return place;
}

Result<ProgramPlace> Programs::by_name(Machinery& m, std::string_view name, Span where) {
  if (name.empty() || characters(name) > most_name || name.find('/') != std::string_view::npos)
    return fail(alarm(AlarmId::file_name, where, name));
  const fs::path folder = fs::path(m.flow.file()).parent_path();
  const fs::path relative = path_of(name);
  const fs::path whole = (folder / relative).lexically_normal();
  const auto file = in_folder(whole.parent_path(), whole.filename().string());
  const auto reader = file ? m.flow.open_program(file->string()) : std::nullopt;
  if (!reader) return fail(alarm(AlarmId::file_missing, where, name));
  return ProgramPlace{*reader, {}};
}

Result<ProgramPlace> Programs::system(Machinery& m, std::uint32_t number, Span where) {
  if (const auto known = systems_.find(number); known != systems_.end()) return known->second;
  const std::string folder = fmt::format("SystemMacros/Channel{}", m.def.channel);
  fs::path base = fs::path(m.flow.main_file()).parent_path();
  for (int i = 0; i < most_parents; ++i, base = base.empty() ? fs::path("..") : base / "..") {
    const auto file = in_folder(base / folder, fmt::format("O{:04}.nct", number));
    const auto reader = file ? m.flow.open_program(file->string()) : std::nullopt;
    if (!reader) continue;
    const ProgramPlace place{*reader, {}};
    systems_.emplace(number, place);
    return place;
  }
  const std::string name = folder + "/" + fmt::format("O{:04}.nct", number);
  return fail(alarm(AlarmId::program_missing, where, std::string_view(name)));
}

}  // namespace kadr::nct
