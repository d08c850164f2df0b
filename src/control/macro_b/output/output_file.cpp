// Names, opens, prints to and closes the files that a program writes. The bytes are written by control/files/file_writer.

#include "control/macro_b/output/output_file.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "base/ascii.h"
#include "lang/text/encoding.h"

namespace kadr::macro_b {

using files::FileMode;
using files::is_good_part;
using files::joined_parts;
using files::parts_of;

namespace {

constexpr std::size_t longest_name = 60;  // greatest number of characters of a file name between < and > (14.4.2)
constexpr double device_number = 31;
constexpr double max_program_number = 99'999'999;
constexpr int short_numbers = 9'999;  // the greatest program number that is written with O and four digits
constexpr std::string_view percent = "%\r\n";
constexpr std::string_view card_file = "PRNT0000.DAT";

constexpr FileMode modes[] = {
    {true, false, false},  // 1
    {true, true, false},   // 2
    {false, true, true},   // 3
    {true, true, true},    // 4
    {false, true, false},  // 5
};

/// Counts the characters of a text. Returns nullopt if a character is not allowed in a name.
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

/// Returns the extension of a path, ".nct" for "sub/part.nct"; empty if the path has no extension.
std::string_view extension_of(std::string_view program) {
  const std::size_t slash = program.rfind('/');
  const std::string_view file = slash == std::string_view::npos ? program : program.substr(slash + 1);
  const std::size_t point = file.rfind('.');
  return point == std::string_view::npos ? std::string_view() : file.substr(point);
}

std::string next_to(std::string_view program, const std::string& file) {
  const std::size_t slash = program.rfind('/');
  return std::string(program.substr(0, slash == std::string_view::npos ? 0 : slash + 1)) + file;
}

files::OpenRequest named_file(const std::string& path, std::string_view shown) {
  return {.path = path,
          .shown = std::string(shown),
          .rule = {},
          .exists = AlarmId::file_exists,
          .missing = AlarmId::file_missing,
          .running = {}};
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
  if (is_open()) return fail(alarm(AlarmId::file_already_open, {}, std::string_view(path())));
  if (!(mode >= 1 && mode <= static_cast<double>(std::size(modes))) || mode != std::floor(mode))
    return fail(alarm(AlarmId::file_mode, {}, mode));
  return {};
}

Status OutputFile::open_device(double device, std::string_view program) {
  if (is_open()) return fail(alarm(AlarmId::file_already_open, {}, std::string_view(path())));
  if (device != device_number) return fail(alarm(AlarmId::file_mode, {}, device));
  program_ = program;
  state_ = State::waits_for_name;
  return {};
}

Status OutputFile::open_card(std::string_view program) {
  constexpr int appended = 4;
  KADR_TRY(ready(appended));
  if (!writer_.has_room(percent)) return fail(alarm(AlarmId::file_write, {}, std::string_view(card_file)));
  KADR_TRY(open({.path = next_to(program, std::string(card_file)),
                 .shown = std::string(card_file),
                 .rule = {},
                 .exists = AlarmId::program_file_exists,
                 .missing = AlarmId::program_missing,
                 .running = {}},
                appended, program));
  if (const Status begun = writer_.write(percent); !begun) {
    abort();
    return begun;
  }
  state_ = State::device;
  return {};
}

Status OutputFile::open_number(double mode, double p, std::string_view program) {
  KADR_TRY(ready(mode));
  if (!(p >= 1 && p <= max_program_number) || p != std::floor(p)) return fail(alarm(AlarmId::value_out_of_range, {}, 'P', p));
  const int number = static_cast<int>(p);
  const std::string extension(extension_of(program));
  std::string name = program_name(number, number <= short_numbers ? 4 : 8);
  const std::string longer = program_name(number, 8);
  if (!writer_.exists(next_to(program, name + extension)) && writer_.exists(next_to(program, longer + extension))) name = longer;
  return open({.path = next_to(program, name + extension),
               .shown = name,
               .rule = {},
               .exists = AlarmId::program_file_exists,
               .missing = AlarmId::program_missing,
               .running = {}},
              static_cast<int>(mode), program);
}

Status OutputFile::open_named(double mode, std::string_view name, std::string_view program) {
  KADR_TRY(ready(mode));
  const Result<std::string> path = path_in_root(name, program);
  KADR_TRY(path);
  return open(named_file(*path, name), static_cast<int>(mode), program);
}

/// Opens the file in a mode of FOPEN (1 to 5), and records it as the open file.
Status OutputFile::open(files::OpenRequest request, int mode, std::string_view program) {
  request.rule = modes[mode - 1];
  request.running = program;
  KADR_TRY(writer_.open(request));
  state_ = State::file;
  return {};
}

Status OutputFile::print(std::string_view line, PrintKind kind) {
  if (state_ == State::closed) return fail(alarm(AlarmId::file_not_open, {}));
  if (state_ == State::waits_for_name) return name_device_file(line, kind);
  return writer_.write(line);
}

/// Opens the file of POPEN31, whose name is in `line`, and writes the first `%` of the file.
Status OutputFile::name_device_file(std::string_view line, PrintKind kind) {
  std::string name;
  for (const char c : line)
    if (c != ' ' && c != '\r' && c != '\n') name += c;
  if (kind == PrintKind::binary || name.empty() || name.find('\\') != std::string::npos)
    return fail(alarm(AlarmId::file_name, {}, std::string_view(name)));
  const std::string file = name + std::string(extension_of(program_));
  const Result<std::string> path = path_in_root(file, program_);
  KADR_TRY(path);
  if (!writer_.has_room(percent))
    // space on the disk is checked before open() empties an existing file
    return fail(alarm(AlarmId::file_write, {}, std::string_view(file)));
  KADR_TRY(open(named_file(*path, file), 2, program_));
  const Status begun = writer_.write(percent);
  if (!begun) {
    abort();
    state_ = State::waits_for_name;
    return begun;
  }
  state_ = State::device;
  return {};
}

Status OutputFile::close_device(double device) {
  if (device != device_number && device != no_device) return fail(alarm(AlarmId::file_mode, {}, device));
  if (state_ == State::waits_for_name) return fail(alarm(AlarmId::file_name, {}, std::string_view()));
  if (state_ != State::device) return fail(alarm(AlarmId::file_not_open, {}));
  KADR_TRY(writer_.write(percent));
  return close();
}

Status OutputFile::close_file() {
  if (state_ != State::file) return fail(alarm(AlarmId::file_not_open, {}));
  return close();
}

Status OutputFile::close() {
  state_ = State::closed;
  return writer_.close();
}

OutputFile::Memory OutputFile::memory() const { return {static_cast<std::uint8_t>(state_), program_, writer_.memory()}; }

Status OutputFile::resume_from(const Memory& memory) {
  KADR_TRY(writer_.resume_from(memory.writer));
  state_ = static_cast<State>(memory.state);
  program_ = memory.program;
  return {};
}

void OutputFile::abort() {
  writer_.abort();
  state_ = State::closed;
}

}  // namespace kadr::macro_b
