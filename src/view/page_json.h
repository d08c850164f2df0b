#pragma once
// Converts values of a run to JSON of the page's protocol (docs/panel-protocol.md).

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
/// `fix`: nullopt if no fix is certain.
PageJson problem_json(const Finding& finding, std::uint16_t file, const std::optional<QuickFix>& fix);
/// A finding of a cut: its problem, extended by the time and the place.
PageJson cut_finding_json(PageJson problem, const CutFinding& finding);
/// The mark of a finding on the time line. `told`: its problem.
PageJson cut_mark_json(const PageJson& told, const CutFinding& finding);
PageJson call_list_json(const std::vector<AlarmReport::Call>& calls);
PageJson state_json(const InstantState& state, const ProgramRun& run);
/// Boxes around what is cut, and around the whole path.
PageJson extents_json(const Statistics& statistics);
PageJson bounds_json(const MachineBounds& space);
PageJson done_json(const ProgramRun& run, Lang lang);
/// Serialises JSON. Invalid text is converted to UTF-8, which JSON requires.
std::string dumped(const PageJson& json);

}  // namespace kadr
