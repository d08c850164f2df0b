// The functions of the Heidenhain dialect that the interpreter calls (control/dialect.h).

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "base/tolerance.h"
#include "control/flow/program_file.h"
#include "control/functions/cutter_compensation.h"
#include "control/functions/rotary_machine.h"
#include "control/heidenhain/block_run.h"
#include "lang/block/block_reader.h"
#include "lang/klartext/klartext_parser.h"

namespace kadr {

std::unique_ptr<Dialect> make_heidenhain_dialect(BlockContext&, const Setup& setup, const RunLimits& limits) {
  return std::make_unique<heidenhain::Heidenhain>(setup, limits);
}

namespace heidenhain {
namespace {

struct NamedParameter {
  ParameterFamily family = ParameterFamily::q;
  std::size_t index = 0;
};

/// Reads #Q5, QL5 …; nullopt if the name is none.
std::optional<NamedParameter> parameter_named(std::string_view name) {
  if (name.starts_with('#')) name.remove_prefix(1);
  if (!name.starts_with('Q')) return std::nullopt;
  name.remove_prefix(1);
  NamedParameter found;
  if (name.starts_with('L')) found.family = ParameterFamily::ql, name.remove_prefix(1);
  else if (name.starts_with('R')) found.family = ParameterFamily::qr, name.remove_prefix(1);
  if (name.empty() || name.size() > 4 || name.find_first_not_of("0123456789") != std::string_view::npos) return std::nullopt;
  found.index = std::strtoul(std::string(name).c_str(), nullptr, 10);
  if (found.index >= (found.family == ParameterFamily::q ? q_count : local_count)) return std::nullopt;
  return found;
}

}  // namespace

struct Heidenhain::Kept : DialectState {
  explicit Kept(Memory all) : memory(std::move(all)) {}
  Memory memory;
  std::set<std::uint32_t> table;
  std::map<std::string, std::uint32_t> names;
  Axes previous{};
};

Heidenhain& heidenhain_of(const BlockContext& m) { return static_cast<Heidenhain&>(*m.dialect); }

Heidenhain::Heidenhain(const Setup&, const RunLimits&) { most.fill(1e300); }

std::shared_ptr<const DialectState> Heidenhain::snapshot() const {
  auto kept = std::make_shared<Kept>(memory);
  kept->table = table_;
  kept->names = names_;
  kept->previous = previous_;
  return kept;
}

Status Heidenhain::restore(BlockContext&, const DialectState& from) {
  const Kept& then = static_cast<const Kept&>(from);
  memory = then.memory;
  table_ = then.table;
  names_ = then.names;
  previous_ = then.previous;
  kept_ = false;
  written_.clear();
  indices_.clear();
  read_.clear();
  loop_lines_.forget_all();
  assumed_axes.clear();  // noted when the run began
  return {};
}

void Heidenhain::take_setup(Emitter& m, const Setup& setup) {
  constexpr std::size_t geometry_axes = 3;
  std::size_t count = geometry_axes;
  missing_axes = 0;
  for (std::size_t a = geometry_axes; a < m.def.axes.size(); ++a) {
    const std::string& name = m.def.axes[a];
    if (std::find(setup.axes.begin(), setup.axes.end(), name) != setup.axes.end()) count = a + 1;
    else missing_axes |= letter_bit(name[0]);
  }
  for (const std::string& name : setup.axes_assumed) assumed_axes += (assumed_axes.empty() ? "" : " ") + name;
  m.axis_names = m.def.axes;
  m.axis_names.resize(count);
  m.axis_count = count;
  for (std::size_t a = 0; a < count; ++a)
    for (const std::string& name : {m.axis_names[a], std::string("*")})
      if (const auto row = setup.machine.find(name); row != setup.machine.end() && row->second.limits && !(most[a] < 1e300))
        most[a] = row->second.limits->second;
  for (const auto& [tool, offset] : setup.offsets) table_.insert(static_cast<std::uint32_t>(tool));
  for (const auto& [name, value] : setup.variables)
    if (const auto named = parameter_named(name); named && value) family(named->family)[named->index] = *value;
  read_tool_table(m);
  five_axis = rotary_machine(setup.kinematics, m.def, missing_axes);
  m.modal.offset_number = m.modal.tool;
  m.change_frames();
  memory.inch_outermost = m.modal.inch;
}

/// A block that a mode or a corner behind it makes more than its words is executed from its text.
bool Heidenhain::needs_text(const BlockContext& m) const {
  if (!memory.begun || memory.calls_always || memory.plunge > 0 || memory.shortest || memory.feed_per_turn ||
      (memory.holds_tip && five_axis.group == MachineGroup::none))
    return true;
  const std::size_t reader = m.program().reader();
  return reader >= indices_.size() || !indices_[reader] || indices_[reader]->has_corners();
}

Result<bool> Heidenhain::takes_block(Interpreter& m) {
  if (!assumed_axes.empty()) [[unlikely]]
    m.warn(note(AlarmId::axes_assumed, m.block->where, std::string_view(std::exchange(assumed_axes, {}))));
  kept_ = false;
  previous_ = m.position.work;
  corner_rounding = corner_chamfer = corner_feed = 0;
  corner = CornerJoin::arc;
  const bool is_text = m.block->statement.kind == StatementKind::klartext;
  loop_lines_.note_block(m.flow.depth(), m.origin.calls);
  if (!is_text && m.block->word_count == 0) return false;
  if (!is_text && !needs_text(m)) {
    for (std::uint32_t i = 0; i < m.block->word_count; ++i) {
      const Word& w = m.block->words[i];
      if ((missing_axes & letter_bit(w.address)) != 0 && w.address != 'F') return fail(alarm(AlarmId::axis_not_named, w.where, w.address));
      if (w.address == 'F' && !(w.value > 0)) return fail(alarm(AlarmId::value_out_of_range, w.where, 'F', w.value));
      if (w.address == 'G' && ((w.code == 410 && m.modal.radius_side == 1) || (w.code == 420 && m.modal.radius_side == -1)))
        return fail(alarm(AlarmId::compensation_active, w.where, m.block->text_of(w.where)));
    }
    memory.moved_at_rapid = m.block->words[0].code == 0;
    KADR_TRY(m.take_words());
    return false;
  }
  return run_text(m);
}

std::shared_ptr<const KlartextBlock> Heidenhain::block_at(const BlockContext& m, Position at) {
  const std::uint64_t key = static_cast<std::uint64_t>(m.program().reader()) << 48U | at.offset;
  if (const auto known = read_.find(key); known != read_.end()) return known->second;
  const ProgramFile& file = m.program().file(m.program().reader());
  BlockReader reader(file.source(), file.grammar(), file.reader().encoding());
  reader.seek(at);
  const auto block = std::make_unique<Block>();
  const auto got = reader.next(*block);
  if (!got || *got == BlockReader::Got::end) return nullptr;
  const Span statement = block->statement.kind == StatementKind::klartext ? block->statement.text : block->where;
  auto text = statement;
  if (block->statement.kind != StatementKind::klartext && block->word_count > 0) text.begin = block->words[0].where.begin;
  auto read = read_klartext_block(block->text, text);
  if (!read) return nullptr;
  return std::make_shared<const KlartextBlock>(std::move(*read));
}

Result<bool> Heidenhain::run_text(Interpreter& m) {
  const Block& block = *m.block;
  Span statement = block.statement.kind == StatementKind::klartext ? block.statement.text : block.where;
  if (block.statement.kind != StatementKind::klartext) {
    statement.begin = block.words[0].where.begin;
    if (!block.comments.empty()) statement.end = block.comments[0].begin - 1;
  }
  const std::uint64_t key = static_cast<std::uint64_t>(m.program().reader()) << 48U | block.position.offset;
  auto found = m.program().in_entered() ? read_.end() : read_.find(key);
  std::shared_ptr<const KlartextBlock> compiled = found == read_.end() ? nullptr : found->second;
  if (!memory.begun) {
    const std::string_view text = block.text_of(statement);
    const bool begins = text.size() > 5 && (text[0] == 'B' || text[0] == 'b') && text.substr(0, 5) == "BEGIN";
    if (!begins && index(m).has_begin()) return true;  // what is in front of BEGIN PGM is not read
    (void)index(m);
    memory.begun = true;
    if (block.statement.kind != StatementKind::klartext && !needs_text(m)) return takes_block(m);
  }
  if (compiled == nullptr) {
    auto read = read_klartext_block(block.text, statement);
    if (!read) return fail(read.error());
    compiled = std::make_shared<const KlartextBlock>(std::move(*read));
    constexpr std::size_t most_kept = 20'000;
    if (read_.size() > most_kept) read_.clear();
    if (m.flow.depth() > 0 || block.repeated || compiled->kind == KlartextKind::assignment || compiled->kind == KlartextKind::jump)
      read_[key] = compiled;
  }
  if (m.block != scratch_.get()) *scratch_ = block;
  m.block = scratch_.get();
  scratch_->word_count = 0;
  scratch_->letters = 0;
  scratch_->shape = {};
  scratch_->altered = true;
  written_.clear();
  const bool only_writes = compiled->kind == KlartextKind::assignment || compiled->kind == KlartextKind::passed_over;
  if (!only_writes) {
    m.keep_state();
    m.keep_flow_place();
    before_ = memory;
    kept_ = true;
  }
  KADR_TRY(BlockRun(m, *this, *compiled).run());
  kept_ = false;
  return true;
}

BlockChanges Heidenhain::changes_of(const BlockContext& m, const Plan& plan) const { return m.changes_of_block(plan); }

void Heidenhain::after_code(Interpreter& m, const CodeRow& row, std::int32_t) {
  switch (row.function) {
    case Function::radius_comp_left:
    case Function::radius_comp_right: m.modal.radius_by_word = tool_radius(m); break;
    case Function::spindle_stop: memory.spindle_code = memory.spindle_code == 1 || memory.spindle_code == 3 ? 3 : 2; break;
    case Function::spindle_cw:
    case Function::spindle_cw_coolant: memory.spindle_code = 0; break;
    case Function::spindle_ccw:
    case Function::spindle_ccw_coolant: memory.spindle_code = 1; break;
    default: break;
  }
}

void Heidenhain::undo_block(BlockContext&) {
  if (!std::exchange(kept_, false)) return;
  static_cast<Modes&>(memory) = before_;
  for (; !written_.empty(); written_.pop_back()) family(written_.back().family)[written_.back().index] = written_.back().value;
}

bool Heidenhain::end_program(Interpreter& m) {
  memory.calls.clear();
  memory.repeats.clear();
  m.flow.frames().clear();
  reset_frames();
  memory.plunge = 0;
  memory.edge_feed = EdgeFeed::none;
  memory.shortest = memory.holds_tip = memory.calls_always = memory.feed_per_turn = false;
  memory.cycle = -1;
  m.change_frames();
  (void)set_frame(m);
  return false;
}

/// The tool length acts along the tool axis from TOOL CALL on (spec/heidenhain 2.4).
void Heidenhain::refresh_frames(Emitter& m) {
  const Placement before = m.frames;
  for (std::size_t a = 0; a < m.axis_count; ++a) m.frames.origin[a] = m.tables.common[a] + m.tables.zeros[m.modal.work_zero][a];
  m.frames.length = {};
  m.frames.turn = nullptr;
  m.frames.space = nullptr;
  if (m.modal.tool != 0) m.use.note(UseKind::length, m.modal.tool, m.origin, tool_length(m) == 0);
  m.frames.length[m.modal.axes.normal] = tool_length(m);
  if (memory.tilted || (memory.holds_tip && five_axis.group != MachineGroup::none)) place_in_space(m);
  if (before.turn && m.frames.turn && *before.turn == *m.frames.turn) m.frames.turn = before.turn;
}

void Heidenhain::emit_arc(Emitter& m, Turn turn, const PlaneArc& arc, const Axes& end, AxisMask named, PlaneAxes axes) {
  Axes middle = m.position.programmed;
  middle[axes.first] = arc.center.x;
  middle[axes.second] = arc.center.y;
  Axes work = end;
  bool reversed = false;
  if (!m.transform.identity) {
    reversed = m.transform.reverses(axes);
    work = m.transform.to_work(end);
    middle = m.transform.to_work(middle);
  }
  named |= AxisMask{1} << axes.first | AxisMask{1} << axes.second;
  m.move_to(end, work, named);
  const bool cw = (turn == Turn::cw) != reversed;
  const PlaneAxes plane = std::exchange(m.modal.axes, axes);
  Motion& motion = m.add_motion(cw ? MotionKind::arc_cw : MotionKind::arc_ccw, named);
  m.modal.axes = plane;
  m.set_feed(motion);
  motion.center = {middle[axes.first], middle[axes.second]};
  motion.turns = arc.turns;
  note_arc_end(m, motion);
  if (memory.edge_feed != EdgeFeed::none && motion.side != 0) {  // M109, M110: the feed holds at the cutting edge
    const double radius = length(in_plane(work, axes) - motion.center);
    const double inside = (cw ? -1 : 1) * motion.side;  // the tool is on the side of the centre
    const double path = radius - inside * motion.tool_radius;
    if (radius > tol::same_point && path > 0 && (memory.edge_feed == EdgeFeed::all || inside > 0)) motion.feed *= path / radius;
  }
  const Vec2 arm = in_plane(end, axes) - arc.center;
  memory.direction = turn == Turn::ccw ? Vec2{-arm.y, arm.x} : Vec2{arm.y, -arm.x};
  memory.direction_plane = axes;
  memory.has_direction = true;
}

/// Adds the corner behind the block to its motion, and notes the direction for CT and DEP.
void Heidenhain::note_motion(Emitter& m, Motion& motion) {
  m.modal.corner_join = corner;
  motion.corner_first = true;
  if (m.modal.contour != CompensationPhase::off) note_compensation(m, motion, m.moved_from);
  const AxisMask plane = AxisMask{1} << motion.first | AxisMask{1} << motion.second;
  const bool cuts = motion.kind == MotionKind::feed || motion.kind == MotionKind::rapid || is_arc(motion.kind);
  std::shared_ptr<MotionDetail> detail;
  const auto own = [&]() -> MotionDetail& {
    if (!detail) detail = motion.detail ? std::make_shared<MotionDetail>(*motion.detail) : std::make_shared<MotionDetail>();
    return *detail;
  };
  if (cuts && (motion.named & plane) != 0 && (corner_rounding > 0 || corner_chamfer > 0)) {
    CornerData at_end;
    at_end.rounding = corner_rounding * m.transform.corner_scale(m.modal.axes);
    at_end.feed = corner_feed;
    at_end.chamfer = corner_chamfer * m.transform.corner_scale(m.modal.axes);
    own().contour = at_end;
  }
  const AxisMask turning = motion.named & m.def.rotary;
  if (turning != 0 && (motion.kind == MotionKind::rapid || memory.shortest) && !memory.holds_tip) {
    own().rolled = turning;
    for (std::size_t a = 0; a < m.axis_count; ++a)
      if ((turning >> a & 1U) != 0) own().travel[a] = m.position.work[a] - previous_[a];
  }
  const bool plain = m.transform.identity && m.modal.radius_side == 0;
  motion.as_programmed = memory.tilted && plain && motion.kind != MotionKind::probe;
  if (!m.transform.identity || (memory.tilted && !plain)) {
    own().programmed = m.position.programmed;
    own().has_programmed = true;
  }
  if (detail) motion.detail = std::move(detail);
  if (!is_arc(motion.kind) && (motion.named & plane) != 0) {
    const Axes from = m.transform.to_programmed(previous_);
    const Vec2 way = in_plane(m.position.programmed, m.modal.axes) - in_plane(from, m.modal.axes);
    if (length(way) > tol::same_point) {
      memory.direction = way;
      memory.direction_plane = m.modal.axes;
      memory.has_direction = true;
    }
  }
  previous_ = m.position.work;
}

void Heidenhain::note_straight(BlockContext& m, bool rapid) {
  const std::int32_t row = m.def.row_of('G', rapid ? 0 : 10);
  if (row < 0) return;
  m.modal.rows[m.def.codes[static_cast<std::size_t>(row)].group] = static_cast<std::int16_t>(row);
  m.modal.motion = rapid ? MotionMode::rapid : MotionMode::linear;
}

void Heidenhain::note_line(BlockContext& m) {
  const PlaneAxes plane = m.modal.axes;
  const Axes& now = m.position.programmed;
  const Vec2 way = in_plane(now, plane) - in_plane(previous_, plane);
  memory.moved_at_rapid = m.modal.motion == MotionMode::rapid;
  if (dot(way, way) <= tol::same_point * tol::same_point) return;
  memory.direction = way;
  memory.direction_plane = plane;
  memory.has_direction = true;
  previous_[plane.first] = now[plane.first];
  previous_[plane.second] = now[plane.second];
}

/// The tilted plane, which stays in force after the end of the program.
std::map<std::string, AxisValues> Heidenhain::programming_frame(const BlockContext& m) const {
  if (!memory.tilted) return {};
  const auto named = [&](Vec3 v) { return AxisValues{{m.axis_names[0], v.x}, {m.axis_names[1], v.y}, {m.axis_names[2], v.z}}; };
  const Axes& origin = memory.tilt_origin;
  return {{"origin", named({origin[0], origin[1], origin[2]})},
          {"x", named(memory.tilt.column(0))},
          {"y", named(memory.tilt.column(1))},
          {"z", named(memory.tilt.column(2))}};
}

AxisMask Heidenhain::rolling_axes(const BlockContext& m) const {
  AxisMask missing = 0;
  for (std::size_t a = 0; a < m.def.axes.size(); ++a)
    if (a >= m.axis_count || (missing_axes & letter_bit(m.def.axes[a][0])) != 0) missing |= AxisMask{1} << a;
  return missing;
}

/// Reports the Q parameters that are not 0, and the watched ones.
void Heidenhain::add_variables(Emitter& m, FinalState& ending, const std::vector<std::string>& watch) {
  for (std::size_t i = 0; i < q_count; ++i)
    if (memory.q[i] != 0 && !std::isnan(memory.q[i])) ending.variables.emplace_back("#Q" + std::to_string(i), memory.q[i]);
  for (const std::string& name : watch) {
    const auto named = parameter_named(name);
    if (!named) {
      ending.watched_unset.emplace_back(name, true);
      continue;
    }
    const auto value = parameter(m, named->family, static_cast<std::uint16_t>(named->index), {});
    if (!value) {
      ending.watched_unset.emplace_back(name, true);
      continue;
    }
    const bool listed = named->family == ParameterFamily::q && memory.q[named->index] != 0;
    if (!listed) ending.variables.emplace_back(name.starts_with('#') ? name : "#" + name, *value);
  }
}

}  // namespace heidenhain
}  // namespace kadr
