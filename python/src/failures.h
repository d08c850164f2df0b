#pragma once
// The C++ exceptions that module.cpp translates into Python exceptions. Findings are copied, so that they stay valid after the session
// ends.

#include <kadr/kadr.h>

#include <string>

namespace kadr::python {

/// Becomes kadr.Error: the request cannot be fulfilled.
struct Failed {
  std::string text;
};

/// Becomes the OSError of this errno: FileNotFoundError, PermissionError, …
struct FileFailed {
  int error = 0;
  std::string file;
};

/// Becomes kadr.Alarm: an alarm has stopped the program.
struct Alarmed {
  Finding finding;
};

/// Ctrl-C was pressed: Python's own signal handler decides what is raised (normally KeyboardInterrupt).
struct Interrupted {};

}  // namespace kadr::python
