#pragma once
// ToolGeometry: what a tool looks like, as tools files and libraries say it (design.md 10). Lengths mm, angles degrees.

#include <cstdint>
#include <string>
#include <vector>

namespace kadr {

/// flat, ball, bull: end mills; taper: of half angle `angle`, of its diameter where the flutes end; chamfer: of full point angle `angle`,
/// as a drill; form: by its profile.
enum class ToolKind : std::uint8_t { flat, ball, bull, drill, taper, chamfer, tslot, form };

/// Of the outline of a body of revolution.
struct ProfilePoint {
  double diameter = 0;
  double height = 0;  // above the tip; of a holder above its own face
  friend bool operator==(const ProfilePoint&, const ProfilePoint&) = default;
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
};

}  // namespace kadr
