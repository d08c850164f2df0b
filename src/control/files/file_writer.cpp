// Opens, writes and closes a file for a program. The access to the disk is in file_place.h.

#include "control/files/file_writer.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <utility>

namespace kadr::files {
namespace {

/// Returns true for names that some systems reserve for devices, whatever their extension.
bool is_device(std::string_view part) {
  std::string stem = capitals(part.substr(0, part.find('.')));
  while (!stem.empty() && stem.back() == ' ') stem.pop_back();
  for (const char* name : {"CON", "PRN", "AUX", "NUL", "CONIN$", "CONOUT$", "CLOCK$"})
    if (stem == name) return true;
  const bool numbered = stem.size() == 4 && stem[3] >= '0' && stem[3] <= '9';
  return numbered && (stem.compare(0, 3, "COM") == 0 || stem.compare(0, 3, "LPT") == 0);
}

}  // namespace

bool is_good_part(std::string_view part) {
  return !part.empty() && part.front() != '.' && part.back() != '.' && part.back() != ' ' &&
         part.find_first_not_of(' ') != std::string_view::npos && !is_device(part);
}

Status FileWriter::open(const OpenRequest& request) {
  const auto bad = [&](AlarmId id) { return fail(alarm(id, {}, std::string_view(request.shown))); };
  const FileMode& rule = request.rule;
  const Place place = look_up(options_.root, request.path);
  if (place.what == There::outside) return bad(AlarmId::file_outside);
  if (place.what == There::other) return bad(AlarmId::file_write);
  if (place.what == There::no_folder) return bad(rule.creates ? AlarmId::file_write : request.missing);

  const std::string same = capitals(place.path);
  if (same == capitals(request.running) || options_.untouched.has(options_.root + "/" + place.path)) return bad(AlarmId::file_already_open);
  const bool is_there = place.what == There::file || made_.count(same) != 0;
  if (is_there && !rule.takes_existing) return bad(request.exists);
  if (!is_there && !rule.creates) return bad(request.missing);
  if (files_.size() >= options_.max_files && !files_.contains(place.path)) return bad(AlarmId::file_write);

  if (options_.writing == OutputWriting::files) {
    const Result<int> opened = open_regular(place, rule, request.shown, options_.untouched);
    KADR_TRY(opened);
    file_ = *opened;
  } else {
    made_.insert(same);
  }
  path_ = place.path;
  open_ = true;
  files_.emplace(path_, 0);
  return {};
}

bool FileWriter::has_room(std::string_view bytes) const { return bytes.size() <= options_.most - std::min(written_, options_.most); }

bool FileWriter::exists(const std::string& path) const {
  return look_up(options_.root, path).what != There::nothing || made_.count(capitals(path)) != 0;
}

Status FileWriter::write(std::string_view bytes) {
  const auto bad = [&] { return fail(alarm(AlarmId::file_write, {}, std::string_view(path_))); };
  if (!has_room(bytes)) return bad();
  if (options_.writing == OutputWriting::files) {
    const off_t before = ::lseek(file_, 0, SEEK_CUR);
    for (std::string_view rest = bytes; !rest.empty();) {
      const ssize_t count = ::write(file_, rest.data(), rest.size());
      if (count < 0 && errno == EINTR) continue;
      if (count <= 0) {
        const bool block_undone = before >= 0 && ::ftruncate(file_, before) == 0 && ::lseek(file_, before, SEEK_SET) == before;
        // a failed write gives the same alarm whether the bytes already written can be removed from the file or not
        static_cast<void>(block_undone);
        return bad();
      }
      rest.remove_prefix(static_cast<std::size_t>(count));
    }
  }
  written_ += bytes.size();
  files_[path_] += bytes.size();
  return {};
}

Status FileWriter::close() {
  const std::string path = path_;
  const int file = std::exchange(file_, -1);
  abort();
  if (file >= 0 && ::close(file) != 0 && errno != EINTR) return fail(alarm(AlarmId::file_write, {}, std::string_view(path)));
  return {};
}

FileWriter::Memory FileWriter::memory() const {
  const off_t size = file_ < 0 ? 0 : ::lseek(file_, 0, SEEK_CUR);
  return {open_, path_, static_cast<std::uint64_t>(std::max<off_t>(size, 0)), written_, made_, files_};
}

Status FileWriter::resume_from(const Memory& memory) {
  constexpr FileMode goes_on = {.creates = false, .takes_existing = true, .appends = true};
  const bool reopens = memory.open && options_.writing == OutputWriting::files;
  int file = -1;
  if (reopens) {
    const auto bad = [&] { return fail(alarm(AlarmId::file_write, {}, std::string_view(memory.path))); };
    const Place place = look_up(options_.root, memory.path);
    if (place.what != There::file) return bad();
    abort();  // closes the open file first, because it may be the file to be opened
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
  open_ = memory.open;
  path_ = memory.path;
  written_ = memory.written;
  made_ = memory.made;
  files_ = memory.files;
  return {};
}

void FileWriter::abort() {
  if (file_ >= 0) ::close(file_);
  file_ = -1;
  path_.clear();
  open_ = false;
}

}  // namespace kadr::files
