#pragma once
// ProgramFolder: the programs of a folder and the names by which they call each other, found as the controls find them: in the own file,
// then by the name of a file (O0200.nc, pocket.ngc, PART.SPF), then by the first program of a file (spec/fanuc 9.2, spec/linuxcnc 6.2,
// spec/sinumerik 1).

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "lsp/document_names.h"

namespace kadr {

/// A place of a program file that names a program: a definition, or a call.
struct ProgramPlace {
  NamedPlace place;
  TextRange range;
};

/// A file of the folder, or an open document in its place.
struct ProgramFileNames {
  std::string uri, path;
  std::vector<ProgramPlace> places;  // of programs and labels
};

/// Returns a text with small Latin letters: names of programs and files are compared so.
std::string in_lower_case(std::string text);

/// Returns the places of a text that name programs.
std::vector<ProgramPlace> program_places(const TextDocument& text, const DocumentNames& names);

class ProgramFolder {
 public:
  static constexpr std::size_t max_files = 2000;                           // of a folder; further ones are not read
  static constexpr std::uint64_t max_file_bytes = std::uint64_t{4} << 20;  // longer files are not read
  static constexpr std::size_t max_places = 500'000;                       // of all files together

  ProgramFolder(std::shared_ptr<const ControlDef> def, ColumnUnit unit) : def_(std::move(def)), unit_(unit) {}

  /// Reads the files of a folder again that have changed. `open`: paths of files that are not read, because they are open documents.
  void read(const std::filesystem::path& folder, const std::vector<std::string>& open);
  const std::vector<ProgramFileNames>& files() const { return files_; }

 private:
  struct State {
    std::filesystem::file_time_type time;
    std::uintmax_t bytes = 0;
    friend bool operator==(const State&, const State&) = default;
  };
  std::shared_ptr<const ControlDef> def_;
  ColumnUnit unit_;
  std::map<std::string, State> states_;
  std::vector<ProgramFileNames> files_;
};

/// Returns the files that a call of a program runs, by the order of the search; those of the folder of the caller before others. Several:
/// the control refuses the call as ambiguous.
///   caller  index of the file that calls
std::vector<std::size_t> files_called(const std::vector<const ProgramFileNames*>& files, std::size_t caller, const NamedPlace& called);

}  // namespace kadr
