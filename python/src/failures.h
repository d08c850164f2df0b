#pragma once
// What becomes an exception of Python's (module.cpp), and findings as values that outlive what they are of.

#include <kadr/kadr.h>

#include <string>

namespace kadr::python {

/// kadr.Error: what was asked for cannot be done.
struct Failed {
  std::string text;
};

/// OSError, of an errno: FileNotFoundError, PermissionError, …
struct FileFailed {
  int error = 0;
  std::string file;
};

/// kadr.Alarm: the program was stopped.
struct Alarmed {
  Finding finding;
};

/// Ctrl-C: what Python's own handler makes of it.
struct Interrupted {};

}  // namespace kadr::python
