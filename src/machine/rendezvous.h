#pragma once
// Rendezvous: which channels wait for each other, and when they may go on (nct 14.5). INFERRED: they match on the pair of code
// and set of channels. One outside its set waits for those in it.

#include <cstdint>
#include <optional>
#include <vector>

namespace kadr {

class Rendezvous {
 public:
  /// `channel` waits from now on, at `at` seconds: bit n of `channels` is channel n. Arrivals come in the order of time.
  void arrive(int channel, std::uint32_t code, std::uint32_t channels, double at);
  /// It waits no more.
  void leave(int channel);

  struct Met {
    std::uint32_t code = 0;
    std::vector<std::uint8_t> channels;  // in the order of arrival
    double at = 0;                       // s: the last arrival
  };
  /// Channels that have all come: they wait no more. Nothing: none.
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
