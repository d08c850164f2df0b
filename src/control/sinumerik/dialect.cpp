// The functions of the Sinumerik's dialect that the interpreter calls (control/dialect.h).

#include <algorithm>
#include <cmath>
#include <utility>

#include "control/functions/rotary_machine.h"
#include "control/sinumerik/sinumerik.h"

namespace kadr {

std::unique_ptr<Dialect> make_sinumerik_dialect(BlockContext&, const Setup&, const RunLimits& limits) {
  return std::make_unique<sinumerik::Sinumerik>(limits);
}

namespace sinumerik {
namespace {

/// What a snapshot keeps: also the words of the block, because it may be taken before the block's end.
struct Kept : DialectState {
  Kept(Memory all, BlockWords of_block) : memory(std::move(all)), words(std::move(of_block)) {}
  /// Each program has the variables of its own DEF and PROC (spec/sinumerik 6, 9.2). Texts, axes, frames and arrays have no value here.
  std::vector<LocalVariables> local_variables(const std::vector<CallFrame>& calls, const ControlDef&) const override {
    std::vector<std::size_t> depths = {0};
    const auto repeats = [&](std::size_t depth) {
      return std::any_of(memory.repeated.begin(), memory.repeated.end(), [&](const RepeatedPart& one) { return one.depth == depth; });
    };
    for (std::size_t i = 0; i < calls.size(); ++i)
      if (calls[i].kind == CallFrame::Kind::subprogram && !repeats(i + 1)) depths.push_back(i + 1);
    std::vector<LocalVariables> all;
    for (std::size_t level = 0; level < std::min(depths.size(), memory.levels.size()); ++level) {
      auto& values = all.emplace_back(LocalVariables{depths[level], {}}).values;
      for (const auto& [name, variable] : memory.levels[level].variables)
        if (variable->sizes.empty() && !variable->values.empty() && variable->values[0].is_number())
          values.emplace_back(name, variable->values[0].number);
    }
    return all;
  }

