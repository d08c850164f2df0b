#pragma once
// Guesses the control of a program for which none is named, from its text and from the files next to it.

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "cli/options.h"
#include "session/folder_guess.h"

namespace kadr::cli {

/// Returns the control that the options name for the file, or that its folder's .kadr.toml remembers; empty if there is none.
std::string named_control(const Options& options, const std::string& file);

/// Returns the named control, or the one guessed from text, name and neighbours of the file; a guess and its reasons are printed on stderr.
///   returns  nullopt if the file cannot be read; empty if it is no program of a control that Kadr supports
std::optional<std::string> control_of(const Options& options, const std::string& file);

/// The same for many programs, each with the others as its neighbours.
class GuessedControls {
 public:
  GuessedControls(const Options& options, const std::vector<std::string>& files);
  std::optional<std::string> of(const std::string& file) const;

 private:
  void say(const std::string& file, const FolderGuess::Neighbours& neighbours) const;
  bool refuses(const std::string& file, const std::string& control) const;

  const Options& options_;
  std::set<std::string> forgotten_;  // files whose control --remember could not save
  FolderGuess guesses_;
};

}  // namespace kadr::cli
