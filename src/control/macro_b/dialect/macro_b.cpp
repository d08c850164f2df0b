// Custom macros B: power-on, set-up and reset, the state that an alarm restores, snapshots, and the functions that the interpreter calls
// (spec/nct/03, 23). Used by control/fanuc/dialect.

#include "control/macro_b/macro_b.h"

#include <algorithm>
#include <utility>

#include "base/code_literals.h"
#include "config/machine/machine_axes.h"
#include "control/interpreter.h"
#include "control/macro_b/calls/calls.h"
#include "control/macro_b/calls/interrupt.h"
#include "control/macro_b/dialect/blocks.h"
#include "control/start_fault.h"
#include "texts/control_start.h"

namespace kadr::macro_b {
namespace {

/// Returns the names of the axes of all channels, indexed by axis number − 1.
std::vector<std::string> all_axes(const ControlDef& def, const Setup& setup) {
  std::vector<std::string> names(32);
  std::size_t number = 1;
  const auto add = [&](const std::vector<std::string>& axes) {
    for (const std::string& name : axes)
      if (number <= names.size()) names[number++ - 1] = name;
  };
  const std::vector<std::string> usual = {"X", "Y", "Z"};
  bool own_added = false;
  for (const auto& [channel, other] : setup.channels) {
    if (channel > setup.channel && !own_added) add(def.axes), own_added = true;
    add(other.axes.empty() ? usual : other.axes);
  }
  if (!own_added) add(def.axes);
  return names;
}

}  // namespace

MacroB::MacroB(BlockContext& m, const Setup& setup, const RunLimits& limits, std::shared_ptr<Commons> commons)
    : variables(std::move(commons), static_cast<int>(setup_number(setup, "1700")), static_cast<int>(setup_number(setup, "1701"))),
      parameters(m.def.parameters, setup.parameters, {all_axes(m.def, setup), setup.channel}),
      output({.root = limits.files,
              .writing = limits.writes_files ? OutputWriting::files : OutputWriting::nothing,
              .untouched = limits.untouched}) {
  parameters.keep_in(m.journal);
  if (const std::string& error = parameters.error(); !error.empty())
    m.start_fault = start_fault_of("parameters", texts::control_start::parameters_invalid, error);
  if (const std::int32_t row = m.def.row_of('G', 63_g); row >= 0) {
    inhibiting = static_cast<std::int16_t>(row);
    stop_group = m.def.codes[static_cast<std::size_t>(row)].group;
  }
  m.macro_variables = &variables;
  for (const VariableRow& row : m.def.variables)
    if (is_clock(row.kind))
      for (const VariableRange& range : row.ranges) clocks_.push_back(range.from);
}

MacroB::~MacroB() = default;

// ---- start and end

void MacroB::read_parameters(BlockContext&) { settings = read_settings(source_of(parameters)); }

void MacroB::refresh_settings(BlockContext& m) {
  if (parameters_seen == parameters.version() + 1) return;
  parameters_seen = parameters.version() + 1;
  read_parameters(m);
}

bool MacroB::start(Interpreter& m, const Setup& setup) {
  refresh_settings(m);
  signals = setup.signals;
  single_block = setup.single_block;
  clock = setup.clock;
  return true;
}

void MacroB::take_setup(Emitter& m, const Setup& setup) {
  for (const auto& [name, value] : setup.variables) {
    if (name.size() < 2 || name[0] != '#') continue;
    const double number = name[1] == '_' ? number_of_symbol(m, name.substr(2)) : std::strtod(name.c_str() + 1, nullptr);
    if (const Status written = set_start_value(m, number, value ? *value : vacant); !written && m.start_fault.empty())
      m.start_fault = start_fault_of("variables." + name, texts::control_start::no_variable, name);
  }
}

/// Simulates that the control loses power and is switched on again (23.5).
bool MacroB::lose_power(Interpreter&) {
  variables.power_off();
  clock_offset_ms = now_ms;
  answer = 0;
  return true;
}

void MacroB::reset_macros() {
  output.abort();
  state.data_mode = DataMode::none;
  state.modal_calls.clear();
  state.active_modal_calls = 0;
  repeated_arguments.clear();
  if (settings.common_cleared) variables.power_off();
  variables.close_levels();
  control_1 = control_2 = 0;
  state.interrupt_program.reset();
  interrupted.active = false;
}

/// Copies the parameters of another channel, because all channels share the parameters (24.1).
void MacroB::take_common(BlockContext& m, const Dialect& from) {
  parameters.take(static_cast<const MacroB&>(from).parameters);
  refresh_settings(m);
}

// ---- the state that an alarm restores; Interpreter::undo_block restores the state that all controls have

void MacroB::begin_block(Emitter& m) {
  m.journal.keep(state.words);
  before_.all = false;
}

void MacroB::keep_all() {
  if (before_.all) return;
  before_ = {true, state, variables.depth(), repeated_arguments.size()};
}

void MacroB::undo_block(BlockContext&) {
  if (!before_.all) return;
  state = before_.state;
  while (variables.depth() > before_.levels) variables.close_level();
  if (repeated_arguments.size() > before_.repeated_arguments) repeated_arguments.resize(before_.repeated_arguments);
}

// ---- snapshot

MacroState::MacroState(const MacroB& of)
    : memory(of), parameters(of.parameters.memory()), variables(of.variables.memory()), output(of.output.memory()) {}

std::shared_ptr<const DialectState> MacroB::snapshot() const { return std::make_shared<MacroState>(*this); }

Status MacroB::restore(BlockContext&, const DialectState& from) {
  const auto& then = static_cast<const MacroState&>(from);
  KADR_TRY(output.resume_from(then.output));
  static_cast<Memory&>(*this) = then.memory;
  parameters.resume_from(then.parameters);
  variables.resume_from(then.variables);
  changes = Changes();  // after a snapshot no value counts as saved, so all rows are written to the state file again
  before_ = {};
  return {};
}

// ---- reports of the machine (11.7, 23.1.9, 23.4)

void MacroB::set_signal(const std::string& name, double value) {
  double& signal = signals[name];
  if (name == interrupt_signal && signal == 0 && value != 0) signal_rose = true;
  signal = value;
}

void MacroB::set_time(double at_ms, double cut_ms) {
  now_ms = at_ms;
  cutting_ms += cut_ms;  // the time is added to the timer, because the program may have assigned a value to the timer
}

// ---- functions that the interpreter calls

void MacroB::add_variables(Emitter& m, FinalState& ending, const std::vector<std::string>& watch) {
  macro_b::add_variables(m, ending, watch);
}

/// Returns true if the block may read a clock variable: it has a clock variable, a variable with a computed number, or a text with
/// variables (23.1.9). All earlier actions are then executed before the block, so that the clock shows the time at the block. From this
/// block on, the actions of each block are executed before the next block.
bool MacroB::reads_clock(const Block& block) const {
  const StatementKind kind = block.statement.kind;
  if (kind == StatementKind::message || kind >= StatementKind::open_port) return true;
  for (const Instruction& i : block.code) {
    if (i.op == Op::variable) return true;
    if (!(i.number > last_common)) continue;
    const bool constant = i.op == Op::number || i.op == Op::variable_at;
    if (constant && std::find(clocks_.begin(), clocks_.end(), i.number) != clocks_.end()) return true;
  }
  return false;
}

Result<bool> MacroB::interrupt(Interpreter& m, BlockMoment moment) { return call_interrupt(m, moment); }

Result<bool> MacroB::statement(Interpreter& m) { return run_statement(m); }
void MacroB::note_fault(Interpreter& m, bool may_have_steered) { endless.note_fault(m, may_have_steered); }
void MacroB::block_undone(Emitter& m) { refresh_settings(m); }
StateChanges MacroB::take_changes(Interpreter& m) { return changes.take(m); }

bool MacroB::leave_call(Interpreter& m) {
  macro_b::leave_call(m);
  return true;
}

Result<double> MacroB::read_variable(Emitter& m, double number, Span where) const { return macro_b::read_variable(m, number, where); }

Result<double> MacroB::number_of_element(const BlockContext& m, double symbol, double index, Span where) const {
  return macro_b::number_of_element(m, symbol, index, where);
}

Result<double> MacroB::control_value(BlockContext& m, double number, double bit, double index, Span where) const {
  return read_parameter(m, number, bit, index, where);
}

/// Executes one of the blocks between G10 L52 and G11, which write parameters (24.1).
Status MacroB::parameter_line(BlockContext& m) {
  ParameterStore::Write write;
  write.block = m.block->where;
  if (m.block->has_number) write.n = ParameterStore::Word{double(m.block->number), m.block->number_where};
  for (std::uint32_t i = 0; i < m.block->word_count; ++i) {
    const Word& w = m.block->words[i];
    if (w.address == 0) continue;
    const ParameterStore::Word word{w.value, w.where};
    if (w.written == 'P') write.p = word;
    else if (w.written == 'Q') write.q = word;
    else if (w.written == 'R') write.r = word, write.increment = w.incremental;
    else if (w.written == 'N' && !write.n) write.n = word;
    else return fail(alarm(AlarmId::data_block, w.where, m.block->text_of(w.where)));
  }
  if (m.block->word_count == 0 && !m.block->has_number) return {};
  KADR_TRY(parameters.write(write));
  refresh_settings(m);
  return {};
}

}  // namespace kadr::macro_b

namespace kadr {

macro_b::MacroB& macro_b_of(const BlockContext& m) { return static_cast<macro_b::MacroB&>(*m.dialect); }

}  // namespace kadr
