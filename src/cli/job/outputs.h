#pragma once
// Outputs: the files that a command writes. An output file must be neither an input file nor another output file.

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/file_id.h"
#include "config/texts.h"
#include "out/trace/result_file.h"

namespace kadr::cli {

/// Checks that everything printed to standard output was written; prints an error if not (disk full, pipe closed).
bool came_out();

class Outputs {
 public:
  explicit Outputs(Lang lang) : lang_(lang) {}

  /// Registers an input file: "-" is standard input, an empty name means no file.
  void reads(const std::string& path);
  /// Registers the output file of an option; an empty name means no file. by_its_owner: open() does not open it, since its owner does
  /// (the state file).
  enum class Opened : std::uint8_t { here, by_its_owner };
  void writes(const std::string& option, const std::string& name, Opened opened = Opened::here);

  /// Checks that no output is also an input or another output; prints an error for the first one that is.
  bool check() const;
  /// Opens all outputs, or none; prints an error for the first one that cannot be opened.
  ///   pre  check() returned true
  bool open();
  /// Returns nullptr if the option was not given.
  const ResultFile* file(const std::string& option) const;
  std::FILE* stream(const std::string& option) const;

  /// All files that must not change while the command runs: inputs and outputs.
  FileSet all() const;

  /// Completes the files and moves them to their final paths, standard output last. Keeps no file if `read`, the files that the run has
  /// read, contains one of them. Prints errors.
  bool keep(const std::vector<std::string>& read = {});

 private:
  struct Output {
    std::string option, name;
    Opened opened;
    std::optional<ResultFile> file;
  };
  std::string fault_of(std::size_t index) const;
  /// Returns the sentence with the option of the output, its name, and the other file.
  std::string clash(const Output& output, TextId<3> sentence, const std::string& other) const;

  Lang lang_;
  std::vector<std::string> inputs_;
  std::vector<Output> outputs_;
};

}  // namespace kadr::cli
