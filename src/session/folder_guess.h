#pragma once
// FolderGuess: guesses for which control a program was written if the user names no control. The evidence is the text and the name of the
// program, and the other programs in its folder. It is used by the commands and by the page.

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/file_access.h"
#include "config/control/guess.h"
#include "lang/text/utf16.h"

namespace kadr {

/// The functions and data with which program files are opened and read.
struct GuessAccess {
  // A function of the caller that returns the control that the user has named for a file. If it returns an empty text, the control is
  // guessed.
  std::function<std::string(const std::string& file)> named{};
  GivenEncoding encoding{};
  const FileAccess* door = nullptr;   // opens the files; nullptr: files are read from the file system
  std::optional<std::string> text{};  // text of the program, used instead of the contents of its file; only if there is a single program
};

/// Reads the beginning of a program file and converts it to UTF-8.
///   returns  nullopt if the file cannot be read; errno states the reason
std::optional<std::string> beginning_of_program(const std::string& file, const GivenEncoding& encoding, const FileAccess* door = nullptr);

/// Guesses the controls of several programs together. A program whose own text is not decisive gets the control of the other programs in
/// its folder, or in the nearest folder above. If only a few programs of a folder are given, some other programs of the folder are read
/// too.
class FolderGuess {
 public:
  FolderGuess(GuessAccess access, const std::vector<std::string>& files);

  struct Neighbours {
    CommonGuess common;
    std::string file;  // name of the neighbouring file that is the evidence; empty: several files together are the evidence
    std::string reason_en, reason_ru;
  };
  struct Answer {
    Guess guess;  // the guess that is based only on the text and the name of the program itself
    // the neighbouring programs whose control is assumed; nullopt: only the program itself is the evidence
    std::optional<Neighbours> neighbours;
    const std::string& control() const { return neighbours ? neighbours->common.control : guess.control; }
  };
  /// Returns the guess for a program. The result is nullopt if the file cannot be read, or if the user has named its control.
  std::optional<Answer> of(const std::string& file) const;

 private:
  void take(const std::string& file, std::size_t max_bytes);
  void take_neighbours(const std::string& folder, const std::vector<std::string>& of);
  void take_folder(const std::string& folder, const std::vector<std::string>& files);
  std::optional<Neighbours> neighbours_of(const std::string& file) const;
  std::string named(const std::string& file) const { return access_.named ? access_.named(file) : std::string(); }

  GuessAccess access_;
  std::map<std::string, std::vector<GuessRows>> rows_;  // by folder: evidence that the control files in the folder define
  std::map<std::string, Guess> guesses_;                // by file: the guess for each readable file for which the user has named no control
  std::map<std::string, Neighbours> folders_;
};

/// Returns the guess for display on a page. If the control of neighbouring programs is assumed, the result contains that control and the
/// reason for the assumption.
Guess with_neighbours(const FolderGuess::Answer& answer);

}  // namespace kadr
