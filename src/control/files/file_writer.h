#pragma once
// FileWriter: writes files of the program memory (nct 23.2.13; linuxcnc 2.4). The
// control defines what a name means; this class handles a path from the root.
//
// The program memory is a folder, the root. Nothing outside it is ever written, whatever the program
// requests: `..` cannot leave the root, and the folders are entered one by one from the root's own descriptor
// (openat) without following any symbolic link below it. So there is no moment between a check and its use in
// which a link could be inserted. Only regular files with one name are written: no links, devices, pipes.

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
  nothing,  // dry run: reports alarms as far as possible without writing; files it would have created count as existing
};

struct OutputOptions {
  std::string root = ".";                       // folder of the program memory; may itself be a symbolic link
  std::uint64_t most = std::uint64_t{1} << 30;  // maximum number of bytes that one run may write to all files together
  OutputWriting writing = OutputWriting::files;
  FileSet untouched{};             // files of the run itself: its state, trace, set-up
  std::size_t max_files = 10'000;  // maximum number of files that one run may write
};

/// Returns true for a part of a path that every system accepts as a file name: not hidden, not a device, no blank or dot at its end.
bool is_good_part(std::string_view part);

/// A request to open a file.
struct Wanted {
  std::string path;   // from the root, separated by `/`
  std::string shown;  // name in alarms
  FileMode rule;
  AlarmId exists, missing;  // alarms if the file exists, or is missing, although `rule` requires the opposite
  std::string running;      // path of the running program, which may not be written
};

/// Writes one file at a time. An alarm leaves the open file and the files
/// on the disk unchanged, but a failing disk may leave a file emptied.
class FileWriter {
 public:
  explicit FileWriter(OutputOptions options) : options_(std::move(options)) {}
  FileWriter(const FileWriter&) = delete;
  FileWriter& operator=(const FileWriter&) = delete;
  ~FileWriter() { abort(); }

  /// Opens a file; no other may be open. Alarms: file_outside, file_write, file_already_open, those of `wanted`.
  Status open(const Wanted& wanted);
  /// Writes to the open file. When this returns, the system has the data (one write, no buffer here): if this program is killed, no
  /// completed line is lost. A write that fails halfway is undone. Alarms: file_write (path), also beyond `most`.
  Status write(std::string_view bytes);
  Status close();
  /// Closes without an alarm; the file stays as it is.
  void abort();

  bool has_room(std::string_view bytes) const;
  /// Returns true if something exists at this path, or would exist by now in a dry run.
  bool exists(const std::string& path) const;
  bool is_open() const { return open_; }

  /// The state in a snapshot.
  struct Memory {
    bool open = false;
    std::string path;            // path of the open file, from the root
    std::uint64_t size = 0;      // size of the open file
    std::uint64_t written = 0;   // bytes written in the whole run
    std::set<std::string> made;  // dry run: files that would exist
    std::map<std::string, std::uint64_t> files;
  };
  Memory memory() const;
  /// Continues the file that was open at the snapshot, without what was printed to the file since. All other files stay as they are.
  ///   alarms   file_write (path): the file is missing, is shorter than it was, or may not be written
  Status resume_from(const Memory& memory);

  /// All files written in the run: path from the root, bytes.
  const std::map<std::string, std::uint64_t>& files() const { return files_; }
  const std::string& root() const { return options_.root; }
  const std::string& path() const { return path_; }  // path of the open file, from the root

 private:
  OutputOptions options_;
  bool open_ = false;
  int file_ = -1;  // descriptor; -1: no file open, or a dry run
  std::string path_;
  std::uint64_t written_ = 0;   // bytes written in the whole run
  std::set<std::string> made_;  // dry run: files that would exist
  std::map<std::string, std::uint64_t> files_;
};

}  // namespace kadr::files
