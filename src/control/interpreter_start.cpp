// Sets up the state before the first block: first by the control's power-on codes, then by the set-up file.

#include <algorithm>

#include "config/setup/setup_names.h"
#include "control/interpreter.h"
#include "control/start_fault.h"
#include "lang/block/lexer.h"
#include "texts/control_start.h"

namespace kadr {
namespace {

Axes axes_of(const AxisValues& values, const std::vector<std::string>& names) {
  Axes axes{};
  for (std::size_t a = 0; a < names.size() && a < max_axes; ++a)
    if (const auto found = values.find(names[a]); found != values.end()) axes[a] = found->second;
  return axes;
}

/// Returns the row of the work offset `name` in the table of work offsets or fixtures. The row of "common" is 0; the result is -1 if no
/// work offset has this name.
int zero_number(const std::vector<WorkSystem>& systems, const std::string& name) {
  if (name == "common") return 0;
  const auto found = std::find_if(systems.begin(), systems.end(), [&](const WorkSystem& system) { return system.name == name; });
  return found == systems.end() || !found->works ? -1 : static_cast<int>(found->row);
}

}  // namespace

/// Checks that the control has all axes and table rows that the set-up names. A set-up from a file has been checked key by key before
/// (config/setup/setup_check). This function is needed for a set-up that a client of the library has built.
void Interpreter::check_setup(const Setup& setup) {
  const auto note = [&](const std::string& key) {
    if (start_fault.empty()) start_fault = start_fault_of(key, texts::control_start::no_such_thing, key, def.id);
  };
  const auto axes_known = [&](const std::string& key, const AxisValues& values) {
    for (const auto& [axis, value] : values)
      if (std::find(axis_names.begin(), axis_names.end(), axis) == axis_names.end()) note(key + "." + axis);
  };
  const auto row_known = [&](const std::string& key, int number, std::size_t size) {
    if (number < 0 || static_cast<std::size_t>(number) >= size) note(key + "." + std::to_string(number));
  };
  const bool plain = dialect->machine_interface() == nullptr;
  if (plain) {
    if (!setup.parameters.empty() && def.parameters.empty()) note("parameters");
    if (!setup.tool_table.empty() || !setup.place_table.empty()) note("tool_table");
    if (!setup.channels.empty() || setup.channel != 1) note("channels");
    if (!setup.events.empty() || !setup.signals.empty()) note("events");
    if (!setup.plane.empty()) note("plane");
    if (!setup.diameter.empty() && !def.diameter_by_setup) note("diameter");
    for (const auto& [axis, on] : setup.diameter) axes_known("diameter", {{axis, 0.0}});
    if (setup.single_block) note("single_block");
    if (setup.spindles.size() > 1 || (!setup.spindles.empty() && setup.spindles.begin()->first != 1)) note("spindle");
  }
  for (const std::string& axis : setup.axes)
    if (std::find(axis_names.begin(), axis_names.end(), axis) == axis_names.end()) note("axes." + axis);
  axes_known("start", setup.start);
  for (const std::string& axis : setup.mirror) axes_known("mirror", {{axis, 0.0}});
  for (const auto& [number, offset] : setup.offsets) row_known("offsets", number, tables.offsets.size());
  for (const auto& [number, value] : setup.correctors) row_known("correctors", number, tables.correctors.size());
  for (const auto& [number, zero] : setup.zeros) row_known("zeros", number, tables.zeros.size()), axes_known("zeros", zero);
  for (const auto& [number, point] : setup.reference_points)
    row_known("reference_points", number, tables.reference.size()), axes_known("reference_points", point);
  for (const auto& [name, zero] : setup.work_offsets) {
    if (!plain) break;
    if (zero_number(work_systems(def), name) < 0) note("work_offsets." + name);
    AxisValues of_axes = zero;
    if (def.has_parameter_file()) of_axes.erase("G17");  // the key G17 is not an axis, but the rotation R of G10 L2 (spec/linuxcnc 7.8)
    axes_known("work_offsets", of_axes);
  }
}

void Interpreter::read_setup(const Setup& setup) {
  if (dialect->reads_outlines()) kept_setup_ = std::make_unique<const Setup>(setup);
  axis_names = def.axes;
  axis_count = axis_names.size();
  probe_stated = !setup.probe.empty() || setup.probe_hole.has_value();
  tables.offsets.resize(def.behaviour.offsets + 1);
  tables.correctors.resize(def.behaviour.offsets + 1);
  for (const CodeRow& row : def.codes)
    if (row.function == Function::work_zero) tables.zeros.resize(std::max(tables.zeros.size(), static_cast<std::size_t>(row.arg) + 1));
  check_setup(setup);
  for (const auto& [number, offset] : setup.offsets)
    if (number >= 0 && static_cast<std::size_t>(number) < tables.offsets.size()) tables.offsets[static_cast<std::size_t>(number)] = offset;
  for (const auto& [number, mm] : setup.correctors)
    if (number >= 0 && static_cast<std::size_t>(number) < tables.correctors.size())
      tables.correctors[static_cast<std::size_t>(number)] = mm;
  for (const auto& [number, zero] : setup.zeros)
    if (number > 0 && static_cast<std::size_t>(number) < tables.zeros.size())
      tables.zeros[static_cast<std::size_t>(number)] = axes_of(zero, axis_names);
  for (const auto& [number, point] : setup.reference_points)
    if (number > 0 && static_cast<std::size_t>(number) < tables.reference.size())
      tables.reference[static_cast<std::size_t>(number)] = axes_of(point, axis_names);
  const std::uint32_t fixtures = variables.first(VariableKind::fixture);
  has_fixtures = fixtures != 0;
  const auto write = [&](std::uint32_t first, const Axes& values) {
    for (std::uint32_t a = 0; a < 6 && a < axis_count && first != 0; ++a)
      if (values[a] != 0) variables.set_raw(first + a, values[a]);
  };
  const std::vector<WorkSystem> systems = setup.work_offsets.empty() ? std::vector<WorkSystem>() : work_systems(def);
  for (const auto& [name, offset] : setup.work_offsets) {
    const int number = zero_number(systems, name);
    const Axes values = axes_of(offset, axis_names);
    if (number > 0 && static_cast<std::size_t>(number) < tables.rotations.size()) {
      const auto angle = [&offset = offset](const char* plane) {
        const auto found = offset.find(plane);
        return found == offset.end() ? 0.0 : found->second;
      };
      tables.rotations[static_cast<std::size_t>(number)] = {angle("G17"), angle("G18"), angle("G19")};
    }
    if (number == 0) tables.common = values;
    else if (fixtures != 0 && static_cast<std::uint32_t>(number - 1) < def.behaviour.fixtures)
      write(variables.first(VariableKind::fixture, static_cast<std::uint32_t>(number - 1)), values);
    else if (number > 0 && static_cast<std::size_t>(number) < tables.zeros.size()) tables.zeros[static_cast<std::size_t>(number)] = values;
  }
  write(variables.first(VariableKind::home), tables.reference[1]);
  write(variables.first(VariableKind::home_second), tables.reference[2]);
  for (const auto& [name, value] : setup.variables) {
    if (macro_variables != nullptr) break;  // on a control with local variables, Dialect::take_setup() sets the variables
    if (!value || name.size() < 2) continue;
    if (const int parameter = variables.parameter_named(name); parameter >= 0) variables.set_parameter(parameter, *value);
    else if (const double n = std::strtod(name.c_str() + 1, nullptr); n >= 1 && n <= variables.highest())
      variables.set_raw(static_cast<std::uint32_t>(n), *value);
  }
  for (const int s : setup.skip)
    if (s >= 0 && s < 10) skip_switches[static_cast<std::size_t>(s)] = true;
  skip_answers = setup.skip_answers;
  // The operator must answer before the next block is read, so run() returns the actions of each block separately.
  if (!skip_answers.empty()) each_block = true;
  optional_stop_on = setup.optional_stop;
  for (const std::string& axis : setup.mirror)
    if (const auto found = std::find(axis_names.begin(), axis_names.end(), axis); found != axis_names.end())
      mirror_switches[static_cast<std::size_t>(found - axis_names.begin())] = true;
  watch_ = setup.watch;
}

/// Puts in force a modal code of the set-up that this version of Kadr does not support. An alarm is raised only by a block that cannot be
/// executed with this mode (modes_served).
bool Interpreter::note_unsupported() {
  for (std::uint32_t i = 0; i < block->word_count; ++i) {
    const Word& w = block->words[i];
    const std::int32_t index = w.code < 0 ? -1 : def.row_of(w.address, w.code);
    if (index < 0 || def.codes[static_cast<std::size_t>(index)].works || !def.codes[static_cast<std::size_t>(index)].modal) continue;
    const CodeRow& row = def.codes[static_cast<std::size_t>(index)];
    modal.rows[row.group] = static_cast<std::int16_t>(index);
    unsupported |= std::uint64_t{1} << row.group;
    return true;
  }
  return false;
}

/// Executes the power-on code of each group and the code words of the set-up as a block that moves nothing.
void Interpreter::start_modal(const Setup& setup) {
  modal.diameter = def.diameter;
  for (std::size_t a = 0; a < axis_count && def.diameter_by_setup; ++a)
    if (const auto found = setup.diameter.find(axis_names[a]); found != setup.diameter.end())
      modal.diameter = found->second ? modal.diameter | 1u << a : modal.diameter & ~(1u << a);
  static std::function<void(const AlarmReport&)> nobody;
  ActionBatch unseen;
  batch = &unseen;
  on_warning = &nobody;
  flow.set_started(true);
  std::string words;
  for (const GroupRow& group : def.groups)
    if (group.power_on >= 0) words += def.codes[static_cast<std::size_t>(group.power_on)].code + " ";
  const auto run_words = [&](const std::string& text) {
    Grammar plain = def.grammar;
    plain.block_number_required = false;
    plain.block_length = 0;
    for (WordFormat& w : plain.words)
      if (w.code) w.at_most = 0;
    block->clear();
    if (!lex_block(text, 0, true, plain, *block) || note_unsupported()) return;
    (void)execute_block();
  };
  if (!dialect->start(*this, setup)) run_words(words);
  if (const std::string started = dialect->start_words(); !started.empty()) run_words(started);
  for (const std::string& word : setup.modal)
    if (start_fault.empty() && !starts(word)) start_fault = start_fault_of("modal", texts::control_start::no_modal_word, def.id, word);
  std::string given;
  for (const std::string& word : setup.modal) {
    if (dialect->starts_code_by_code()) run_words(word);
    else given += word + " ";
  }
  run_words(given);
  if (setup.feed) {
    modal.feed = *setup.feed;
    modal.feed_known = true;
  }
  modal.rpm = setup.spindle().rpm;
  modal.spindle = setup.spindle().dir == "cw" ? SpindleDir::cw : setup.spindle().dir == "ccw" ? SpindleDir::ccw : SpindleDir::stop;
  modal.tool = modal.tool_selected = static_cast<std::uint32_t>(std::max(setup.tool, 0));
  apply_mirror();
  dialect->take_setup(*this, setup);
  refresh_frames();
  const Axes start = axes_of(setup.start, axis_names);
  for (std::size_t a = 0; a < max_axes && frames.is_plain(); ++a) {
    const double shift = frames.origin[a] + frames.length[a];
    position.machine[a] = setup.start_in_work ? start[a] + shift : start[a];
    position.work[a] = position.machine[a] - shift;
  }
  if (!frames.is_plain()) {
    position.machine = setup.start_in_work ? frames.machine_of(start) : start;
    position.work = frames.work_of(position.machine);
  }
  dialect->roll(*this, position.work), dialect->roll(*this, position.machine);
  position.programmed = transform.to_programmed(position.work);
  dialect->started(*this);
  flow.set_started(false);
  block->clear();
  batch = nullptr;
}

/// Returns true if the control's table has a code with this name, such as `G54`.
bool Interpreter::starts(const std::string& text) const {
  if (text.size() < 2) return false;
  if (text[0] < 'A' || text[0] > 'Z') return false;
  if (text[0] != 'G' && text[0] != 'M') return def.grammar.word(text[0]).known;
  const double tenth = std::strtod(text.c_str() + 1, nullptr) * 10 + 0.5;
  return tenth >= 0 && tenth < ControlDef::max_tenths && def.row_of(text[0], static_cast<std::int32_t>(tenth)) >= 0;
}

}  // namespace kadr
