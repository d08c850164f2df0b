#pragma once
// SharedMemory: the data that the channels of one machine share (spec/nct/01 1.2): common variables (23.1.4) and tool offsets (15.1).
// Parameters of the control define how many of these data are shared.

#include <algorithm>
#include <memory>
#include <vector>

#include "config/setup/setup.h"
#include "control/variables/macro_variables.h"

namespace kadr {

class SharedMemory {
 public:
  std::shared_ptr<Commons> commons = std::make_shared<Commons>();

  /// Makes the tool offsets 1 … `count` (parameter N1401) common to all channels. Their values are those of the first channel that calls
  /// this function.
  void share_offsets(std::vector<ToolOffset>& of_channel, int count) {
    if (!offsets_.empty() || count <= 0) return lend(of_channel);
    offsets_.assign(of_channel.begin(), of_channel.begin() + std::min<std::ptrdiff_t>(count + 1, std::ssize(of_channel)));
  }
  /// lend() copies the common offsets to a channel before the channel runs; undo_block() copies them back afterwards. Only one channel runs
  /// at a time.
  void lend(std::vector<ToolOffset>& to) const { std::copy_n(offsets_.begin(), std::min(offsets_.size(), to.size()), to.begin()); }
  void undo_block(const std::vector<ToolOffset>& from) {
    std::copy_n(from.begin(), std::min(offsets_.size(), from.size()), offsets_.begin());
  }

 private:
  std::vector<ToolOffset> offsets_;  // tool offsets by number; element [0] is unused
};

}  // namespace kadr
