// Guesses blank and tools for kadr cut, and decides how it cuts. This file is used by cli/cut and tested by tests/run_cut.py.

#include "cli/cut_guess.h"

#include <fmt/core.h>

#include <algorithm>

#include "cli/cut_turned.h"
#include "cli/job/terminal.h"
#include "session/cutting/named_body.h"
#include "session/cutting/offset_insert.h"
#include "session/cutting/turning/cut_survey.h"
#include "texts/cut_command.h"
#include "view/proposals.h"
#include "view/stock_guess.h"

namespace kadr::cli {
namespace {

constexpr double section_tolerance = 0.05;  // mm; corners of a wanted part that is a body of revolution are this near to its section

OpenedProgram opened_of(const Job& job, const RunLimits& limits) {
  OpenedProgram opened;
  opened.path = job.file;
  opened.def = job.def;
  opened.texts = std::make_shared<const AlarmTexts>(job.texts());
  opened.machine = job.profile;
  opened.setup = job.setup;
  opened.stated = job.stated;
  opened.encoding = job.encoding;
  opened.number = job.program;
  opened.limits = limits;
  return opened;
}

/// Returns proposals for the tools of the program. If the user has named a tools file, they contain its data.
std::vector<ProposedTool> tools_of(const CutOptions& options, const ProgramRun& run) {
  if (options.tools.empty() || options.tools == guess_word) return proposed_tools(run, nullptr);
  // an error in the file is not reported here, since it is reported when the file is read for cutting
  auto library = load_tools(options.tools);
  const KnownTools file{options.tools, library ? std::move(*library) : ToolLibrary()};
  return proposed_tools(run, &file);
}

bool is_of_lathe(const Job& job) { return job.def->behaviour.lathe != Lathe::none; }

/// Finds the blank. `turns`: every tool that cuts turns or is on the axis.
bool take_stock(const StockGuess& guess, const ProgramRun& run, const Job& job, bool turns, const std::vector<ProposedTool>& tools,
                std::string& stock) {
  const Vec3 zero = run.path().zero();
  const bool turned = is_of_lathe(job) || turns || turns_part(run, guess);
  const BlankHints hints = blank_hints(run);
  stock = guess.text(zero, turned, radii_of(tools), hints);
  const std::optional<StatedBlank>& bar = hints.turned.stated;
  if (stock.empty()) complain(translated(texts::cut_command::cuts_nothing));
  else if (turned && bar && bar->size.length)
    write_message(translated(texts::cut_command::stock_stated, stock, bar->line, bar->text) + "\n");
  else if (turned && bar) write_message(translated(texts::cut_command::diameter_stated, stock, bar->line, bar->text) + "\n");
  else if (!turned && hints.box && hints.box->size.zero)
    write_message(translated(texts::cut_command::box_placed, stock, hints.box->line, hints.box->text) + "\n");
  else if (!turned && hints.box) write_message(translated(texts::cut_command::box_stated, stock, hints.box->line, hints.box->text) + "\n");
  else write_message(translated(texts::cut_command::stock_guessed, stock) + "\n");
  return !stock.empty();
}

/// Returns the form of an insert in figures: its angle, or the width of a grooving insert.
std::string shape_of_insert(const ToolGeometry& tool) {
  return tool.insert.width > 0 ? fmt::format("{:g} mm", tool.insert.width) : fmt::format("{:g}°", tool.angle);
}

/// `lathe`: true if the program is that of a lathe. Its offset table states noses, not mills, and the cut takes the inserts of unknown
/// tools from there.
bool take_tools(const std::vector<ProposedTool>& proposals, bool lathe, ToolLibrary& tools) {
  std::string unknown;
  for (const ProposedTool& proposed : proposals) {
    const ToolGeometry& tool = proposed.tool;
    if (lathe && (!proposed.known || proposed.by_offset || (tool.kind != ToolKind::drill && tool.kind != ToolKind::turning))) continue;
    if (!proposed.known) {
      unknown += fmt::format("{}T{}", unknown.empty() ? "" : ", ", tool.number);
      continue;
    }
    tools.tools.push_back(tool);
    if (tool.kind == ToolKind::turning)
      write_message(translated(texts::cut_command::insert_guessed, tool.number, shape_of_insert(tool), tool.corner, proposed.from) + "\n");
    else write_message(translated(texts::cut_command::tool_guessed, tool.number, name_of(tool.kind), tool.diameter, proposed.from) + "\n");
  }
  if (!unknown.empty()) complain(translated(texts::cut_command::tools_unknown, unknown));
  return unknown.empty();
}

bool states_inserts(const Job& job) {
  const auto& offsets = job.setup.offsets;
  return std::any_of(offsets.begin(), offsets.end(), [&](const auto& row) {
    return states_insert(*job.def, row.second) && insert_of_offset(row.second, 1, tip_numbers(*job.def));
  });
}

std::optional<ToolGeometry> insert_of(const Job& job, std::uint32_t row, std::uint32_t tool) {
  const auto found = job.setup.offsets.find(int(row));
  if (found == job.setup.offsets.end() || !states_insert(*job.def, found->second)) return std::nullopt;
  return insert_of_offset(found->second, tool, tip_numbers(*job.def));
}

/// True if the kind of cut follows only from what the tools of the program do.
bool needs_survey(const Job& job, const ToolLibrary& tools) {
  const auto is_a = [](auto... kinds) { return [=](const ToolGeometry& t) { return ((t.kind == kinds) || ...); }; };
  const auto has = [&](const auto& fits) { return std::any_of(tools.tools.begin(), tools.tools.end(), fits); };
  if (is_of_lathe(job)) return !std::all_of(tools.tools.begin(), tools.tools.end(), is_a(ToolKind::turning));
  return has(is_a(ToolKind::turning)) || states_inserts(job);
}

/// True if the part is cut exactly. Of a lathe, what the lattice cannot cut is left out of the exact cut.
bool is_turned(const Job& job, const CutSurvey& survey) {
  if (!is_of_lathe(job)) return survey.is_turned();
  const auto& rotary = job.profile.chains.part;
  const bool lattice_can = survey.rows().empty() && (!survey.has_rotated() || !rotary.empty());
  return !survey.mills() || !lattice_can;
}

/// Executes the program once.
class Trial {
 public:
  /// `tools` must outlive the object.
  static std::unique_ptr<Trial> of(const CutOptions& options, const Job& job, const ToolLibrary& tools) {
    auto run = ProgramRun::make(opened_of(job, options.run.limits), options.run.limits.stop);
    if (run) return std::unique_ptr<Trial>(new Trial(std::move(*run), job, tools));
    complain(run.error());
    return nullptr;
  }

