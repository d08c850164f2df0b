#pragma once
// The dialect of the generic Soviet ISO control: axis correctors, which are offsets added to the motion of an axis (spec/correctors 1), and
// the milling of pockets (spec/correctors 3).

#include <vector>

#include "control/dialect.h"

namespace kadr::correctors {

/// The words of G87, which stores a pocket for G79 (spec/correctors 3).
struct PocketCycle {
  bool defined = false;
  double x = 0, y = 0, z = 0, clearance = 0, corner = 0, stepover = 0, direction = 0, pass = 0;
  double feed = 0;  // feed in mm/min; 0: the feed in force
};

/// A pocket that G79 has cut, in programmed coordinates (mm).
struct PocketCut {
  Vec2 middle, half;
  double face = 0, floor = 0;
};

/// All data that the dialect stores between blocks.
struct Memory {
  PocketCycle pocket;
  std::vector<PocketCut> pockets_cut;
  // by corrector: true if the set-up gives its value, or if the warning that the value is missing was reported (spec/correctors 1)
  std::vector<bool> is_set;
  std::vector<double> applied;  // value that each corrector added last to each axis, mm (spec/correctors 1)
};

class Correctors final : public Dialect, public Memory {
 public:
  Correctors(const BlockContext& m, const Setup& setup);

  BlockChanges changes_of(const BlockContext& m, const Plan& plan) const override;
  void keep(BlockContext& m) override;
  void begin_block(Emitter& m) override;
  void undo_block(BlockContext& m) override;

  std::shared_ptr<const DialectState> snapshot() const override;
  Status restore(BlockContext& m, const DialectState& from) override;

  /// Returns true if the block has a word L, which adds a corrector (offset) to the motion.
  bool adds_to_motion(const BlockContext& m) const override;
  bool lines_follow(const BlockContext&) const override { return true; }
  /// Adds the correctors of the block's L words to its motion: sets Transform::added.
  ///   returns  the axes that the correctors shift
  ///   alarms   corrector_axis: `L17` without exactly one axis word, or an axis code above 7; corrector_unknown
  Result<AxisMask> add_to_motion(Emitter& m) override;

 private:
  struct Before {
    PocketCycle pocket;
    std::vector<double> applied;
  };
  Before before_;
  bool state_saved_ = false;
};

Correctors& correctors_of(const BlockContext& m);

}  // namespace kadr::correctors
