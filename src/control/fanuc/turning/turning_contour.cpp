// Reads the contour of a turning cycle: the blocks P … Q of the program, which the control does not execute (spec/nct/19.A 2, 5). Used by
// control/fanuc/turning/turning, control/fanuc/turning/turning_rough.

#include "control/fanuc/turning/turning_contour.h"

#include <algorithm>
#include <cmath>

#include "action/by_kind.h"
#include "control/fanuc/fanuc.h"
#include "control/fanuc/geometry/automatic_geometry.h"
#include "control/fanuc/lathe/figure_block.h"
#include "control/fanuc/turning/turning_plane.h"
#include "control/fanuc/words/coordinates.h"
#include "control/functions/functions.h"

namespace kadr::fanuc {
namespace {

constexpr std::size_t max_pieces = 10'000;

/// Lets the interpreter read blocks without executing them; the destructor restores the interpreter's state. Meanwhile mirroring, scaling
/// and rotation are off. INFERRED (16): the cycle computes with the contour as programmed, and the motions of the cycle are transformed
/// like any others. In G41 or G42 the first motion of the contour starts compensation (spec/fanuc-t 9.11).
class DryRun {
 public:
  explicit DryRun(Emitter& m)
      : m_(m),
        modal_(m.modal),
        position_(m.position),
        block_(m.block),
        batch_(m.batch),
        axes_taken_(m.block_axes_taken),
        transform_(m.transform),
        origin_(m.origin),
        state_(fanuc_of(m).state),
        macros_(macro_b_of(m).state),
        moved_(macro_b_of(m).moved),
        uncompensated_(fanuc_of(m).uncompensated) {
    m.batch = &actions;
    m.transform = Transform();
    m.position.work = m.position.programmed;
    m.block_axes_taken = false;
    // a feed is assumed to be known while the contour is read, because its F words apply to the finishing pass only
    m.modal.feed_known = true;
    m.modal.feed = 1;
    fanuc_of(m).uncompensated = false;
    fanuc_of(m).reads_figure = true;
    if (m.modal.radius_side != 0) fanuc_of(m).state.side_step = SideStep::begins;
  }
  ~DryRun() {
    m_.modal = modal_;
    m_.position = position_;
    m_.block = block_;
    m_.batch = batch_;
    m_.block_axes_taken = axes_taken_;
    m_.transform = transform_;
    m_.origin = origin_;
    fanuc_of(m_).state = state_;
    macro_b_of(m_).state = macros_;
    macro_b_of(m_).moved = moved_;
    fanuc_of(m_).uncompensated = uncompensated_;
    fanuc_of(m_).reads_figure = false;
  }
  DryRun(const DryRun&) = delete;
  DryRun& operator=(const DryRun&) = delete;

  ActionBatch actions;

 private:
  Emitter& m_;
  Modal modal_;
  ProgramPosition position_;
  Block* block_;
  ActionBatch* batch_;
  bool axes_taken_;
  Transform transform_;
  Origin origin_;
  UndoableState state_;
  macro_b::UndoableState macros_;
  bool moved_;
  bool uncompensated_;
};

class Reader {
 public:
  Reader(Interpreter& m, const Call& call) : m_(m), call_(call), run_(m), start_(m.position.work) {}

  Status run(const ContourLocation& place, Contour& contour) {
    ProgramFile& file = m_.flow.program_file();
    BlockReader reader(file.source(), file.grammar(), file.reader().encoding());
    reader.seek(place.first);
    while (reader.position().offset <= place.last.offset) {
      const std::uint64_t offset = reader.position().offset;
      if (m_.use.watches()) pass_line(reader.position().line);
      const auto got = reader.next(block_);
      if (!got) return unread(got.error());
      if (*got == BlockReader::Got::end) break;
      if (block_.has_number) m_.origin.block = number_ = block_.number;
      if (block_.skip != 0 && m_.skip_switches[std::min<std::size_t>(block_.skip, 9)]) continue;
      KADR_TRY(strict_ ? figure_block({offset == place.first.offset, offset >= place.last.offset}) : block());
    }
    reads_ = false;
    if (run_.actions.empty()) return strict_ ? fail(alarm(AlarmId::figure_first_block, call_.where, double(number_))) : shape();
    contour.first_named = std::get<Motion>(run_.actions.begin()->what).named;
    contour.uncompensated = uncompensated_;
    const Motion first = std::get<Motion>(run_.actions[0].what);
    KADR_TRY(corners());
    take_pieces(contour.pieces);
    const ContourPiece& resolved = contour.pieces.front();
    contour.entry = (first.side_step == SideStep::begins ? in_plane(first.to) : resolved.to) - resolved.from;
    return {};
  }

