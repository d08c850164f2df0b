#pragma once
// take_actions(): updates a position by many actions at once.

#include <utility>
#include <variant>

#include "action/by_kind.h"
#include "action/tool_position.h"

namespace kadr {

/// Updates the tool's position by the actions from `begin` to `end`, in their order. Of the motions between two changes of the frame only
/// the last one is copied.
///   law  the result is that of ToolPosition::take() for each action
inline void take_actions(ToolPosition& position, const Action* begin, const Action* end) {
  const Motion* last = nullptr;
  for (const Action* action = begin; action != end; ++action) {
    if (const auto* const motion = motion_of(*action)) {
      last = motion;
    } else if (const auto* const frame = std::get_if<FrameChange>(&action->what)) {
      if (last != nullptr) position.take(*std::exchange(last, nullptr));
      position.take(*frame);
    }
  }
  if (last != nullptr) position.take(*last);
}

}  // namespace kadr
