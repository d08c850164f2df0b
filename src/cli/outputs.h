#pragma once
// Outputs: the files that one command writes. It may not write a file that it reads, and no file twice.

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/file_id.h"
#include "config/alarm_texts.h"
#include "out/trace/result_file.h"

namespace kadr::cli {

/// Checks that everything printed was written, and complains if not: a full disk or a closed pipe is an error of every command.
bool came_out();

class Outputs {
 public:
  explicit Outputs(Lang lang) : lang_(lang) {}

  /// Registers an input: "-" is standard input, an empty name means no file.
  void reads(const std::string& path);
  /// Registers an output of the option; an empty name means no file. `opened`: by_its_owner if its owner opens it himself (the state file).
  enum class Opened : std::uint8_t { here, by_its_owner };
  void writes(const std::string& option, const std::string& name, Opened opened = Opened::here);

  /// Checks that no output is an input or another output; complains of the first that is.
  bool check() const;
  /// Opens all outputs, or none; complains of the first that cannot be opened.
  ///   pre  check() returned true
  bool open();
  /// Returns nullptr if the option was not given.
  const ResultFile* file(const std::string& option) const;
  std::FILE* stream(const std::string& option) const;

  /// All files that must not change while the command runs: inputs and outputs.
  FileSet all() const;

  /// Completes the files and puts them in their places, standard output last. Keeps none of them if `read` names one. Complains on errors.
  bool keep(const std::vector<std::string>& read = {});

 private:
  struct Output {
    std::string option, name;
    Opened opened;
    std::optional<ResultFile> file;
  };
  std::string fault_of(std::size_t index) const;
  std::string clash(const Output& output, const char* en, const char* ru, const std::string& other) const;

  Lang lang_;
  std::vector<std::string> inputs_;
  std::vector<Output> outputs_;
};

}  // namespace kadr::cli
