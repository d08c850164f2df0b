#pragma once
// ThreadCuts: records the threads that turning tools have cut, pass by pass. Used by session/cutting.
//
// From a rotating part the stock removes rings, but the groove of a thread is a helix. Therefore the thread is reported separately, and the
// stock keeps the cylinder or cone that the thread is cut into. The tool holder is checked against the stock, and the whole tool against
// fixtures, as on any motion.

#include <vector>

#include "base/vec.h"
#include "stock/cut_result.h"
#include "stock/stock.h"

namespace kadr {

/// A pass of a threading tool in the half plane of a rotating part: x is the signed radius at the tip of the insert.
struct ThreadPass {
  Origin origin;
  double lead = 0;  // thread lead, mm; 0: the program does not state it
  Vec3 from, to;
};

class ThreadCuts {
 public:
  void add(const ThreadPass& pass, const ToolShape& tool);
  /// Returns the threads, with crest radii measured on the present stock.
  std::vector<ThreadCut> found_in(const Stock& stock) const;

 private:
  std::vector<ThreadCut> threads_;
};

}  // namespace kadr
