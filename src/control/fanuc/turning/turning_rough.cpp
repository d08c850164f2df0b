// G71.7, G72.7: passes parallel to one axis down to the contour, then one pass along the contour; G73.7: repeated passes along the contour
// (spec/nct/19.B).

#include <algorithm>
#include <cmath>

#include "base/code_literals.h"
#include "base/tolerance.h"
#include "control/fanuc/fanuc.h"
#include "control/fanuc/turning/turning.h"
#include "control/fanuc/turning/turning_contour.h"
#include "control/fanuc/turning/turning_plane.h"

namespace kadr::fanuc {
namespace {

constexpr double max_cuts = 1e6;
constexpr int halvings = 60;

/// Continues the program after the contour, if the contour comes after the cycle's block. Otherwise does nothing.
Status jump_after(Interpreter& m, const Contour& contour) {
  if (contour.follows) m.flow.jump(contour.contour_end);
  return {};
}

/// The contour in coordinates relative to the start point: u is the coordinate along the passes, depth the coordinate into the material.
/// The finishing allowance shifts the whole contour, so the class does not need it.
///
///   start u ───────────►
///     │  ══════════► pass at depth d, up to where the contour rises above d
///     ▼          ╭────
///   depth   ─────╯ contour
class Profile {
 public:
  /// A roughing pass along the coordinate u. `from`, `to`: coordinates u of its ends. `open`: true if the pass starts from the side of the
  /// start point; false if it starts inside a pocket, into which the tool must plunge.
  struct Cut {
    double from, to;
    bool open;
  };

  ///     alarms  contour_shape: the contour is not monotone, or its first block is not a line or has no motion along the infeed axis
  static Result<Profile> of(const Contour& drawing, bool facing, Span where) {
    const std::vector<ContourPiece>& contour = drawing.pieces;
    Profile p;
    p.facing_ = facing;
    const ContourPiece& first = contour.front();
    const auto shape = [&](const ContourPiece& piece) { return fail(alarm(AlarmId::contour_shape, where, double(piece.block))); };
    p.start_ = p.uv(first.from);
    const Vec2 in = p.uv(first.to) - p.start_;
    if (first.is_arc() || std::fabs(in.y) <= tol::level || contour.size() == 1) return shape(first);
    p.sign_ = in.y < 0 ? -1 : 1;
    p.pockets_ = std::fabs(p.uv(drawing.entry).x) > tol::level;
    p.pieces_ = monotone({contour.begin() + 1, contour.end()});
    p.deepest_ = p.depth(first.to);
    double direction = p.pockets_ ? in.x : 0;
    for (const ContourPiece& piece : p.pieces_) {
      const double travel = p.uv(piece.to).x - p.uv(piece.from).x, depth = p.depth(piece.to);
      if (direction == 0 && std::fabs(travel) > tol::level) direction = travel;
      if (travel * direction < 0 && std::fabs(travel) > tol::level) return shape(piece);
      if (!p.pockets_ && depth > p.depth(piece.from) + tol::level) return shape(piece);
      // only at its end may the contour rise to a depth less than that of the start point
      if (p.pockets_ && depth < -tol::level && &piece != &p.pieces_.back()) return shape(piece);
      p.deepest_ = std::max(p.deepest_, depth);
    }
    if (direction == 0) return shape(contour.back());
    p.direction_ = direction < 0 ? -1 : 1;
    return p;
  }

  /// Converts a point of the plane to the pair (coordinate along the passes, coordinate of the infeed), or back. The facing cycle exchanges
  /// the two axes.
  Vec2 uv(Vec2 p) const { return facing_ ? Vec2{p.y, p.x} : p; }
  /// Returns the point of the plane with the coordinates u (along the passes) and depth.
  Vec2 at(double u, double depth) const { return uv({u, start_.y + sign_ * depth}); }

