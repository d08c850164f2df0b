#pragma once
// What is to be told of a milled area: lines, the warning of holes, the place of a fault in the drawing, the picture.

#include <string>
#include <vector>

#include "action/action.h"
#include "config/alarm_texts.h"
#include "out/picture/mill_picture.h"
#include "session/milling/milling.h"

namespace kadr {

struct MillLine {
  std::string name, value;
};

/// Zone, scheme, path, wall, what stays, plunges, holes to be drilled, the program.
std::vector<MillLine> mill_summary(const Milled& milled, Lang lang);

/// Holes without which the tool breaks, empty: none. Said even to those who want no summary.
std::string warning_of_holes(const Milled& milled, Lang lang);

/// A fault with its line of the drawing, for people; `file` names the drawing.
AlarmReport report_of(const ContourFault& fault, std::string_view drawing, const std::string& file);

/// Refers to `milled`.
MillPicture mill_picture(const Milled& milled, const ControlDef& def, const std::string& title, Lang lang);

}  // namespace kadr
