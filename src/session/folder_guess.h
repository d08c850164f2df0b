#pragma once
// The control of programs for which none is named: guessed from their texts, their names, and what lies beside them. For the commands and
// the page alike.

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/file_door.h"
#include "config/guess.h"
#include "lang/text/utf16.h"

namespace kadr {

/// How the files are asked.
struct GuessWays {
  std::function<std::string(const std::string& file)> named{};  // a control that somebody names for it: it is not guessed; empty: none
  SaidEncoding encoding{};
  const FileDoor* door = nullptr;     // opens them; nullptr: the file system
  std::optional<std::string> text{};  // of the only file, in the place of what it holds
};

/// The beginning of a program as text.
///   returns  nothing: it cannot be read, errno tells why
std::optional<std::string> beginning_of_program(const std::string& file, const SaidEncoding& encoding, const FileDoor* door = nullptr);

/// A program without a decisive mark is taken for what those of its folder are, or of the nearest folder above it. Where few programs of a
/// folder are named, some of the others that lie there are looked at, too.
class FolderGuess {
 public:
  FolderGuess(GuessWays ways, const std::vector<std::string>& files);

  struct Neighbours {
    CommonGuess common;
    std::string file;  // that shows it; empty: none alone
    std::string reason_en, reason_ru;
  };
  struct Answer {
    Guess guess;                           // its own
    std::optional<Neighbours> neighbours;  // it is taken for what they are
    const std::string& control() const { return neighbours ? neighbours->common.control : guess.control; }
  };
  ///   returns  nothing: it cannot be read, or has a control named
  std::optional<Answer> of(const std::string& file) const;

 private:
  void take(const std::string& file, std::size_t most_bytes);
  void take_neighbours(const std::string& folder, const std::vector<std::string>& of);
  void take_folder(const std::string& folder, const std::vector<std::string>& files);
  std::optional<Neighbours> neighbours_of(const std::string& file) const;
  std::string named(const std::string& file) const { return ways_.named ? ways_.named(file) : std::string(); }

  GuessWays ways_;
  std::map<std::string, std::vector<GuessRows>> rows_;  // of a folder's own controls
  std::map<std::string, Guess> guesses_;                // of the files that can be read and have no control named
  std::map<std::string, Neighbours> folders_;
};

/// The guess that a page shows: the neighbours' control with its reason, where it is taken for that.
Guess with_neighbours(const FolderGuess::Answer& answer);

}  // namespace kadr
