// ChannelAxes, what virtual and real axes have in common. Used by panel/panel_machine.

#include "panel/channel_axes.h"

#include <utility>

namespace kadr {

void ChannelAxes::start_over() {
  drop();
  on = pending = {};
  modes_of = ~0u;
  holds_next = holds_again = enters = has_ended = false;
  entered = 0;
}

bool ChannelAxes::is_held() {
  if (std::exchange(holds_again, false)) return false;
  return holds_again = std::exchange(holds_next, false);
}

}  // namespace kadr
