#pragma once
// The files that a program writes: the log and the file of probed points (spec/linuxcnc 2.4), and at the end of the program the parameter
// file (4.4) and the tool table (9). All are in the program memory; at most one file of each kind is open.

#include <string>
#include <string_view>

#include "action/tool_position.h"
#include "base/result.h"
#include "control/control.h"
#include "control/files/file_writer.h"

namespace kadr::linuxcnc {

class ProgramFiles {
 public:
  enum class Which : std::uint8_t { log, probe, parameters, tools };

  explicit ProgramFiles(const files::OutputOptions& options) : log_(options), probe_(options), parameters_(options), tools_(options) {}

  /// Opens a file. An open file of the same kind is closed first.
  ///   name     path relative to the program memory, with `/` between its parts
  ///   appends  true: text is added to an existing file; false: an existing file is emptied
  ///   running  path of the running program
  ///   alarms   file_name, file_outside, file_write, file_already_open
  Status open(Which which, std::string_view name, bool appends, const std::string& running);
  Status close(Which which);
  /// Replaces the contents of a file by `text`. The former contents `before` are saved in a file `name.bak`.
  Status replace(Which which, const std::string& name, const std::string& before, const std::string& text);
  /// Writes a line to the open file of this kind. If no such file is open, nothing is written.
  Status write(Which which, std::string_view line);

  const WrittenFiles& written() const { return written_; }

  struct Memory {
    files::FileWriter::Memory log, probe;
  };
  Memory memory() const { return {log_.memory(), probe_.memory()}; }
  Status resume_from(const Memory& memory);

 private:
  files::FileWriter& of(Which which) {
    switch (which) {
      case Which::log: return log_;
      case Which::probe: return probe_;
      case Which::parameters: return parameters_;
      case Which::tools: break;
    }
    return tools_;
  }
  void note();

  files::FileWriter log_, probe_, parameters_, tools_;
  WrittenFiles written_;
};

}  // namespace kadr::linuxcnc
