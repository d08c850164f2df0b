#pragma once
// The control of a program for which none is named: guessed from its text and from those that lie beside it.

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "cli/options.h"
#include "config/guess.h"

namespace kadr::cli {

/// The control that the options name for the file; empty: none.
std::string control_by_pattern(const Options& options, const std::string& file);

/// The control that the options name for the file, or the one its text looks like: said on stderr, with what it was seen by.
///   returns  nothing: it cannot be read; empty: it is no program of a control that Kadr knows
std::optional<std::string> control_of(const Options& options, const std::string& file);

/// The same of many programs: one without a decisive mark is taken for what those of its folder are, or of the nearest folder above it.
class GuessedControls {
 public:
  GuessedControls(const Options& options, const std::vector<std::string>& files);
  std::optional<std::string> of(const std::string& file) const;

 private:
  struct Neighbour {
    std::string control;
    std::string file;  // that shows it; empty: none alone
    std::string reason_en, reason_ru;
  };
  std::optional<Neighbour> neighbour_of(const std::string& file) const;

  const Options& options_;
  std::map<std::string, Guess> guesses_;  // of the files that can be read and have no control named
  std::map<std::string, Neighbour> folders_;
};

}  // namespace kadr::cli
