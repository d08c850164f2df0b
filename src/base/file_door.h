#pragma once
// FileDoor: who opens the files that are read because a program, a set-up or a control's file names them: what it calls, extends, begins
// with. Without one they are those of the file system. A server gives one that opens nothing beyond the folder that it serves.

#include <string>

namespace kadr {

class FileDoor {
 public:
  virtual ~FileDoor() = default;
  /// For reading: a regular file, and nobody is waited for.
  ///   returns  a descriptor, the caller's; -1: errno tells why
  virtual int open_for_reading(const std::string& path) const = 0;
  /// The path, links not followed, lies where files may be looked for.
  virtual bool reaches(const std::string& path) const = 0;
};

}  // namespace kadr
