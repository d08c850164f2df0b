// Turning cycles G70, G71, G71.1, G71.2, G72, G72.1, G72.2: reads the words of the cycle and its profile, and executes the motions.
// Described in turning_cycles.h.

#include "control/linuxcnc/turning/turning_cycles.h"

#include <fmt/format.h>

#include <cmath>
#include <memory>

#include "action/by_kind.h"
#include "base/code_literals.h"
#include "base/units.h"
#include "control/functions/functions.h"
#include "control/interpreter.h"
#include "control/linuxcnc/linuxcnc.h"
#include "control/linuxcnc/motions.h"
#include "control/linuxcnc/o_line_flow.h"

namespace kadr::linuxcnc {
namespace {

constexpr double equal_within = 1e-4;
constexpr std::size_t z_axis = 2, max_pieces = 100'000;

double scale_of(const BlockContext& m) { return m.modal.inch ? mm_per_inch : 1; }

tl::unexpected<Alarm> wrong_turning(const BlockContext& m, Span where, std::string text) {
  return linuxcnc_of(m).fault(AlarmId::rs274_cycle, where, std::move(text));
}

/// Returns the value of a word in the unit of the program. The value of a diameter X is halved.
double radius_or_length(const BlockContext& m, char letter) {
  const bool diameter = letter == 'X' && (m.modal.diameter & 1U) != 0;
  return m.value(letter) * (diameter ? 0.5 : 1);
}

void set_motion(BlockContext& m, std::int32_t tenths) {
  const auto row = static_cast<std::int16_t>(m.def.row_of('G', tenths));
  linuxcnc_of(m).state.motion = tenths;
  linuxcnc_of(m).state.cycle_began = false;
  m.modal.motion = MotionMode::none;
  m.modal.motion_row = row;
  if (row >= 0) m.modal.rows[m.def.codes[static_cast<std::size_t>(row)].group] = row;
}

/// Marks the last motion as not compensated. Cutter compensation does not apply to motions to the start of G70, of the cycle and of each
/// pass (LinuxCNC 2.9.4).
void leave_uncompensated(Emitter& m) {
  if (m.batch->empty()) return;
  Motion* const motion = motion_of(m.batch->back());
  if (motion == nullptr) return;
  motion->side = 0;
  motion->side_step = SideStep::none;
}

/// Executes the motions of the cycle, a few at a time.
class Turning final : public SteppedCycleValue<Turning> {
 public:
  /// `moves`: the motions of the turning cycle, which are executed one after the other; `done`: the result to report after them.
  Turning(std::shared_ptr<const std::vector<TurningMove>> moves, Turned done, Span where)
      : moves_(std::move(moves)), done_(std::move(done)), where_(where) {}

  Result<bool> next(Emitter& m) override {
    for (std::size_t i = 0; i < batch_size / 8 && at_ < moves_->size(); ++i) KADR_TRY(move(m, (*moves_)[at_++]));
    if (at_ < moves_->size()) return true;
    if (done_) return false;
    if (done_.error().empty()) return fail(alarm(AlarmId::cycle_endless, where_));
    return wrong_turning(m, where_, "G7X error: " + done_.error());
  }

 private:
  Status move(Emitter& m, const TurningMove& step) const {
    const double unit = scale_of(m);
    Axes to = m.position.programmed;
    const bool stays = std::fabs(to[0] - step.to.imag() * unit) < equal_within * unit &&
                       std::fabs(to[z_axis] - step.to.real() * unit) < equal_within * unit;
    to[0] = step.to.imag() * unit;
    to[z_axis] = step.to.real() * unit;
    constexpr AxisMask x_and_z = 1U | 1U << z_axis;
    switch (step.kind) {
      case TurningMove::Kind::rapid:
        set_motion(m, 0);
        KADR_TRY(m.straight(MotionKind::rapid, to, x_and_z));
        if (step.to_start) leave_uncompensated(m);
        return {};
      case TurningMove::Kind::line: set_motion(m, 1_g); return line(m, to, x_and_z);
      case TurningMove::Kind::arc_cw:
      case TurningMove::Kind::arc_ccw: break;
    }
    if (stays) return {};
    const bool ccw = step.kind == TurningMove::Kind::arc_ccw;
    set_motion(m, ccw ? 3_g : 2_g);
    return arc_to(m, where_, ccw ? Turn::ccw : Turn::cw, to, {step.center.real() * unit, step.center.imag() * unit}, x_and_z);
  }

