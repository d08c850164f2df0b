#pragma once
// MotionDialect: what a control does differently for motions, feeds and
// the spindle. One of the interfaces of a Dialect (control/dialect.h).

#include "action/action.h"
#include "base/result.h"
#include "base/vec.h"
#include "control/block/arc.h"
#include "control/control.h"

namespace kadr {

class BlockContext;
class Emitter;
struct Call;

class MotionDialect {
 public:
  virtual ~MotionDialect() = default;

  /// Computes the end point from the block's axis words.
  virtual Status target(const BlockContext& m, Axes& to, AxisMask& named) const;
  /// Returns true if the block has words that add to its motion. add_to_motion()
  /// executes them and returns the axes moved in addition to those of the axis words.
  virtual bool adds_to_motion(const BlockContext& m) const;
  virtual Result<AxisMask> add_to_motion(Emitter& m);
  /// Returns true if the block has words that turn G0, G1 into something else, which straight() executes.
  virtual bool shapes_lines(const BlockContext& m) const;
  virtual Status straight(Emitter& m, const Call& call, MotionKind kind);
  /// Returns true if the words only shift the start point and nothing moves.
  virtual bool only_shifts(const BlockContext& m) const;
  virtual Status arc(Emitter& m, const Call& call, Turn turn);
  /// Executes a straight motion where the plane is a surface (PathSurface).
  virtual Status surface_line(Emitter& m, MotionKind kind, const Axes& programmed, AxisMask named);
  /// Returns true if a block that gives only an end point, an arc centre and a feed may be executed like the block before it, because
  /// neither its words nor the modes nor other data of the dialect need another check (control/block/motion_run).
  virtual bool lines_follow(const BlockContext&) const { return false; }
  /// Axes to which lines_follow() does not apply.
  virtual AxisMask rolling_axes(const BlockContext&) const { return 0; }
  /// Rule by which such blocks give the centre of an arc.
  virtual ArcRule arc_rule(const BlockContext& m) const;
  /// Scales the numbers of such a block, as they were read, to what the control counts them in: F without a point, expressions. Called
  /// before they are used.
  virtual void count_words(BlockContext&) const {}
  /// Called when such a block has been executed.
  virtual void note_line(BlockContext&) {}
  /// Checks that these axes may be moved.
  virtual Status may_move(const BlockContext& m, AxisMask named) const;
  virtual void note_motion(Emitter& m, Motion& motion);
  /// Returns the feed of a motion programmed in inches.
  virtual double inch_feed(const BlockContext& m, const Motion& motion, const Axes& from) const;
  /// Called when a feed given in the block comes into force.
  virtual void note_feed(BlockContext& m);
  /// True if the feeds per minute and per revolution are stored separately; else a change of the unit discards the feed.
  virtual bool keeps_both_feeds() const { return false; }
  /// Returns true if M3, M4, M5 are for other spindles than the first one; the dialect has then commanded them.
  virtual Result<bool> turns_spindle(Emitter&, SpindleDir, Span) { return false; }
  virtual SurfaceSpeed surface_speed(const BlockContext& m) const;
  /// True if its drilling cycles only emit their motions and call no other function of the dialect.
  virtual bool drills_plainly() const { return false; }
  virtual Status take_answer(Emitter& m, const ProbeAnswer& answer);
};

}  // namespace kadr
