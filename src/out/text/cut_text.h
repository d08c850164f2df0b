#pragma once
// CutResult → text: the summary on stdout, JSON (design.md 10).

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "config/alarm_texts.h"
#include "stock/cut_result.h"

namespace kadr {

/// In a line: "removed 82581.4 mm³, cell 0.25 mm"; of the window, if there is one.
std::string cut_caption(const CutResult& result, Lang lang);

/// Which tools are too thin for the cells; empty: none is.
std::string told_too_coarse(const CutResult& result, Lang lang);

std::string cut_summary(const CutResult& result, Lang lang);

/// One object. `alarms`, `warnings`: of the program itself, the findings not among them.
nlohmann::ordered_json cut_json(const CutResult& result, std::size_t alarms, std::size_t warnings);

/// Of a finding of AlarmId::machine: those that met, in whole (an alarm cuts them short); else empty.
std::string names_of_bodies(const CutFinding& finding);

/// The finding as an alarm or warning, without its place.
Alarm alarm_of(const CutFinding& finding);

}  // namespace kadr
