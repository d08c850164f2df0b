#pragma once
// PanelJournal: the data of panel machines that outlive the server (--state FILE), and the log of the shift. It is one state file
// (config/state_file) of the control "panel", with one key per item; the writer of an item chooses its format.
//
//   "machine:part.nc" how it was switched on · "tables:part.nc" edited tables · "spot:part.nc" its location · "log:part.nc:17" log entry

#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "config/state_file.h"

namespace kadr {

class PanelJournal {
 public:
  static constexpr std::size_t most_logged = 10'000;  // entries per machine; the oldest is dropped
  using Done = tl::expected<void, std::string>;

  /// Keeps everything in memory only.
  PanelJournal() = default;
  /// Opens a state file, or creates it.
  ///   returns  an error sentence with the name of the file
  static tl::expected<std::unique_ptr<PanelJournal>, std::string> open(const std::string& path);

  // All functions below may be called from any thread.
  bool lasts() const { return file_ != nullptr; }
  std::optional<std::string> value(const std::string& what, const std::string& machine) const;
  /// Saves a value. It is safe on return, even if the process is killed then.
  ///   returns  an error sentence: the value is kept in memory, but not in the file
  Done keep(const std::string& what, const std::string& machine, std::string value);
  /// Machines with saved data.
  std::vector<std::string> machines() const;
  /// Deletes everything of the machine except its log.
  Done forget(const std::string& machine);
  Done log(const std::string& machine, std::string entry);
  /// Oldest entry first.
  std::vector<std::string> log_of(const std::string& machine) const;

 private:
  /// Saves the rows, and those that could not be saved before.
  Done save(const std::vector<StateRow>& rows);

  mutable std::mutex lock_;
  std::unique_ptr<StateFile> file_;  // nullptr: memory only
  std::vector<StateRow> unsaved_;
  std::map<std::string, std::string> all_;
  std::map<std::string, std::map<std::uint64_t, std::string>> logs_;  // by machine, in order
};

}  // namespace kadr
