#pragma once
// The files that a program writes: POPEN31, FOPEN, DPRNT, BPRNT, FCLOS, PCLOS31 (nct 23.2.13). One is open at a time, in the program
// memory. OutputFile opens, prints and closes; path_in_root() finds the file that a name means.
// control/files/file_writer.h describes the program memory, and ensures that nothing outside it is written.

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

/// Returns the file that <name> means in `program`, for FOPEN as for calls by name.
///   name     text between < >: at most 60 characters, parts separated by `\`; `..` is the folder above, a leading `\` is the program's own
///            folder, blanks at both ends are ignored (14.4.2)
///   program  path of the program that uses the name, from the root, separated by `/`: "part.nct", "sub/part.nct"
///   returns  path from the root, separated by `/`
///   alarms   file_outside (name): leads above the root, or starts with a drive. file_name (name): empty, too long, not UTF-8; `/`, control
///            characters, `: * ? " < > |`, empty parts, parts that start with a point (hidden files: .bashrc, .git) or end in a point or
///            blank, names of devices (CON, NUL, COM1 …)
///   law      no part of the result is empty, `.` or `..`
///   manual   14.4.2; the characters and devices are our choice, so that the same program works on any system
Result<std::string> path_in_root(std::string_view name, std::string_view program);

/// The file that a program writes. An alarm leaves the open file and all others as they were, except that a failing disk may leave a file
/// emptied.
class OutputFile {
 public:
  explicit OutputFile(OutputOptions options) : writer_(std::move(options)) {}

  /// POPENn. The first print() names and creates the file.
  ///   device   31
  ///   program  running program, from the root; gives folder and extension
  ///   alarms   file_mode (device), file_already_open (path)
  Status open_device(double device, std::string_view program);

  /// POPEN without a number: appends to PRNT0000.DAT in the program's folder, first `%` CR LF (spec/fanuc 5.9). alarms as open_named
  Status open_card(std::string_view program);

  /// FOPENn Pp: the file's name is O and four digits, or eight if p is longer or only that file exists; folder and extension of `program`
  /// (14.4.2).
  ///   mode     1 new; 2 new or emptied; 3 appended; 4 new or appended; 5 emptied
  ///   alarms   file_mode (mode), value_out_of_range (P, p), file_already_open, program_file_exists ("O0012"), program_missing ("O0012"),
  ///            file_outside, file_write; file_already_open also for the running program itself (ours)
  Status open_number(double mode, double p, std::string_view program);

  /// FOPENn <name>; alarms as open_number with file_exists (name), file_missing (name), and those of path_in_root.
  ///   Capital and small Latin letters are equal in names, but an exact match comes first (inferred, 14.4.2). A folder must exist.
  Status open_named(double mode, std::string_view name, std::string_view program);

  /// Writes the text of one statement, as decimal() or binary() gives it, with its CR LF. The operating system has it when this returns
  /// (one write, no buffer of our own), so killing this process loses no completed statement. A write that fails halfway is taken back.
  /// The first DPRNT after POPEN31 gives the file's name, without blanks, and is not written itself (inferred); `%` CR LF is written.
  ///   alarms   file_not_open, file_write (path), also beyond `most`; for a name: file_name (also for BPRNT, or a separator), file_outside
  Status print(std::string_view line, PrintKind kind);

  /// PCLOSn: writes `%` CR LF (inferred) and closes. Alarms file_mode (device), file_not_open (also after FOPEN), file_name: no name was
  /// given; file_write.
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
  /// Continues the file that was open at the snapshot: what was printed after it is cut off. All other files stay as they are.
  ///   alarms   file_write (path): the file no longer exists, is shorter than it was, or may not be written
  Status remember(const Memory& memory);

  bool is_open() const { return state_ != State::closed; }
  /// All files written in the run: path from the root, bytes.
  const std::map<std::string, std::uint64_t>& files() const { return writer_.files(); }
  const std::string& root() const { return writer_.root(); }
  const std::string& path() const { return writer_.path(); }  // of the open file, from the root; empty before it has a name

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
