#pragma once
// ThreadCuts: records the threads that turning tools have cut, pass by pass. It is used by session/cutting.
//
// The stock removes rings from a rotating part, but the groove of a thread is a helix. Therefore the thread is reported separately, and the
// stock still contains the cylinder or cone into which the thread is cut. As on any motion, the tool holder is checked against the stock,
// and the whole tool against fixtures.

#include <functional>
#include <optional>
#include <vector>

#include "base/vec.h"
#include "stock/cut_result.h"
#include "stock/stock.h"

namespace kadr {

/// A pass of a threading tool in the half plane of a rotating part. The coordinate x is the signed radius at the tip of the insert, mm.
struct ThreadPass {
  Origin origin;
  double lead = 0;  // thread lead, mm; 0: the program states no lead
  Vec3 from, to;
};

class ThreadCuts {
 public:
  void add(const ThreadPass& pass, const ToolShape& tool);
  bool empty() const { return threads_.empty(); }
  /// Returns the threads, with crest radii (mm) measured on the present stock.
  std::vector<ThreadCut> found_in(const Stock& stock) const;
  /// The same for a stock of any kind. `radii_at`: returns the least and the greatest radius of the material at a Z, mm; nullopt where no
  /// material is.
  std::vector<ThreadCut> found(const std::function<std::optional<Vec2>(double z)>& radii_at) const;

 private:
  std::vector<ThreadCut> threads_;
};

}  // namespace kadr
