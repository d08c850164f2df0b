#pragma once
// FileAccess: opens the files that a program, a set-up or a control's file refers to, for example a called program or the control that
// another control extends. Without a FileAccess, Kadr opens such files directly in the file system. The server uses a FileAccess that opens
// nothing outside the served folder.

#include <string>

namespace kadr {

class FileAccess {
 public:
  virtual ~FileAccess() = default;
  /// Opens a regular file for reading, without blocking.
  ///   returns  a file descriptor that the caller owns, or -1 with the reason in errno
  virtual int open_for_reading(const std::string& path) const = 0;
  /// Returns true if the path is inside the folders that this FileAccess may open. Links in the path are not resolved for this check.
  virtual bool reaches(const std::string& path) const = 0;
};

}  // namespace kadr