  Status line(Emitter& m, const Axes& to, AxisMask named) const {
    const auto no = [&](AlarmId id, const char* text) { return linuxcnc_of(m).fault(id, where_, text); };
    if (m.modal.feed_mode == FeedMode::inverse_time) return no(AlarmId::rs274_motion, "F word missing with inverse time g1 move");
    if (!(m.modal.feed_known && m.modal.feed > 0)) return no(AlarmId::rs274_motion, "Cannot do g1 with zero feed rate");
    if (m.modal.feed_mode == FeedMode::per_revolution && m.modal.rpm == 0)
      return no(AlarmId::rs274_spindle, "Cannot feed with zero spindle speed in feed per rev mode");
    return m.straight(MotionKind::feed, to, named);
  }

  std::shared_ptr<const std::vector<TurningMove>> moves_;
  std::size_t at_ = 0;
  Turned done_;
  Span where_;
};

/// Adds the motion of one block of the profile's subprogram to the profile.
class ProfileBlock {
 public:
  ProfileBlock(BlockContext& m, TurningCycle& cycle) : m_(m), cycle_(cycle) {}

  Status take() {
    const auto end = end_point();
    if (!end) return fail(end.error());
    const std::int32_t coded = linuxcnc_of(m_).codes.g1();
    if (coded >= 0) linuxcnc_of(m_).state.motion = cycle_.motion = coded;
    if (*end == cycle_.at) return {};
    if (cycle_.profile.pieces.size() > max_pieces) return wrong("G7X error: the profile has too many pieces");
    KADR_TRY(add(*end));
    const double unit = scale_of(m_);
    m_.position.programmed[0] = end->imag() * unit;
    m_.position.programmed[z_axis] = end->real() * unit;
    cycle_.at = *end;
    return {};
  }

 private:
  tl::unexpected<Alarm> wrong(const char* text) const { return wrong_turning(m_, m_.block->where, text); }

  Result<Point> end_point() const {
    Point end = cycle_.absolute ? cycle_.at : Point();
    if (m_.has('U')) {
      if (!cycle_.absolute) return wrong("G7x error: Cannot use U in incremental mode (G91)");
      if (m_.has('X')) return wrong("G7x error: Cannot use U and X in the same block");
      end.imag(end.imag() + m_.value('U') * ((m_.modal.diameter & 1U) != 0 ? 0.5 : 1));
    } else if (m_.has('X')) {
      end.imag(radius_or_length(m_, 'X'));
    }
    if (m_.has('W')) {
      if (!cycle_.absolute) return wrong("G7x error: Cannot use W in incremental mode (G91)");
      if (m_.has('Z')) return wrong("G7x error: Cannot use W and Z in the same block");
      end.real(end.real() + m_.value('W'));
    } else if (m_.has('Z')) {
      end.real(m_.value('Z'));
    }
    return cycle_.absolute ? end : end + cycle_.at;
  }

  Status add(Point end) {
    std::list<Piece>& pieces = cycle_.profile.pieces;
    switch (cycle_.motion) {
      case 0:
      case 1_g: pieces.push_back(Piece::line(cycle_.at, end)); break;
      case 2_g:
      case 3_g: {
        const auto center = center_of(end);
        if (!center) return fail(center.error());
        pieces.push_back(Piece::arc(cycle_.motion == 3_g, cycle_.at, *center, end));
        break;
      }
      default: return {};
    }
    if (m_.has('A') && m_.has('C')) return wrong("G7X error: Both A and C parameters on a corner");
    if (m_.has('A')) pieces.push_back(Piece::fillet(m_.value('A'), end));
    if (m_.has('C')) pieces.push_back(Piece::chamfer(m_.value('C'), end));
    return {};
  }

  Result<Point> center_of(Point end) const {
    if (!m_.has('R')) {
      if (!m_.has('I') && !m_.has('K')) return wrong("G7X error: either I or K must be present for arc");
      const Point given(m_.has('K') ? m_.value('K') : 0, m_.has('I') ? m_.value('I') : 0);
      return cycle_.centers_absolute ? given : given + cycle_.at;
    }
    if (m_.has('I') || m_.has('K')) return wrong("G7X error: both R and I or K flag used for arc");
    const double r = m_.value('R'), square = std::norm(end - cycle_.at);
    const Point aside = Point(0, 1) * std::sqrt((r * r - square / 4) / square) * (end - cycle_.at);
    const Point middle = (cycle_.at + end) / 2.0;
    return cycle_.motion == 3_g ? middle + aside : middle - aside;
  }

