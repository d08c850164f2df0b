#pragma once
// The live report of `kadr report --live`: the page without a server with the program and its files inside.

#include <string>
#include <tl/expected.hpp>

#include "cli/job/job.h"
#include "cli/options/options.h"

namespace kadr::cli {

/// Returns why these options cannot make a live report; empty if they can.
std::string live_fault_message(const ReportOptions& options);

/// Creates the live report of a program that has run.
///   called   names of the files that the program has called or read
///   returns  the page as HTML, or an error sentence
tl::expected<std::string, std::string> live_report(const ReportOptions& options, const Job& job, const std::vector<std::string>& called);

}  // namespace kadr::cli
