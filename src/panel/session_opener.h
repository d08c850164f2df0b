#pragma once
// This file has the start data of a panel machine: the function that opens a session of the program, and the operator's switches.

#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "session/session.h"

namespace kadr {

/// The type of the function that opens a session of the program at its beginning. `start` is the position of the axes in machine
/// coordinates; nullopt means the start position of the set-up. Any thread may call the function.
///   returns  the session, or an error sentence
using SessionOpener =
    std::function<tl::expected<std::unique_ptr<Session>, std::string>(const std::optional<Axes>& start, const StopToken& stop)>;

/// The start position and the switches of a run.
struct PanelStart {
  std::optional<Axes> axes;  // start position of the own channel in machine coordinates; nullopt: the start position is in the set-up
  // Start positions of all channels, by index, for machines with several channels; empty: the start positions are in the set-up. For the
  // program's own channel `axes` is used instead.
  std::vector<Axes> stands{};
  std::set<int> skip;
  bool optional_stop = false;
  friend bool operator==(const PanelStart&, const PanelStart&) = default;
};

}  // namespace kadr
