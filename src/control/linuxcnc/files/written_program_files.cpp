// Writes the log, the file of probed points, the parameter file and the tool table.

#include "control/linuxcnc/files/written_program_files.h"

#include <vector>

namespace kadr::linuxcnc {
namespace {

constexpr files::FileMode emptied{.creates = true, .takes_existing = true, .appends = false};
constexpr files::FileMode gone_on_with{.creates = true, .takes_existing = true, .appends = true};

/// Returns the path of a file in the program memory. INFERRED: the program memory replaces LinuxCNC's working folder, and a path that
/// leaves the program memory is an alarm.
Result<std::string> path_of(std::string_view name) {
  const auto bad = [&](AlarmId id) { return fail(alarm(id, {}, name)); };
  const std::size_t end = name.find_last_not_of(" \t\r");
  if (end == std::string_view::npos) return bad(AlarmId::file_name);
  const std::string_view text = name.substr(0, end + 1);
  if (text.front() == '/') return bad(AlarmId::file_outside);
  std::vector<std::string> path;
  for (const std::string& part : files::parts_of(text, '/')) {
    if (part == ".") continue;
    if (part == "..") {
      if (path.empty()) return bad(AlarmId::file_outside);
      path.pop_back();
    } else if (files::is_good_part(part) && part.find_first_of("\\:*?\"<>|") == std::string::npos) {
      path.push_back(part);
    } else {
      return bad(AlarmId::file_name);
    }
  }
  if (path.empty()) return bad(AlarmId::file_name);
  return files::joined_parts(path);
}

}  // namespace

Status ProgramFiles::open(Which which, std::string_view name, bool appends, const std::string& running) {
  const auto path = path_of(name);
  if (!path) return fail(path.error());
  KADR_TRY(close(which));
  const files::FileWriter& other = of(which == Which::log ? Which::probe : Which::log);
  if (other.is_open() && other.path() == *path) return fail(alarm(AlarmId::file_already_open, {}, std::string_view(*path)));
  KADR_TRY(of(which).open({.path = *path,
                           .shown = std::string(name),
                           .rule = appends ? gone_on_with : emptied,
                           .exists = AlarmId::file_exists,
                           .missing = AlarmId::file_missing,
                           .running = running}));
  note();
  return {};
}

Status ProgramFiles::close(Which which) { return of(which).is_open() ? of(which).close() : Status(); }

Status ProgramFiles::write(Which which, std::string_view line) {
  if (!of(which).is_open()) return {};
  KADR_TRY(of(which).write(std::string(line) + "\n"));
  note();
  return {};
}

Status ProgramFiles::replace(Which which, const std::string& name, const std::string& before, const std::string& text) {
  const auto whole = [&](const std::string& path, const std::string& bytes) -> Status {
    if (bytes.empty()) return {};
    KADR_TRY(open(which, path, false, {}));
    KADR_TRY(of(which).write(bytes));
    return close(which);
  };
  KADR_TRY(whole(name + ".bak", before));
  KADR_TRY(whole(name, text));
  note();
  return {};
}

Status ProgramFiles::resume_from(const Memory& memory) {
  KADR_TRY(log_.resume_from(memory.log));
  KADR_TRY(probe_.resume_from(memory.probe));
  note();
  return {};
}

void ProgramFiles::note() {
  written_ = log_.files();
  for (const files::FileWriter* const other : {&probe_, &parameters_, &tools_})
    for (const auto& [path, bytes] : other->files()) written_[path] += bytes;
}

}  // namespace kadr::linuxcnc
