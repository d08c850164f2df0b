// G41, G42, G41.1, G42.1 (spec/linuxcnc 7.5; convert_cutter_compensation_on of LinuxCNC's source). The corners of the path are computed in
// the room path.

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstdint>

#include "control/emitter.h"
#include "control/functions/cutter_compensation.h"
#include "control/functions/functions.h"
#include "control/linuxcnc/linuxcnc.h"

namespace kadr::functions {
namespace {

constexpr std::uint8_t unknown_nose =
    // Number for a lathe tool whose orientation is not in the table of orientations 0 to 9. The path of such a tool is the path of its nose
    // centre, and its entry motion before an arc differs from that of other tools.
    10;

/// Returns the number of the imaginary tip (Motion::nose) for an orientation of the tool table. LinuxCNC draws the tips with X pointing
/// down (latheorigin_x and latheorigin_z of its source), so the two numbers differ by a mirror image in X.
std::uint8_t nose_of(double orientation) {
  constexpr std::array<std::uint8_t, 10> noses{0, 4, 3, 2, 1, 5, 8, 7, 6, 9};
  return orientation < 0 || orientation > 9 ? unknown_nose : noses[static_cast<std::size_t>(orientation)];
}

}  // namespace

/// Starts cutter compensation. arg 41, 42 (G41, G42): the radius is in the tool table. arg 411, 421 (G41.1, G42.1): the word D is the
/// tool's diameter.
Status tool_side(Emitter& m, const Call& call) {
  const linuxcnc::LinuxCnc& control = linuxcnc::linuxcnc_of(m);
  const int code = call.row->arg;
  const bool by_word = code > 100;
  const auto wrong = [&](std::string text) { return control.fault(AlarmId::rs274_compensation, call.where, std::move(text)); };
  if (m.modal.plane == Plane::yz || linuxcnc::is_plane_of_uvw(m)) return wrong("Cutter radius compensation allowed only in XY, XZ planes");
  if (m.modal.radius_side != 0) return wrong("Cannot turn cutter radius comp on when on");
  double diameter = 0, orientation = 0;
  if (by_word) {
    if (!m.has('D')) return wrong(fmt::format("G{}.1 with no D word", code / 10));
    if (m.has('L') && m.modal.plane != Plane::zx) return wrong(fmt::format("G{}.1 with L word, but plane is not G18", code / 10));
    diameter = m.length_value('D');
    orientation = m.has('L') ? std::round(m.value('L')) : 0;
  } else {
    const double d = m.has('D') ? m.value('D') : 0;
    if (d < 0 || std::fabs(d - std::round(d)) > 1e-4) return wrong(fmt::format("G{} requires D word to be a whole number", code));
    const double number = std::round(d) == 0 ? m.modal.tool : std::round(d);
    const linuxcnc::Tool* const tool = control.tool(number);
    if (tool == nullptr && number != 0)
      return control.fault(AlarmId::rs274_tool, call.where, fmt::format("Requested tool {:.0f} not found in the tool table", number));
    orientation = tool == nullptr ? 0 : tool->orientation;
    if (orientation != 0 && orientation != 9 && m.modal.plane == Plane::xy)
      return wrong(fmt::format("G{} with lathe tool, but plane is not G18", code));
    diameter = tool == nullptr ? 0 : tool->diameter;
    m.modal.offset_number = static_cast<std::uint32_t>(number);
  }
  const bool left = code == 41 || code == 411;
  const double radius = diameter / 2;
  m.modal.radius_by_word = std::fabs(radius);
  m.modal.nose = nose_of(orientation);
  return begin_compensation(m, call, static_cast<std::int8_t>((radius < 0) != left ? -1 : +1));
}

}  // namespace kadr::functions
