#pragma once
// InForce: one named value that is in force between two blocks: a position, a code, a feed … The user can inspect and set such values
// before a program continues.

#include <cstdint>
#include <string>
#include <vector>

namespace kadr {

struct InForce {
  enum class Kind : std::uint8_t {
    position,       // position of an axis in work coordinates, mm or degrees
    machine,        // position of an axis in machine coordinates, mm or degrees
    code,           // code in force in a modal group
    feed,           // feed in mm/min, mm/rev or 1/min; the code in force in the feed's modal group selects the unit
    speed,          // spindle speed: the number after S, rev/min or m/min
    spindle,        // state of the main spindle: `code` is M3, M4 or M5
    coolant,        // state of the coolant: `code` is M7, M8 or M9
    tool,           // number of the tool in the spindle
    selected,       // number of the selected tool: the number after T
    offset,         // number of the offset in force: the number after D
    length_offset,  // number of the tool length offset in force: the number after H
    origin,         // origin of the work system with all its shifts: machine coordinate of one axis, mm or degrees
    length,         // tool length along an axis, mm
    rotation,       // angle of the rotation of the plane, degrees
    scale,          // scale factor of an axis; negative if the axis is mirrored
    variable,       // value of a variable; `name` is spelled as in a program
  };
  Kind kind = Kind::position;
  std::string name{};  // name of the axis, modal group or variable that the value belongs to
  std::string code{};
  double value = 0;
  friend bool operator==(const InForce&, const InForce&) = default;
};

}  // namespace kadr
