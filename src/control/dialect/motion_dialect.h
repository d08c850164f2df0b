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
  /// Returns true if the block has words that add to its motion. add_to_motion() executes these words and returns the axes that move
  /// besides those of the axis words.
  virtual bool adds_to_motion(const BlockContext& m) const;
  virtual Result<AxisMask> add_to_motion(Emitter& m);
  /// Returns true if the block has words that turn a straight G0 or G1 motion into another path, which straight() then executes.
  virtual bool shapes_lines(const BlockContext& m) const;
  virtual Status straight(Emitter& m, const Call& call, MotionKind kind);
  /// Returns true if the words only shift the start point and nothing moves.
  virtual bool only_shifts(const BlockContext& m) const;
  virtual Status arc(Emitter& m, const Call& call, Turn turn);
  /// Executes a straight motion while the surface of the path is not the plane itself but a face (G12.1) or a cylinder (G7.1):
  /// PathSurface.
  virtual Status surface_line(Emitter& m, MotionKind kind, const Axes& programmed, AxisMask named);
  /// Returns true if a block that gives only an end point, an arc centre and a feed may be executed like the block before it, because
  /// neither its words nor the modes nor other data of the dialect need another check (control/block/motion_run).
  virtual bool lines_follow(const BlockContext&) const { return false; }
  /// Axes to which lines_follow() does not apply.
  virtual AxisMask rolling_axes(const BlockContext&) const { return 0; }
  /// Returns the rule by which blocks that lines_follow() covers give the centre of an arc.
  virtual ArcRule arc_rule(const BlockContext& m) const;
  /// Scales the numbers of a block that lines_follow() covers, as they were read, to the unit that the control counts in: F without a
  /// decimal point, expressions. Called before the numbers are used.
  virtual void count_words(BlockContext&) const {}
  /// Called when a block that lines_follow() covers has been executed.
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
  /// Returns true if M3, M4, M5 of this block are for spindles other than the first one; the dialect has then commanded these spindles.
  virtual Result<bool> turns_spindle(Emitter&, SpindleDir, Span) { return false; }
  virtual SurfaceSpeed surface_speed(const BlockContext& m) const;
  /// True if its drilling cycles only emit their motions and call no other function of the dialect.
  virtual bool drills_plainly() const { return false; }
  virtual Status accept_answer(Emitter& m, const ProbeAnswer& answer);
};

}  // namespace kadr
