#pragma once
// Rendezvous: finds which channels wait for each other, and when they may continue (nct 14.5). INFERRED: channels belong together if their
// wait codes and their sets of channels are equal. A channel that is not in its own set waits for the channels in the set.

#include <cstdint>
#include <optional>
#include <vector>

namespace kadr {

class Rendezvous {
 public:
  /// Records that `channel` waits from `at` (s) on. Bit n of `channels` stands for channel n. The caller must make these calls in ascending
  /// order of time.
  void arrive(int channel, std::uint32_t code, std::uint32_t channels, double at);
  /// Removes a channel from the waiting channels.
  void leave(int channel);

  struct Met {
    std::uint32_t code = 0;
    std::vector<std::uint8_t> channels;  // numbers of the channels that have met, in their order of arrival
    double at = 0;                       // time at which the last channel arrived, s
  };
  /// Returns a set of channels that wait for each other and have all arrived, and ends their wait; nullopt if no set is complete.
  std::optional<Met> next();

 private:
  struct Waiting {
    int channel;
    std::uint32_t code, channels;
    double at;
  };
  std::vector<Waiting> waiting_;
};

}  // namespace kadr
