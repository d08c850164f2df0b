// G70, G71, G72 and G73 of lathes: their words in both formats, and the cycles that execute the passes (spec/fanuc-t 9, spec/haas-st 6).

#include <cmath>
#include <memory>
#include <utility>

#include "base/code_literals.h"
#include "base/tolerance.h"
#include "control/fanuc/fanuc.h"
#include "control/fanuc/geometry/sides.h"
#include "control/fanuc/lathe/lathe.h"
#include "control/fanuc/lathe/lathe_words.h"
#include "control/fanuc/lathe/rough_passes.h"
#include "control/fanuc/turning/turning.h"
#include "control/fanuc/turning/turning_contour.h"
#include "control/fanuc/turning/turning_plane.h"
#include "control/macro_b/dialect/blocks.h"

namespace kadr::fanuc {
namespace {

// passes of a cycle; a program that asks for more has a mistake in its depth
constexpr double most_passes = 1e6;

/// Executes RoughPasses or PatternPasses, one motion at a time.
template <class Passes>
class RepetitiveRun final : public SteppedCycleValue<RepetitiveRun<Passes>> {
 public:
  RepetitiveRun(Passes passes, std::optional<Position> after) : passes_(std::move(passes)), after_(after) {}

  Result<bool> next(Emitter& m) override {
    const auto step = passes_.next();
    if (!step) return false;
    if (length(step->motion.to - step->motion.from) > tol::level || step->motion.turns > 0.5) KADR_TRY(emit(m, step->motion, {}));
    if (step->ends_pass) end_pass(m);
    return true;
  }

  /// 9.1: the program goes on behind the figure, if the figure follows the cycle.
  Status finish(Interpreter& m) const override {
    if (after_) m.flow.jump(*after_);
    return {};
  }

