#pragma once
// MotionDialect: what a control makes of motions, feeds and the spindle. One of the interfaces of a Dialect (control/dialect.h).

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

  /// End point by the block's axis words.
  virtual Status target(const BlockContext& m, Axes& to, AxisMask& named) const;
  /// The block has words that add to its motion; add_to_motion() does. Returns the axes it moves besides those of the words.
  virtual bool adds_to_motion(const BlockContext& m) const;
  virtual Result<AxisMask> add_to_motion(Emitter& m);
  /// The block has words that make of G0, G1 something else: then straight() carries it out.
  virtual bool shapes_lines(const BlockContext& m) const;
  virtual Status straight(Emitter& m, const Call& call, MotionKind kind);
  /// The words only shift the start point: nothing moves.
  virtual bool only_shifts(const BlockContext& m) const;
  virtual Status arc(Emitter& m, const Call& call, Turn turn);
  /// A straight motion where the plane is a surface (PathSurface).
  virtual Status surface_line(Emitter& m, MotionKind kind, const Axes& programmed, AxisMask named);
  /// Blocks that give only the end point of a motion, its centre, its feed go on as the block before did: neither words,
  /// modes nor anything else that is known here has to be looked at again (control/block/motion_run).
  virtual bool lines_follow(const BlockContext&) const { return false; }
  /// Axes for which this does not hold.
  virtual AxisMask rolling_axes(const BlockContext&) const { return 0; }
  /// How it reads the centre of an arc in such blocks.
  virtual ArcRule arc_rule(const BlockContext& m) const;
  /// The numbers of such a block, as they are read, become what the control counts: of F without a point, of expressions. Called before
  /// they are used.
  virtual void count_words(BlockContext&) const {}
  /// Such a block has been carried out.
  virtual void note_line(BlockContext&) {}
  /// These axes may be moved.
  virtual Status may_move(const BlockContext& m, AxisMask named) const;
  virtual void note_motion(Emitter& m, Motion& motion);
  /// Feed of a motion programmed in inches.
  virtual double inch_feed(const BlockContext& m, const Motion& motion, const Axes& from) const;
  /// A feed of its own comes into force.
  virtual void note_feed(BlockContext& m);
  /// Feeds per minute and per revolution stand side by side; else a change of the unit forgets the feed.
  virtual bool keeps_both_feeds() const { return false; }
  /// M3, M4, M5 are for other spindles than the first one: it has commanded them.
  virtual Result<bool> turns_spindle(Emitter&, SpindleDir, Span) { return false; }
  virtual SurfaceSpeed surface_speed(const BlockContext& m) const;
  /// Its drilling cycles emit their motions alone: nothing here is asked about them.
  virtual bool drills_plainly() const { return false; }
  virtual Status take_answer(Emitter& m, const ProbeAnswer& answer);
};

}  // namespace kadr
