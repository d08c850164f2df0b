#pragma once
// Converts values of a run to JSON for the page (docs/panel-protocol.md).

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "out/text/alarm_print.h"
#include "out/text/quick_fix.h"
#include "stock/cut_result.h"
#include "view/instant.h"
#include "view/machine_bounds.h"
#include "view/served_folder.h"

namespace kadr {

using PageJson = nlohmann::ordered_json;

PageJson files_json(const FolderList& list);
/// Converts a finding of a check to JSON. `fix` is a proposed correction; nullopt if no correction is certain.
PageJson problem_json(const Finding& finding, std::uint16_t file, const std::optional<QuickFix>& fix);
/// Converts a finding of a cut to JSON: adds the time and the position of the collision to `problem`.
PageJson cut_finding_json(PageJson problem, const CutFinding& finding);
/// Converts a finding of a cut to a mark on the time line, as JSON. `reported` is the same finding as JSON from problem_json().
PageJson cut_mark_json(const PageJson& reported, const CutFinding& finding);
PageJson call_list_json(const std::vector<AlarmReport::Call>& calls);
PageJson state_json(const InstantState& state, const ProgramRun& run);
/// Converts the extents of a program: a box around the cutting motions, and a box around the whole path.
PageJson extents_json(const Statistics& statistics);
PageJson bounds_json(const MachineBounds& space);
PageJson done_json(const ProgramRun& run, Lang lang);
/// Converts JSON to text. Strings that are not valid UTF-8 are made valid, because JSON requires UTF-8.
std::string dumped(const PageJson& json);

}  // namespace kadr