  void execute() {
    run_->on_piece = [this](const ViewPiece& piece, std::uint32_t channel) {
      if (channel == 0) guess_.take(piece);
    };
    run_->on_step = [this](const Step& step) { survey_.take(step); };
    run_->execute();
  }
  const ProgramRun& run() const { return *run_; }
  const CutSurvey& survey() const { return survey_; }
  const StockGuess& guess() const { return guess_; }

 private:
  Trial(std::unique_ptr<ProgramRun> run, const Job& job, const ToolLibrary& tools)
      : run_(std::move(run)),
        survey_(
            AxisRoles::of(run_->control().axes(), run_->control().rotary()), tools,
            [&job](std::uint32_t row, std::uint32_t tool) { return insert_of(job, row, tool).has_value(); },
            std::uint32_t(std::max(job.setup.tool, 0))) {}

  std::unique_ptr<ProgramRun> run_;
  CutSurvey survey_;
  StockGuess guess_;
};

/// Adds the inserts that only the offset table tells, for the lattice.
void add_inserts(const Job& job, const CutSurvey& survey, ToolLibrary& tools) {
  for (const auto& [tool, row] : survey.rows())
    if (auto insert = insert_of(job, row, tool)) tools.tools.push_back(std::move(*insert));
}

}  // namespace

std::optional<CutPlan> plan_cut(CutOptions& options, const Job& job, const std::optional<Mesh>& part, ToolLibrary& tools) {
  if (options.stock.empty()) options.stock = guess_word;
  const bool stock = options.stock == guess_word, shapes = options.tools == guess_word;
  CutPlan plan;
  if (part) plan.wanted = section_of(*part, section_tolerance);
  const bool may_turn = can_turn(options, plan, part.has_value());
  const bool surveys = may_turn ? shapes || needs_survey(job, tools) : states_inserts(job);
  plan.turned = may_turn && is_of_lathe(job);
  if (!stock && !shapes && !surveys) return plan;
  if (job.file == "-") {
    if (!stock && !shapes) return plan;
    complain(translated(texts::cut_command::guess_from_input));
    return std::nullopt;
  }
  const auto trial = Trial::of(options, job, tools);
  if (!trial) return std::nullopt;
  trial->execute();
  if (options.run.limits.stop.requested()) return std::nullopt;
  const CutSurvey& survey = trial->survey();
  const std::vector<ProposedTool> proposals = tools_of(options, trial->run());
  const bool turns = is_of_lathe(job) || survey.is_turned();
  if (stock && !take_stock(trial->guess(), trial->run(), job, turns, proposals, options.stock)) return std::nullopt;
  if (shapes && !take_tools(proposals, turns || survey.turning().count > 0, tools)) return std::nullopt;
  plan.turned = can_turn(options, plan, part.has_value()) && is_turned(job, survey);
  if (!plan.turned) add_inserts(job, survey, tools);
  return plan;
}

}  // namespace kadr::cli
