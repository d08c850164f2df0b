#pragma once
// Describes a milled area for the user: the lines of the summary, the warning about holes to be drilled, the location of a fault in the
// drawing, and the picture.

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

/// Returns the lines of the summary: area, milling scheme, path, wall, remaining stock, plunges, holes to be drilled, and the program.
std::vector<MillLine> mill_summary(const Milled& milled, Lang lang);

/// Returns a warning about holes that must be drilled first, since the tool would break without them. The warning is empty if no holes are
/// needed. It is displayed even if the user requests no summary.
std::string warning_of_holes(const Milled& milled, Lang lang);

/// Describes a fault in a drawing, with the faulty line. `drawing`: text of the drawing. `file`: its name.
AlarmReport report_of(const DrawingFault& fault, std::string_view drawing, const std::string& file);

/// Creates the picture. The picture refers to `milled`, so `milled` must outlive the picture.
MillPicture mill_picture(const Milled& milled, const ControlDef& def, const std::string& title, Lang lang);

}  // namespace kadr
