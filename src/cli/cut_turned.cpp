// Cuts spinning parts for kadr cut. This file is used by cli/cut and tested by tests/run_cut.py.

#include "cli/cut_turned.h"

#include <nlohmann/json.hpp>

#include "cli/cut_meshes.h"
#include "cli/job/found.h"
#include "cli/job/progress.h"
#include "cli/job/stop_signals.h"
#include "cli/job/terminal.h"
#include "config/language.h"
#include "out/text/cut_load_text.h"
#include "out/text/cut_text.h"
#include "session/cutting/turned_run.h"
#include "stock/turned/turned_mesh.h"

namespace kadr::cli {
namespace {

constexpr double mesh_deviation = 0.01;  // mm; deviation of the mesh from the part unless --simplify states another

void print_to_terminal(Found& found, std::FILE* blocks, TurnedRun& run) {
  const auto print_report = [&found](const AlarmReport& report) { found.print_report(report); };
  run.on_report = print_report;
  run.on_finding = [print_report](const CutFinding&, const AlarmReport& report) { print_report(report); };
  if (blocks == nullptr) return;
  write_data(blocks, blocks_heading());
  run.on_block([blocks](const BlockLoad& load) { write_data(blocks, blocks_row(load)); });
}

bool write_results(const TurnedCut& c, const TurnedRun& run, const CutResult& result) {
  const CutOptions& options = c.options;
  if (std::FILE* const file = c.outputs.stream("--out"); file != nullptr) {
    const double deviation = options.simplify > 0 ? options.simplify : mesh_deviation;
    if (!write_part(options.out, turned_mesh(run.cutting().stock().region(), deviation), file)) return false;
  }
  if (std::FILE* const file = c.outputs.stream("--json"); file != nullptr)
    write_data(file, cut_json(result, run.alarms(), run.warnings()).dump() + "\n");
  const bool prints_summary = options.json != "-" && options.out != "-" && options.blocks != "-";
  if (!options.run.quiet && prints_summary) type_out("{}", cut_summary(result, language(options.run)));
  return c.outputs.keep();
}

}  // namespace

bool cuts_turned(const CutOptions& o, const Job& job) {
  const bool needs_lattice = o.resolution > 0 || !o.window.empty() || !o.part.empty() || !o.deviation.empty() || !o.run.plot.empty() ||
                             o.coolant || o.allow >= 0 || o.allow_left >= 0;
  return !needs_lattice && turned_job_of(*job.def, job.profile, o.stock, o.fixtures).has_value();
}

int cut_turned(const TurnedCut& c) {
  TurnedRun run(c.session, c.cut, *turned_job_of(*c.job.def, c.job.profile, c.options.stock, c.options.fixtures));
  Found found(c.job.texts(), language(c.options.run), stderr, c.options.run.every);
  print_to_terminal(found, c.outputs.stream("--blocks"), run);
  Progress progress(c.options.run.quiet);
  run.attach(c.options.run.limits.stop, &progress);
  c.drive.execute(c.session);
  if (interrupted()) return interrupted_status();
  run.finish();
  found.finish();
  const CutResult result = run.result();
  erase_bar();
  if (!write_results(c, run, result)) return interrupted() ? interrupted_status() : wrong_usage;
  return run.alarms() != 0 || !result.collisions.empty() ? alarms : ok;
}

}  // namespace kadr::cli
