// The programs of a folder. Used by lsp/folder_navigation; tested by tests/lsp.py.

#include "lsp/program_folder.h"

#include <algorithm>
#include <fstream>

#include "base/ascii.h"
#include "lang/text/text_spool.h"
#include "lang/text/utf16.h"
#include "lsp/lsp_json.h"
#include "view/source_text.h"

namespace kadr {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t looked_at = 4096;  // bytes at the beginning of a file; a file with a zero byte there is no text

bool is_about_programs(NameKind kind) { return kind == NameKind::program || kind == NameKind::label; }

bool is_number(std::string_view text) { return !text.empty() && std::all_of(text.begin(), text.end(), is_digit); }

/// Returns the name under which a file is called, in the form of NamedPlace::name: "200" of O0200.nc, "pocket" of pocket.ngc.
std::string called_name(const std::string& path) {
  std::string stem = in_lower_case(fs::path(path).stem().string());
  constexpr std::string_view prefix = "_n_";
  if (stem.starts_with(prefix)) stem.erase(0, prefix.size());
  for (const std::string_view ending : {"_spf", "_mpf"})
    if (stem.ends_with(ending)) stem.erase(stem.size() - ending.size());
  if (stem.size() < 2 || stem.front() != 'o' || !is_number(std::string_view(stem).substr(1))) return stem;
  stem.erase(0, std::min(stem.find_first_not_of('0', 1), stem.size() - 1));
  return stem;
}

/// Returns the name of a program as a file has it: without the brackets of o<pocket>.
std::string plain_name(const std::string& name) {
  return name.size() > 2 && name.front() == '<' && name.back() == '>' ? name.substr(1, name.size() - 2) : name;
}

bool defines(const ProgramFileNames& file, const NamedPlace& called, bool first_only) {
  for (const ProgramPlace& one : file.places) {
    if (!one.place.defines || one.place.kind != called.kind) continue;
    if (one.place.name == called.name) return true;
    if (first_only) return false;
  }
  return false;
}

std::string extension_of(const std::string& path) { return in_lower_case(fs::path(path).extension().string()); }

}  // namespace

std::string in_lower_case(std::string text) {
  for (char& c : text) c = to_lower(c);
  return text;
}

std::vector<ProgramPlace> program_places(const TextDocument& text, const DocumentNames& names) {
  std::vector<ProgramPlace> places;
  for (std::size_t n = 0; n < names.lines(); ++n)
    for (const NamedPlace& place : names.line(n))
      if (is_about_programs(place.kind)) places.push_back({place, text.range_of(n, place.where)});
  return places;
}

void ProgramFolder::read(const fs::path& folder, const std::vector<std::string>& open) {
  std::map<std::string, State> present;
  std::error_code error;
  fs::directory_iterator entries(folder, fs::directory_options::skip_permission_denied, error);
  for (; !error && entries != fs::directory_iterator() && present.size() < max_files; entries.increment(error)) {
    std::error_code none;
    const std::string path = entries->path().string();
    if (!entries->is_regular_file(none) || std::find(open.begin(), open.end(), path) != open.end()) continue;
    const State state{entries->last_write_time(none), entries->file_size(none)};
    if (!none && state.bytes != 0 && state.bytes <= max_file_bytes) present.emplace(path, state);
  }
  std::size_t count = 0;
  std::vector<ProgramFileNames> files;
  for (const auto& [path, state] : present) {
    const auto known = std::find_if(files_.begin(), files_.end(), [&, p = &path](const ProgramFileNames& file) { return file.path == *p; });
    const auto before = states_.find(path);
    if (known != files_.end() && before != states_.end() && before->second == state) {
      files.push_back(std::move(*known));
    } else {
      ProgramFileNames file{uri_of_path(path), path, {}};
      if (OpenedText opened = open_text(path); opened.source != nullptr) {
        const std::string text = whole_text(*utf8_text(std::move(opened)));
        if (text.substr(0, looked_at).find('\0') == std::string::npos) {
          const TextDocument document(text, unit_);
          DocumentNames names(def_);
          names.read(document);
          file.places = program_places(document, names);
        }
      }
      files.push_back(std::move(file));
    }
    if ((count += files.back().places.size()) > max_places) files.back().places.clear();
  }
  states_ = std::move(present);
  files_ = std::move(files);
}

std::vector<std::size_t> files_called(const std::vector<const ProgramFileNames*>& files, std::size_t caller, const NamedPlace& called) {
  if (defines(*files[caller], called, false)) return {caller};
  const std::string name = in_lower_case(plain_name(called.name));
  const bool is_label = called.kind == NameKind::label;  // the file of a label has its name and this ending
  const std::string extension = is_label ? ".ngc" : extension_of(files[caller]->path);
  std::vector<std::size_t> same, other, headed;
  for (std::size_t i = 0; i < files.size(); ++i) {
    if (called_name(files[i]->path) == name) (extension_of(files[i]->path) == extension ? same : other).push_back(i);
    if (i != caller && defines(*files[i], called, true)) headed.push_back(i);
  }
  // Of several folders, that of the caller comes first.
  const auto near = [&](const std::vector<std::size_t>& found) {
    std::vector<std::size_t> own;
    for (const std::size_t i : found)
      if (fs::path(files[i]->path).parent_path() == fs::path(files[caller]->path).parent_path()) own.push_back(i);
    return own;
  };
  const auto first_of = [&](const auto& part) {
    const auto in_same = part(same), in_other = part(other);
    return is_label || !in_same.empty() ? in_same : !in_other.empty() ? in_other : part(headed);
  };
  const std::vector<std::size_t> own = first_of(near);
  return !own.empty() ? own : first_of([](const std::vector<std::size_t>& found) { return found; });
}

}  // namespace kadr
