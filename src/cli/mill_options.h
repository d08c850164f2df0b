#pragma once
// kadr mill: words of the command line → what is wanted of path/area.

#include "base/result.h"
#include "cli/options.h"
#include "path/area/mill.h"

namespace kadr::cli {

/// The job, complete.
///   alarms  mill_value, mill_stepover
Result<area::Job> mill_job(const MillOptions& options);

/// Whether that is a name of one, and the names that there are.
bool is_scheme(std::string_view name);
bool is_direction(std::string_view name);
bool is_plunge(std::string_view name);
std::vector<std::string> scheme_names();
std::vector<std::string> direction_names();
std::vector<std::string> plunge_names();

/// Names as printed in the source: СПИР, 1 ЗИГЗАГ; СПУСК.
std::string_view russian_name(area::Scheme scheme);
std::string_view russian_name(area::Plunge plunge);

}  // namespace kadr::cli