  Memory memory;
  BlockWords words;
  Axes previous{};
  bool circle_by_name = false;
};

}  // namespace

Sinumerik& sinumerik_of(const BlockContext& m) { return static_cast<Sinumerik&>(*m.dialect); }

std::shared_ptr<const DialectState> Sinumerik::snapshot() const {
  auto kept = std::make_shared<Kept>(separate_copy(memory), words);
  kept->previous = previous_;
  kept->circle_by_name = circle_by_name_;
  return kept;
}

Status Sinumerik::restore(BlockContext&, const DialectState& from) {
  const Kept& then = static_cast<const Kept&>(from);
  memory = separate_copy(then.memory);
  words = then.words;
  previous_ = then.previous;
  circle_by_name_ = then.circle_by_name;
  kept_ = false;
  written_.clear();
  found_.clear();
  indices_.clear();
  calculation_.forget_all();
  word_lines_.forget_all();
  assumed_axes.clear();  // noted when the run began
  return {};
}

/// The machine has X, Y, Z, and of the further axes those that the set-up names (spec/sinumerik 0).
void Sinumerik::take_axes(Emitter& m, const Setup& setup) {
  constexpr std::size_t geometry_axes = 3;
  std::size_t count = geometry_axes;
  missing_axes = 0;
  for (std::size_t a = geometry_axes; a < m.def.axes.size(); ++a) {
    const std::string& name = m.def.axes[a];
    const bool named = std::find(setup.axes.begin(), setup.axes.end(), name) != setup.axes.end();
    if (named) count = a + 1;
    else missing_axes |= letter_bit(name[0]);
  }
  for (const std::string& name : setup.axes_assumed) assumed_axes += (assumed_axes.empty() ? "" : " ") + name;
  m.axis_names = m.def.axes;
  m.axis_names.resize(count);
  m.axis_count = count;
}

void Sinumerik::take_setup(Emitter& m, const Setup& setup) {
  take_axes(m, setup);
  rotary = rotary_machine(setup.kinematics, m.def, missing_axes);
  for (std::size_t n = 0; n < settable_frames && n < m.tables.zeros.size(); ++n) memory.settable[n].shift = m.tables.zeros[n];
  for (const auto& [tool, offset] : setup.offsets) table_.insert(tool);
  for (const auto& [name, value] : setup.variables) {
    const std::size_t begin = name.starts_with("#R") ? 2 : name.starts_with("R") ? 1 : 0;
    if (begin == 0 || !value || name.find_first_not_of("0123456789", begin) != std::string::npos) continue;
    const unsigned long index = std::strtoul(name.c_str() + begin, nullptr, 10);
    if (index < parameter_count) memory.parameters[index] = *value;
  }
  memory.active = memory.settable[m.modal.work_zero];
  if (memory.edge != 0 || m.modal.tool != 0) {
    const bool off = std::find(setup.modal.begin(), setup.modal.end(), "D0") != setup.modal.end();
    memory.edge = off ? 0 : std::max<std::uint32_t>(1, memory.edge);
    m.modal.offset_number = off || m.modal.tool >= tool_rows ? 0 : m.modal.tool;
  }
  words = {};
  memory.levels.front().executing = memory.levels.front().acted = false;
}

bool Sinumerik::knows_tool(const BlockContext& m, double tool) const {
  if (table_.empty() || tool == 0 || table_.contains(static_cast<int>(tool))) return true;
  const auto number = static_cast<std::size_t>(tool);
  return number < tool_rows && number < m.tables.offsets.size() && !(m.tables.offsets[number] == ToolOffset{});  // $TC_DP of the program
}

/// Puts an edge of the tool in force (spec/sinumerik 5).
Status Sinumerik::activate_edge(Emitter& m, std::uint32_t edge, Span where) {
  const std::uint32_t tool = m.modal.tool;
  const bool in_table = tool != 0 && tool < tool_rows && tool < m.tables.offsets.size();
  const auto own = memory.edges.find({tool, edge});
  if (edge > 1 && (own == memory.edges.end() || !in_table)) return fail(alarm(AlarmId::edge_missing, where, double(tool), double(edge)));
  memory.edge = edge;
  m.modal.offset_number = edge == 0 || !in_table ? 0 : edge_row(tool, edge);
  if (edge > 1) m.tables.offsets[m.modal.offset_number] = own->second;
  set_normal_offset(m);
  m.change_frames();
  return {};
}

double Sinumerik::tool_radius(const BlockContext& m) const {
  return m.modal.offset_number < m.tables.offsets.size() ? m.tables.offsets[m.modal.offset_number].whole_radius() : 0.0;
}

Result<double> Sinumerik::cutter_radius(BlockContext& m, Span where) const {
  const double radius = tool_radius(m);
  if (m.modal.offset_number != 0) m.use.note(UseKind::radius, m.modal.offset_number, m.origin, radius == 0);
  if (!(radius > 0)) return fail(alarm(AlarmId::cycle_tool_radius, where, double(m.modal.tool)));
  return radius;
}

void Sinumerik::set_normal_offset(BlockContext& m) const {
  m.modal.radius_by_word = memory.normal_offset == 0 ? -1 : std::max(0.0, tool_radius(m) + memory.normal_offset);
}

void Sinumerik::after_code(Interpreter& m, const CodeRow& row, std::int32_t) {
  switch (row.function) {
    case Function::change_tool: {
      const std::uint32_t edge = words.edge.value_or(m.modal.tool == 0 ? 0 : 1);
      words.edge.reset();
      if (edge <= 1 || memory.edges.contains({m.modal.tool, edge})) (void)activate_edge(m, edge, words.edge_where);
      else words.edge = edge;  // after_block() raises the alarm
      break;
    }
    case Function::work_zero:
      memory.active = memory.settable[static_cast<std::size_t>(row.arg)];
      m.change_frames();
      break;
    case Function::constant_velocity: m.modal.blend_tolerance = row.code == "G64" ? 0 : memory.tolerance; break;
    case Function::exact_stop_mode: m.modal.blend_tolerance = 0; break;
    case Function::surface_speed: {  // G96 is of the group of G95: its feed is per revolution
      if (m.modal.feed_mode == FeedMode::per_revolution) break;
      m.modal.feed_mode = FeedMode::per_revolution;
      m.modal.feed_known = m.has('F');
      break;
    }
    case Function::feed_per_minute:
    case Function::feed_per_revolution:
    case Function::feed_inverse_time:
      if (m.modal.surface_speed) {
        m.modal.rpm = m.surface_speed().rpm(m.position.work, m.modal.rpm);
        m.modal.surface_speed = false;
        m.emit(m.surface_speed());
      }
      break;
    case Function::plane_xy:
    case Function::plane_zx:
    case Function::plane_yz: m.change_frames(); break;
    case Function::rapid:
    case Function::linear:
    case Function::arc_cw:
    case Function::arc_ccw:
      if (!circle_by_name_) memory.motion = NamedMotion::none;
      break;
    default: break;
  }
}

Status Sinumerik::after_block(Interpreter& m) {
  if (words.edge) {
    const std::uint32_t edge = *words.edge;
    words.edge.reset();
    KADR_TRY(activate_edge(m, edge, words.edge_where));
  }
  kept_ = false;
  if (words.probe != 0) return fail(alarm(AlarmId::not_available, words.where("MEAS"), "MEAS"));  // an arc, G0, or no motion
  if (words.chuck) {
    const Modal now = std::exchange(m.modal, *std::exchange(words.chuck, std::nullopt));
    m.modal.spindle = now.spindle, m.modal.rpm = now.rpm, m.modal.tool = now.tool, m.modal.tool_selected = now.tool_selected;
    m.modal.offset_number = now.offset_number, m.modal.mist = now.mist, m.modal.flood = now.flood;
  }
  if (words.space_arc) KADR_TRY(emit_in_space(m, *std::exchange(words.space_arc, std::nullopt)));
  for (const ApproachStep& step : std::exchange(words.retraction, {})) KADR_TRY(approach_step(m, step));
  if (words.motion_before) {
    const MotionBefore before = *std::exchange(words.motion_before, std::nullopt);
    m.modal.motion = before.motion;
    m.modal.motion_row = before.motion_row;
    for (std::size_t g = 1; g < m.def.groups.size(); ++g)
      if (m.def.groups[g].name == "1") m.modal.rows[g] = before.rows[g];
  }
  if (words.block_feed) {
    m.modal.feed = *std::exchange(words.block_feed, std::nullopt);
    m.modal.feed_known = words.block_feed_known;
  }
  if (words.returns) {
    const std::string label = std::exchange(words.return_label, {});
    KADR_TRY(leave(m, m.block->where));
    return label.empty() || m.flow.ended() ? Status() : jump_in_caller(m, label, m.block->where);
  }
  if (!words.moved || m.program().ended() || !level().modal_call) return {};
  const ModalCall modal = *level().modal_call;
  const auto found = find_program(m, modal.name);
  if (found) return call(m, *found, modal.name, modal.arguments, {}, !modal.arguments.empty(), 1, m.block->where);
  if (is_cycle(modal.name)) return run_cycle(m, modal.name, modal.arguments, m.block->where);
  return fail(alarm(AlarmId::program_missing, m.block->where, std::string_view(modal.name)));
}

void Sinumerik::keep(BlockContext&) {}

void Sinumerik::undo_block(BlockContext&) {
  if (!std::exchange(kept_, false)) return;
  static_cast<Modes&>(memory) = before_;
  for (; !written_.empty(); written_.pop_back()) {
    WrittenValue& last = written_.back();
    if (last.variable != nullptr) last.variable->values[last.place] = std::move(last.value);
    else if (last.value.type == Type::frame) memory.settable[last.place] = *last.value.frame;
    else memory.parameters[last.place] = last.value.number;
  }
}

/// A block other than PROC, EXTERN and DEF: the parameters of the call must have been taken.
Status Sinumerik::begin_pass(Interpreter& m) {
  Level& own = level();
  if (!own.executing && !own.took_arguments && own.has_arguments)
    return fail(alarm(AlarmId::parameters_without_proc, m.block->where, std::string_view(own.name)));
  own.executing = true;
  return {};
}

bool Sinumerik::end_program(Interpreter& m) {
  memory.repeated.clear();
  memory.pattern.reset();
  memory.levels.erase(memory.levels.begin() + 1, memory.levels.end());
  calculation_.forget_variables();
  level().modal_call.reset();
  m.flow.frames().clear();
  memory.motion = NamedMotion::none;
  memory.rounding = memory.corner_feed = memory.tolerance = m.modal.blend_tolerance = 0;
  memory.feed_in_mm = false;
  memory.override_percent = 100;
  memory.approach_in_plane = false;
  memory.surface_most = memory.speed_least = memory.speed_most = 0;
  memory.programmable = memory.swivel = {};
  memory.swivelled_to.reset();
  memory.holds_tip = false;
  memory.normal_offset = 0;
  memory.goes_around = false;
  memory.arc_feed = ArcFeed::contour;
  memory.area_watched = true;
  memory.in_space = false;
  const auto switches = m.transform.mirror;
  m.transform = Transform();
  m.transform.mirror = switches;
  m.transform.refresh();
  memory.edge = 0;
  m.modal.offset_number = 0;
  m.change_frames();
  m.position.programmed = m.position.work;
  return false;
}

/// G96: LIMS, G25 S and G26 S limit the speed (spec/sinumerik 5).
SurfaceSpeed Sinumerik::surface_speed(const BlockContext& m) const {
  SurfaceSpeed speed = m.speed_by_x();
  if (memory.surface_most > 0) speed.most = memory.surface_most;
  if (memory.speed_most > 0) speed.most = std::min(speed.most, memory.speed_most);
  speed.least = std::min(memory.speed_least, speed.most);
  return speed;
}

Result<bool> Sinumerik::end_of_file(BlockContext&) { return true; }

/// Alarms whose number depends on the word (spec/sinumerik 18).
void Sinumerik::reword(const BlockContext&, AlarmReport& report) const { (void)report; }

/// Reports the R parameters that are not 0, and the watched variables of the main program.
void Sinumerik::add_variables(Emitter&, FinalState& ending, const std::vector<std::string>& watch) {
  for (std::size_t i = 0; i < parameter_count; ++i)
    if (memory.parameters[i] != 0) ending.variables.emplace_back("#R" + std::to_string(i), memory.parameters[i]);
  for (const std::string& name : watch) {
    const std::string plain = name.starts_with("#") ? name.substr(1) : name;
    if (plain.size() > 1 && plain[0] == 'R' && plain.find_first_not_of("0123456789", 1) == std::string::npos) {
      const unsigned long index = std::strtoul(plain.c_str() + 1, nullptr, 10);
      if (index < parameter_count && memory.parameters[index] == 0) ending.variables.emplace_back(name, 0.0);
      else if (index >= parameter_count) ending.watched_unset.emplace_back(name, true);
      continue;
    }
    const auto& variables = memory.levels.front().variables;
    const auto found = variables.find(plain);
    if (found != variables.end() && found->second->sizes.empty() && found->second->values[0].is_number())
      ending.variables.emplace_back(name, found->second->values[0].number);
    else ending.watched_unset.emplace_back(name, true);
  }
}

}  // namespace sinumerik
}  // namespace kadr
