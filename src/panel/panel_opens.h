#pragma once
// What a panel machine starts with: a session of its program, and the operator's settings.

#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "session/session.h"

namespace kadr {

/// Opens a session of the program at its beginning, with the axes at `start` in machine coordinates (nullopt: as the set-up states). May be
/// called from any thread.
///   returns  an error sentence
using PanelOpens =
    std::function<tl::expected<std::unique_ptr<Session>, std::string>(const std::optional<Axes>& start, const StopToken& stop)>;

/// The start of a run.
struct PanelStart {
  std::optional<Axes> axes;    // machine coordinates; nullopt: from the set-up
  std::vector<Axes> stands{};  // of each channel, by index; the program's own uses `axes`. Empty: from the set-up
  std::set<int> skip;
  bool optional_stop = false;
  friend bool operator==(const PanelStart&, const PanelStart&) = default;
};

}  // namespace kadr
