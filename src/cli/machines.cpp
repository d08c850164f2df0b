// kadr machines: lists the built-in machine profiles, or describes one of the profiles.

#include <fmt/core.h>

#include "cli/job/terminal.h"
#include "cli/options/options.h"
#include "config/machine/machine_profile.h"
#include "kinematics/machine_tree.h"
#include "out/text/source_line.h"
#include "texts/machines_command.h"

namespace kadr::cli {
namespace {

std::string name_of(const MachineProfile& machine) { return thread_language() == Lang::ru ? machine.name_ru : machine.name_en; }

/// Adds blanks to the text until it has `width` characters.
std::string padded(std::string text, std::size_t width) {
  const std::size_t characters = characters_before(text, text.size());
  if (characters < width) text += std::string(width - characters, ' ');
  return text;
}

std::string number_of(double value) { return fmt::format("{:.12g}", value); }

/// Returns the rapid rates of the axes, e.g. "X Y 30000, Z 24000" (mm/min). Neighbouring axes with the same rate are in one group.
std::string rapids_of(const MachineProfile& machine) {
  std::string list, axes;
  for (auto axis = machine.axes.begin(); axis != machine.axes.end(); ++axis) {
    axes += (axes.empty() ? "" : " ") + axis->first;
    const auto next = std::next(axis);
    if (next != machine.axes.end() && next->second.rapid == axis->second.rapid) continue;
    list += (list.empty() ? "" : ", ") + axes + " " + number_of(axis->second.rapid);
    axes.clear();
  }
  return list;
}

void print_list() {
  constexpr std::size_t id_width = 15, name_width = 42;
  type_out("{}{}{}\n", padded(translated(texts::machines_command::id), id_width),
           padded(translated(texts::machines_command::machine), name_width), translated(texts::machines_command::rapid_rates));
  for (const std::string& id : built_in_machines()) {
    const auto machine = load_machine(id);
    if (machine) type_out("{}{}{}\n", padded(id, id_width), padded(name_of(*machine), name_width), rapids_of(*machine));
  }
}

std::string planner_of(const MachineProfile& machine) {
  switch (machine.planner) {
    case PlannerMode::control: return translated(texts::machines_command::as_the_control_makes_it);
    case PlannerMode::optimal: return translated(texts::machines_command::least_time);
    default: return translated(texts::machines_command::programmed_feeds);
  }
}

std::string travel_of(const AxisProfile& axis) {
  if (axis.least <= AxisProfile{}.least && axis.most >= AxisProfile{}.most) return translated(texts::machines_command::no_limits);
  const std::string least = axis.least <= AxisProfile{}.least ? "…" : number_of(axis.least);
  return least + " … " + (axis.most >= AxisProfile{}.most ? "" : number_of(axis.most));
}

/// Returns the description of a rotary axis, e.g. "A (about [1, 0, 0], through [-400, -250, -420], reversed)".
std::string joint_text(const std::string& name, const AxisJoint& joint) {
  if (!joint.turns) return name;
  const auto vector = [](Vec3 v) { return fmt::format("[{:.12g}, {:.12g}, {:.12g}]", v.x, v.y, v.z); };
  const auto turning = joint.reversed ? texts::machines_command::turning_reversed : texts::machines_command::turning;
  return translated(turning, name, vector(joint.direction), vector(joint.through));
}

/// Prints the order in which the axes carry each other. If NCT parameters cannot describe that order, the reason is printed too.
void print_chains(const MachineProfile& machine) {
  const auto chain = [&](const std::string& what, const std::vector<std::string>& names) {
    std::string text = translated(texts::machines_command::bed);
    for (const std::string& name : names) text += " → " + joint_text(name, machine.axes.at(name).joint);
    type_out("{}{} → {}\n", padded(what, 20), text, what);
  };
  chain(translated(texts::machines_command::tool), machine.chains.tool);
  chain(translated(texts::machines_command::part), machine.chains.part);
  std::vector<std::string> names;
  for (const auto& [name, axis] : machine.axes) names.push_back(name);
  const auto five = MachineTree(machine, names).five_axis();
  if (!five)
    type_out("{}{}\n", padded(translated(texts::machines_command::nct_parameters), 20),
             translated(texts::machines_command::nct_parameters_cannot, five.error()));
}

void print_one(const MachineProfile& machine) {
  constexpr std::size_t first = 20, column = 18;
  type_out("{}: {}\n", machine.id, name_of(machine));
  const auto line = [](const std::string& what, const std::string& value) { type_out("{}{}\n", padded(what, first), value); };
  line(translated(texts::machines_command::speed), planner_of(machine));
  line(translated(texts::machines_command::tool_change), translated(texts::machines_command::seconds, number_of(machine.tool_change_s)));
  line(translated(texts::machines_command::spindle_start),
       translated(texts::machines_command::seconds, number_of(machine.spindle_start_s)));
  if (machine.most_rpm > 0)
    line(translated(texts::machines_command::spindle_speed), translated(texts::machines_command::at_most, number_of(machine.most_rpm)));
  line(translated(texts::machines_command::corners_within), translated(texts::machines_command::millimetres, number_of(machine.tolerance)));
  type_out("{}{}{}{}{}\n", padded(translated(texts::machines_command::axis), 5),
           padded(translated(texts::machines_command::rapid_rate), column), padded(translated(texts::machines_command::travel), column),
           padded(translated(texts::machines_command::acceleration), column), translated(texts::machines_command::jerk));
  for (const auto& [name, axis] : machine.axes)
    type_out("{}{}{}{}{}\n", padded(name, 5), padded(number_of(axis.rapid), column), padded(travel_of(axis), column),
             padded(number_of(axis.acceleration), column), number_of(axis.jerk));
  if (machine.chains.given()) print_chains(machine);
  type_out("{}\n", translated(texts::machines_command::units));
}

}  // namespace

int list_machines(const std::string& id) {
  if (id.empty()) {
    print_list();
    return ok;
  }
  const auto machine = load_machine(id);
  if (!machine) {
    complain(machine.error());
    return wrong_usage;
  }
  print_one(*machine);
  return ok;
}

}  // namespace kadr::cli
