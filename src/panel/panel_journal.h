#pragma once
// PanelJournal: what is kept of the machines at their panels beyond the end of the server (--state FILE), and the log of the shift. One
// state file (config/state_file) of the control "panel"; a key a thing, whoever keeps it says in what form.
//
//   "machine:part.nc" how it was switched on · "tables:part.nc" what was edited · "spot:part.nc" where it stands · "log:part.nc:17"

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
  static constexpr std::size_t most_logged = 10'000;  // of a machine: the oldest goes
  using Done = tl::expected<void, std::string>;

  /// Kept in memory alone.
  PanelJournal() = default;
  /// In a state file, or in a new one where there is none.
  ///   returns  an error sentence naming the file
  static tl::expected<std::unique_ptr<PanelJournal>, std::string> open(const std::string& path);

  // From any thread.
  bool lasts() const { return file_ != nullptr; }
  std::optional<std::string> value(const std::string& what, const std::string& machine) const;
  /// Kept when this returns, also if the process is killed then.
  ///   returns  an error sentence: it is known here, and not in the file
  Done keep(const std::string& what, const std::string& machine, std::string value);
  /// Machines that are kept.
  std::vector<std::string> machines() const;
  /// All but the log.
  Done forget(const std::string& machine);
  Done log(const std::string& machine, std::string entry);
  /// The oldest first.
  std::vector<std::string> log_of(const std::string& machine) const;

 private:
  /// With what could not be saved before.
  Done save(const std::vector<StateRow>& rows);

  mutable std::mutex lock_;
  std::unique_ptr<StateFile> file_;  // nullptr: none is asked for
  std::vector<StateRow> unsaved_;
  std::map<std::string, std::string> all_;
  std::map<std::string, std::map<std::uint64_t, std::string>> logs_;  // by machine, in their order
};

}  // namespace kadr
