#pragma once
// SampleOptions: the options with which positions are sampled (out/trace/samples).

#include <vector>

#include "base/stop_token.h"
#include "motion/play/override_change.h"

namespace kadr {

struct SampleOptions {
  double rate = 1000;                   // Hz
  std::vector<OverrideChange> changes;  // override changes in the order of their times
  bool spindle = false;                 // true: a column contains the spindle angle
  double max_time = 86400;              // time of the last sample, s; the default is one day, which is 4 GB for three axes at 1 kHz
  StopToken stop{};
};

}  // namespace kadr
