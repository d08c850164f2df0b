#pragma once
// Guesses the control of a program from its text and from the files next to it, if the user names none.

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "cli/options/options.h"
#include "session/folder_guess.h"

namespace kadr::cli {

/// Returns the control that the options name for the file, or that .kadr.toml in its folder stores; empty if there is none.
std::string named_control(const Options& options, const std::string& file);

/// Returns the named control, or the control guessed from the text, the name and the neighbours of the file; prints a guess and its
/// reasons on stderr.
///   returns  nullopt if the file cannot be read; an empty text if the file is no program of a control that Kadr supports
std::optional<std::string> control_of(const Options& options, const std::string& file);

/// Finds the controls of many programs; a guess for one program also considers the others.
class GuessedControls {
 public:
  GuessedControls(const Options& options, const std::vector<std::string>& files);
  std::optional<std::string> of(const std::string& file) const;

 private:
  void say(const std::string& file, const FolderGuess::Neighbours& neighbours) const;
  bool refuses(const std::string& file, const std::string& control) const;

  const Options& options_;
  std::set<std::string> forgotten_;  // files for which --remember could not save the control
  FolderGuess guesses_;
};

}  // namespace kadr::cli
