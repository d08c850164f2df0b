#pragma once
// FileWriter: writes files of the program memory (nct 23.2.13; linuxcnc 2.4). Each control defines what a file name in a program means;
// this class receives a path, relative to the root.
//
// The program memory is a folder, the root. Nothing outside the root is ever written, whatever the program requests: `..` cannot leave the
// root. The folders are entered one by one, starting from the root's own descriptor (openat), and no symbolic link below the root is
// followed. So there is no moment between a check and the use of its result in which a link could be inserted. Only regular files that have
// one name are written, never links, devices or pipes.

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>

#include "base/file_id.h"
#include "base/result.h"
#include "control/files/file_place.h"

namespace kadr::files {

enum class OutputWriting : std::uint8_t {
  files,
  nothing,  // dry run: reports alarms as far as possible without writing; a file that it would have created counts as existing
};

struct OutputOptions {
  std::string root = ".";                       // folder of the program memory; the folder itself may be a symbolic link
  std::uint64_t most = std::uint64_t{1} << 30;  // maximum number of bytes that one run may write to all files together
  OutputWriting writing = OutputWriting::files;
  FileSet untouched{};             // files of the run itself: its state, trace, set-up
  std::size_t max_files = 10'000;  // maximum number of files that one run may write
};

/// Returns true if every system accepts this part of a path as a file name: not hidden, not a device, no blank or dot at its end.
bool is_good_part(std::string_view part);

/// A request to open a file.
struct Wanted {
  std::string path;   // path from the root; its parts are separated by `/`
  std::string shown;  // name in alarms
  FileMode rule;
  AlarmId exists, missing;  // alarm if the file exists though `rule` forbids it; alarm if it is missing though `rule` requires it
  std::string running;      // path of the running program, which may not be written
};

/// Writes one file at a time. If an alarm is raised, the open file and the files on the disk are unchanged; only a failing disk may leave
/// an emptied file.
class FileWriter {
 public:
  explicit FileWriter(OutputOptions options) : options_(std::move(options)) {}
  FileWriter(const FileWriter&) = delete;
  FileWriter& operator=(const FileWriter&) = delete;
  ~FileWriter() { abort(); }

  /// Opens a file; no other file may be open.
  ///   alarms  file_outside, file_write, file_already_open, those of `wanted`
  Status open(const Wanted& wanted);
  /// Appends bytes to the open file. After this call the system has the data (one system call, no buffer here): no completed line is lost
  /// if this program is killed. If the call fails halfway, its bytes are removed again.
  ///   alarms  file_write (its argument is the path), also for more than `most` bytes
  Status write(std::string_view bytes);
  Status close();
  /// Closes the file without an alarm; what was written remains.
  void abort();

  bool has_room(std::string_view bytes) const;
  /// Returns true if something exists at this path, or would exist by now in a dry run.
  bool exists(const std::string& path) const;
  bool is_open() const { return open_; }

  /// The state in a snapshot.
  struct Memory {
    bool open = false;
    std::string path;            // path of the open file, relative to the root
    std::uint64_t size = 0;      // size of the open file, bytes
    std::uint64_t written = 0;   // bytes written in the whole run
    std::set<std::string> made;  // dry run: paths of the files that would exist
    std::map<std::string, std::uint64_t> files;
  };
  Memory memory() const;
  /// Reopens the file that was open at the snapshot, and removes what was written to it since. All other files remain as they are.
  ///   alarms   file_write (its argument is the path): the file is missing, is shorter than it was, or may not be written
  Status resume_from(const Memory& memory);

  /// Returns all files written in the run: for each path from the root, the number of bytes.
  const std::map<std::string, std::uint64_t>& files() const { return files_; }
  const std::string& root() const { return options_.root; }
  const std::string& path() const { return path_; }  // path of the open file, from the root

 private:
  OutputOptions options_;
  bool open_ = false;
  int file_ = -1;  // descriptor; -1: no file open, or a dry run
  std::string path_;
  std::uint64_t written_ = 0;   // bytes written in the whole run
  std::set<std::string> made_;  // dry run: paths of the files that would exist
  std::map<std::string, std::uint64_t> files_;
};

}  // namespace kadr::files
