#pragma once
// LatheWatch: finds what endangers a lathe: constant surface speed without an upper limit of the spindle speed, threads that are faster
// than an axis, and motions beyond the face of the chuck.

#include <optional>
#include <vector>

#include "action/step.h"
#include "motion/time/spindle_turning.h"
#include "session/checklist/advice.h"

namespace kadr {

class LatheWatch {
 public:
  ///   rapid       rapid rate of each axis, mm/min, as far as the set-up or the machine's file states it; 0: unknown
  ///   chuck_face  Z of the chuck's face, work coordinates, mm; nullopt: the set-up does not state it
  LatheWatch(const Axes& rapid, const std::optional<double>& chuck_face) : rapid_(rapid), chuck_face_(chuck_face) {}

  void take(const Step& step, Advices& to);

 private:
  void take_motion(const Step& step, const Motion& motion, Advices& to);
  void take_thread(const Step& step, const Motion& motion, Advices& to);
  SpindleTurning& spindle(std::size_t number);

  Axes rapid_;
  std::optional<double> chuck_face_;
  std::vector<SpindleTurning> spindles_;  // the index is the number of the spindle
  bool unlimited_reported_ = false;
};

}  // namespace kadr
