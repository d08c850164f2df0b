#pragma once
// What the channels of one machine have in common (spec/nct/01 1.2): common variables as far as the parameters say so.

#include <memory>

#include "control/nct/macro_variables.h"

namespace kadr {

class SharedMemory {
 public:
  std::shared_ptr<nct::Commons> commons = std::make_shared<nct::Commons>();
};

}  // namespace kadr
