#pragma once
// ThreadCuts: records the threads that turning tools have cut, pass by pass. Used by session/cutting.
//
// A helical groove is no ring: the material keeps the cylinder or cone that the thread is cut into, and the thread is reported
// separately. The holder is moved past the material as on any motion, and the whole tool past fixtures.

#include <vector>

#include "base/vec.h"
#include "stock/cut_result.h"
#include "stock/stock.h"

namespace kadr {

/// In the half plane of a part that rotates: x is the signed radius of the insert's tip.
struct ThreadPass {
  Origin origin;
  double lead = 0;  // mm; 0: not stated by the program
  Vec3 from, to;
};

class ThreadCuts {
 public:
  void add(const ThreadPass& pass, const ToolShape& tool);
  /// The threads, with the crests that the material has now.
  std::vector<ThreadCut> told(const Stock& stock) const;

 private:
  std::vector<ThreadCut> threads_;
};

}  // namespace kadr