 private:
  Passes passes_;
  std::optional<Position> after_;
};

std::optional<Position> place_after(const Contour& contour) { return contour.follows ? std::optional(contour.contour_end) : std::nullopt; }

/// Returns the allowance δ = (Δw, Δu/2) of the block (9.1).
Vec2 allowance(const BlockContext& m) {
  const bool diameter = fanuc_of(m).settings.axes[m.modal.axes.second].diameter;
  return {m.length_value('W'), m.length_value('U') / (diameter ? 2 : 1)};
}

/// Returns the rough allowance (K, I) of a Haas, which the levels leave besides δ (spec/haas-st 6.2).
Vec2 rough_allowance(const BlockContext& m) { return is_haas(m) ? Vec2{m.length_value('K'), m.length_value('I')} : Vec2{}; }

/// Returns true if R1 makes the cycle one of type II, which it does on a Haas with setting 33 YASNAC (spec/haas-st 6.2).
bool asks_for_pockets(const BlockContext& m) { return fanuc_of(m).settings.lathe.is_yasnac && m.has('R') && digits_of(m, 'R') == 1; }

/// Returns true for the block that executes the cycle. A Haas has no other (spec/haas-st 6).
bool is_cycle_block(const BlockContext& m) { return is_haas(m) || m.has('P') || m.has('Q') || m.has('D'); }

Status words_missing(const Call& call) { return fail(alarm(AlarmId::figure_words, call.where)); }

/// First block of G71 or G72: Δd is U in G71 and W in G72, both radii or lengths (9.2, 9.4).
Status set_rough(BlockContext& m, const Call& call, char depth) {
  RepetitiveMemory& memory = fanuc_of(m).state.turning.repetitive;
  if (!m.has(depth) && !m.has('R')) return words_missing(call);
  if (m.has(depth) && !(m.value(depth) > 0)) return fail(alarm(AlarmId::figure_depth, m.where(depth)));
  // INFERRED: a negative escape is as wrong as a negative depth
  if (m.has('R') && !(m.value('R') >= 0)) return fail(alarm(AlarmId::figure_depth, m.where('R')));
  if (m.has(depth)) memory.depth = m.length_value(depth);
  if (m.has('R')) memory.back = m.length_value('R');
  return {};
}

/// Returns the number that a word means as a count (9.5): R3, R3. and the old form R0.003 are 3. alarms pattern_repeats
Result<std::uint32_t> count_of(const BlockContext& m, char letter) {
  constexpr double old_unit = 1000;
  const Word& w = *m.word(letter);
  double count = digits_of(m, letter);
  if (w.counted == 0 && count < 1) count *= old_unit;
  const double whole = std::round(count);
  if (!(whole >= 1) || whole > most_passes || std::fabs(count - whole) > tol::whole_number)
    return fail(alarm(AlarmId::pattern_repeats, w.where));
  return static_cast<std::uint32_t>(whole);
}

/// First block of G73: Δi is U, Δk is W, d is R; Δi is a radius (9.5).
Status set_pattern(BlockContext& m, const Call& call) {
  RepetitiveMemory& memory = fanuc_of(m).state.turning.repetitive;
  if (!m.has('U') && !m.has('W') && !m.has('R')) return words_missing(call);
  if (m.has('R')) {
    const auto passes = count_of(m, 'R');
    if (!passes) return fail(passes.error());
    memory.passes = *passes;
  }
  if (m.has('U')) memory.relief_second = m.length_value('U');
  if (m.has('W')) memory.relief_first = m.length_value('W');
  return {};
}

/// Returns twice the area that an arc encloses with its chord, mm²; positive if the arc is counter-clockwise.
double twice_segment(const ContourPiece& piece) {
  if (!piece.is_arc()) return 0;
  const double angle = 2 * pi * piece.turns, radius = length(piece.from - piece.center);
  const double area = radius * radius * (angle - std::sin(angle));
  return piece.kind == MotionKind::arc_ccw ? area : -area;
}

/// Checks that G41 or G42 puts the nose on that side of the figure on which the cycle begins. The figure and the way back to the start
/// point S through `corner` enclose the stock, so S is on the left of the figure if they are traversed counter-clockwise. In G71 and G72
/// the corner is at the level of S: the straight way from the end of a figure that ends in a pocket would lead through the part. INFERRED:
/// the manual names no rule, and the nose radius may be 0 (9.11). alarms figure_wrong_side (PS0328)
Status check_side(const BlockContext& m, const std::vector<ContourPiece>& figure, Vec2 corner, const Call& call) {
  if (m.modal.radius_side == 0 || m.def.behaviour.lathe != Lathe::fanuc) return {};
  const Vec2 start = figure.front().from;
  double area = cross(figure.back().to - start, corner - start);
  for (const ContourPiece& piece : figure) area += cross(piece.from - start, piece.to - start) + twice_segment(piece);
  const bool left = (m.modal.radius_side < 0) != m.transform.reverses(m.modal.axes);
  const bool wrong = std::fabs(area) > tol::level && (area > 0) != left;
  return wrong ? fail(alarm(AlarmId::figure_wrong_side, call.where)) : Status();
}

Status figure_fault(FigureFault fault, std::uint32_t block, const Call& call) {
  switch (fault) {
    case FigureFault::none: return {};
    case FigureFault::first_axis: return fail(alarm(AlarmId::figure_not_monotone, call.where, double(block)));
    case FigureFault::second_axis: return fail(alarm(AlarmId::figure_not_monotone_second, call.where, double(block)));
    case FigureFault::over_start: return fail(alarm(AlarmId::figure_over_start, call.where, double(block)));
    case FigureFault::first_block: return fail(alarm(AlarmId::figure_first_block, call.where, double(block)));
  }
  return {};
}

/// Drops a rapid motion at the end of the figure of a Haas. INFERRED: the Q block of real programs is G00 G40 with the way off the part,
/// and leads back along Z (spec/haas-st 6.1, 6.3); in G71 to G73 the way back to the start point takes its place.
void drop_departure(const BlockContext& m, Contour& contour) {
  if (is_haas(m) && contour.pieces.size() > 1 && contour.pieces.back().kind == MotionKind::rapid) contour.pieces.pop_back();
}

Status rough_cycle(Interpreter& m, const Call& call) {
  const RepetitiveMemory& memory = fanuc_of(m).state.turning.repetitive;
  const RepetitiveSettings& settings = fanuc_of(m).settings.repetitive;
  RoughPasses::Plan plan;
  plan.depth = m.has('D') ? step_of(m, 'D') : memory.depth.value_or(settings.depth);
  plan.back = memory.back.value_or(settings.back);
  plan.clearance = settings.clearance;
  if (!(plan.depth > 0)) return fail(alarm(AlarmId::figure_depth, call.where));
  auto contour = read_drawing(m, call);
  if (!contour) return fail(contour.error());
  drop_departure(m, *contour);
  const bool facing = call.row->arg == 72.7_g;
  const Vec2 start = contour->pieces.front().from, end = contour->pieces.back().to;
  KADR_TRY(check_side(m, contour->pieces, facing ? Vec2{start.x, end.y} : Vec2{end.x, start.y}, call));
  const AxisMask both = 1u << m.modal.axes.first | 1u << m.modal.axes.second;
  RoughFigure::Settings shape;
  shape.facing = facing;
  shape.pockets = (contour->first_named & both) == both || asks_for_pockets(m);  // 9.3
  const Vec2 rough = rough_allowance(m);
  shape.allowance = allowance(m) + rough;
  shape.levels_from_start = is_haas(m);
  if (rough != Vec2{}) plan.further = -1.0 * rough;
  // The control computes in least increments, so a reversal below one increment does not exist for it (INFERRED)
  const double increment = least_increment(m);
  shape.reversal_permitted = settings.reversal + Vec2{increment, increment};
  RoughFigure figure(contour->pieces, shape);
  KADR_TRY(figure_fault(figure.fault(), figure.fault_block(), call));
  if (figure.deepest() / plan.depth > most_passes) return fail(alarm(AlarmId::figure_depth, call.where));
  plan.along_figure = !(shape.pockets ? settings.leaves_out_second : settings.leaves_out_first);
  KADR_TRY(m.feed_known(call.where));
  suspend_side(m);
  m.running = std::make_unique<RepetitiveRun<RoughPasses>>(RoughPasses(std::move(figure), plan), place_after(*contour));
  return {};
}

Status pattern_cycle(Interpreter& m, const Call& call) {
  const RepetitiveMemory& memory = fanuc_of(m).state.turning.repetitive;
  const RepetitiveSettings& settings = fanuc_of(m).settings.repetitive;
  PatternPasses::Plan plan;
  plan.allowance = allowance(m);
  plan.relief = {memory.relief_first.value_or(settings.relief.x), memory.relief_second.value_or(settings.relief.y)};
  plan.passes = memory.passes.value_or(static_cast<std::uint32_t>(settings.passes >= 1 ? settings.passes : 0));
  if (m.has('D')) {  // one-block format: I, K and D, which are not kept (INFERRED)
    plan.relief = {m.length_value('K'), m.length_value('I')};
    const auto passes = count_of(m, 'D');
    if (!passes) return fail(passes.error());
    plan.passes = *passes;
  }
  if (plan.passes == 0) return fail(alarm(AlarmId::pattern_repeats, call.where));
  auto contour = read_drawing(m, call);
  if (!contour) return fail(contour.error());
  drop_departure(m, *contour);
  if (contour->pieces.front().is_arc()) return figure_fault(FigureFault::first_block, contour->pieces.front().block, call);
  KADR_TRY(check_side(m, contour->pieces, contour->pieces.front().from, call));
  KADR_TRY(m.feed_known(call.where));
  const auto after = place_after(*contour);
  suspend_side(m);
  m.running = std::make_unique<RepetitiveRun<PatternPasses>>(PatternPasses(std::move(contour->pieces), plan), after);
  return {};
}

/// Warns of positions in a block of G71 to G73, such as X for U: the words have no meaning there (9.1).
void pass_over_positions(Emitter& m) {
  for (std::uint32_t i = 0; i < m.block->word_count; ++i) {
    const Word& w = m.block->words[i];
    const bool position = w.address != 0 && (m.letters.axes & letter_bit(w.address)) != 0 &&
                          m.def.address(w.address).function != Function::increment_axis && w.address != 'U' && w.address != 'W';
    if (position) m.warn(warning(AlarmId::word_passed_over, w.where, m.block->text_of(w.where)));
  }
}

/// The cycles are executed in the plane, in which the program's coordinates are those of the machine.
Status in_plane(const BlockContext& m, const Call& call) {
  // spec/haas-st 6.2: G18 must be in force
  if (is_haas(m) && m.modal.plane != Plane::zx) return fail(alarm(AlarmId::plane_wrong, call.where, call.row->code));
  if (m.modal.surface != PathSurface::plane) return fail(alarm(AlarmId::surface_state, call.where, call.row->code));
  return {};
}

}  // namespace

Status lathe_rough(Interpreter& m, const Call& call) {
  KADR_TRY(in_plane(m, call));
  pass_over_positions(m);
  if (!is_cycle_block(m)) return set_rough(m, call, call.row->arg == 72.7_g ? 'W' : 'U');
  return rough_cycle(m, call);
}

Status lathe_pattern(Interpreter& m, const Call& call) {
  KADR_TRY(in_plane(m, call));
  pass_over_positions(m);
  if (!is_cycle_block(m)) return set_pattern(m, call);
  return pattern_cycle(m, call);
}

Status lathe_finish(Interpreter& m, const Call& call) {
  KADR_TRY(in_plane(m, call));
  restart_side(m);
  return finish(m, call);
}

}  // namespace kadr::fanuc
