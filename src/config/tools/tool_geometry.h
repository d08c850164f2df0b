#pragma once
// ToolGeometry: the shape of a tool, from tools files and libraries (docs/commands/cut.md, "Tools"). Lengths are in mm, angles in degrees.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace kadr {

/// The kind of a tool. flat, ball, bull: end mills. taper: `angle` is half the taper angle, and the diameter is that at the upper end of
/// the flutes. chamfer: `angle` is the full point angle, as for a drill. form: a profile describes the shape. turning: an insert that does
/// not rotate, see InsertGeometry.
enum class ToolKind : std::uint8_t { flat, ball, bull, drill, taper, chamfer, tslot, form, turning };

/// A point on the outline of a rotating tool or holder.
struct ProfilePoint {
  double diameter = 0;
  double height = 0;  // height above the tip, mm; for a holder, height above the lower face of the holder
  friend bool operator==(const ProfilePoint&, const ProfilePoint&) = default;
};

/// A point in the half plane of a turning tool, in mm from the programmed point. x is along the radius (machine X, or Y if the part's
/// radius is along Y), z is along Z.
struct InsertPoint {
  double x = 0, z = 0;
  friend bool operator==(const InsertPoint&, const InsertPoint&) = default;
};

/// The insert of a turning tool. In ToolGeometry, `corner` is the nose radius of the insert, `angle` the included angle of the nose (0: a
/// round insert), `flutes` the length of the cutting edges from the sharp corner, and `length` the length of the insert's sides.
struct InsertGeometry {
  /// Direction, -1, 0 or 1 along x and z, from the nose's centre to the programmed point. If both are 0, the programmed point is the nose's
  /// centre.
  int tip_x = 0, tip_z = 0;
  // Entering angle, degrees: the angle between the leading cutting edge and the feed direction, which is the direction along z in which the
  // tip points.
  std::optional<double> lead;
  double width = 0;  // width of a grooving insert, mm; 0: the insert is not for grooving
  // Outline of the insert's cutting part, a simple polygon; if it has points, it replaces the nose, angles and width of the insert
  std::vector<InsertPoint> profile;
  std::vector<InsertPoint> holder;  // outline of the holder, a simple polygon; two points are opposite corners of a rectangle
};

struct ToolGeometry {
  std::uint32_t number = 0;
  std::string name;
  ToolKind kind = ToolKind::flat;
  double diameter = 0;
  double corner = 0;                  // corner radius of a bull nose mill, mm
  double angle = 0;                   // angle of a taper, drill or chamfer tool (see ToolKind), or of an insert's nose, degrees
  double tip = 0;                     // diameter of the flat end of a chamfer tool or drill, mm
  double flutes = 0;                  // height of the cutting part (flute length), mm
  double length = 0;                  // stick-out, mm: height of the holder's lower face above the tip
  std::vector<ProfilePoint> profile;  // outline of the cutting part of a form tool
  std::vector<ProfilePoint> shank;    // outline of the shank; empty: the shank is a cylinder of `diameter` from `flutes` to `length`
  std::vector<ProfilePoint> holder;   // outline of the holder; empty: the shape of the holder is not known
  bool plunges = true;                // true if the tool can cut while it moves straight down
  int teeth = 0;                      // number of cutting edges; 0: the number is not known
  InsertGeometry insert;              // insert of the tool; only for a turning tool
};

}  // namespace kadr
