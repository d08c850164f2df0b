#pragma once
// What is in force between two blocks, thing by thing with its name: what a person looks at and sets before a program goes on.

#include <cstdint>
#include <string>
#include <vector>

namespace kadr {

struct InForce {
  enum class Kind : std::uint8_t {
    position,       // of an axis, work coordinates, mm or degrees
    machine,        // of an axis, machine coordinates
    code,           // of a modal group: `code`
    feed,           // mm/min, mm/rev or 1/min by the code of its group
    speed,          // S
    spindle,        // of the main spindle: `code` M3, M4, M5
    coolant,        // `code` M7, M8, M9
    tool,           // in the spindle
    selected,       // T
    offset,         // D
    length_offset,  // H
    origin,         // of the work system, all shifts included: machine coordinate of an axis
    length,         // of the tool, along an axis
    rotation,       // of the plane, degrees
    scale,          // of an axis, negative where it is mirrored
    variable,       // `name` as the program writes it
  };
  Kind kind = Kind::position;
  std::string name{};  // of the axis, the group, the variable
  std::string code{};
  double value = 0;
  friend bool operator==(const InForce&, const InForce&) = default;
};

}  // namespace kadr
