#pragma once
// FileWriter: writes files of the program memory (nct 23.2.13; linuxcnc 2.4). Each control defines what a file name in a program means;
// this class receives a path, relative to the root.
//
// The program memory is a folder, called the root. Nothing outside the root is ever written, whatever the program requests: `..` cannot
// leave the root. The folders are opened one by one, starting from the root's own descriptor (openat), and no symbolic link below the root
// is followed. So no link can be inserted between a check and the use of its result. Only regular files that have one name are written,
// never links, devices or pipes.

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
  nothing,  // Dry run: reports alarms as far as possible without writing. A file that the program would have created counts as existing.
};

struct OutputOptions {
  std::string root = ".";                       // folder of the program memory; the folder itself may be a symbolic link
  std::uint64_t most = std::uint64_t{1} << 30;  // maximum number of bytes that one run may write to all files together
  OutputWriting writing = OutputWriting::files;
  FileSet untouched{};             // files that belong to the run itself (its state, trace, set-up); the program may not write them
  std::size_t max_files = 10'000;  // maximum number of files that one run may write
};

/// Returns true if every system accepts this part of a path as a file name: the name is not hidden and not that of a device, and has no
/// blank or dot at its end.
bool is_good_part(std::string_view part);

/// A request to open a file.
struct OpenRequest {
  std::string path;   // path from the root folder; its parts are separated by `/`
  std::string shown;  // name in alarms
  FileMode rule;
  // Alarm if the file exists though `rule` forbids this, and alarm if the file is missing though `rule` requires it.
  AlarmId exists, missing;
  std::string running;  // path of the running program, which may not be written
};

/// Writes one file at a time. If an alarm is raised, the open file and the files on the disk are unchanged; only a failing disk may leave
/// an empty file.
class FileWriter {
 public:
  explicit FileWriter(OutputOptions options) : options_(std::move(options)) {}
  FileWriter(const FileWriter&) = delete;
  FileWriter& operator=(const FileWriter&) = delete;
  ~FileWriter() { abort(); }

  /// Opens a file. No other file may be open.
  ///   alarms  file_outside, file_write, file_already_open, those of `request`
  Status open(const OpenRequest& request);
  /// Appends bytes to the open file. One system call passes the bytes to the system, without a buffer here, so no completed line is lost if
  /// this program is killed. If the call fails halfway, its bytes are removed again.
  ///   alarms  file_write (its argument is the path), also for more than `most` bytes
  Status write(std::string_view bytes);
  Status close();
  /// Closes the file without raising an alarm; the bytes that were written remain.
  void abort();

  bool has_room(std::string_view bytes) const;
  /// Returns true if a file or folder exists at this path, or if the program would have created it by now in a dry run.
  bool exists(const std::string& path) const;
  bool is_open() const { return open_; }

  /// The state of the writer in a snapshot.
  struct Memory {
    bool open = false;
    std::string path;            // path of the open file, relative to the root folder of the program memory
    std::uint64_t size = 0;      // size of the open file, bytes
    std::uint64_t written = 0;   // bytes written in the whole run
    std::set<std::string> made;  // dry run: paths of the files that the program would have created
    std::map<std::string, std::uint64_t> files;
  };
  Memory memory() const;
  /// Reopens the file that was open at the snapshot, and removes the bytes that were written to it after the snapshot. All other files
  /// remain unchanged.
  ///   alarms   file_write (its argument is the path): the file is missing, is shorter than it was, or may not be written
  Status resume_from(const Memory& memory);

  /// Returns all files written in the run. The key is the path from the root, the value is the number of bytes.
  const std::map<std::string, std::uint64_t>& files() const { return files_; }
  const std::string& root() const { return options_.root; }
  const std::string& path() const { return path_; }  // path of the open file, relative to the root folder of the program memory

 private:
  OutputOptions options_;
  bool open_ = false;
  int file_ = -1;  // file descriptor; -1: no file is open, or the run is a dry run
  std::string path_;
  std::uint64_t written_ = 0;   // bytes written in the whole run
  std::set<std::string> made_;  // dry run: paths of the files that the program would have created
  std::map<std::string, std::uint64_t> files_;
};

}  // namespace kadr::files
