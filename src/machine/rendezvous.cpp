// Matches channels that wait for each other (nct 14.5). Used by session/channels; tested by tests/machine/rendezvous_test.cpp.

#include "machine/rendezvous.h"

#include <algorithm>

namespace kadr {

void Rendezvous::arrive(int channel, std::uint32_t code, std::uint32_t channels, double at) {
  waiting_.push_back({channel, code, channels, at});
}

void Rendezvous::leave(int channel) {
  std::erase_if(waiting_, [&](const Waiting& w) { return w.channel == channel; });
}

std::optional<Rendezvous::Met> Rendezvous::next() {
  for (const Waiting& first : waiting_) {
    Met met{first.code, {}, 0};
    std::uint32_t missing = first.channels;
    for (const Waiting& w : waiting_) {
      if (w.code != first.code || w.channels != first.channels) continue;
      missing &= ~(1u << w.channel);
      met.channels.push_back(static_cast<std::uint8_t>(w.channel));
      met.at = std::max(met.at, w.at);
    }
    if (missing != 0) continue;
    // leave() ends the wait of each channel that has met. It also makes the iterator `first` invalid
    for (const std::uint8_t channel : met.channels) leave(channel);
    return met;
  }
  return std::nullopt;
}

}  // namespace kadr
