#pragma once
// Converts a CutResult to text: the summary on stdout, and JSON (docs/commands/cut.md).

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "config/alarm_texts.h"
#include "stock/cut_result.h"

namespace kadr {

/// Returns a caption of one line, e.g. "removed 82581.4 mm³, cell 0.25 mm". If a window (part of the blank that is cut with finer cells) is
/// given, the caption describes only the window.
std::string cut_caption(const CutResult& result, Lang lang);

/// Returns a message that lists the tools that are too thin for the cell size of the stock, so that their cuts are hardly visible; empty if
/// there are no such tools.
std::string too_coarse_message(const CutResult& result, Lang lang);

std::string cut_summary(const CutResult& result, Lang lang);

/// Returns the result of the cut as one JSON object. `alarms`, `warnings`: how many alarms and warnings the program has raised on the
/// control; those of the cut are not included.
nlohmann::ordered_json cut_json(const CutResult& result, std::size_t alarms, std::size_t warnings);

/// Returns the full names of the bodies that collided, if the finding is a collision of machine bodies (AlarmId::machine); empty for any
/// other finding. The alarm itself contains only shortened names.
std::string names_of_bodies(const CutFinding& finding);

/// Returns the finding as an alarm or a warning, without its location.
Alarm alarm_of(const CutFinding& finding);

}  // namespace kadr
