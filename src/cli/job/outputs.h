#pragma once
// Outputs: the files that a command writes. An output file must not be an input file or another output file.

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/file_id.h"
#include "config/texts.h"
#include "out/trace/result_file.h"

namespace kadr::cli {

/// True if everything printed to standard output was written. Prints an error otherwise (disk full, pipe closed).
bool came_out();

class Outputs {
 public:
  explicit Outputs(Lang lang) : lang_(lang) {}

  /// Registers an input file. The name "-" means standard input, an empty name means no file.
  void reads(const std::string& path);
  /// Registers the output file of an option. An empty name means no file. open() opens an output with Opened::here. An output with
  /// Opened::by_its_owner (the state file) is opened by the object that writes it.
  enum class Opened : std::uint8_t { here, by_its_owner };
  void writes(const std::string& option, const std::string& name, Opened opened = Opened::here);

  /// Checks that no output is also an input or another output. Prints an error for the first such output and returns false.
  bool check() const;
  /// Opens all outputs. If one of them cannot be opened, the function prints an error, opens none of them and returns false.
  ///   pre  check() has returned true
  bool open();
  /// Returns the open file of an option, e.g. "--out"; nullptr if the user has not given the option.
  const ResultFile* file(const std::string& option) const;
  std::FILE* stream(const std::string& option) const;

  /// Returns all files that must not change while the command runs: inputs and outputs.
  FileSet all() const;

  /// Completes the files and moves them to their final paths, standard output last. If an output is also in `read` (the files that the run
  /// has read), no output is completed. If an error occurs, it is printed and the function returns false.
  bool keep(const std::vector<std::string>& read = {});

 private:
  struct Output {
    std::string option, name;
    Opened opened;
    std::optional<ResultFile> file;
  };
  std::string fault_of(std::size_t index) const;
  /// Returns the error message for an output that is the same file as another one. The message is `sentence` with the option and the name
  /// of the output, and with `other`, the name of the other file.
  std::string clash(const Output& output, TextId<3> sentence, const std::string& other) const;

  Lang lang_;
  std::vector<std::string> inputs_;
  std::vector<Output> outputs_;
};

}  // namespace kadr::cli
