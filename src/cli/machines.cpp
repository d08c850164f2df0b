// kadr machines: lists the built-in machine profiles, or describes one of them.

#include <fmt/core.h>

#include "cli/job/terminal.h"
#include "cli/options/options.h"
#include "config/language.h"
#include "config/machine/machine_profile.h"
#include "kinematics/machine_tree.h"
#include "out/text/source_line.h"

namespace kadr::cli {
namespace {

std::string name_of(const MachineProfile& machine) { return told(machine.name_en, machine.name_ru); }

/// Pads the text to `width` characters.
std::string padded(std::string text, std::size_t width) {
  const std::size_t characters = characters_before(text, text.size());
  if (characters < width) text += std::string(width - characters, ' ');
  return text;
}

std::string number_of(double value) { return fmt::format("{:.12g}", value); }

/// Returns "X Y 30000, Z 24000": neighbouring axes with the same rapid rate are grouped.
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
  type_out("{}{}{}\n", padded(told("id", "обозначение"), id_width), padded(told("machine", "станок"), name_width),
           told("rapid rates, mm/min, degrees/min", "быстрые ходы, мм/мин, град/мин"));
  for (const std::string& id : built_in_machines()) {
    const auto machine = load_machine(id);
    if (machine) type_out("{}{}{}\n", padded(id, id_width), padded(name_of(*machine), name_width), rapids_of(*machine));
  }
}

std::string planner_of(const MachineProfile& machine) {
  switch (machine.planner) {
    case PlannerMode::control: return told("as the control makes it with these accelerations", "как её ведёт УЧПУ с этими ускорениями");
    case PlannerMode::optimal: return told("the least time", "наименьшее время");
    default: return told("programmed feeds and rapid rates", "программные подачи и быстрые ходы");
  }
}

std::string travel_of(const AxisProfile& axis) {
  if (axis.least <= AxisProfile{}.least && axis.most >= AxisProfile{}.most) return told("no limits", "без пределов");
  const std::string least = axis.least <= AxisProfile{}.least ? "…" : number_of(axis.least);
  return least + " … " + (axis.most >= AxisProfile{}.most ? "" : number_of(axis.most));
}

/// Returns "A (about [1, 0, 0], through [-400, -250, -420], reversed)".
std::string joint_text(const std::string& name, const AxisJoint& joint) {
  if (!joint.turns) return name;
  const auto vector = [](Vec3 v) { return fmt::format("[{:.12g}, {:.12g}, {:.12g}]", v.x, v.y, v.z); };
  return fmt::format("{} ({} {}, {} {}{})", name, told("about", "вокруг"), vector(joint.direction), told("through", "через"),
                     vector(joint.through), joint.reversed ? told(", reversed", ", обратно") : "");
}

/// Prints the order in which the axes carry each other and, where it applies, why NCT parameters cannot express it.
void print_chains(const MachineProfile& machine) {
  const auto chain = [&](const std::string& what, const std::vector<std::string>& names) {
    std::string text = told("bed", "станина");
    for (const std::string& name : names) text += " → " + joint_text(name, machine.axes.at(name).joint);
    type_out("{}{} → {}\n", padded(what, 20), text, what);
  };
  chain(told("tool", "инструмент"), machine.chains.tool);
  chain(told("part", "деталь"), machine.chains.part);
  std::vector<std::string> names;
  for (const auto& [name, axis] : machine.axes) names.push_back(name);
  const auto five = MachineTree(machine, names).five_axis();
  if (!five)
    type_out("{}{}\n", padded(told("N3200 to N3224", "N3200–N3224"), 20), told("do not say it: ", "этого не выражают: ") + five.error());
}

void print_one(const MachineProfile& machine) {
  constexpr std::size_t first = 20, column = 18;
  type_out("{}: {}\n", machine.id, name_of(machine));
  const auto line = [](const std::string& what, const std::string& value) { type_out("{}{}\n", padded(what, first), value); };
  line(told("speed", "скорость"), planner_of(machine));
  line(told("tool change", "смена инструмента"), number_of(machine.tool_change_s) + told(" s", " с"));
  line(told("spindle start", "разгон шпинделя"), number_of(machine.spindle_start_s) + told(" s", " с"));
  if (machine.most_rpm > 0) line(told("spindle speed", "частота шпинделя"), told("at most ", "не более ") + number_of(machine.most_rpm));
  line(told("corners within", "допуск на углах"), number_of(machine.tolerance) + told(" mm", " мм"));
  type_out("{}{}{}{}{}\n", padded(told("axis", "ось"), 5), padded(told("rapid rate /min", "быстрый ход /мин"), column),
           padded(told("travel", "перемещение"), column), padded(told("acceleration /s²", "ускорение /с²"), column),
           told("jerk /s³", "рывок /с³"));
  for (const auto& [name, axis] : machine.axes)
    type_out("{}{}{}{}{}\n", padded(name, 5), padded(number_of(axis.rapid), column), padded(travel_of(axis), column),
             padded(number_of(axis.acceleration), column), number_of(axis.jerk));
  if (machine.chains.given()) print_chains(machine);
  type_out("{}\n", told("mm, of rotary axes degrees; travel in machine coordinates",
                        "мм, у поворотных осей градусы; перемещение в координатах станка"));
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
