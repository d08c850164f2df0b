#pragma once
// InForce: one named item of what is in force between two blocks. A person inspects and sets these before a program continues.

#include <cstdint>
#include <string>
#include <vector>

namespace kadr {

struct InForce {
  enum class Kind : std::uint8_t {
    position,       // of an axis, in work coordinates, mm or degrees
    machine,        // of an axis, in machine coordinates
    code,           // in force in a modal group: `code`
    feed,           // mm/min, mm/rev or 1/min, according to the code of the feed's modal group
    speed,          // S
    spindle,        // of the main spindle: `code` M3, M4, M5
    coolant,        // `code` M7, M8, M9
    tool,           // in the spindle
    selected,       // T
    offset,         // D
    length_offset,  // H
    origin,         // of the work system, all shifts included: machine coordinate of one axis
    length,         // tool length along an axis
    rotation,       // of the plane, degrees
    scale,          // of an axis; negative if mirrored
    variable,       // `name` as the program writes it
  };
  Kind kind = Kind::position;
  std::string name{};  // name of the axis, group or variable
  std::string code{};
  double value = 0;
  friend bool operator==(const InForce&, const InForce&) = default;
};

}  // namespace kadr
