#pragma once
// Values of a run → JSON of the page's protocol (docs/panel-protocol.md).

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
/// `fix`: nothing: none is certain.
PageJson problem_json(const Finding& finding, std::uint16_t file, const std::optional<QuickFix>& fix);
/// What a cut has found: the problem that it is, with its moment and its place.
PageJson cut_finding_json(PageJson problem, const CutFinding& finding);
/// Its mark in time. `told`: the problem that it is.
PageJson cut_mark_json(const PageJson& told, const CutFinding& finding);
PageJson call_list_json(const std::vector<AlarmReport::Call>& calls);
PageJson state_json(const InstantState& state, const ProgramRun& run);
/// Boxes of what is cut and of all that is gone through.
PageJson extents_json(const Statistics& statistics);
PageJson bounds_json(const MachineBounds& space);
PageJson done_json(const ProgramRun& run, Lang lang);
/// Text that is UTF-8 whatever it was: JSON is.
std::string dumped(const PageJson& json);

}  // namespace kadr
