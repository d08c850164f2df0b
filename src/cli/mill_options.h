#pragma once
// kadr mill: words of the command line → what is wanted of path/area.

#include "base/result.h"
#include "cli/options.h"
#include "path/area/mill.h"

namespace kadr::cli {

/// The job, complete.
///   alarms  mill_value, mill_stepover
Result<area::Job> mill_job(const MillOptions& options);

/// Names as printed in the source: СПИР, 1 ЗИГЗАГ; СПУСК.
std::string_view russian_name(area::Scheme scheme);
std::string_view russian_name(area::Plunge plunge);

}  // namespace kadr::cli