  BlockContext& m_;
  TurningCycle& cycle_;
};

TurningWords turning_words(const BlockContext& m, Point start) {
  TurningWords words;
  words.start = start;
  if (m.has('D')) words.distance = m.value('D');
  if (m.has('E')) words.last = m.value('E');
  if (m.has('I')) words.depth = m.value('I');
  if (m.has('P')) words.passes = m.value('P');
  if (m.has('R')) words.retract = m.value('R');
  return words;
}

}  // namespace

Status take_profile_block(BlockContext& m) { return ProfileBlock(m, *linuxcnc_of(m).turning).take(); }

Status run_turning(Emitter& m) {
  LinuxCnc& control = linuxcnc_of(m);
  TurningCycle cycle = std::move(*control.turning);
  control.turning.reset();
  set_motion(m, cycle.motion);
  if (cycle.profile.pieces.size() <= 1) return {};
  if (cycle.words.depth <= 0) return wrong_turning(m, cycle.where, "G7X error: I must be greater than zero.");
  auto moves = std::make_shared<std::vector<TurningMove>>();
  const auto pockets = static_cast<Pockets>(cycle.code % 10);
  Turned done = cycle.code == 70_g ? finish_profile(cycle.profile, cycle.words, *moves)
                                   : rough_profile(cycle.profile, cycle.words, pockets, cycle.code >= 72_g, *moves);
  m.running = std::make_unique<Turning>(std::move(moves), std::move(done), cycle.where);
  return {};
}

}  // namespace kadr::linuxcnc

namespace kadr::functions {

using linuxcnc::linuxcnc_of;

/// G70 to G72: moves at rapid to the point of the axis words, which are absolute also in G91. Then calls the subprogram Q, which has the
/// profile.
Status profile_cycle(Interpreter& m, const Call& call) {
  linuxcnc::LinuxCnc& control = linuxcnc_of(m);
  const auto wrong = [&](std::string text) { return control.fault(AlarmId::rs274_cycle, call.where, std::move(text)); };
  const int code = call.row->tenth;
  if (!m.has('Q')) return wrong("G7x.x  requires a Q word");
  if (m.modal.radius_side != 0 && code != 70_g)
    return wrong(fmt::format("G{}.{} cannot be used with cutter compensation enabled", code / 10, code % 10));
  if (m.modal.plane != Plane::zx) return wrong(fmt::format("G{}.{} can only be used in XZ plane (G18)", code / 10, code % 10));

  const double unit = linuxcnc::scale_of(m);
  linuxcnc::TurningCycle cycle;
  cycle.code = code;
  cycle.depth = control.flow.calls.size();
  cycle.absolute = m.modal.absolute;
  cycle.centers_absolute = m.modal.centers_absolute;
  cycle.where = call.where;
  const double x = m.position.programmed[0] / unit, z = m.position.programmed[linuxcnc::z_axis] / unit;
  linuxcnc::Point start(z, x);
  if (m.has('X')) start.imag((cycle.absolute ? 0 : x) + linuxcnc::radius_or_length(m, 'X'));
  if (m.has('Z')) start.real((cycle.absolute ? 0 : z) + m.value('Z'));
  cycle.words = linuxcnc::turning_words(m, start);
  cycle.at = start;

  m.modal.absolute = true;
  AxisMask named = 0;
  Axes to;
  const Status aimed = m.target(to, named);
  m.modal.absolute = cycle.absolute;
  KADR_TRY(aimed);
  if (named == 0) named = 1U | 1U << linuxcnc::z_axis;  // LinuxCNC makes a motion of length zero here, so Kadr does the same
  KADR_TRY(m.straight(MotionKind::rapid, to, named));
  linuxcnc::leave_uncompensated(m);
  linuxcnc::set_motion(m, 0);
  const double q = m.value('Q');
  if (std::fabs(q - std::round(q)) > linuxcnc::equal_within) return wrong("Non integer value for integer");
  KADR_TRY(linuxcnc::call_sub(m, linuxcnc::label_of_number(std::round(q)), call.where));
  control.turning = std::move(cycle);
  return {};
}

}  // namespace kadr::functions
