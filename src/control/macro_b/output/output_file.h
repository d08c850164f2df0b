#pragma once
// The files that a program writes: POPEN31, FOPEN, DPRNT, BPRNT, FCLOS, PCLOS31 (nct 23.2.13). One file is open at a time, in the program
// memory. OutputFile opens, prints and closes; path_in_root() finds the file that a name means.
// control/files/file_writer.h describes the program memory, and ensures that no file outside the program memory is written.

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

/// The device number that a PCLOS without a number has (spec/fanuc 5.9).
inline constexpr double no_device = 0;

/// Returns the path of the file that a program refers to by <name>, in FOPEN or in a call by name.
///   name     text between < >: at most 60 characters, parts separated by `\`; `..` is the folder above, a leading `\` is the program's own
///            folder, blanks at both ends are ignored (14.4.2)
///   program  path of the program that uses the name, from the root, separated by `/`: "part.nct", "sub/part.nct"
///   returns  path from the root, separated by `/`
///   alarms   file_outside (name): the name leads above the root, or starts with a drive. file_name (name): the name is empty, too long or
///            not UTF-8, or has `/`, control characters, `: * ? " < > |`, empty parts, parts that start with a dot (hidden files: .bashrc,
///            .git) or end in a dot or blank, names of devices (CON, NUL, COM1 …)
///   law      no part of the result is empty, `.` or `..`
///   manual   14.4.2; the characters and devices are our choice, so that the same program works on any system
Result<std::string> path_in_root(std::string_view name, std::string_view program);

/// The file that a program writes. A statement that raises an alarm changes no file, except that after a disk error a file may be empty.
class OutputFile {
 public:
  explicit OutputFile(OutputOptions options) : writer_(std::move(options)) {}

  /// POPENn. The first print() names and creates the file.
  ///   device   31
  ///   program  path of the running program from the root; the new file gets the same folder and extension
  ///   alarms   file_mode (device), file_already_open (path)
  Status open_device(double device, std::string_view program);

  /// Executes POPEN without a number: appends to PRNT0000.DAT in the program's folder, starting with `%` CR LF (spec/fanuc 5.9). The alarms
  /// are those of open_named().
  Status open_card(std::string_view program);

  /// Executes FOPENn Pp: opens the file Onnnn, whose name has the number p in four digits. The name has eight digits if p is longer, or if
  /// only the eight-digit file exists. Folder and extension are those of `program` (14.4.2).
  ///   mode     1: a new file is created; 2: a new file is created, or an existing file is emptied;
  ///            3: text is appended to an existing file; 4: a new file is created, or text is appended to an existing file;
  ///            5: an existing file is emptied
  ///   alarms   file_mode (mode), value_out_of_range (P, p), file_already_open, program_file_exists ("O0012"), program_missing ("O0012"),
  ///            file_outside, file_write; file_already_open also if the file is the running program itself (our choice)
  Status open_number(double mode, double p, std::string_view program);

  /// Executes FOPENn <name>. The alarms are those of path_in_root() and of open_number(), with file_exists (name) and file_missing (name)
  /// in place of the alarms for programs. Inferred (14.4.2): capital and small Latin letters are equal in names, but an exact match has
  /// priority. Folders are not created.
  Status open_named(double mode, std::string_view name, std::string_view program);

  /// Writes the text of one print statement, as decimal() or binary() returns it, with its CR LF. When print() returns, the operating
  /// system has the text (one write, no buffer of our own), so a statement that is complete is not lost if this process is killed. A write
  /// that fails halfway is undone. The first DPRNT after POPEN31 is an exception: its text, with blanks removed, is the file's name, and
  /// `%` CR LF is written instead (inferred).
  ///   alarms   file_not_open, file_write (path), also if the file would exceed `most` bytes; if the text is the file's name: file_name
  ///            (also for BPRNT, or if the name has a separator), file_outside
  Status print(std::string_view line, PrintKind kind);

  /// Executes PCLOSn: writes `%` CR LF (inferred) and closes the file of POPEN. Alarms: file_mode (device); file_not_open, also after
  /// FOPEN; file_name, if no DPRNT has named the file; file_write.
  Status close_device(double device);

  /// Executes FCLOS: closes the file of FOPEN. Alarms: file_not_open, also after POPEN; file_write.
  Status close_file();

  /// Closes the open file at M2, M30 or any other end of the run, without writing a closing `%`.
  void abort();

  /// The part of a snapshot that belongs to the output file.
  struct Memory {
    std::uint8_t state = 0;
    std::string program;  // path of the program that executed POPEN
    files::FileWriter::Memory writer;
  };
  Memory memory() const;
  /// Continues the file that was open when the snapshot was taken. Text that was printed after the snapshot is cut off. Other files do not
  /// change.
  ///   alarms   file_write (path): the file no longer exists, is shorter than at the snapshot, or may not be written
  Status resume_from(const Memory& memory);

  bool is_open() const { return state_ != State::closed; }
  /// Returns all files written in the run, as a map from the path (from the root) to the size in bytes.
  const std::map<std::string, std::uint64_t>& files() const { return writer_.files(); }
  const std::string& root() const { return writer_.root(); }
  const std::string& path() const { return writer_.path(); }  // path of the open file from the root; empty until the file has a name

 private:
  enum class State : std::uint8_t { closed, waits_for_name, device, file };
  Status ready(double mode) const;
  Status open(files::OpenRequest request, int mode, std::string_view program);
  Status name_device_file(std::string_view line, PrintKind kind);
  Status close();

  files::FileWriter writer_;
  State state_ = State::closed;
  std::string program_;  // path of the program that executed POPEN
};

}  // namespace kadr::macro_b
