// A page in a browser has no state files, which are databases: each function says so. The page keeps nothing after power-off.

#include "config/state/state_check.h"
#include "config/state/state_file.h"
#include "texts/state_file.h"

namespace kadr {
namespace {

tl::unexpected<std::string> refused(const std::string& path) { return tl::unexpected(translated(texts::state_file::not_in_page, path)); }

}  // namespace

class StateFile::Database {};

StateFile::StateFile(std::unique_ptr<Database> database) : database_(std::move(database)) {}
StateFile::StateFile(StateFile&&) noexcept = default;
StateFile& StateFile::operator=(StateFile&&) noexcept = default;
StateFile::~StateFile() = default;

tl::expected<StateFile, std::string> StateFile::open(const std::string& path, const std::string&) { return refused(path); }
tl::expected<StoredState, std::string> StateFile::load() { return StoredState(); }
tl::expected<void, std::string> StateFile::save(const StateChanges&) { return {}; }

tl::expected<StateReport, std::string> check_state(const std::string& path) { return refused(path); }
tl::expected<StateReport, std::string> recover_state(const std::string& path, const std::string&, const std::string&) {
  return refused(path);
}
bool state_is_unchecked(const std::string&) { return false; }

}  // namespace kadr
