// Copies values from a machine's file into the set-up. This file is used by session and tested by tests/session/give_machine_test.cpp.

#include "session/give_machine.h"

#include <algorithm>
#include <cmath>

#include "config/setup/setup_names.h"
#include "kinematics/machine_tree.h"
#include "motion/time/estimate.h"

namespace kadr {
namespace {

constexpr const char* first_parameter = "3200";
constexpr const char* last_parameter = "3224";

bool has_kinematics_parameters(const ControlDef& control) {
  return std::any_of(control.parameters.begin(), control.parameters.end(),
                     [](const ParameterRow& row) { return row.name == first_parameter; });
}

bool has_kinematics(const Setup& setup) {
  return std::any_of(setup.parameters.begin(), setup.parameters.end(),
                     [](const auto& given) { return given.first.name >= first_parameter && given.first.name <= last_parameter; });
}

/// Returns the names of the machine's axes: X, Y and Z first, as far as the kinematic chains have them, then the other axes of the chains.
/// In each chain, an axis comes before the axes that it carries. On a lathe's control the axis Y comes last, behind C: X Z C Y. INFERRED:
/// the order of axes beyond X and Z is the machine builder's.
std::vector<std::string> axes_of(const MachineProfile& profile, bool lathe) {
  const auto in = [](const std::vector<std::string>& list, const std::string& name) {
    return std::find(list.begin(), list.end(), name) != list.end();
  };
  std::vector<std::string> axes;
  for (const char* const name : {"X", "Y", "Z"})
    if (!(lathe && name[0] == 'Y') && (in(profile.chains.tool, name) || in(profile.chains.part, name))) axes.emplace_back(name);
  const auto& first = lathe ? profile.chains.part : profile.chains.tool;
  const auto& second = lathe ? profile.chains.tool : profile.chains.part;
  for (const auto* chain : {&first, &second})
    for (const std::string& name : *chain)
      if (!in(axes, name)) axes.push_back(name);
  return axes;
}

/// The direction of a line as parameter N3205 states it: a code, and an inclination in degrees. A line outside the three coordinate planes
/// has no code (nct 25.1, spec/nct/25a 3).
struct DirectionCode {
  int code = 0;
  double inclination = 0;
  bool turned = false;  // true: the code stands for the opposite direction of the line
};
std::optional<DirectionCode> code_of(Vec3 d) {
  const double parts[] = {d.x, d.y, d.z};
  for (int i = 0; i < 3; ++i)
    if (std::fabs(parts[i]) == 1) return DirectionCode{i + 1, 0, parts[i] < 0};
  if (d.z == 0) return DirectionCode{4, std::atan2(d.y, d.x) / rad_per_deg};
  if (d.x == 0) return DirectionCode{5, std::atan2(d.z, d.y) / rad_per_deg};
  if (d.y == 0) return DirectionCode{6, std::atan2(d.x, d.z) / rad_per_deg};
  return std::nullopt;
}

void give_kinematics(Setup& setup, const FiveAxis& five) {
  const auto first = code_of(five.first.direction), second = code_of(five.second.direction);
  if (!first || !second) return;
  const auto give = [&](int number, double value) { setup.parameters.emplace(ParameterKey{std::to_string(number), "", ""}, value); };
  give(3200, static_cast<double>(five.group));
  give(3201, five.tool.x == 1 ? 1 : five.tool.y == 1 ? 2 : 3);
  const auto joint = [&](int number, const char* reversed, const RotaryJoint& of, const DirectionCode& code) {
    give(number, of.axis + 1);
    give(number + 1, code.code);
    give(number + 2, code.inclination);
    setup.parameters.emplace(ParameterKey{"3212", "", reversed}, (of.sense < 0) != code.turned ? 1. : 0.);
  };
  joint(3204, "RD1", five.first, *first);
  joint(3208, "RD2", five.second, *second);
  const auto vector = [&](int number, Vec3 v) {
    give(number, v.x);
    give(number + 1, v.y);
    give(number + 2, v.z);
  };
  vector(3213, five.table);
  vector(3216, five.second_table);
  vector(3219, five.holder);
  vector(3222, five.head);
}

/// Returns the letter of the axis if it turns about X, Y or Z as A, B or C do; 0 for any other axis.
char letter_of(const RotaryJoint& joint, const std::vector<std::string>& axes) {
  const std::string& name = axes[static_cast<std::size_t>(joint.axis)];
  const Vec3 about = name == "A" ? Vec3{1, 0, 0} : name == "B" ? Vec3{0, 1, 0} : Vec3{0, 0, 1};
  const bool usual = (name == "A" || name == "B" || name == "C") && std::fabs(dot(about, joint.direction)) == 1;
  return usual ? name[0] : '\0';
}

/// Gives the kinematics as the set-up has them for controls without parameters for them (KinematicsSetup).
void give_kinematics_in_words(KinematicsSetup& kinematics, const FiveAxis& five, const std::vector<std::string>& axes) {
  const char first = letter_of(five.first, axes), second = letter_of(five.second, axes);
  if (first == 0 || second == 0 || five.tool.z != 1) return;
  kinematics.type = five.has_head() && five.has_table() ? "head-table" : five.has_head() ? "head-head" : "table-table";
  kinematics.axes = {first, second};
  for (const RotaryJoint* const joint : {&five.first, &five.second}) {
    const bool backwards = joint->direction.x + joint->direction.y + joint->direction.z < 0;
    if ((joint->sense < 0) != backwards) kinematics.reversed += letter_of(*joint, axes);
  }
  const auto give = [&](const char* name, Vec3 v) { kinematics.vectors[name] = {v.x, v.y, v.z}; };
  give("T1", five.table);
  give("T2", five.second_table);
  give("E", five.holder);
  give("D", five.head);
}

/// Returns the machine's axes that the control has too.
std::vector<std::string> axes_in(const std::vector<std::string>& axes, const ControlDef& control) {
  std::vector<std::string> known;
  for (const std::string& name : axes)
    if (std::find(control.axes.begin(), control.axes.end(), name) != control.axes.end()) known.push_back(name);
  return known;
}

}  // namespace

void give_machine(Setup& setup, const MachineProfile& profile, const ControlDef& control) {
  const bool gives_kinematics =
      profile.chains.given() && control.machine_axes() && has_kinematics_parameters(control) && !has_kinematics(setup);
  const bool lathe = control.behaviour.lathe != Lathe::none;
  const bool in_words = profile.chains.given() && !control.machine_axes() && has(control, SetupNeeds::kinematics);
  const bool gives_axes = gives_kinematics || (lathe && profile.chains.given());
  if (gives_axes && setup.axes.empty() && setup.channels.empty()) setup.axes = axes_of(profile, lathe);
  if (in_words && setup.axes.empty()) {
    setup.axes = axes_in(axes_of(profile, false), control);
    const auto five = MachineTree(profile, setup.axes).five_axis();
    if (five && five->first.axis >= 0 && five->second.axis >= 0 && setup.kinematics.type.empty())
      give_kinematics_in_words(setup.kinematics, *five, setup.axes);
  }
  const std::vector<std::string>& axes = setup.axes.empty() ? control.axes : setup.axes;
  for (const auto& [code, text] : profile.m_codes) setup.machine_codes[code] = {text.en, text.ru};
  for (const std::string& axis : axes) setup.axis_limits[axis] = limits_of(profile, setup, axis);
  if (!gives_kinematics) return;
  const auto five = MachineTree(profile, axes).five_axis();
  if (five && five->first.axis >= 0 && five->second.axis >= 0) give_kinematics(setup, *five);
  for (const std::string& axis : axes) {
    const auto found = profile.axes.find(axis);
    if (found != profile.axes.end() && found->second.joint.rolls_over) setup.parameters.emplace(ParameterKey{"0107", axis, "0"}, 1.);
  }
}

}  // namespace kadr
