#pragma once
// ToolGeometry: the shape of a tool, from tools files and libraries (docs/commands/cut.md, "Tools"). Lengths are in mm, angles in degrees.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace kadr {

/// The kind of a tool. flat, ball, bull: end mills. taper: half angle `angle`, with its diameter at the upper end of the flutes. chamfer:
/// full point angle `angle`, as for a drill. form: shape given by a profile. turning: an insert that does not rotate, see InsertGeometry.
enum class ToolKind : std::uint8_t { flat, ball, bull, drill, taper, chamfer, tslot, form, turning };

/// A point on the outline of a body of revolution.
struct ProfilePoint {
  double diameter = 0;
  double height = 0;  // height above the tip; for a holder, height above the holder's own face
  friend bool operator==(const ProfilePoint&, const ProfilePoint&) = default;
};

/// A point in the half plane of a turning tool, relative to the programmed point: x along the radius (machine X, or Y if that is the
/// radius), z along Z.
struct InsertPoint {
  double x = 0, z = 0;
  friend bool operator==(const InsertPoint&, const InsertPoint&) = default;
};

/// The insert of a turning tool. ToolGeometry::corner is the nose radius of the insert, `angle` the included angle of the nose (0: a round
/// insert), `flutes` the length of its cutting edges from the sharp corner, `length` the length of the insert's sides.
struct InsertGeometry {
  /// Direction from the nose's centre to the programmed point: -1, 0, 1 along x and z. Both 0: the programmed point is the centre.
  int tip_x = 0, tip_z = 0;
  // Entering angle, degrees: between the leading cutting edge and the feed direction along z that the tip points to
  std::optional<double> lead;
  double width = 0;                  // width of a grooving insert; 0: not a grooving insert
  std::vector<InsertPoint> profile;  // outline of the cutting part, a simple polygon; if given, it replaces the values above
  std::vector<InsertPoint> holder;   // outline of the holder, a simple polygon; two points: opposite corners of a rectangle
};

struct ToolGeometry {
  std::uint32_t number = 0;
  std::string name;
  ToolKind kind = ToolKind::flat;
  double diameter = 0;
  double corner = 0;                  // corner radius of a bull nose mill
  double angle = 0;                   // angle of a taper, drill or chamfer tool (see ToolKind), or of an insert's nose
  double tip = 0;                     // diameter of the flat end of a chamfer tool or drill
  double flutes = 0;                  // height of the cutting part (flute length)
  double length = 0;                  // stick-out: height of the holder's face above the tip
  std::vector<ProfilePoint> profile;  // outline of the cutting part of a form tool
  std::vector<ProfilePoint> shank;    // outline of the shank; empty: a cylinder of `diameter` from `flutes` to `length`
  std::vector<ProfilePoint> holder;   // outline of the holder; empty: not known
  bool plunges = true;                // the tool may cut straight down
  int teeth = 0;                      // number of cutting edges; 0: not known
  InsertGeometry insert;              // the insert, only for a turning tool
};

}  // namespace kadr
