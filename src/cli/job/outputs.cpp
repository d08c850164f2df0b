// Outputs: opens, checks and completes the files that a command writes. It is used by cli/run, cli/mill, cli/tape_command and cli/check,
// and tested by tests/run_outputs.py.

#include "cli/job/outputs.h"

#include <fmt/core.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "cli/options/options.h"
#include "config/read_file.h"
#include "texts/outputs.h"

namespace kadr::cli {
namespace {

/// True for a device (terminal, /dev/null). Two outputs may use the same device, and a device may also be an input.
bool is_device(const std::string& name) {
  struct stat there {};
  return ::stat(name.c_str(), &there) == 0 && S_ISCHR(there.st_mode);
}

/// Returns the identity of the file. The name "-" means the file to which the standard stream `stream` is redirected. The result is empty
/// if that stream is not redirected to a file.
FileSet set_of(const std::string& name, int stream) {
  FileSet set;
  if (name != "-") set.add(name);
  else if (const auto id = file_id_of(stream)) set.add(*id);
  return set;
}

}  // namespace

bool came_out() {
  const int error = error_of(stdout);
  if (error != 0) complain_of_writing(translated(texts::outputs::standard_output), error);
  return error == 0;
}

void Outputs::reads(const std::string& path) {
  if (!path.empty()) inputs_.push_back(path);
}

void Outputs::writes(const std::string& option, const std::string& name, Opened opened) {
  if (name.empty()) return;
  outputs_.push_back({option, name, opened, std::nullopt});
  // the additional files of a state file must not be written either: SQLite reads them when it opens the state file again
  if (opened == Opened::by_its_owner)
    for (const char* const log : {"-wal", "-shm", "-journal"}) reads(name + log);
}

std::string Outputs::clash(const Output& output, TextId<3> sentence, const std::string& other) const {
  return translated_in(lang_, sentence, output.option, output.name, other);
}

/// Returns the reason why the output with this index cannot be written; empty if it can be written.
std::string Outputs::fault_of(std::size_t index) const {
  const Output& output = outputs_[index];
  const auto same = [](const std::string& a, const std::string& b, int stream_of_b) {
    if (a != "-" && b == "-") return set_of(b, stream_of_b).has(a);
    return a == "-" ? set_of("-", STDOUT_FILENO).has(b) : set_of(b, stream_of_b).has(a);
  };
  if (output.name != "-" && is_device(output.name)) return {};
  for (std::size_t i = 0; i < index; ++i) {
    const Output& other = outputs_[i];
    const bool both_standard = output.name == "-" && other.name == "-";
    if (both_standard || same(output.name, other.name, STDOUT_FILENO))
      return clash(output, texts::outputs::same_file, fmt::format("{} {}", other.option, other.name));
  }
  for (const std::string& input : inputs_) {
    if (output.name == "-" || (input != "-" && is_device(input))) continue;
    if (same(output.name, input, STDIN_FILENO)) return clash(output, texts::outputs::over_input, input);
  }
  // If standard output goes to the same file, the summary and this output would overwrite each other.
  if (output.name != "-" && !is_device("/dev/stdout") && same(output.name, "-", STDOUT_FILENO))
    return clash(output, texts::outputs::standard_output_goes_there, output.option + " -");
  return {};
}

bool Outputs::check() const {
  for (std::size_t i = 0; i < outputs_.size(); ++i)
    if (const std::string fault = fault_of(i); !fault.empty()) {
      complain(fault);
      return false;
    }
  return true;
}

bool Outputs::open() {
  for (Output& output : outputs_) {
    if (output.opened == Opened::by_its_owner) continue;
    auto file = ResultFile::open(output.name);
    if (!file) {
      complain(file.error());
      outputs_.clear();
      return false;
    }
    output.file = std::move(*file);
  }
  return true;
}

const ResultFile* Outputs::file(const std::string& option) const {
  for (const Output& output : outputs_)
    if (output.option == option && output.file) return &*output.file;
  return nullptr;
}

std::FILE* Outputs::stream(const std::string& option) const {
  const ResultFile* const found = file(option);
  return found != nullptr ? found->get() : nullptr;
}

FileSet Outputs::all() const {
  FileSet set;
  for (const std::string& input : inputs_)
    if (input != "-") set.add(input);
  for (const Output& output : outputs_)
    if (output.name != "-" && !is_device(output.name)) set.add(output.name);
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (const auto id = file_id_of(stream)) set.add(*id);
  return set;
}

bool Outputs::keep(const std::vector<std::string>& read) {
  if (!came_out()) return false;
  for (const std::string& input : read)
    for (const Output& output : outputs_) {
      if (output.name == "-" || is_device(output.name) || !set_of(output.name, STDOUT_FILENO).has(input)) continue;
      complain(clash(output, texts::outputs::over_called_file, input));
      return false;
    }
  for (Output& output : outputs_) {
    if (!output.file) continue;
    if (const auto saved = output.file->keep(); !saved) {
      if (!saved.error().empty()) complain(saved.error());
      return false;
    }
  }
  return true;
}

}  // namespace kadr::cli
