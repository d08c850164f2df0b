#pragma once
// FrameDialect: where a control stores its coordinate systems, and in which unit. One of the interfaces of a Dialect (control/dialect.h).

#include <map>
#include <string>

#include "base/vec.h"
#include "config/setup/setup.h"

namespace kadr {

class BlockContext;
class Emitter;

class FrameDialect {
 public:
  virtual ~FrameDialect() = default;

  /// Recomputes the origin, the tool length and the shifts from the tables and the modal state.
  virtual void refresh_frames(Emitter& m);
  /// Returns, in mm, the part of the current origin by which G52 and G92 shift the work system; the work offset of the table is not
  /// included.
  virtual Axes shift_of_origin(const BlockContext& m) const;
  /// Returns true if the work offset may change during cutter compensation; if not, such a change raises an alarm.
  virtual bool zero_may_move() const { return false; }
  /// Returns the unit of the lengths in the machine's own tables, in mm.
  virtual double machine_unit() const { return 1; }
  /// Returns true if G20 and G21 are allowed during cutter compensation.
  virtual bool units_may_change() const { return false; }
  /// Returns the programming frame in work coordinates: `origin`, `x`, `y`, `z`; empty if it is the work system. Only for a control without
  /// a MachineInterface, whose run_state() has the frame.
  virtual std::map<std::string, AxisValues> programming_frame(const BlockContext&) const { return {}; }
  /// Converts positions for display: the position of each axis that rolls over is reduced to one revolution.
  virtual void roll(const BlockContext& m, Axes& positions) const;
};

}  // namespace kadr
