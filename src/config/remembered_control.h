#pragma once
// The control that a folder's .kadr.toml remembers for its programs, and for those of folders below it:
//
//   control = "haas"              # an id of `kadr controls`, or a control file, beside this one
//   [control_for]
//   "*.ngc" = "linuxcnc"          # as --control-for
//
// It is written by --remember alone.

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/file_door.h"

namespace kadr {

inline constexpr const char* remembering_file = ".kadr.toml";

/// Reads the .kadr.toml of each folder once.
class RememberedControls {
 public:
  ///   complain  gets a sentence for each thing that is wrong in one
  ///   door      opens them; nullptr: the file system. It outlives this
  explicit RememberedControls(std::function<void(const std::string&)> complain, const FileDoor* door = nullptr)
      : complain_(std::move(complain)), door_(door) {}

  /// The nearest .kadr.toml decides, in the folder of the program or above.
  ///   returns  empty: nothing is remembered
  std::string of(const std::string& program);

 private:
  struct Remembered {
    std::string control;
    std::vector<std::pair<std::string, std::string>> patterns;
  };
  std::optional<Remembered> read(const std::string& file) const;

  std::function<void(const std::string&)> complain_;
  const FileDoor* door_;
  std::map<std::string, std::optional<Remembered>> folders_;
};

/// Writes `control` to the .kadr.toml of the folder the program lies in; other lines stay.
///   returns  an error sentence; empty: it is written
std::string remember_control(const std::string& control, const std::string& program);

}  // namespace kadr
