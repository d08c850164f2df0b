#pragma once
// FrameDialect: where a control stores its coordinate systems, and in which unit. One of the interfaces of a Dialect (control/dialect.h).

#include "base/vec.h"

namespace kadr {

class BlockContext;
class Emitter;

class FrameDialect {
 public:
  virtual ~FrameDialect() = default;

  /// Recomputes origin, length and shifts from the tables and the modal state.
  virtual void refresh_frames(Emitter& m);
  /// Returns the part of the current origin that is a shift of the work system (G52, G92), not a work offset of its table; mm.
  virtual Axes shift_of_origin(const BlockContext& m) const;
  /// True if the work offset may change during cutter compensation without an alarm.
  virtual bool zero_may_move() const { return false; }
  /// mm per unit of the lengths in the machine's own tables.
  virtual double machine_unit() const { return 1; }
  /// True if G20 and G21 may come during cutter compensation.
  virtual bool units_may_change() const { return false; }
  /// Converts positions for display: brings axes that roll over into one revolution.
  virtual void roll(const BlockContext& m, Axes& positions) const;
};

}  // namespace kadr
