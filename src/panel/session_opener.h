#pragma once
// The start of a panel machine: the function that opens a session of its program, and the operator's switches.

#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "session/session.h"

namespace kadr {

/// Opens a session of the program at its beginning, with the axes at `start` in machine coordinates (nullopt: the start position of the
/// set-up). May be called from any thread.
///   returns  an error sentence
using SessionOpener =
    std::function<tl::expected<std::unique_ptr<Session>, std::string>(const std::optional<Axes>& start, const StopToken& stop)>;

/// The start position and the switches of a run.
struct PanelStart {
  std::optional<Axes> axes;    // machine coordinates at the start; nullopt: they are in the set-up
  std::vector<Axes> stands{};  // starts of the channels, by index; the own channel uses `axes`; empty: they are in the set-up
  std::set<int> skip;
  bool optional_stop = false;
  friend bool operator==(const PanelStart&, const PanelStart&) = default;
};

}  // namespace kadr