 private:
  Status shape() const {
    if (strict_) return at_own_block(alarm(AlarmId::figure_unavailable, block_.where, block_.text_of(block_.where)));
    return fail(alarm(AlarmId::contour_shape, call_.where, double(number_)));
  }
  /// Records that the cycle has read a line, so that `kadr setup` does not list it as not executed.
  void pass_line(std::uint32_t line) const {
    Origin origin = m_.origin;
    origin.line = line;
    m_.use.pass(origin);
  }
  Status without(std::string_view what) const { return fail(alarm(AlarmId::not_available, call_.where, what)); }

  /// Returns an alarm about the block of the figure that is being read. A lathe's control shows that block, not the block of the cycle.
  Status at_own_block(const Alarm& alarm) const {
    Origin origin = m_.origin;
    origin.line = block_.position.line;
    origin.block = block_.number;
    origin.has_block = block_.has_number;
    m_.fault_place = {origin, std::string(block_.text)};
    return fail(alarm);
  }

  static bool has_comma(char address) {
    return address == comma_chamfer || address == comma_rounding || address == comma_angle || address == comma_vector;
  }

  /// Returns an alarm that a block of the contour has raised; the location in the alarm is that of the cycle's block.
  Status unread(Alarm alarm) const {
    const bool comma = alarm.id == AlarmId::address_unknown && alarm.args[0].text().size() == 1 && has_comma(alarm.args[0].text()[0]);
    if (comma) return without(",C ,R ,A");
    if (strict_ && reads_) return at_own_block(alarm);
    alarm.where = call_.where;
    return fail(alarm);
  }

  /// Computes chamfers ,C, roundings ,R and all other points that depend on the next block (17), in the same way as for executed motions;
  /// then the path of the tool, if G41 or G42 is in force in the cycle's block (spec/fanuc-t 9.11).
  Status corners() {
    const auto waits = [](const Action& action) {
      const Motion& motion = std::get<Motion>(action.what);
      return (motion.detail && motion.detail->contour) || motion.side_step == SideStep::begins;
    };
    if (std::none_of(run_.actions.begin(), run_.actions.end(), waits)) return {};
    if (m_.find_corners == nullptr || !*m_.find_corners) return without(m_.modal.radius_side == 0 ? ",C ,R ,A" : "G41, G42");
    const auto fault = (*m_.find_corners)(run_.actions, start_);
    return fault ? unread(*fault) : Status();
  }

  Vec2 in_plane(const Axes& axes) const { return {axes[m_.modal.axes.first], axes[m_.modal.axes.second]}; }

  void take_pieces(std::vector<ContourPiece>& pieces) const {
    Vec2 at = in_plane(start_);
    for (const Action& action : run_.actions) {
      const auto& motion = std::get<Motion>(action.what);
      const Vec2 to = in_plane(motion.to);
      pieces.push_back({motion.kind, at, to, motion.center, motion.turns, action.origin.block});
      at = to;
    }
  }

  /// Reads a block of a figure on a lathe's control, which permits less (fanuc-t 9.1). A dwell has no effect.
  Status figure_block(FigureBlock which) {
    m_.block = &block_;
    if (const Status permitted = check_figure_block(m_, which, block_.where); !permitted) return at_own_block(permitted.error());
    return m_.has_code({Function::dwell, Function::dwell_or_turns}) ? Status() : block();
  }

