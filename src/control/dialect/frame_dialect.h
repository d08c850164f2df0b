#pragma once
// FrameDialect: where a control has its coordinate systems, and in which unit. One of the interfaces of a Dialect (control/dialect.h).

#include "base/vec.h"

namespace kadr {

class BlockContext;
class Emitter;

class FrameDialect {
 public:
  virtual ~FrameDialect() = default;

  /// Origin, length, shifts by the tables and the modal state.
  virtual void refresh_frames(Emitter& m);
  /// What of the origin in force is a shift of the work system, and no zero of its table (G52, G92), mm.
  virtual Axes shift_of_origin(const BlockContext& m) const;
  /// The zero may move under a contour that is being compensated.
  virtual bool zero_may_move() const { return false; }
  /// mm: of lengths in the machine's own tables.
  virtual double machine_unit() const { return 1; }
  /// G20 and G21 may come while a contour is being compensated.
  virtual bool units_may_change() const { return false; }
  /// Positions as they are shown: axes that roll over within their turn.
  virtual void roll(const BlockContext& m, Axes& positions) const;
};

}  // namespace kadr
