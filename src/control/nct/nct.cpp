// The NCT control at power-on, by a set-up, at the end of a program (spec/nct/03, 13, 24). For the rest of control.

#include "control/nct/nct.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/code_literals.h"
#include "config/machine_axes.h"
#include "control/functions/functions.h"
#include "control/nct/calls/waiting.h"
#include "control/nct/five_axis/five_axis.h"
#include "control/nct/frames/transformations.h"
#include "control/nct/variables/system_variables.h"
#include "control/nct/words/coordinates.h"

namespace kadr::nct {
namespace {

/// Names of all axes of the machine by their number: those of the other channels too.
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

ParameterSource source_of(const ParameterStore& store) {
  return {[&store](const char* name) { return store.meaning(name).row != ParameterId::none; },
          [&store](const char* name, int index) {
            const ParameterStore::Meaning meant = store.meaning(name);
            if (meant.bit >= 0) return store.bit(meant.row, meant.bit, index) ? 1.0 : 0.0;
            return store.value(meant.row != ParameterId::none ? meant.row : store.named(name), index);
          },
          [&store](const char* name, const char* bit, int index) {
            const ParameterStore::Meaning meant = store.meaning(std::string(name) + '#' + bit);
            if (meant.row != ParameterId::none)
              return meant.bit < 0 ? store.value(meant.row, index) != 0 : store.bit(meant.row, meant.bit, index);
            const ParameterId id = store.named(name);
            const bool digit = bit[0] >= '0' && bit[0] <= '9' && bit[1] == '\0';
            const int number = digit ? bit[0] - '0' : store.bit_named(id, bit);
            return number >= 0 && store.bit(id, number, index);
          },
          [&store](const char* name, int index) {
            const std::string text = store.text(store.named(name), index);
            return text.size() == 1 && text[0] >= 'A' && text[0] <= 'Z' ? text[0] : '\0';
          }};
}

/// Number of a modal group's name; 0: it is no G group.
int group_number(const GroupRow& group) {
  const bool digits = !group.name.empty() && group.name.find_first_not_of("0123456789") == std::string::npos;
  return digits ? std::stoi(group.name) : 0;
}

/// Tenths of the code that a group begins with (3.3).
std::int32_t initial_code(const Settings& s, int group, std::int32_t otherwise) {
  switch (group) {
    case 1: return s.default_1[0] ? 1_g : 0_g;
    case 2: return s.default_1[1] ? 18_g : s.default_1[2] ? 19_g : 17_g;
    case 3: return s.default_1[7] ? 91_g : 90_g;
    case 5: return s.default_per_rev ? 95_g : 94_g;
    case 6: return s.default_1[3] ? 20_g : 21_g;
    case 8: return s.default_1[5] ? 43_g : s.default_1[6] ? 44_g : 49_g;
    default: return otherwise;
  }
}

/// Every modal group's initial code is in force; `keep`: the bits of CLR G Table are obeyed.
void reset_codes(Interpreter& m, bool keep) {
  const Settings& s = nct_of(m).settings;
  nct_of(m).plane_axes = 0;
  Block* const block = m.block;
  Block none;
  m.block = &none;  // the functions find no words
  for (std::size_t g = 1; g < m.def.groups.size(); ++g) {
    const GroupRow& group = m.def.groups[g];
    const int number = group_number(group);
    constexpr int gear_group = 34;
    if (number == gear_group && nct_of(m).state.gear.on) continue;     // 20.1.4: with RCE=0 a reset leaves it on
    const bool always = number == 15 || number == 17 || number == 21;  // G64, G15, G13.1: whatever CLR says (6.3.3, 5.4, 4.5)
    if (group.power_on < 0 || (!always && keep && s.keeps_codes && static_cast<std::size_t>(number) < s.kept_groups.size() &&
                               s.kept_groups[static_cast<std::size_t>(number)]))
      continue;
    const std::int32_t tenth = initial_code(s, number, m.def.codes[static_cast<std::size_t>(group.power_on)].tenth);
    const std::int32_t index = m.def.row_of('G', tenth);
    if (index < 0) continue;
    const CodeRow& row = m.def.codes[static_cast<std::size_t>(index)];
    if (row.function == Function::mirror_off) clear_mirror(m);  // under G51, G68 that stay on, too
    const std::size_t silent = m.batch->size();
    (void)handler_of(row.function)(m, {&row, nullptr, {}});
    m.batch->cut(silent);
    m.modal.rows[g] = static_cast<std::int16_t>(index);
  }
  m.block = block;
}

void reset_shifts(Interpreter& m) {
  reset_five_axis(m);
  m.modal.new_system = {};
  if (!nct_of(m).settings.shift_is_global) m.modal.local = {};  // spec/haas 5.3: setting 33
  m.modal.surface = PathSurface::plane;
  m.modal.smoothing = 0;
  m.modal.diameter = 0;
  for (std::size_t a = 0; a < m.axis_count; ++a)
    if (nct_of(m).settings.axes[a].diameter) m.modal.diameter |= 1u << a;
}

}  // namespace

/// "_ALM" without its underscore; -1: unknown.
double number_of_symbol(const Interpreter& m, const std::string& name) {
  const std::string plain = name.substr(0, name.find('['));
  const double index = name.find('[') == std::string::npos ? 1 : std::strtod(name.c_str() + name.find('[') + 1, nullptr);
  for (const VariableName& row : m.def.grammar.symbols)
    if (row.text == plain) return row.indexed ? row.number + index - row.first_index : row.number;
  return -1;
}

/// N1400, N2902, N2903.
ToolLimits tool_limits(const ParameterStore& p) {
  const ToolLimits usual;
  const auto whole = [&](const char* name, int otherwise) {
    const ParameterId id = p.named(name);
    return id == ParameterId::none ? otherwise : static_cast<int>(p.value(id));
  };
  const int columns = whole("2903", usual.user_data);
  return {whole("2902", usual.rows), columns > 0 ? columns : usual.user_data, whole("1400", usual.offsets)};
}

Nct::Nct(Interpreter& m, const Setup& setup, const RunLimits& limits, std::shared_ptr<Commons> commons)
    : variables(std::move(commons), static_cast<int>(setup_number(setup, "1700")), static_cast<int>(setup_number(setup, "1701"))),
      parameters(m.def.parameters, setup.parameters, {all_axes(m.def, setup), setup.channel}),
      output({.root = limits.files,
              .writing = limits.writes_files ? OutputWriting::files : OutputWriting::nothing,
              .untouched = limits.untouched}) {
  tools = ToolManagement(setup, tool_limits(parameters));
  tools.keep_in(m.journal);
  parameters.keep_in(m.journal);
  if (const std::string& error = parameters.error(); !error.empty())
    m.start_fault = {"parameters", error, "ключ «parameters» исходного состояния: недопустимое значение (" + error + ")"};
  const auto group_of = [&](std::int32_t tenth) {
    const std::int32_t row = m.def.row_of('G', tenth);
    return row < 0 ? std::uint8_t{0} : m.def.codes[static_cast<std::size_t>(row)].group;
  };
  drilling_group = group_of(80_g);
  motion_group = group_of(0_g);
  inhibiting = static_cast<std::int16_t>(m.def.row_of('G', 63_g));
  slowing = static_cast<std::int16_t>(m.def.row_of('G', 62_g));
  stop_group = group_of(63_g);
  m.macro_variables = &variables;
  m.waiting.known = channels_of(setup);
  m.tables.zeros.resize(all_systems + dynamic_systems);
  m.tables.rotations.resize(all_systems + dynamic_systems);
  for (const VariableRow& row : m.def.variables)
    if (is_clock(row.kind))
      for (const VariableRange& range : row.ranges) clocks_.push_back(range.from);
}

Nct::~Nct() = default;

/// The reference points of the parameters (9, 9.2) go before those that the set-up states by themselves.
void Nct::take_reference_points(Interpreter& m) {
  for (std::size_t a = 0; a < m.axis_count; ++a)
    for (std::size_t point = 1; point < m.tables.reference.size(); ++point) {
      const double position = settings.axes[a].reference[point - 1];
      m.tables.reference[point][a] = position != 0 ? position : setup_reference_[point][a];
    }
}

void Nct::refresh_settings(Interpreter& m) {
  if (parameters_seen == parameters.version() + 1) return;
  parameters_seen = parameters.version() + 1;
  tools.set_limits(tool_limits(parameters));
  settings = read_settings(source_of(parameters), m.axis_names, m.def.axis_numbers);
  if (m.def.behaviour.tool_along_third) settings.length_axes = settings.length_of_block ? 0 : std::max(settings.length_axes, 1);
  take_reference_points(m);
}

bool Nct::start(Interpreter& m, const Setup& setup) {
  setup_reference_ = m.tables.reference;
  refresh_settings(m);
  without_point = 0;
  for (char letter = 'A'; letter <= 'Z'; ++letter)
    if (const WordFormat& format = m.def.grammar.word(letter); format.known && format.whole_digits == 0 && !format.point)
      without_point |= letter_bit(letter);
  singular = setup.kinematics.singular;
  for (std::size_t a = 0; a < m.axis_count; ++a) {
    constexpr double unlimited = std::numeric_limits<double>::infinity();
    axis_limits[a] = {-unlimited, unlimited};
    if (const auto found = setup.axis_limits.find(m.axis_names[a]); found != setup.axis_limits.end()) axis_limits[a] = found->second;
    for (const std::string& name : {std::string("*"), m.axis_names[a]})
      if (const auto found = setup.machine.find(name); found != setup.machine.end() && found->second.limits)
        axis_limits[a] = *found->second.limits;
    for (const std::string& name : {std::string("*"), m.axis_names[a]})
      if (const auto found = setup.machine.find(name); found != setup.machine.end()) servo_lag[a] = found->second.position_error;
  }
  for (const auto& [number, spindle_setup] : setup.spindles) {
    if (number < 1 || number > static_cast<int>(most_spindles)) continue;
    SpindleState& s = spindle(number);
    s.known = true;
    s.channel = spindle_setup.channel;
    s.rpm = spindle_setup.rpm;
    s.dir = spindle_setup.dir == "cw" ? SpindleDir::cw : spindle_setup.dir == "ccw" ? SpindleDir::ccw : SpindleDir::stop;
    s.angle = spindle_setup.angle.value_or(0);
    ranges[number] = spindle_setup.ranges;
    spindle_names[number] = spindle_setup.name;
  }
  if (settings.default_spindle > 0) state.current_spindle = state.main_spindle = settings.default_spindle;
  m.modal.main_spindle = static_cast<std::uint8_t>(state.main_spindle);  // 11.4, INFERRED: that of N0604
  spindle_part = setup.spindle_override / 100;
  state.surface_speed = settings.surface_speed;
  state.css_axis = settings.css_axis;
  signals = setup.signals;
  single_block = setup.single_block;
  clock = setup.clock;
  m.transform = Transform();
  reset_shifts(m);
  reset_codes(m, false);
  const double feeds[] = {parameters.value(parameters.named("0300")), parameters.value(parameters.named("0301"))};  // 6.2
  const bool per_minute = m.modal.feed_mode == FeedMode::per_minute;
  m.modal.feed = feeds[per_minute ? 0 : 1];
  m.modal.other_feed = feeds[per_minute ? 1 : 0];
  m.modal.feed_known = m.modal.feed > 0;
  m.modal.other_feed_known = m.modal.other_feed > 0;
  return true;
}

namespace {

/// G43 and H of a set-up are in force without an axis that was named: INFERRED: along the tool (25.1), else Z.
void take_length_in_force(Interpreter& m) {
  const std::uint32_t number = m.modal.length_number;
  if (m.modal.length_sign == 0 || number == 0 || m.modal.turning_lengths || any_nonzero(m.modal.lengths)) return;
  if (nct_of(m).state.five_axis.lead != ToolLead::none || number >= m.tables.offsets.size()) return;
  const Vec3 tool = nct_of(m).settings.five_axis.tool;
  const int axis = main_axis(m, tool.x != 0 ? 1 : tool.y != 0 ? 2 : 3);
  if (axis >= 0) m.modal.lengths[static_cast<std::size_t>(axis)] = m.modal.length_sign * m.tables.offsets[number].whole_length();
}

}  // namespace

/// Settings 45 to 48 (spec/haas 6.1): about the work zero, from the start.
void Nct::mirror_by_settings(Interpreter& m) const {
  if (settings.mirrored == 0) return;
  const Axes at = m.transform.to_work(m.position.programmed);
  for (std::size_t a = 0; a < m.axis_count && a < 4; ++a)
    if ((settings.mirrored >> a & 1U) != 0) m.transform.mirror[a] = -1;
  m.transform.refresh();
  m.position.programmed = m.transform.to_programmed(at);
}

void Nct::take_setup(Interpreter& m, const Setup& setup) {
  for (const auto& [name, value] : setup.variables) {
    if (name.size() < 2 || name[0] != '#') continue;
    const double number = name[1] == '_' ? number_of_symbol(m, name.substr(2)) : std::strtod(name.c_str() + 1, nullptr);
    if (const Status written = set_start_value(m, number, value ? *value : vacant); !written && m.start_fault.empty())
      m.start_fault = {"variables." + name, "setup key 'variables." + name + "': no such variable, or not one that can be given",
                       "ключ «variables." + name + "» исходного состояния: такой переменной нет, или её нельзя задать"};
  }
  for (const auto& [name, on] : setup.diameter)
    for (std::size_t a = 0; a < m.axis_count; ++a)
      if (m.axis_names[a] == name) m.modal.diameter = on ? m.modal.diameter | 1u << a : m.modal.diameter & ~(1u << a);
  for (std::size_t first = 0; first < m.axis_count; ++first)
    for (std::size_t second = 0; second < m.axis_count; ++second)
      if (!setup.plane.empty() && m.axis_names[first] + m.axis_names[second] == setup.plane)
        m.modal.axes.first = first, m.modal.axes.second = second;
  m.transform.refresh();
  take_length_in_force(m);
  axes_in_all = static_cast<int>(m.axis_count);
  constexpr int by_default = 3;  // X, Y, Z
  for (const auto& [number, channel] : setup.channels)
    axes_in_all += channel.axes.empty() ? by_default : static_cast<int>(channel.axes.size());
  if (m.start_fault.empty()) m.start_fault = coupling_fault(m, setup.events);
  find_spindle_axes(m, setup);
  watch_tool_time(m);
  mirror_by_settings(m);
}

/// M5, M9 at the end of the program (13.1, "usually"): the codes of the table's `end`; all spindles of the channel stand.
void stop_machine(Interpreter& m) {
  const std::size_t silent = m.batch->size();
  const double parts = nct_of(m).state.parts_done;
  for (const std::int32_t index : m.def.end_codes) {
    const CodeRow& row = m.def.codes[static_cast<std::size_t>(index)];
    if (row.letter != 'M') continue;
    (void)handler_of(row.function)(m, {&row, nullptr, {}});
    if (row.group != 0 && row.modal) m.modal.rows[row.group] = static_cast<std::int16_t>(index);
  }
  for (SpindleState& s : nct_of(m).state.spindles) {
    if (s.known && s.channel != m.def.channel) continue;
    s.dir = SpindleDir::stop;
    s.loop_closed = s.referenced = false;
    s.master = 0;
  }
  nct_of(m).state.parts_done = parts;
  m.batch->cut(silent);
}

/// Where a tool's life is counted in time, the machine's time is looked at after each block.
void watch_tool_time(Interpreter& m) {
  if (!nct_of(m).tools.counts_time()) return;
  m.reads_clock = m.each_block = nct_of(m).counts_time = true;
}

void Nct::reset_program(Interpreter& m) {
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
  finishing.clear();
  state.turning.code = 0;
  const bool ends_gear = parameters.bit(parameters.named("1800"), 0);  // RCE
  if (ends_gear) (void)withdraw(m);
  stop_machine(m);
  reset_shifts(m);
  if (ends_gear) disengage(m);
  reset_codes(m, true);
  state.side_step = SideStep::none;
  state.compensates = false;
  m.change_frames();
}

}  // namespace kadr::nct

namespace kadr {

nct::Nct& nct_of(const Interpreter& m) { return static_cast<nct::Nct&>(*m.dialect); }

}  // namespace kadr
