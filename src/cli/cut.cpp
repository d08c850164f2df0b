// kadr cut: executes a program on a blank, and reports the remaining stock and the collisions.

#include <fmt/core.h>

#include <cstdio>
#include <nlohmann/json.hpp>

#include "cli/cut_guess.h"
#include "cli/cut_job.h"
#include "cli/cut_meshes.h"
#include "cli/cut_portion.h"
#include "cli/cut_turned.h"
#include "cli/job/drive.h"
#include "cli/job/found.h"
#include "cli/job/outputs.h"
#include "cli/job/progress.h"
#include "cli/job/stop_signals.h"
#include "cli/job/terminal.h"
#include "config/json_text.h"
#include "config/language.h"
#include "config/setup/setup_blank.h"
#include "out/picture/part_page.h"
#include "out/text/alarm_print.h"
#include "out/text/cut_load_text.h"
#include "out/text/cut_text.h"
#include "out/text/page_file.h"
#include "session/cutting/body_watch.h"
#include "session/cutting/cut_cells.h"
#include "session/cutting/cut_run.h"
#include "session/cutting/cut_setup.h"
#include "stock/surface/surface.h"
#include "texts/cut_command.h"

namespace kadr::cli {
namespace {

constexpr double bytes_of_mb = 1 << 20;
// Default permitted depth of a gouge: `allowed` in mm, plus `allowed_of_cell` times the cell size, the position error of a surface point
// (docs/stock.md).
constexpr double allowed = 0.01, allowed_of_cell = 0.1;

/// Returns the output files of the command. They are not open yet.
Outputs outputs_of(const CutOptions& options, const Job& job) {
  Outputs outputs(language(options.run));
  outputs.reads(job.file);
  outputs.reads(job.setup_file);
  if (options.tools != guess_word) outputs.reads(options.tools);
  if (options.run.control.ends_with(".toml")) outputs.reads(options.run.control);
  if (options.run.machine.ends_with(".toml")) outputs.reads(options.run.machine);
  outputs.writes("--out", options.out);
  outputs.writes("--deviation", options.deviation);
  outputs.writes("--json", options.json);
  outputs.writes("--plot", options.run.plot);
  outputs.writes("--blocks", options.blocks);
  for (const std::string& body : options.fixtures) outputs.reads(body);
  outputs.reads(options.stock);
  outputs.reads(options.part);
  for (const std::string& portion : options.join) outputs.reads(portion);
  return outputs;
}

PartColour colour_of(const std::string& word) {
  return word == "age"         ? PartColour::age
         : word == "deviation" ? PartColour::deviation
         : word == "load"      ? PartColour::load
                               : PartColour::tool;
}

/// The state after the execution of the program.
struct Cut {
  const Surface& surface;
  const PartComparison& held;
  const CutRun& run;
  const Stock& stock;  // the stock, of the blank or of the window, whose surface is `surface`
};

/// Draws the picture if --plot requests one. Returns an error sentence if the picture cannot be drawn.
tl::expected<void, std::string> draw(const CutOptions& options, const Job& job, const Outputs& outputs, const Cut& cut,
                                     const CutResult& result) {
  if (options.run.plot.empty()) return {};
  const Lang lang = language(options.run);
  const Stock& stock = cut.stock;
  PartScene scene{cut.surface, stock.blank().box(), colour_of(options.run.colour), {}, {}, {}};
  scene.load.rates = cut.run.cutting().rates();
  for (const BlockLoad& load : result.heaviest) scene.load.heaviest.push_back(load.at);
  for (const CutFinding& f : result.collisions) scene.collisions.push_back({f.at, f.origin.line});
  if (result.part) scene.deviation = {cut.held.deviation, result.part->allow};
  scene.title = {job.file, lang == Lang::ru ? job.def->name.ru : job.def->name.en, lang, cut_caption(result, lang), {}};
  scene.colours.resize(stock.sweeps());
  for (std::size_t i = 0; i < scene.colours.size(); ++i) scene.colours[i] = std::uint8_t(stock.sweep(i).tool);
  for (std::size_t i = 0; i < stock.tools(); ++i) scene.title.legend.push_back(fmt::format("T{}", stock.tool(i).geometry.number));
  return draw_part_page(*outputs.file("--plot"), scene);
}

bool write_results(const CutOptions& options, const Job& job, Outputs& outputs, const Cut& cut, CutResult& result) {
  const bool joined = !options.join.empty();  // then the surface is written already
  if (!joined && !write_meshes(options, outputs, cut.surface, cut.held, cut.run.cutting(), result)) return false;
  if (interrupted()) return false;
  if (std::FILE* const file = outputs.stream("--json"); file != nullptr)
    write_data(file, json_text(cut_json(result, cut.run.alarms(), cut.run.warnings())) + "\n");
  if (const auto drawn = draw(options, job, outputs, cut, result); !drawn) {
    complain(drawn.error());
    return false;
  }
  const bool prints_summary = options.json != "-" && options.out != "-" && options.blocks != "-" && options.deviation != "-";
  if (!options.run.quiet && prints_summary) type_out("{}", cut_summary(result, language(options.run)));
  return outputs.keep();
}

/// Checks that all results can be written in the requested formats. Prints an error and returns false otherwise.
bool can_write(const CutOptions& options) {
  if (!can_write_meshes(options)) return false;
  const std::string fault = options.run.plot.empty() ? "" : page_fault(options.run.plot);
  if (!fault.empty()) complain("--plot " + fault);
  return fault.empty();
}

/// What the cut and the comparison with the target part have found.
struct Measured {
  const Stock& stock;
  Surface surface;
  PartComparison held;
  CutResult result;
};

/// Measures the remaining stock, and compares it with the target part.
Measured measured(const CutJob& cut_job, const CutRun& run, const std::optional<Mesh>& part) {
  const Stock* const window = run.cutting().window();
  Measured all{window != nullptr ? *window : run.cutting().stock(), surface_of(run.cutting().stock()), {}, {}};
  Surface of_window = window != nullptr ? surface_of(*window) : Surface();
  all.result = cut_figures(run.cutting(), cut_job, all.surface, window != nullptr ? &of_window : nullptr);
  if (window != nullptr) all.surface = std::move(of_window);
  if (part) all.held = compare_with_part(cut_job, all.stock, all.surface, *part);
  return all;
}

/// Joins what the portions have measured. If an error occurs, it is printed and the function returns nullopt.
std::optional<Measured> joined(const CutOptions& options, const CutJob& cut_job, const CutRun& run, const Outputs& outputs,
                               PortionInputs& portions) {
  auto joined = portions.join(options, outputs, run.cutting());
  if (!joined) return std::nullopt;
  return Measured{run.cutting().stock(), {}, std::move(joined->held), joined_figures(run.cutting(), cut_job, joined->surface)};
}

/// Prints the results of the cut and writes the output files. To be called after the execution of the program. Returns the exit status.
int print_results(const CutOptions& options, const Job& job, const CutRun& run, Measured all, Outputs& outputs) {
  CutResult result = run.named(std::move(all.result));
  if (!options.part.empty()) {
    result.part = run.part_result(all.held);
    result.part->allow = options.allow >= 0 ? options.allow : allowed + allowed_of_cell * all.stock.lattice().cell();
    if (options.allow_left >= 0) result.part->allow_left = options.allow_left;
  }
  if (interrupted()) return interrupted_status();
  erase_bar();
  if (const std::string note = too_coarse_message(result, language(options.run)); !note.empty()) write_message(note + "\n");
  if (!write_results(options, job, outputs, {all.surface, all.held, run, all.stock}, result))
    return interrupted() ? interrupted_status() : wrong_usage;
  const bool part_is_wrong = result.part && (result.part->is_gouged() || result.part->is_left_on());
  return run.alarms() != 0 || !result.collisions.empty() || part_is_wrong ? alarms : ok;
}

/// Returns the collision check of the machine's solid bodies; nullptr if the machine has no bodies. Returns nullopt after printing an
/// error.
std::optional<std::unique_ptr<MachineWatch>> watch_of(const CutOptions& options, const Session& session, const CutJob& cut) {
  std::vector<std::string> notes;
  auto watch =
      watch_bodies(session, cut, work_of(cut, options.stock, options.fixtures, options.fixtures), options.max_memory * bytes_of_mb, notes);
  for (const std::string& note : notes) write_message(note + "\n");
  if (!watch) {
    complain(watch.error());
    return std::nullopt;
  }
  return std::move(*watch);
}

void print_to_terminal(Found& found, std::FILE* blocks, CutRun& run) {
  const auto print_report = [&found](const AlarmReport& report) { found.print_report(report); };
  run.on_report = print_report;
  run.on_finding = [print_report](const CutFinding&, const AlarmReport& report) { print_report(report); };
  run.on_note = [](const std::string& note) { write_message(note + "\n"); };
  if (blocks == nullptr) return;
  write_data(blocks, blocks_heading());
  run.on_block([blocks](const BlockLoad& load) { write_data(blocks, blocks_row(load)); });
}

/// Takes blank and fixtures from the set-up file where the command line names none.
void take_setup_blank(CutOptions& options, const Job& job) {
  if (job.setup_file.empty()) return;
  const auto source = setup_source(job.setup_file);
  const SetupBlank blank = source ? setup_blank(source->json) : SetupBlank();
  if (options.fixtures.empty()) options.fixtures = blank.fixtures;
  if (!options.stock.empty() || blank.stock.empty()) return;
  options.stock = blank.stock;
  write_message(translated(texts::cut_command::stock_by_setup, options.stock) + "\n");
}

}  // namespace

int cut(const CutOptions& given) {
  CutOptions options = given;
  CutJob cut_job;
  std::optional<Mesh> part;
  if (!can_write(options) || !portion_options_fit(options)) return wrong_usage;
  auto job = make_job(options.run, options.run.programs.front());
  if (job) take_setup_blank(options, *job);
  const auto plan =
      job && find_tools_and_end(options, cut_job) && find_part(options, part) ? plan_cut(options, *job, part, cut_job.tools) : std::nullopt;
  if (!plan || (!plan->turned && !find_cut_job(options, cut_job, part))) return interrupted() ? interrupted_status() : wrong_usage;
  if (!find_system(options, *job, cut_job.system)) return wrong_usage;
  Outputs outputs = outputs_of(options, *job);
  auto program = outputs.check() ? open_program(*job) : std::nullopt;
  const auto drive = program ? drive_of(options.run) : nullptr;
  if (!drive) return wrong_usage;
  const auto session = make_session(*job, std::move(*program), options.run.limits);
  if (!session) return wrong_usage;
  take_session(*session, job->stated.count("start") != 0, cut_job);
  const bool is_portion = !options.portion.empty();
  const auto watch = is_portion ? std::optional(std::unique_ptr<MachineWatch>()) : watch_of(options, *session, cut_job);
  if (!watch || !outputs.open()) return wrong_usage;
  const auto portion = is_portion ? std::make_unique<PortionOutput>(options, outputs, cut_job) : nullptr;
  const auto portions = options.join.empty() ? nullptr : PortionInputs::open(options, cut_job);
  if (!options.join.empty() && !portions) return wrong_usage;
  session->control().watch_calls();
  const std::unique_ptr<Drive, void (*)(Drive*)> leaves(drive.get(), [](Drive* left) { left->leave(); });
  if (const auto nothing = drive->begin(*session, *job)) return interrupted() ? interrupted_status() : *nothing;
  if (plan->turned) return cut_turned({options, *job, cut_job, *session, *drive, outputs, *plan, watch->get()});
  CutRun run(*session, cut_job, watch->get());
  Found found(job->texts(), language(options.run), stderr, options.run.every);
  if (!is_portion) print_to_terminal(found, outputs.stream("--blocks"), run);  // the process that joins the portions reports
  Progress progress(options.run.quiet);
  run.attach(options.run.limits.stop, &progress);
  drive->execute(*session);
  if (!interrupted()) run.finish();
  found.finish();
  if (interrupted()) return interrupted_status();
  if (portion) return portion->finish(cut_job, run.cutting(), part, outputs);
  auto all = portions ? joined(options, cut_job, run, outputs, *portions) : std::optional(measured(cut_job, run, part));
  return all ? print_results(options, *job, run, std::move(*all), outputs) : wrong_usage;
}

}  // namespace kadr::cli
