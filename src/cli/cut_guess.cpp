// Guesses blank and tools for kadr cut. This file is used by cli/cut and tested by tests/run_cut.py.

#include "cli/cut_guess.h"

#include <fmt/core.h>

#include "cli/job/terminal.h"
#include "texts/cut_command.h"
#include "view/proposals.h"
#include "view/stock_guess.h"

namespace kadr::cli {
namespace {

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

bool take_stock(const StockGuess& guess, const ProgramRun& run, const std::vector<ProposedTool>& tools, std::string& stock) {
  const Vec3 zero = run.path().zero();
  stock = guess.text(zero, turns_part(run, guess), radii_of(tools));
  if (stock.empty()) complain(translated(texts::cut_command::cuts_nothing));
  else write_message(translated(texts::cut_command::stock_guessed, stock) + "\n");
  return !stock.empty();
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
    write_message(translated(texts::cut_command::tool_guessed, tool.number, name_of(tool.kind), tool.diameter, proposed.from) + "\n");
  }
  if (!unknown.empty()) complain(translated(texts::cut_command::tools_unknown, unknown));
  return unknown.empty();
}

}  // namespace

bool guess_blank_and_tools(CutOptions& options, const Job& job, ToolLibrary& tools) {
  const bool stock = options.stock == guess_word, shapes = options.tools == guess_word;
  if (!stock && !shapes) return true;
  if (job.file == "-") {
    complain(translated(texts::cut_command::guess_from_input));
    return false;
  }
  auto run = ProgramRun::make(opened_of(job, options.run.limits), options.run.limits.stop);
  if (!run) {
    complain(run.error());
    return false;
  }
  StockGuess guess;
  (*run)->on_piece = [&guess](const ViewPiece& piece, std::uint32_t channel) {
    if (channel == 0) guess.take(piece);
  };
  (*run)->execute();
  if (options.run.limits.stop.requested()) return false;
  const std::vector<ProposedTool> proposals = tools_of(options, **run);
  const bool has_stock = !stock || take_stock(guess, **run, proposals, options.stock);
  return (!shapes || take_tools(proposals, job.def->behaviour.lathe != Lathe::none, tools)) && has_stock;
}

}  // namespace kadr::cli
