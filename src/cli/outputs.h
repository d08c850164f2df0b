#pragma once
// Outputs: the files of one command. None that it writes is one that it reads, and no two are one file.

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/file_id.h"
#include "config/alarm_texts.h"
#include "out/trace/result_file.h"

namespace kadr::cli {

/// What was printed has come out: a full disk or a closed pipe is an error of every command. Complains.
bool came_out();

class Outputs {
 public:
  explicit Outputs(Lang lang) : lang_(lang) {}

  /// An input: "-" is standard input, an empty name nothing.
  void reads(const std::string& path);
  /// An output under the option's name; an empty name is none. `kept`: by whoever opens it himself (the state file).
  enum class Opened : std::uint8_t { here, by_its_owner };
  void writes(const std::string& option, const std::string& name, Opened opened = Opened::here);

  /// None is an input or another output; complains of the first that is.
  bool check() const;
  /// After check(): opens them all, or none; complains of the first that cannot be.
  bool open();
  /// nullptr: not asked for.
  const ResultFile* file(const std::string& option) const;
  std::FILE* stream(const std::string& option) const;

  /// All that must stay as it is while the command runs: inputs and outputs.
  FileSet all() const;

  /// They are complete and take their places, standard output last; none does if `read` names one of them. Complains.
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
