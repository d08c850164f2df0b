#pragma once
// A file that a program writes, in the program memory (nct 23.2.13; linuxcnc 2.4). What a name means is the control's; here is what is done
// with a path from the root.
//
// The program memory is a folder, the root. Nothing outside it is ever written, whatever the program says: `..` cannot climb over the root,
// and the folders are entered one by one from the root's own descriptor (openat) without following any symbolic link below it. So there is
// no moment between a check and its use in which a link could be slipped in. Only regular files with one name are written: no links,
// devices, pipes.

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
  nothing,  // dry: alarms as far as they can be known without writing; files that would exist by now count as existing
};

struct OutputOptions {
  std::string root = ".";                       // folder of the program memory; may itself be a symbolic link
  std::uint64_t most = std::uint64_t{1} << 30;  // bytes that one run may write, all files together
  OutputWriting writing = OutputWriting::files;
  FileSet untouched{};              // files of the run itself: its state, trace, set-up
  std::size_t most_files = 10'000;  // that one run may write
};

/// A part of a path that any system takes for a file: not hidden, no device, no blank or point at its end.
bool is_good_part(std::string_view part);

/// What is to be opened.
struct Wanted {
  std::string path;   // from the root, separated by `/`
  std::string shown;  // in alarms
  FileMode rule;
  AlarmId exists, missing;  // what is said where the rule wants the other
  std::string running;      // path of the running program, which is not written
};

/// One file at a time. An alarm leaves what is open, and the files, as they were; but a disk that fails may leave a file emptied.
class FileWriter {
 public:
  explicit FileWriter(OutputOptions options) : options_(std::move(options)) {}
  FileWriter(const FileWriter&) = delete;
  FileWriter& operator=(const FileWriter&) = delete;
  ~FileWriter() { abort(); }

  /// Nothing is open. Alarms: file_outside, file_write, file_already_open, those of `wanted`.
  Status open(const Wanted& wanted);
  /// It is with the system when this returns (one write, no buffer of our own): ending this program by force loses no completed line. A
  /// write that fails halfway is taken back. Alarms: file_write (path), also beyond `most`.
  Status write(std::string_view bytes);
  Status close();
  /// The file stays as it is.
  void abort();

  bool has_room(std::string_view bytes) const;
  /// Is something of that path there, or would it be by now?
  bool exists(const std::string& path) const;
  bool is_open() const { return open_; }

  /// What a snapshot holds.
  struct Memory {
    bool open = false;
    std::string path;            // of the open file, from the root
    std::uint64_t size = 0;      // of the open file
    std::uint64_t written = 0;   // in the run
    std::set<std::string> made;  // dry: files that would exist
    std::map<std::string, std::uint64_t> files;
  };
  Memory memory() const;
  /// The file that was open then is gone on with: what was printed after it is cut off. All others stay as they are.
  ///   alarms   file_write (path): it is not there any more, is shorter than it was, or may not be written
  Status remember(const Memory& memory);

  /// All that were written in the run: path from the root, bytes.
  const std::map<std::string, std::uint64_t>& files() const { return files_; }
  const std::string& root() const { return options_.root; }
  const std::string& path() const { return path_; }  // of the open file, from the root

 private:
  OutputOptions options_;
  bool open_ = false;
  int file_ = -1;  // descriptor; -1: none, or dry
  std::string path_;
  std::uint64_t written_ = 0;   // in the run
  std::set<std::string> made_;  // dry: files that would exist
  std::map<std::string, std::uint64_t> files_;
};

}  // namespace kadr::files
