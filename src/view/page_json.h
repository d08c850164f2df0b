#pragma once
// Values of a run → JSON of the page's protocol (docs/panel-protocol.md).

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "out/text/alarm_print.h"
#include "view/instant.h"
#include "view/served_folder.h"
#include "view/machine_bounds.h"

namespace kadr {

using PageJson = nlohmann::ordered_json;

PageJson files_json(const FolderList& list);
PageJson problem_json(const Finding& finding, std::uint16_t file);
PageJson state_json(const InstantState& state, const ProgramRun& run);
PageJson bounds_json(const MachineBounds& space);
PageJson done_json(const ProgramRun& run, Lang lang);
/// Text that is UTF-8 whatever it was: JSON is.
std::string dumped(const PageJson& json);

}  // namespace kadr
