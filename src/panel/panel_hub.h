#pragma once
// PanelHub has the machines that are switched on, for all pages that display them. Several pages may display one machine; only one of these
// pages has control.

#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "panel/panel_machine.h"

namespace kadr {

class PanelHub {
 public:
  static constexpr std::size_t max_machines = 16;

  /// A machine that is switched on. The object exists while any pointer to it exists, even after the machine is switched off.
  struct HubMachine {
    std::string name;
    std::shared_ptr<void> content;  // program and tables that the machine uses; they must be destroyed after the machine
    std::unique_ptr<PanelMachine> machine;
    std::atomic<std::uint64_t> holder{0};  // number of the page that has control; 0: no page has control
    // The PanelLocation of the machine, as JSON, at the last end of the server; empty: the machine was not in mid-program.
    std::string stood;
  };

  /// Returns a unique number for each page.
  std::uint64_t new_page() { return ++pages_; }

  std::shared_ptr<HubMachine> find(const std::string& name) const {
    const std::lock_guard hold(lock_);
    const auto found = places_.find(name);
    return found == places_.end() ? nullptr : found->second;
  }
  /// Adds a machine. Returns false if a machine with the same name is already on, or if too many machines are on.
  bool add(const std::shared_ptr<HubMachine>& place) {
    const std::lock_guard hold(lock_);
    return places_.size() < max_machines && places_.emplace(place->name, place).second;
  }
  void remove(const std::string& name) {
    // This pointer is declared before the lock, so that the machine is destroyed after the lock is released.
    std::shared_ptr<HubMachine> last;
    const std::lock_guard hold(lock_);
    const auto found = places_.find(name);
    if (found == places_.end()) return;
    last = std::move(found->second);
    places_.erase(found);
  }
  std::vector<std::shared_ptr<HubMachine>> all() const {
    const std::lock_guard hold(lock_);
    std::vector<std::shared_ptr<HubMachine>> all;
    for (const auto& [name, place] : places_) all.push_back(place);
    return all;
  }

 private:
  mutable std::mutex lock_;
  std::map<std::string, std::shared_ptr<HubMachine>> places_;
  std::atomic<std::uint64_t> pages_{0};
};

}  // namespace kadr
