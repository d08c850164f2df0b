#pragma once
// Guesses the control of a program from the text of the program and from the neighbouring files, if the user names no control.

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "cli/options/options.h"
#include "session/folder_guess.h"

namespace kadr::cli {

/// Returns the control that the options name for the file, otherwise the control that .kadr.toml in the file's folder stores; empty if
/// neither exists.
std::string named_control(const Options& options, const std::string& file);

/// Returns the control that the user has named. If there is none, guesses the control from the text, the name and the neighbours of the
/// file, and prints the guess with its reasons on stderr.
///   returns  nullopt if the file cannot be read; an empty text if the file is no program of a control that Kadr supports
std::optional<std::string> control_of(const Options& options, const std::string& file);

/// Finds the controls of many programs. The guess for one program also considers the other programs.
class GuessedControls {
 public:
  GuessedControls(const Options& options, const std::vector<std::string>& files);
  std::optional<std::string> of(const std::string& file) const;

 private:
  void print_neighbours(const std::string& file, const FolderGuess::Neighbours& neighbours) const;
  bool refuses(const std::string& file, const std::string& control) const;

  const Options& options_;
  std::set<std::string> forgotten_;  // files in whose folder --remember could not store the control
  FolderGuess guesses_;
};

}  // namespace kadr::cli
