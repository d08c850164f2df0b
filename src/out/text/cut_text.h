#pragma once
// Writes a CutResult as text: the summary on stdout, and JSON (docs/commands/cut.md).

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "config/alarm_texts.h"
#include "stock/cut_result.h"

namespace kadr {

/// Returns one line: "removed 82581.4 mm³, cell 0.25 mm". If only a window of the part is cut, the line describes the window.
std::string cut_caption(const CutResult& result, Lang lang);

/// Returns the names of the tools that are too thin for the cell size; empty if no tool is.
std::string too_coarse_message(const CutResult& result, Lang lang);

std::string cut_summary(const CutResult& result, Lang lang);

/// Returns one JSON object. `alarms` and `warnings` are the numbers of the program's own alarms and warnings, without the findings of the
/// cut.
nlohmann::ordered_json cut_json(const CutResult& result, std::size_t alarms, std::size_t warnings);

/// For a finding of AlarmId::machine, returns the full names of the bodies that collided (an alarm shortens them); else empty.
std::string names_of_bodies(const CutFinding& finding);

/// Returns the finding as an alarm or warning, without its line.
Alarm alarm_of(const CutFinding& finding);

}  // namespace kadr