  double start() const { return start_.x; }
  double deepest() const { return deepest_; }
  double direction() const { return direction_; }
  bool pockets() const { return pockets_; }

  std::vector<Cut> cuts(double depth) const {
    std::vector<Cut> all;
    const auto add = [&](double from, double to, bool open) {
      if (direction_ * (to - from) > tol::level) all.push_back({from, to, open});
    };
    bool inside = this->depth(pieces_.front().from) >= depth - tol::level, open = inside;
    double from = start_.x;
    for (const ContourPiece& piece : pieces_) {
      const bool stays = this->depth(piece.to) >= depth - tol::level;
      if (inside == stays) continue;
      const double u = crossing(piece, depth);
      if (inside) add(from, u, open);
      from = u;
      open = false;
      inside = stays;
    }
    if (inside) add(from, uv(pieces_.back().to).x, open);
    return all;
  }

 private:
  double depth(Vec2 p) const { return sign_ * (uv(p).y - start_.y); }

  /// Returns the coordinate u at which a monotone line or arc reaches the depth `depth`. The coordinate is found by bisection.
  double crossing(const ContourPiece& piece, double depth) const {
    const bool rises = this->depth(piece.to) < this->depth(piece.from);
    double low = 0, high = 1;
    for (int i = 0; i < halvings; ++i) {
      const double middle = (low + high) / 2;
      ((this->depth(piece.at(middle)) >= depth) == rises ? low : high) = middle;
    }
    return uv(piece.at((low + high) / 2)).x;
  }

  bool facing_ = false, pockets_ = false;
  Vec2 start_;
  double sign_ = 1, direction_ = 1, deepest_ = 0;
  std::vector<ContourPiece> pieces_;
};

class RoughRun final : public SteppedCycleValue<RoughRun> {
 public:
  RoughRun(Contour contour, Profile profile, Vec2 allowance, const TurningMemory& data)
      : contour_(std::move(contour)), profile_(std::move(profile)), allowance_(allowance), depth_(data.depth), back_(data.back) {}

  Result<bool> next(Emitter& m) override {
    if (!began_) {
      began_ = true;
      KADR_TRY(to(m, MotionKind::rapid, profile_.start(), 0));
    } else if (cut_ < cuts_.size()) {
      KADR_TRY(cut(m));
    } else if (level_ < profile_.deepest()) {
      before_ = level_;
      level_ = level_ + depth_ >= profile_.deepest() - tol::level ? profile_.deepest() : level_ + depth_;
      cuts_ = profile_.cuts(level_);
      cut_ = 0;
    } else if (piece_ < contour_.pieces.size()) {
      if (piece_ == 0) KADR_TRY(to(m, MotionKind::rapid, profile_.start(), 0));
      KADR_TRY(emit(m, contour_.pieces[piece_++], allowance_));
    } else {
      KADR_TRY(go(m, MotionKind::rapid, contour_.pieces.front().from));
      end_pass(m);
      return false;
    }
    return true;
  }

  Status finish(Interpreter& m) const override { return jump_after(m, contour_); }

 private:
  Status to(Emitter& m, MotionKind kind, double u, double depth) const { return go(m, kind, profile_.at(u, depth) + allowance_); }

  Status cut(Emitter& m) {
    const Profile::Cut now = cuts_[cut_++];
    const bool last = cut_ == cuts_.size();
    if (now.open) {
      KADR_TRY(to(m, contour_.pieces.front().kind, now.from, level_));
    } else {  // the tool plunges into a pocket from above the remaining stock
      KADR_TRY(to(m, MotionKind::rapid, now.from, 0));
      KADR_TRY(to(m, MotionKind::rapid, now.from, std::max(0.0, before_ - back_)));
      KADR_TRY(to(m, MotionKind::feed, now.from, level_));
    }
    KADR_TRY(to(m, MotionKind::feed, now.to, level_));
    const double along = std::min(back_, std::fabs(now.to - now.from));
    const double away = profile_.pockets() ? std::max(0.0, level_ - back_) : level_ - back_;
    const double u = now.to - profile_.direction() * along;
    KADR_TRY(to(m, MotionKind::rapid, u, away));
    if (profile_.pockets()) KADR_TRY(to(m, MotionKind::rapid, u, 0));
    if (!profile_.pockets() || last) KADR_TRY(to(m, MotionKind::rapid, profile_.start(), profile_.pockets() ? 0 : away));
    end_pass(m);
    return {};
  }

