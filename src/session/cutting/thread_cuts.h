#pragma once
// ThreadCuts: the threads that turning tools have cut, pass by pass. For session/cutting.
//
// A groove that goes round in a helix is no ring: the material keeps the cylinder or the cone that the thread is cut into, and what is told
// of the thread stands beside it. The holder is carried past the material as on any motion, and the whole tool past fixtures.

#include <vector>

#include "base/vec.h"
#include "stock/cut_result.h"
#include "stock/stock.h"

namespace kadr {

/// In the half plane of a part that spins: x the signed radius of the insert's point.
struct ThreadPass {
  Origin origin;
  double lead = 0;  // mm; 0: the program does not say
  Vec3 from, to;
};

class ThreadCuts {
 public:
  void add(const ThreadPass& pass, const ToolShape& tool);
  /// With the crests as the material stands now.
  std::vector<ThreadCut> told(const Stock& stock) const;

 private:
  std::vector<ThreadCut> threads_;
};

}  // namespace kadr
