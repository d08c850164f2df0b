// kadr report: defines the options of the command.

#include <CLI/CLI.hpp>

#include "cli/options/command_parts.h"
#include "cli/options/help_text.h"
#include "cli/options/option_values.h"
#include "texts/live_report.h"
#include "texts/report_options.h"

namespace kadr::cli {

void add_report(CLI::App& app, Commands& c) {
  ReportOptions& o = c.report;
  CLI::App* const report = app.add_subcommand("report", translated(texts::report_options::report));
  program_argument(*report, o.cut.run);
  writes_file(report->add_option("--out", o.out, translated(texts::report_options::out))->required());
  takes_file(report->add_option("--live", o.live, plain_text(texts::live_report::option)));
  const auto [stock, tools] = blank_options(*report, o.cut);
  stock->needs(tools);
  cell_option(*report, o.cut);
  for (const char* const option : {"--fixture", "--resolution"}) report->get_option(option)->needs(stock);
  program_options(*report, o.cut.run);
  memory_option(*report, o.cut.run);
  report->footer(plain_text(texts::help_examples::report));
}

}  // namespace kadr::cli
