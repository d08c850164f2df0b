// Files that a program writes: opening, printing, closing. What is on the disk: file_place.h.

#include "control/nct/output/output_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "base/ascii.h"
#include "control/nct/output/file_place.h"
#include "lang/text/encoding.h"

namespace kadr::nct {
namespace {

constexpr std::size_t longest_name = 60;  // characters between < > (14.4.2)
constexpr double device_number = 31;
constexpr double most_program_number = 99'999'999;
constexpr int short_numbers = 9'999;  // O and four digits
constexpr std::string_view percent = "%\r\n";
constexpr std::string_view card_file = "PRNT0000.DAT";

constexpr FileMode modes[] = {
    {true, false, false},  // 1
    {true, true, false},   // 2
    {false, true, true},   // 3
    {true, true, true},    // 4
    {false, true, false},  // 5
};

/// Names that some systems take for devices, whatever their extension.
bool is_device(std::string_view part) {
  std::string stem = capitals(part.substr(0, part.find('.')));
  while (!stem.empty() && stem.back() == ' ') stem.pop_back();
  for (const char* name : {"CON", "PRN", "AUX", "NUL", "CONIN$", "CONOUT$", "CLOCK$"})
    if (stem == name) return true;
  const bool numbered = stem.size() == 4 && stem[3] >= '0' && stem[3] <= '9';
  return numbered && (stem.compare(0, 3, "COM") == 0 || stem.compare(0, 3, "LPT") == 0);
}

bool is_good_part(std::string_view part) {
  return !part.empty() && part.front() != '.' && part.back() != '.' && part.back() != ' ' &&
         part.find_first_not_of(' ') != std::string_view::npos && !is_device(part);
}

/// Characters of the text; nothing where one must not stand in a name.
std::optional<std::size_t> count_characters(std::string_view text) {
  std::size_t count = 0;
  for (; !text.empty(); ++count) {
    const Character c = first_character(text);
    if (c.size == 0 || c.code < U' ' || c.code == U'\x7F') return std::nullopt;
    if (c.code < 128 && std::string_view("/:*?\"<>|").find(static_cast<char>(c.code)) != std::string_view::npos) return std::nullopt;
    text.remove_prefix(c.size);
  }
  return count;
}

/// ".nct" of "sub/part.nct", or nothing.
std::string_view extension_of(std::string_view program) {
  const std::size_t slash = program.rfind('/');
  const std::string_view file = slash == std::string_view::npos ? program : program.substr(slash + 1);
  const std::size_t point = file.rfind('.');
  return point == std::string_view::npos ? std::string_view() : file.substr(point);
}

std::string beside(std::string_view program, const std::string& file) {
  const std::size_t slash = program.rfind('/');
  return std::string(program.substr(0, slash == std::string_view::npos ? 0 : slash + 1)) + file;
}

std::string program_name(int number, std::size_t digits) {
  const std::string text = std::to_string(number);
  return "O" + std::string(digits > text.size() ? digits - text.size() : 0, '0') + text;
}

}  // namespace

Result<std::string> path_in_root(std::string_view name, std::string_view program) {
  const auto bad = [&](AlarmId id) { return fail(alarm(id, {}, name)); };
  const bool drive = name.size() >= 2 && name[1] == ':' && to_upper(name[0]) >= 'A' && to_upper(name[0]) <= 'Z';
  if (drive) return bad(AlarmId::file_outside);
  const std::optional<std::size_t> length = count_characters(name);
  if (!length || *length > longest_name) return bad(AlarmId::file_name);

  const std::size_t first = name.find_first_not_of(' ');
  if (first == std::string_view::npos) return bad(AlarmId::file_name);
  std::string_view rest = name.substr(first, name.find_last_not_of(' ') - first + 1);
  if (rest.front() == '\\') rest.remove_prefix(1);

  std::vector<std::string> path = parts_of(program, '/');
  path.pop_back();
  const std::vector<std::string> steps = parts_of(rest, '\\');
  for (const std::string& step : steps) {
    if (step != "..") {
      if (!is_good_part(step)) return bad(AlarmId::file_name);
      path.push_back(step);
      continue;
    }
    if (path.empty()) return bad(AlarmId::file_outside);
    path.pop_back();
  }
  if (steps.back() == "..") return bad(AlarmId::file_name);
  return joined_parts(path);
}

Status OutputFile::ready(double mode) const {
  if (is_open()) return fail(alarm(AlarmId::file_already_open, {}, std::string_view(path_)));
  if (!(mode >= 1 && mode <= static_cast<double>(std::size(modes))) || mode != std::floor(mode))
    return fail(alarm(AlarmId::file_mode, {}, mode));
  return {};
}

Status OutputFile::open_device(double device, std::string_view program) {
  if (is_open()) return fail(alarm(AlarmId::file_already_open, {}, std::string_view(path_)));
  if (device != device_number) return fail(alarm(AlarmId::file_mode, {}, device));
  program_ = program;
  path_.clear();
  state_ = State::waits_for_name;
  return {};
}

Status OutputFile::open_card(std::string_view program) {
  constexpr int appended = 4;
  KADR_TRY(ready(appended));
  if (!has_room(percent)) return fail(alarm(AlarmId::file_write, {}, std::string_view(card_file)));
  KADR_TRY(open({beside(program, std::string(card_file)), std::string(card_file), false}, appended, program));
  if (const Status begun = write(percent); !begun) return abort(), begun;
  state_ = State::device;
  return {};
}

Status OutputFile::open_number(double mode, double p, std::string_view program) {
  KADR_TRY(ready(mode));
  if (!(p >= 1 && p <= most_program_number) || p != std::floor(p)) return fail(alarm(AlarmId::value_out_of_range, {}, 'P', p));
  const int number = static_cast<int>(p);
  const std::string extension(extension_of(program));
  std::string name = program_name(number, number <= short_numbers ? 4 : 8);
  const auto exists = [&](const std::string& path) {
    return look_up(options_.root, path).what != There::nothing || made_.count(capitals(path)) != 0;
  };
  const std::string longer = program_name(number, 8);
  if (!exists(beside(program, name + extension)) && exists(beside(program, longer + extension))) name = longer;
  return open({beside(program, name + extension), name, true}, static_cast<int>(mode), program);
}

Status OutputFile::open_named(double mode, std::string_view name, std::string_view program) {
  KADR_TRY(ready(mode));
  const Result<std::string> path = path_in_root(name, program);
  KADR_TRY(path);
  return open({*path, std::string(name), false}, static_cast<int>(mode), program);
}

/// Opens it and makes it the open file.
Status OutputFile::open(const Wanted& wanted, int mode, std::string_view program) {
  const auto bad = [&](AlarmId id) { return fail(alarm(id, {}, std::string_view(wanted.shown))); };
  const FileMode& rule = modes[mode - 1];
  const AlarmId missing = wanted.by_number ? AlarmId::program_missing : AlarmId::file_missing;
  const Place place = look_up(options_.root, wanted.path);
  if (place.what == There::outside) return bad(AlarmId::file_outside);
  if (place.what == There::other) return bad(AlarmId::file_write);
  if (place.what == There::no_folder) return bad(rule.creates ? AlarmId::file_write : missing);

  const std::string same = capitals(place.path);
  if (same == capitals(program) || options_.untouched.has(options_.root + "/" + place.path)) return bad(AlarmId::file_already_open);
  const bool exists = place.what == There::file || made_.count(same) != 0;
  if (exists && !rule.takes_existing) return bad(wanted.by_number ? AlarmId::program_file_exists : AlarmId::file_exists);
  if (!exists && !rule.creates) return bad(missing);
  if (files_.size() >= options_.most_files && !files_.contains(place.path)) return bad(AlarmId::file_write);

  if (options_.writing == OutputWriting::files) {
    const Result<int> opened = open_regular(place, rule, wanted.shown, options_.untouched);
    KADR_TRY(opened);
    file_ = *opened;
  } else {
    made_.insert(same);
  }
  path_ = place.path;
  state_ = State::file;
  files_.emplace(path_, 0);
  return {};
}

Status OutputFile::print(std::string_view line, PrintKind kind) {
  if (state_ == State::closed) return fail(alarm(AlarmId::file_not_open, {}));
  if (state_ == State::waits_for_name) return name_device_file(line, kind);
  return write(line);
}

/// The file of POPEN31 gets its name and its first `%`.
Status OutputFile::name_device_file(std::string_view line, PrintKind kind) {
  std::string name;
  for (const char c : line)
    if (c != ' ' && c != '\r' && c != '\n') name += c;
  if (kind == PrintKind::binary || name.empty() || name.find('\\') != std::string::npos)
    return fail(alarm(AlarmId::file_name, {}, std::string_view(name)));
  const std::string file = name + std::string(extension_of(program_));
  const Result<std::string> path = path_in_root(file, program_);
  KADR_TRY(path);
  if (!has_room(percent)) return fail(alarm(AlarmId::file_write, {}, std::string_view(file)));  // before it is emptied
  KADR_TRY(open({*path, file, false}, 2, program_));
  const Status begun = write(percent);
  if (!begun) {
    abort();
    state_ = State::waits_for_name;
    return begun;
  }
  state_ = State::device;
  return {};
}

bool OutputFile::has_room(std::string_view bytes) const { return bytes.size() <= options_.most - std::min(written_, options_.most); }

Status OutputFile::write(std::string_view bytes) {
  const auto bad = [&] { return fail(alarm(AlarmId::file_write, {}, std::string_view(path_))); };
  if (!has_room(bytes)) return bad();
  if (options_.writing == OutputWriting::files) {
    const off_t before = ::lseek(file_, 0, SEEK_CUR);
    for (std::string_view rest = bytes; !rest.empty();) {
      const ssize_t count = ::write(file_, rest.data(), rest.size());
      if (count < 0 && errno == EINTR) continue;
      if (count <= 0) {
        const bool taken_back = before >= 0 && ::ftruncate(file_, before) == 0 && ::lseek(file_, before, SEEK_SET) == before;
        static_cast<void>(taken_back);  // if that fails too, the alarm is the same
        return bad();
      }
      rest.remove_prefix(static_cast<std::size_t>(count));
    }
  }
  written_ += bytes.size();
  files_[path_] += bytes.size();
  return {};
}

Status OutputFile::close_device(double device) {
  if (device != device_number && device != no_device) return fail(alarm(AlarmId::file_mode, {}, device));
  if (state_ == State::waits_for_name) return fail(alarm(AlarmId::file_name, {}, std::string_view()));
  if (state_ != State::device) return fail(alarm(AlarmId::file_not_open, {}));
  KADR_TRY(write(percent));
  return close();
}

Status OutputFile::close_file() {
  if (state_ != State::file) return fail(alarm(AlarmId::file_not_open, {}));
  return close();
}

Status OutputFile::close() {
  const std::string path = path_;
  const int file = std::exchange(file_, -1);
  abort();
  if (file >= 0 && ::close(file) != 0 && errno != EINTR) return fail(alarm(AlarmId::file_write, {}, std::string_view(path)));
  return {};
}

OutputFile::Memory OutputFile::memory() const {
  const off_t size = file_ < 0 ? 0 : ::lseek(file_, 0, SEEK_CUR);
  return {
      static_cast<std::uint8_t>(state_), path_, program_, static_cast<std::uint64_t>(std::max<off_t>(size, 0)), written_, made_, files_};
}

Status OutputFile::remember(const Memory& memory) {
  constexpr FileMode goes_on = {.creates = false, .takes_existing = true, .appends = true};
  const bool reopens = !memory.path.empty() && options_.writing == OutputWriting::files;
  int file = -1;
  if (reopens) {
    const auto bad = [&] { return fail(alarm(AlarmId::file_write, {}, std::string_view(memory.path))); };
    const Place place = look_up(options_.root, memory.path);
    if (place.what != There::file) return bad();
    abort();  // the same file, perhaps
    const Result<int> opened = open_regular(place, goes_on, memory.path, options_.untouched);
    KADR_TRY(opened);
    const auto size = static_cast<off_t>(memory.size);
    Descriptor held(*opened);
    if (::lseek(held.number(), 0, SEEK_END) < size || ::ftruncate(held.number(), size) != 0 ||
        ::lseek(held.number(), size, SEEK_SET) != size)
      return bad();
    file = held.release();
  }
  abort();
  file_ = file;
  state_ = static_cast<State>(memory.state);
  path_ = memory.path;
  program_ = memory.program;
  written_ = memory.written;
  made_ = memory.made;
  files_ = memory.files;
  return {};
}

void OutputFile::abort() {
  if (file_ >= 0) ::close(file_);
  file_ = -1;
  path_.clear();
  state_ = State::closed;
}

}  // namespace kadr::nct
