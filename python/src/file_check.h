#pragma once
// Checks a file as `kadr check` does: all programs of a tape, the checklist, the values that the set-up does not state.

#include <string>
#include <vector>

#include "program.h"

namespace kadr::python {

struct FileCheck {
  std::vector<Finding> findings;   // in the order in which the check meets them
  std::vector<std::string> files;  // the files that the programs have called; the file itself is not listed
};

/// Returns everything that `kadr check` finds in the file, each finding once. Tools files next to the program are not read, so that the
/// result depends on the program only, and on the files that it calls.
///   throws  Interrupted, Failed, FileFailed
FileCheck check_file(const ProgramSpec& spec);

/// The controls that the .kadr.toml of folders remember. Each of these files is read once.
class Remembered {
 public:
  Remembered() : controls_([this](const std::string& why) { fault_ = why; }) {}
  Remembered(const Remembered&) = delete;  // its member calls back into this object
  Remembered& operator=(const Remembered&) = delete;
  /// Returns the control that .kadr.toml in the program's folder, or in a folder above it, remembers; empty if there is none.
  ///   throws  Failed, if a .kadr.toml has a fault
  std::string of(const std::string& file);

 private:
  std::string fault_;
  RememberedControls controls_;
};

/// Judges a file by its name as `kadr check` does for the files of a folder: "program", "nothing" (the contents decide), "other".
std::string name_verdict(const std::string& name);

}  // namespace kadr::python
