#pragma once
// FolderGuess: guesses the control of programs for which the user names none, from their texts, their names and the files next to them.
// Used by the commands and the page alike.

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/file_door.h"
#include "config/guess.h"
#include "lang/text/utf16.h"

namespace kadr {

/// How the files are opened and read.
struct GuessWays {
  std::function<std::string(const std::string& file)> named{};  // the control that the user names: not guessed then; empty: none
  SaidEncoding encoding{};
  const FileDoor* door = nullptr;     // opens them; nullptr: the file system
  std::optional<std::string> text{};  // contents of the only file, used instead of reading it
};

/// Reads the beginning of a program as text.
///   returns  nullopt if the file cannot be read; errno says why
std::optional<std::string> beginning_of_program(const std::string& file, const SaidEncoding& encoding, const FileDoor* door = nullptr);

/// A program without a decisive mark is assigned the control of the programs in its folder, or in the nearest folder above. If only a few
/// programs of a folder are given, some of the others in the folder are read too.
class FolderGuess {
 public:
  FolderGuess(GuessWays ways, const std::vector<std::string>& files);

  struct Neighbours {
    CommonGuess common;
    std::string file;  // the file that is evidence for it; empty: no single file
    std::string reason_en, reason_ru;
  };
  struct Answer {
    Guess guess;                           // from the program itself
    std::optional<Neighbours> neighbours;  // set if their control is assumed
    const std::string& control() const { return neighbours ? neighbours->common.control : guess.control; }
  };
  ///   returns  nullopt if the file cannot be read, or the user has named its control
  std::optional<Answer> of(const std::string& file) const;

 private:
  void take(const std::string& file, std::size_t most_bytes);
  void take_neighbours(const std::string& folder, const std::vector<std::string>& of);
  void take_folder(const std::string& folder, const std::vector<std::string>& files);
  std::optional<Neighbours> neighbours_of(const std::string& file) const;
  std::string named(const std::string& file) const { return ways_.named ? ways_.named(file) : std::string(); }

  GuessWays ways_;
  std::map<std::string, std::vector<GuessRows>> rows_;  // of a folder's own control files
  std::map<std::string, Guess> guesses_;                // of the files that can be read and whose control is not named
  std::map<std::string, Neighbours> folders_;
};

/// The guess that a page displays: with the neighbours' control and its reason, if that is assumed.
Guess with_neighbours(const FolderGuess::Answer& answer);

}  // namespace kadr
