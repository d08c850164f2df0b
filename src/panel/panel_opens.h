#pragma once
// What a panel's machine is begun with: its program from the beginning, and how its operator has set it.

#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "session/session.h"

namespace kadr {

/// Makes a session of the program from its beginning, with `start` as machine coordinates where the axes stand (nothing: those of the
/// set-up). From any thread.
///   returns  an error sentence
using PanelOpens =
    std::function<tl::expected<std::unique_ptr<Session>, std::string>(const std::optional<Axes>& start, const StopToken& stop)>;

/// Of a run.
struct PanelStart {
  std::optional<Axes> axes;    // machine coordinates; nothing: those of the set-up
  std::vector<Axes> stands{};  // of each channel, by its index; the program's own is `axes`. Empty: those of the set-up
  std::set<int> skip;
  bool optional_stop = false;
  friend bool operator==(const PanelStart&, const PanelStart&) = default;
};

}  // namespace kadr
