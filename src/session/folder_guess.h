#pragma once
// FolderGuess: guesses for which control a program was written if the user names none. The evidence is the text and the name of the
// program, and other programs in its folder. Used by the commands and the page alike.

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/file_access.h"
#include "config/control/guess.h"
#include "lang/text/utf16.h"

namespace kadr {

/// How the program files are opened and read.
struct GuessAccess {
  // returns the control that the user has named for a file; empty: none, so the control is guessed
  std::function<std::string(const std::string& file)> named{};
  GivenEncoding encoding{};
  const FileAccess* door = nullptr;   // opens the files; nullptr: the file system
  std::optional<std::string> text{};  // contents of the program if there is only one, used instead of the contents of its file
};

/// Reads the beginning of a program file as text.
///   returns  nullopt if the file cannot be read; errno says why
std::optional<std::string> beginning_of_program(const std::string& file, const GivenEncoding& encoding, const FileAccess* door = nullptr);

/// A program whose own text leaves the control open is assigned the control of the other programs in its folder, or in the nearest folder
/// above. If only a few programs of a folder are given, some other programs of the folder are read too.
class FolderGuess {
 public:
  FolderGuess(GuessAccess ways, const std::vector<std::string>& files);

  struct Neighbours {
    CommonGuess common;
    std::string file;  // the neighbouring file that is the evidence; empty: several files together are the evidence
    std::string reason_en, reason_ru;
  };
  struct Answer {
    Guess guess;                           // the guess from the program itself
    std::optional<Neighbours> neighbours;  // the neighbouring programs whose control is assumed; nullopt: the program itself decides
    const std::string& control() const { return neighbours ? neighbours->common.control : guess.control; }
  };
  ///   returns  nullopt if the file cannot be read, or if the user has named its control
  std::optional<Answer> of(const std::string& file) const;

 private:
  void take(const std::string& file, std::size_t max_bytes);
  void take_neighbours(const std::string& folder, const std::vector<std::string>& of);
  void take_folder(const std::string& folder, const std::vector<std::string>& files);
  std::optional<Neighbours> neighbours_of(const std::string& file) const;
  std::string named(const std::string& file) const { return ways_.named ? ways_.named(file) : std::string(); }

  GuessAccess ways_;
  std::map<std::string, std::vector<GuessRows>> rows_;  // by folder: the evidence that control files in the folder define
  std::map<std::string, Guess> guesses_;                // by file: readable files whose control the user has not named
  std::map<std::string, Neighbours> folders_;
};

/// Returns the guess for display on a page. If the control of neighbouring programs is assumed, the guess has that control and the
/// reason.
Guess with_neighbours(const FolderGuess::Answer& answer);

}  // namespace kadr
