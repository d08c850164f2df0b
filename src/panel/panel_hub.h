#pragma once
// PanelHub: the machines that are on, whoever looks at them. Several pages may look at one; one of them holds the controls.

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
  static constexpr std::size_t most_machines = 16;

  /// One that is on. It stays as long as somebody has it, switched off or not.
  struct Place {
    std::string name;
    std::shared_ptr<void> content;  // what the machine's program is made of: outlives it
    std::unique_ptr<PanelMachine> machine;
    std::atomic<std::uint64_t> holder{0};  // page; 0: nobody
    std::string stood;                     // where it stood in mid program when the server ended, as that was kept; empty: nowhere
  };

  /// A number of its own for each page that looks.
  std::uint64_t new_page() { return ++pages_; }

  std::shared_ptr<Place> find(const std::string& name) const {
    const std::lock_guard hold(lock_);
    const auto found = places_.find(name);
    return found == places_.end() ? nullptr : found->second;
  }
  /// False: one of that name is on already, or there are too many.
  bool add(const std::shared_ptr<Place>& place) {
    const std::lock_guard hold(lock_);
    return places_.size() < most_machines && places_.emplace(place->name, place).second;
  }
  void remove(const std::string& name) {
    std::shared_ptr<Place> last;  // goes without the lock
    const std::lock_guard hold(lock_);
    const auto found = places_.find(name);
    if (found == places_.end()) return;
    last = std::move(found->second);
    places_.erase(found);
  }
  std::vector<std::shared_ptr<Place>> all() const {
    const std::lock_guard hold(lock_);
    std::vector<std::shared_ptr<Place>> all;
    for (const auto& [name, place] : places_) all.push_back(place);
    return all;
  }

 private:
  mutable std::mutex lock_;
  std::map<std::string, std::shared_ptr<Place>> places_;
  std::atomic<std::uint64_t> pages_{0};
};

}  // namespace kadr
