// PanelJournal stores data of panel machines. Used by view/page/page_panel; tested by tests/panel/panel_journal_test.cpp and
// tests/panel_kills.py.

#include "panel/panel_journal.h"

#include <cstdlib>
#include <filesystem>
#include <utility>

namespace kadr {
namespace {

constexpr const char* control = "panel";  // the name of the control in the journal's state file
const std::string log_ = "log:";

/// Renames a log file that a killed server has left after its state file was deleted. This log would prevent the creation of a new state
/// file. It gets another name and is not deleted, because somebody may need its data.
void put_left_log_aside(const std::string& path) {
  std::error_code none;
  if (!path.empty() && !std::filesystem::exists(path, none) && std::filesystem::exists(path + "-wal", none))
    std::filesystem::rename(path + "-wal", path + "-wal.old", none);
}

}  // namespace

tl::expected<std::unique_ptr<PanelJournal>, std::string> PanelJournal::open(const std::string& path) {
  put_left_log_aside(path);
  auto file = StateFile::open(path, control);
  if (!file) return tl::unexpected(file.error());
  const auto stored = file->load();
  if (!stored) return tl::unexpected(stored.error());
  auto journal = std::make_unique<PanelJournal>();
  journal->file_ = std::make_unique<StateFile>(std::move(*file));
  for (const StateRow& row : stored->rows) {
    const auto* const text = std::get_if<std::string>(&row.value);
    if (row.table != StateTable::panel || text == nullptr) continue;
    const std::size_t last = row.key.rfind(':');
    if (!row.key.starts_with(log_) || last < log_.size()) journal->all_[row.key] = *text;
    else journal->logs_[row.key.substr(log_.size(), last - log_.size())][std::strtoull(row.key.c_str() + last + 1, nullptr, 10)] = *text;
  }
  return journal;
}

PanelJournal::Done PanelJournal::save(const std::vector<StateRow>& rows) {
  if (!file_) return {};
  unsaved_.insert(unsaved_.end(), rows.begin(), rows.end());
  Done done = file_->save({unsaved_});
  if (done) unsaved_.clear();
  else if (unsaved_.size() > max_logged) unsaved_.erase(unsaved_.begin(), unsaved_.end() - std::ptrdiff_t(max_logged));
  return done;
}

std::optional<std::string> PanelJournal::value(const std::string& what, const std::string& machine) const {
  const std::lock_guard hold(lock_);
  const auto found = all_.find(what + ":" + machine);
  return found == all_.end() ? std::nullopt : std::optional(found->second);
}

PanelJournal::Done PanelJournal::keep(const std::string& what, const std::string& machine, std::string value) {
  const std::lock_guard hold(lock_);
  const std::string key = what + ":" + machine;
  if (const auto there = all_.find(key); there != all_.end() && there->second == value && unsaved_.empty()) return {};
  all_[key] = value;
  return save({{StateTable::panel, key, std::move(value)}});
}

std::vector<std::string> PanelJournal::machines() const {
  const std::lock_guard hold(lock_);
  const std::string prefix = "machine:";
  std::vector<std::string> names;
  for (auto at = all_.lower_bound(prefix); at != all_.end() && at->first.starts_with(prefix); ++at)
    names.push_back(at->first.substr(prefix.size()));
  return names;
}

PanelJournal::Done PanelJournal::forget(const std::string& machine) {
  const std::lock_guard hold(lock_);
  std::vector<StateRow> rows;
  for (const char* const what : {"machine:", "spot:", "tables:"})
    if (all_.erase(what + machine) != 0) rows.push_back({StateTable::panel, what + machine, std::monostate()});
  return rows.empty() ? Done() : save(rows);
}

PanelJournal::Done PanelJournal::log(const std::string& machine, std::string entry) {
  const std::lock_guard hold(lock_);
  auto& log = logs_[machine];
  const auto key = [&](std::uint64_t number) { return log_ + machine + ":" + std::to_string(number); };
  const std::uint64_t number = log.empty() ? 1 : log.rbegin()->first + 1;
  std::vector<StateRow> rows = {{StateTable::panel, key(number), entry}};
  log[number] = std::move(entry);
  while (log.size() > max_logged) {
    rows.push_back({StateTable::panel, key(log.begin()->first), std::monostate()});
    log.erase(log.begin());
  }
  return save(rows);
}

std::vector<std::string> PanelJournal::log_of(const std::string& machine) const {
  const std::lock_guard hold(lock_);
  std::vector<std::string> all;
  const auto found = logs_.find(machine);
  if (found == logs_.end()) return all;
  for (const auto& [number, entry] : found->second) all.push_back(entry);
  return all;
}

}  // namespace kadr
