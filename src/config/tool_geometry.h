#pragma once
// ToolGeometry: what a tool looks like, as tools files and libraries say it (design.md 10). Lengths mm, angles degrees.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace kadr {

/// flat, ball, bull: end mills; taper: of half angle `angle`, of its diameter where the flutes end; chamfer: of full point angle `angle`,
/// as a drill; form: by its profile; turning: an insert that does not spin, see InsertGeometry.
enum class ToolKind : std::uint8_t { flat, ball, bull, drill, taper, chamfer, tslot, form, turning };

/// Of the outline of a body of revolution.
struct ProfilePoint {
  double diameter = 0;
  double height = 0;  // above the tip; of a holder above its own face
  friend bool operator==(const ProfilePoint&, const ProfilePoint&) = default;
};

/// In the half plane of a turning tool, from the programmed point: x along the radius (machine X, or Y where that is the radius), z along
/// Z.
struct InsertPoint {
  double x = 0, z = 0;
  friend bool operator==(const InsertPoint&, const InsertPoint&) = default;
};

/// Of a turning tool. Its `corner` is the nose radius, `angle` the nose's included angle (0: a round insert), `flutes` the length of its
/// cutting edges from the sharp corner, `length` that of the insert's sides.
struct InsertGeometry {
  /// Where the programmed point lies, seen from the centre of the nose: -1, 0, 1 along x and z. Both 0: there.
  int tip_x = 0, tip_z = 0;
  std::optional<double> lead;        // entering angle: of the leading edge with the feed along z that the tip points to, degrees
  double width = 0;                  // of a grooving insert; 0: none
  std::vector<InsertPoint> profile;  // of the cutting part, instead of all this; a simple polygon
  std::vector<InsertPoint> holder;   // a simple polygon; two points: opposite corners of a rectangle
};

struct ToolGeometry {
  std::uint32_t number = 0;
  std::string name;
  ToolKind kind = ToolKind::flat;
  double diameter = 0;
  double corner = 0;                  // radius at the end of a bull nose
  double angle = 0;                   // see ToolKind
  double tip = 0;                     // diameter of the flat end of a chamfer tool or drill
  double flutes = 0;                  // height of the cutting part
  double length = 0;                  // stick-out: where the holder's face stands
  std::vector<ProfilePoint> profile;  // of the cutting part of a form tool
  std::vector<ProfilePoint> shank;    // empty: `diameter` from `flutes` to `length`
  std::vector<ProfilePoint> holder;   // empty: none is known
  bool plunges = true;                // may cut straight down
  int teeth = 0;                      // 0: not known
  InsertGeometry insert;              // of a turning tool
};

}  // namespace kadr