  Contour contour_;
  Profile profile_;
  Vec2 allowance_;
  double depth_, back_;
  bool began_ = false;
  double level_ = 0, before_ = 0;
  std::vector<Profile::Cut> cuts_;
  std::size_t cut_ = 0, piece_ = 0;
};

/// Cuts the whole contour `passes` times. The first pass is offset from the contour by `relief`; the last pass is offset only by the
/// allowance.
class PatternRun final : public SteppedCycleValue<PatternRun> {
 public:
  PatternRun(Contour contour, Vec2 allowance, Vec2 relief, std::uint32_t passes)
      : contour_(std::move(contour)), allowance_(allowance), relief_(relief), passes_(passes) {}

  Result<bool> next(Emitter& m) override {
    const double left = passes_ == 1 ? 0 : double(passes_ - 1 - pass_) / (passes_ - 1);
    const Vec2 shift = allowance_ + left * relief_;
    const Vec2 start = contour_.pieces.front().from;
    if (piece_ == 0) KADR_TRY(go(m, MotionKind::rapid, start + shift));
    KADR_TRY(emit(m, contour_.pieces[piece_++], shift));
    if (piece_ < contour_.pieces.size()) return true;
    piece_ = 0;
    if (++pass_ < passes_) {
      end_pass(m);
      return true;
    }
    KADR_TRY(go(m, MotionKind::rapid, start));
    end_pass(m);
    return false;
  }

  Status finish(Interpreter& m) const override { return jump_after(m, contour_); }

 private:
  Contour contour_;
  Vec2 allowance_, relief_;
  std::uint32_t passes_;
  std::uint32_t pass_ = 0;
  std::size_t piece_ = 0;
};

}  // namespace

/// G71.7, G72.7 (19.A 4). call.row->arg is 717 for G71.7, with infeed along the second axis of the plane, and 727 for G72.7, with infeed
/// along the first axis.
Status rough(Interpreter& m, const Call& call, Vec2 allowance) {
  const TurningMemory& memory = fanuc_of(m).state.turning;
  const bool facing = call.row->arg == 72.7_g;
  auto contour = read_drawing(m, call);
  if (!contour) return fail(contour.error());
  if (!(memory.depth > 0)) return fail(alarm(AlarmId::word_missing, call.where, letter_of(m, facing ? 0 : 1), call.row->code));
  auto profile = Profile::of(*contour, facing, call.where);
  if (!profile) return fail(profile.error());
  if (profile->deepest() / memory.depth > max_cuts)
    return fail(alarm(AlarmId::value_out_of_range, call.where, letter_of(m, facing ? 0 : 1), memory.depth));
  KADR_TRY(m.feed_known(call.where));
  m.running = std::make_unique<RoughRun>(std::move(*contour), std::move(*profile), allowance, memory);
  return {};
}

Status pattern(Interpreter& m, const Call& call, Vec2 allowance) {
  const TurningMemory& memory = fanuc_of(m).state.turning;
  auto contour = read_drawing(m, call);
  if (!contour) return fail(contour.error());
  if (memory.passes == 0) return fail(alarm(AlarmId::word_missing, call.where, 'R', call.row->code));
  KADR_TRY(m.feed_known(call.where));
  m.running = std::make_unique<PatternRun>(std::move(*contour), allowance, memory.relief, memory.passes);
  return {};
}

}  // namespace kadr::fanuc