  Status block() {
    if (block_.statement.kind != StatementKind::none) return shape();
    m_.block = &block_;
    if (const Status values = m_.evaluate_words(); !values) return unread(values.error());
    take_corner_letters(m_);
    const CodeRow* motion = nullptr;
    for (std::uint32_t i = 0; i < block_.word_count; ++i)
      if (const Word& w = block_.words[i]; w.address != 0) KADR_TRY(word(w, motion));
    const bool moves = (block_.letters & (m_.letters.axes | m_.letters.centers)) != 0;
    if (motion == nullptr && moves && m_.modal.motion_row >= 0) motion = &m_.def.codes[static_cast<std::size_t>(m_.modal.motion_row)];
    if (motion == nullptr) return moves ? shape() : Status();
    return move(*motion);
  }

  Status word(const Word& w, const CodeRow*& motion) {
    if ((m_.letters.codes & letter_bit(w.address)) != 0) return code(w, motion);
    // word Q is allowed in the contour, because it selects an intersection (17.3)
    constexpr std::uint64_t of_others = letter_bit('P') | letter_bit('E');
    if ((of_others & letter_bit(w.address)) != 0) return shape();
    return {};  // F, S, T and D are allowed in the contour, because they apply to the finishing pass only
  }

  /// Returns the tool radius of the block's own D, or of the D in force.
  double radius() const {
    const Word* const d = block_.find('D');
    if (d == nullptr) return m_.radius_in_force();
    const auto number = static_cast<std::size_t>(std::max(d->value, 0.0));
    return number < m_.tables.offsets.size() ? m_.tables.offsets[number].whole_radius() : 0;
  }

  Status code(const Word& w, const CodeRow*& motion) {
    const std::int32_t index = w.code < 0 ? -1 : m_.def.row_of(w.address, w.code);
    if (index < 0) return unread(alarm(AlarmId::code_unknown, w.where, block_.text_of(w.where)));
    const CodeRow& row = m_.def.codes[static_cast<std::size_t>(index)];
    switch (row.function) {
      case Function::rapid:
      case Function::linear:
      case Function::arc_cw:
      case Function::arc_ccw:
        if (motion != nullptr) return shape();
        motion = &row;
        return {};
      case Function::absolute:
      case Function::incremental: return handler_of(row.function)(m_, {&row, nullptr, call_.where});
      case Function::radius_side: side(row); return {};
      case Function::feed_per_minute:
      case Function::feed_per_revolution:
      case Function::css_on:
      case Function::css_off:
      case Function::feed_control:
      case Function::exact_stop_block:
      case Function::exact_stop_mode: return {};
      default: break;
    }
    const bool ignored = w.address == 'M' && row.phase != Phase::flow && (strict_ || row.phase != Phase::stop);
    return ignored ? Status() : shape();
  }

  /// Executes G41 and G42 in a contour, which only permit over-determined blocks there (17.3). INFERRED: the contour is not compensated, as
  /// on a Fanuc (19.B).
  void side(const CodeRow& row) {
    m_.modal.radius_side = row.arg == 0 ? std::int8_t{0} : row.arg == 1 ? std::int8_t{-1} : std::int8_t{1};
    if (row.arg != 0 && uncompensated_.empty() && radius() != 0) uncompensated_ = row.code;
  }

  Status move(const CodeRow& row) {
    if (row.function != Function::rapid && row.function != Function::linear && row.function != Function::arc_cw &&
        row.function != Function::arc_ccw)
      return shape();
    const std::size_t before = run_.actions.size();
    if (const Status moved = handler_of(row.function)(m_, {&row, nullptr, call_.where}); !moved) return unread(moved.error());
    if (run_.actions.size() > max_pieces) return shape();
    const AxisMask both = 1u << m_.modal.axes.first | 1u << m_.modal.axes.second;
    for (std::size_t i = before; i < run_.actions.size(); ++i) {
      const auto* const motion = motion_of(run_.actions[i]);
      if (motion == nullptr || (motion->named & ~both) != 0 || motion->turns > 1) return shape();
    }
    return {};
  }

