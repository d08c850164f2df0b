#pragma once
// The control of a program for which none is named: guessed from its text and from those that lie beside it.

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "cli/options.h"
#include "session/folder_guess.h"

namespace kadr::cli {

/// The control that the options name for the file, or its folder's .kadr.toml remembers; empty: none.
std::string named_control(const Options& options, const std::string& file);

/// The named control, or the one that its text, its name and its neighbours speak for: said on stderr, with what it was seen by.
///   returns  nothing: it cannot be read; empty: it is no program of a control that Kadr knows
std::optional<std::string> control_of(const Options& options, const std::string& file);

/// The same of many programs, each beside the others.
class GuessedControls {
 public:
  GuessedControls(const Options& options, const std::vector<std::string>& files);
  std::optional<std::string> of(const std::string& file) const;

 private:
  void say(const std::string& file, const FolderGuess::Neighbours& neighbours) const;
  bool refuses(const std::string& file, const std::string& control) const;

  const Options& options_;
  std::set<std::string> forgotten_;  // files whose control --remember could not write down
  FolderGuess guesses_;
};

}  // namespace kadr::cli
