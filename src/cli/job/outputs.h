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
  /// Registers the output file of an option; an empty name means no file. open() opens an output with Opened::here. It does not open an
  /// output with Opened::by_its_owner (the state file), because the object that writes the file opens it.
  enum class Opened : std::uint8_t { here, by_its_owner };
  void writes(const std::string& option, const std::string& name, Opened opened = Opened::here);

  /// Checks that no output is also an input or another output; prints an error for the first one that is.
  bool check() const;
  /// Opens all outputs, or none; prints an error for the first one that cannot be opened.
  ///   pre  check() returned true
  bool open();
  /// Returns the open file of an option, such as "--out"; nullptr if the option was not given.
  const ResultFile* file(const std::string& option) const;
  std::FILE* stream(const std::string& option) const;

  /// All files that must not change while the command runs: inputs and outputs.
  FileSet all() const;

  /// Completes the files and moves them to their final paths, standard output last. If one of the outputs is also in `read`, the files that
  /// the run has read, no output is kept. Prints errors.
  bool keep(const std::vector<std::string>& read = {});

 private:
  struct Output {
    std::string option, name;
    Opened opened;
    std::optional<ResultFile> file;
  };
  std::string fault_of(std::size_t index) const;
  /// Returns the error message for an output that conflicts with another file: `sentence` with the option, the name of the output, and
  /// `other`.
  std::string clash(const Output& output, TextId<3> sentence, const std::string& other) const;

  Lang lang_;
  std::vector<std::string> inputs_;
  std::vector<Output> outputs_;
};

}  // namespace kadr::cli
