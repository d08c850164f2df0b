#pragma once
// PanelJournal stores the data of panel machines that outlive the server (--state FILE), and the log of the operators' actions. All data
// are in one state file (config/state/state_file) whose control is named "panel". Each item has a key; the code that saves an item chooses
// the format of its value.
//
//   "machine:part.nc"  how the machine of part.nc was switched on
//   "tables:part.nc"   its edited tables
//   "spot:part.nc"     its location in the program
//   "log:part.nc:17"   entry 17 of its log

#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "config/state/state_file.h"

namespace kadr {

class PanelJournal {
 public:
  // The number of log entries per machine. When it is exceeded, the oldest entry is deleted.
  static constexpr std::size_t max_logged = 10'000;
  using Done = tl::expected<void, std::string>;

  /// Creates a journal without a file. All data are then in memory only.
  PanelJournal() = default;
  /// Opens a state file; if the file does not exist, creates it.
  ///   returns  the journal, or an error sentence with the name of the file
  static tl::expected<std::unique_ptr<PanelJournal>, std::string> open(const std::string& path);

  // All functions below may be called from any thread.
  bool lasts() const { return file_ != nullptr; }
  std::optional<std::string> value(const std::string& what, const std::string& machine) const;
  /// Saves a value. When the function returns, the value is on the disk, so it survives even if the process is killed.
  ///   returns  an error sentence if the file cannot be written; the value is then in memory only
  Done keep(const std::string& what, const std::string& machine, std::string value);
  /// Names of the machines with saved data.
  std::vector<std::string> machines() const;
  /// Deletes all data of the machine except its log.
  Done forget(const std::string& machine);
  Done log(const std::string& machine, std::string entry);
  /// The log entries of the machine, the oldest entry first.
  std::vector<std::string> log_of(const std::string& machine) const;

 private:
  /// Writes the rows to the file. Rows that an earlier call could not write are written too.
  Done save(const std::vector<StateRow>& rows);

  mutable std::mutex lock_;
  std::unique_ptr<StateFile> file_;  // the state file; nullptr: all data are in memory only
  std::vector<StateRow> unsaved_;
  std::map<std::string, std::string> all_;
  std::map<std::string, std::map<std::uint64_t, std::string>> logs_;  // log entries by machine, then by entry number
};

}  // namespace kadr