  Interpreter& m_;
  const Call& call_;
  DryRun run_;
  Axes start_;
  Block block_;
  std::uint32_t number_ = 0;
  std::string_view uncompensated_;
  bool strict_ = m_.def.behaviour.lathe != Lathe::none;
  bool reads_ = true;  // the blocks are being read; false: their corners and path are being computed
};

}  // namespace

Result<ContourLocation> find_contour(Interpreter& m, const Call& call) {
  constexpr double highest = 99'999'999;
  const bool lathe = m.def.behaviour.lathe != Lathe::none;
  const auto missing = [&](char letter, std::uint32_t number) {
    return fail(lathe ? alarm(AlarmId::figure_block_missing, m.where(letter), double(number))
                      : alarm(AlarmId::contour_block_missing, m.where(letter), double(number)));
  };
  for (const char letter : {'P', 'Q'})
    if (!m.has(letter))
      return fail(lathe ? alarm(AlarmId::figure_words, call.where) : alarm(AlarmId::word_missing, call.where, letter, call.row->code));
  const auto p = m.whole('P', 1, highest), q = m.whole('Q', 1, highest);
  if (!p) return fail(p.error());
  if (!q) return fail(q.error());
  ProgramFile& file = m.flow.program_file();
  // fanuc-t 9.1: the first block found from the start of the program counts
  const auto first = file.find_number(*p, lathe ? file.first_block() : m.program().position());
  if (!first) return missing('P', *p);
  const auto last = file.find_number(*q, *first);
  if (!last || (lathe && last->offset < first->offset)) return missing('Q', *q);
  if (last->offset < first->offset) return fail(alarm(AlarmId::contour_order, m.where('Q'), double(*p), double(*q)));
  BlockReader reader(file.source(), file.grammar(), file.reader().encoding());
  reader.seek(*last);
  Block block;
  (void)reader.next(block);  // a fault in the contour's last block is ignored here, because the block's execution reports it
  return ContourLocation{*first, *last, reader.position()};
}

Result<Contour> read_drawing(Interpreter& m, const Call& call) {
  const auto place = find_contour(m, call);
  if (!place) return fail(place.error());
  const PlaneAxes& plane = m.modal.axes;
  if (m.transform.leaves(plane)) return fail(alarm(AlarmId::plane_wrong, call.where, call.row->code));
  Contour contour;
  KADR_TRY(Reader(m, call).run(*place, contour));
  const auto is_arc = [](const ContourPiece& piece) { return piece.is_arc(); };
  // 16.2: different scale factors would turn an arc into an ellipse
  if (m.transform.distorts(plane) && std::any_of(contour.pieces.begin(), contour.pieces.end(), is_arc))
    return fail(alarm(AlarmId::not_together, call.where, "G51", call.row->code));
  if (!contour.uncompensated.empty()) m.warn(warning(AlarmId::rough_uncompensated, call.where, contour.uncompensated, call.row->code));
  contour.contour_end = place->contour_end;
  contour.follows = contour.contour_end.offset > m.program().position().offset;
  return contour;
}

Status emit(Emitter& m, const ContourPiece& piece, Vec2 shift) {
  const Vec2 end = piece.to + shift;
  if (!piece.is_arc()) return go(m, piece.kind, end);
  const PlaneAxes& plane = m.modal.axes;
  Axes to = m.position.programmed;
  to[plane.first] = end.x;
  to[plane.second] = end.y;
  const AxisMask both = 1u << plane.first | 1u << plane.second;
  const Vec2 center = piece.center + shift;
  Axes work = to;
  MotionKind kind = piece.kind;
  if (!m.transform.identity) {
    work = transformed(m, to);
    KADR_TRY(m.within_reach(work));
    if (m.transform.reverses(plane)) kind = kind == MotionKind::arc_cw ? MotionKind::arc_ccw : MotionKind::arc_cw;
  }
  m.move_to(to, work, both);
  Motion& motion = m.add_motion(kind, both);
  m.set_feed(motion);
  motion.center = m.transform.identity ? center : m.transform.to_work(center, plane);
  motion.turns = piece.turns;
  motion.along = FeedAlong::arc;
  return {};
}

}  // namespace kadr::fanuc
