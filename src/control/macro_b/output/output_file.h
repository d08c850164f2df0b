#pragma once
// Files that a program writes: POPEN31, FOPEN, DPRNT, BPRNT, FCLOS, PCLOS31 (nct 23.2.13); one at a time, in the program memory.
// OutputFile opens, prints and closes; path_in_root() says which file a name means.
// The program memory, and that nothing outside of it is written: control/files/file_writer.h.

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <utility>

#include "base/result.h"
#include "control/files/file_writer.h"
#include "control/macro_b/output/print.h"

namespace kadr::macro_b {

using files::OutputOptions;
using files::OutputWriting;

/// PCLOS without a number (spec/fanuc 5.9).
inline constexpr double no_device = 0;

/// The file that <name> means in `program`, for FOPEN as for calls by name.
///   name     text between < >: at most 60 characters, parts separated by `\`, `..` is the folder above; a leading `\` is the program's own
///            folder; blanks at both ends do not count (14.4.2)
///   program  path of the program that names it, from the root, separated by `/`: "part.nct", "sub/part.nct"
///   returns  path from the root, separated by `/`
///   alarms   file_outside (name): climbs over the root, or begins with a drive. file_name (name): empty, too long, not UTF-8; `/`, control
///            characters, `: * ? " < > |`, empty parts, parts that begin with a point (hidden files: .bashrc, .git) or end in a point or
///            blank, names of devices (CON, NUL, COM1 …)
///   law      no part of the result is empty, `.` or `..`
///   manual   14.4.2; the characters and devices are ours, so that the same program works on any system
Result<std::string> path_in_root(std::string_view name, std::string_view program);

/// An alarm leaves what is open, and the files, as they were; but a disk that fails may leave a file emptied.
class OutputFile {
 public:
  explicit OutputFile(OutputOptions options) : writer_(std::move(options)) {}

  /// POPENn. The file is made by the first print(), which gives its name.
  ///   device   31
  ///   program  running program, from the root; gives folder and extension
  ///   alarms   file_mode (device), file_already_open (path)
  Status open_device(double device, std::string_view program);

  /// POPEN without a number: PRNT0000.DAT in the program's folder goes on, `%` CR LF first (spec/fanuc 5.9). alarms as open_named
  Status open_card(std::string_view program);

  /// FOPENn Pp: O and four digits, or eight if p is longer or only that file exists; folder and extension of `program` (14.4.2).
  ///   mode     1 new; 2 new or emptied; 3 appended; 4 new or appended; 5 emptied
  ///   alarms   file_mode (mode), value_out_of_range (P, p), file_already_open, program_file_exists ("O0012"), program_missing ("O0012"),
  ///            file_outside, file_write; file_already_open too for the running program itself (ours)
  Status open_number(double mode, double p, std::string_view program);

  /// FOPENn <name>; alarms as above with file_exists (name), file_missing (name), and those of path_in_root.
  ///   Names are found in small and capital Latin letters alike, an exact match first (inferred, 14.4.2). A folder must exist.
  Status open_named(double mode, std::string_view name, std::string_view program);

  /// One statement, as decimal() or binary() gives it, with its CR LF. It is with the system when this returns (one write, no buffer
  /// of our own): ending this program by force loses no completed statement. A write that fails halfway is taken back.
  /// The first DPRNT after POPEN31 is the file's name, blanks dropped, and is not written itself (inferred); `%` CR LF is.
  ///   alarms   file_not_open, file_write (path), also beyond `most`; for a name: file_name (also for BPRNT, or a separator), file_outside
  Status print(std::string_view line, PrintKind kind);

  /// PCLOSn: `%` CR LF (inferred), closed. Alarms file_mode (device), file_not_open (also after FOPEN), file_name: no name came;
  /// file_write.
  Status close_device(double device);

  /// FCLOS. Alarms file_not_open (also after POPEN), file_write.
  Status close_file();

  /// M2, M30, or the end in any other way: the file stays as it is, without a closing `%`.
  void abort();

  /// What a snapshot holds.
  struct Memory {
    std::uint8_t state = 0;
    std::string program;  // of POPEN
    files::FileWriter::Memory writer;
  };
  Memory memory() const;
  /// The file that was open then is gone on with: what was printed after it is cut off. All others stay as they are.
  ///   alarms   file_write (path): it is not there any more, is shorter than it was, or may not be written
  Status remember(const Memory& memory);

  bool is_open() const { return state_ != State::closed; }
  /// All that were written in the run: path from the root, bytes.
  const std::map<std::string, std::uint64_t>& files() const { return writer_.files(); }
  const std::string& root() const { return writer_.root(); }
  const std::string& path() const { return writer_.path(); }  // of the open file, from the root; empty before the name came

 private:
  enum class State : std::uint8_t { closed, waits_for_name, device, file };
  Status ready(double mode) const;
  Status open(files::Wanted wanted, int mode, std::string_view program);
  Status name_device_file(std::string_view line, PrintKind kind);
  Status close();

  files::FileWriter writer_;
  State state_ = State::closed;
  std::string program_;  // of POPEN
};

}  // namespace kadr::macro_b
