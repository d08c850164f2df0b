#pragma once
// Describes a milled area for the user: the lines of the summary, the warning about plunge holes, the location of a fault in the drawing,
// the picture.

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

/// Returns the lines of the summary: area, milling scheme, path, wall, remaining stock, plunges, holes to be drilled, the program.
std::vector<MillLine> mill_summary(const Milled& milled, Lang lang);

/// Returns a warning of holes that must be drilled first, or the tool breaks; empty if none are needed. The warning is displayed even if no
/// summary is requested.
std::string warning_of_holes(const Milled& milled, Lang lang);

/// Describes a fault, with its line of the drawing. `file`: name of the drawing.
AlarmReport report_of(const DrawingFault& fault, std::string_view drawing, const std::string& file);

/// Creates the picture. It refers to `milled`, which must outlive it.
MillPicture mill_picture(const Milled& milled, const ControlDef& def, const std::string& title, Lang lang);

}  // namespace kadr
