#pragma once
// The file .kadr.toml of a folder, which remembers the control for the programs of this folder and of the folders below it.
// Example of its contents:
//
//   control = "haas"              # an id that `kadr controls` lists, or the path of a control file, relative to .kadr.toml
//   [control_for]
//   "*.ngc" = "linuxcnc"          # control for files whose names match a pattern, as with the option --control-for
//
// Kadr writes the file only with the option --remember.

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/file_access.h"

namespace kadr {

inline constexpr const char* remembering_file = ".kadr.toml";

/// Reads each .kadr.toml once and stores what it states.
class RememberedControls {
 public:
  ///   complain  receives a sentence for each fault in a .kadr.toml
  ///   door      opens the files; nullptr: files are opened in the file system directly. It must exist longer than this object
  explicit RememberedControls(std::function<void(const std::string&)> complain, const FileAccess* door = nullptr)
      : complain_(std::move(complain)), door_(door) {}

  /// Returns the control for a program. The nearest .kadr.toml decides: in the program's folder, or in a folder above it.
  ///   returns  empty if no .kadr.toml states a control for the program
  std::string of(const std::string& program);

 private:
  struct Remembered {
    std::string control;
    std::vector<std::pair<std::string, std::string>> patterns;
  };
  std::optional<Remembered> read(const std::string& file) const;

  std::function<void(const std::string&)> complain_;
  const FileAccess* door_;
  std::map<std::string, std::optional<Remembered>> folders_;
};

/// Writes `control` to the .kadr.toml in the program's folder. Other lines of the file stay unchanged.
///   returns  an error sentence; empty on success
std::string save_control_choice(const std::string& control, const std::string& program);

}  // namespace kadr
