#pragma once
// The control of a program for which none is named: guessed from its text and from those that lie beside it.

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "cli/options.h"
#include "config/guess.h"

namespace kadr::cli {

/// The control that the options name for the file, or its folder's .kadr.toml remembers; empty: none.
std::string named_control(const Options& options, const std::string& file);

/// The named control, or the one that its text, its name and its neighbours speak for: said on stderr, with what it was seen by.
///   returns  nothing: it cannot be read; empty: it is no program of a control that Kadr knows
std::optional<std::string> control_of(const Options& options, const std::string& file);

/// The same of many programs: one without a decisive mark is taken for what those of its folder are, or of the nearest folder above it.
/// Where few programs of a folder are named, some of the others that lie there are looked at, too.
class GuessedControls {
 public:
  GuessedControls(const Options& options, const std::vector<std::string>& files);
  std::optional<std::string> of(const std::string& file) const;

 private:
  struct Neighbours {
    CommonGuess common;
    std::string file;  // that shows it; empty: none alone
    std::string reason_en, reason_ru;
  };
  void take(const std::string& file, std::size_t most_bytes);
  void take_neighbours(const std::string& folder, const std::vector<std::string>& of);
  void take_folder(const std::string& folder, const std::vector<std::string>& files);
  std::optional<Neighbours> neighbours_of(const std::string& file) const;
  void say(const std::string& file, const Neighbours& neighbours) const;
  bool refuses(const std::string& file, const std::string& control) const;

  const Options& options_;
  std::map<std::string, std::vector<GuessRows>> rows_;  // of a folder's own controls
  std::map<std::string, Guess> guesses_;                // of the files that can be read and have no control named
  std::map<std::string, Neighbours> folders_;
  std::set<std::string> forgotten_;  // files whose control --remember could not write down
};

}  // namespace kadr::cli
