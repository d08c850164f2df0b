#include "control/functions/rotary_machine.h"

#include <algorithm>
#include <string>

#include "lang/block/block.h"

namespace kadr {

FiveAxis rotary_machine(const KinematicsSetup& given, const ControlDef& def, std::uint64_t missing) {
  FiveAxis machine;
  if (given.axes.size() != 2) return machine;
  for (const std::size_t n : {0U, 1U}) {
    const char letter = given.axes[n];
    const auto at = std::find(def.axes.begin(), def.axes.end(), std::string(1, letter));
    if (at == def.axes.end() || (missing & letter_bit(letter)) != 0) return FiveAxis();
    RotaryJoint& joint = n == 0 ? machine.first : machine.second;
    joint.axis = static_cast<int>(at - def.axes.begin());
    joint.direction = letter == 'A' ? Vec3{1, 0, 0} : letter == 'B' ? Vec3{0, 1, 0} : Vec3{0, 0, 1};
    joint.sense = given.reversed.find(letter) != std::string::npos ? -1 : 1;
  }
  machine.group = given.type == "head-head"     ? MachineGroup::head_head
                  : given.type == "table-table" ? MachineGroup::table_table
                  : given.type == "head-table"  ? MachineGroup::head_table
                                                : MachineGroup::none;
  const auto vector = [&](const char* name, Vec3& to) {
    if (const auto found = given.vectors.find(name); found != given.vectors.end())
      to = {found->second[0], found->second[1], found->second[2]};
  };
  vector("T1", machine.table);
  vector("T2", machine.second_table);
  vector("E", machine.holder);
  vector("D", machine.head);
  return machine;
}

}  // namespace kadr
