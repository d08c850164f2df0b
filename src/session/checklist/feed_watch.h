#pragma once
// FeedWatch: finds feeds and spindle speeds that the programmer cannot have intended.

#include <map>

#include "action/step.h"
#include "session/checklist/advice.h"

namespace kadr {

class FeedWatch {
 public:
  void take(const Step& step, Advices& to);
  /// Reports implausible feeds per tooth. `teeth`: number of teeth by tool number, from comments; a tool without an entry is not checked.
  void finish(const std::map<std::uint32_t, int>& teeth, Advices& to);

 private:
  void take_motion(const Step& step, const Motion& motion, Advices& to);
  void take_tap(const Motion& motion, const Origin& origin, Advices& to);

  double rpm_ = 0;
  std::uint32_t tool_ = 0;
  bool small_reported_ = false, large_reported_ = false;
  double tap_reported_ = 0;  // thread pitch of the tapping cycle reported last, mm; the same pitch is not reported again
  /// The largest and the smallest feed per revolution of one tool, mm, and the blocks where they occur.
  struct Advance {
    double least = 1e300, most = 0;
    Origin at_least, at_most;
  };
  std::map<std::uint32_t, Advance> advances_;
};

}  // namespace kadr
