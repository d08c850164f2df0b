// kadr cut: defines the options of the command.

#include <CLI/CLI.hpp>

#include "cli/options/command_parts.h"
#include "cli/options/help_text.h"
#include "cli/options/option_values.h"
#include "texts/cut_options.h"
#include "texts/values.h"

namespace kadr::cli {
namespace {

constexpr double least_cell = 1e-3, max_cell = 1000;    // mm
constexpr double least_memory = 16, most_memory = 1e6;  // MB
constexpr double max_allowed = 1000;                    // greatest value of --allow and of --allow-left, mm
constexpr double max_threads = 256;
// least value of --simplify, mm; a smaller value is useless, since the points of the mesh are less exact
constexpr double least_simplify = 1e-4;

void part_options(CLI::App& app, CutOptions& o) {
  takes(app.add_option("--stock-zero", o.stock_zero, translated(texts::cut_options::stock_zero)), plain_text(texts::values::name));
  takes_file(app.add_option("--part", o.part, translated(texts::cut_options::part)));
  number(app.add_option("--allow", o.allow, translated(texts::cut_options::allow)), plain_text(texts::values::mm), 0, max_allowed);
  number(app.add_option("--allow-left", o.allow_left, translated(texts::cut_options::allow_left)), plain_text(texts::values::mm), 0,
         max_allowed);
}

void window_options(CLI::App& app, CutOptions& o) {
  takes(app.add_option("--window", o.window, translated(texts::cut_options::window)), translated(texts::cut_options::box));
  number(app.add_option("--max-memory", o.max_memory, translated(texts::cut_options::max_memory)), plain_text(texts::values::megabytes),
         least_memory, most_memory)
      ->capture_default_str();
  whole_number(app.add_option("--threads", o.threads, translated(texts::cut_options::threads)), 1, max_threads);
}

void portion_options(CLI::App& app, CutOptions& o) {
  takes(app.add_option("--portion", o.portion, translated(texts::cut_options::portion)), "K/N");
  takes_file(app.add_option("--join", o.join, translated(texts::cut_options::join)));
}

}  // namespace

std::array<CLI::Option*, 2> blank_options(CLI::App& app, CutOptions& o) {
  CLI::Option* const stock =
      takes(app.add_option("--stock", o.stock, translated(texts::cut_options::stock)), translated(texts::cut_options::body));
  CLI::Option* const tools = takes_file(app.add_option("--tools", o.tools, translated(texts::cut_options::tools)));
  takes(app.add_option("--fixture", o.fixtures, translated(texts::cut_options::fixture))->allow_extra_args(false),
        translated(texts::cut_options::body));
  return {stock, tools};
}

void cell_option(CLI::App& app, CutOptions& o) {
  number(app.add_option("--resolution", o.resolution, translated(texts::cut_options::resolution)), plain_text(texts::values::mm),
         least_cell, max_cell);
}

void add_cut(CLI::App& app, Commands& c) {
  CutOptions& o = c.cut;
  CLI::App* const cut = app.add_subcommand("cut", translated(texts::cut_options::cut));
  program_argument(*cut, o.run);
  blank_options(*cut, o)[1]->required();  // without --stock the blank is guessed
  part_options(*cut, o);
  cell_option(*cut, o);
  window_options(*cut, o);
  portion_options(*cut, o);
  takes(cut->add_option("--until", o.until, translated(texts::cut_options::until)), translated(texts::cut_options::line_or_seconds))
      ->check(
          CLI::Validator([](const std::string& text) { return text.empty() ? translated(texts::cut_options::until_is_empty) : ""; }, ""));
  cut->add_flag("--coolant", o.coolant, translated(texts::cut_options::coolant));
  writes_file(cut->add_option("--plot", o.run.plot, translated(texts::cut_options::plot)));
  one_of(cut->add_option("--colour,--color", o.run.colour, translated(texts::cut_options::colour)), {"tool", "age", "deviation", "load"});
  writes_file(cut->add_option("--out", o.out, translated(texts::cut_options::out)));
  number(cut->add_option("--simplify", o.simplify, translated(texts::cut_options::simplify)), plain_text(texts::values::mm), least_simplify,
         max_allowed);
  writes_file(cut->add_option("--deviation", o.deviation, translated(texts::cut_options::deviation)));
  writes_file(cut->add_option("--json", o.json, translated(texts::cut_options::json)));
  writes_file(cut->add_option("--blocks", o.blocks, translated(texts::cut_options::blocks)));
  program_options(*cut, o.run);
  memory_option(*cut, o.run);
  cut->footer(plain_text(texts::help_examples::cut));
}

}  // namespace kadr::cli
