// kadr mill: defines the options of the command.

#include <CLI/CLI.hpp>
#include <limits>

#include "cli/options/command_parts.h"
#include "cli/options/help_text.h"
#include "cli/options/option_values.h"
#include "lang/text/end_mark.h"
#include "texts/help_examples.h"
#include "texts/mill_options.h"
#include "texts/values.h"

namespace kadr::cli {
namespace {

CLI::Option* millimetres(CLI::Option* option) { return number(option, plain_text(texts::values::mm)); }
CLI::Option* degrees(CLI::Option* option) { return number(option, translated(texts::mill_options::degrees)); }
CLI::Option* feed(CLI::Option* option) { return number(option, translated(texts::mill_options::mm_per_minute)); }

/// Adds the options that state which area is milled, and how deep.
void zone_options(CLI::App& app, MillOptions& o) {
  app.add_option(translated(texts::mill_options::contour_name), o.contour, translated(texts::mill_options::contour))->required();
  millimetres(app.add_option("--tool-diameter", o.tool_diameter, translated(texts::mill_options::tool_diameter)))->required();
  millimetres(app.add_option("--depth", o.depth, translated(texts::mill_options::depth)))->required();
  millimetres(app.add_option("--pass", o.pass, translated(texts::mill_options::pass)));
  millimetres(app.add_option("--allowance", o.allowance, translated(texts::mill_options::allowance)))->capture_default_str();
  millimetres(app.add_option("--top", o.top, translated(texts::mill_options::top)))->capture_default_str();
}

/// Adds the options that state with which passes the area is milled.
void scheme_options(CLI::App& app, MillOptions& o) {
  known_by(app.add_option("--scheme", o.scheme, translated(texts::mill_options::scheme)), translated(texts::mill_options::scheme_name),
           is_scheme, scheme_names());
  known_by(app.add_option("--direction", o.direction, translated(texts::mill_options::direction)),
           translated(texts::mill_options::direction_names), is_direction, direction_names());
  takes(app.add_option("--stepover", o.stepover, translated(texts::mill_options::stepover)),
        translated(texts::mill_options::mm_or_percent));
  known_by(app.add_option("--plunge", o.plunge, translated(texts::mill_options::plunge)), translated(texts::mill_options::plunge_names),
           is_plunge, plunge_names())
      ->capture_default_str();
  number(app.add_option("--hole", o.hole, translated(texts::mill_options::hole)), "X Y")->expected(2);
  degrees(app.add_option("--ramp-angle", o.ramp_angle, translated(texts::mill_options::ramp_angle)))->capture_default_str();
  millimetres(app.add_option("--clearance", o.clearance, translated(texts::mill_options::clearance)))->capture_default_str();
  millimetres(app.add_option("--overrun", o.overrun, translated(texts::mill_options::overrun)))->capture_default_str();
  degrees(app.add_option("--angle", o.angle, translated(texts::mill_options::angle)))->capture_default_str();
}

void technology_options(CLI::App& app, MillOptions& o) {
  feed(app.add_option("--feed", o.feed, translated(texts::mill_options::feed)))->capture_default_str();
  feed(app.add_option("--plunge-feed", o.plunge_feed, translated(texts::mill_options::plunge_feed)));
  number(app.add_option("--speed", o.speed, translated(texts::mill_options::speed)),
         translated(texts::mill_options::revolutions_per_minute));
  whole_number(app.add_option("--tool", o.tool, translated(texts::mill_options::tool)), 0, std::numeric_limits<std::uint32_t>::max());
  app.add_flag("--coolant", o.coolant, translated(texts::mill_options::coolant));
}

void output_options(CLI::App& app, MillOptions& o) {
  one_of(app.add_option("--mark", o.mark, translated(texts::mill_options::mark)), {std::string(end_mark_in_text), "LF"});
  writes_file(app.add_option("--output", o.output, translated(texts::mill_options::output)));
  writes_file(app.add_option("--plot", o.plot, translated(texts::mill_options::plot)));
  quiet_option(app, o.quiet);
  language_option(app, o.lang);
}

void add_task(CLI::App& mill, Commands& c, const char* name, const std::string& what) {
  CLI::App* const task = mill.add_subcommand(name, what);
  MillOptions& o = c.mill;
  zone_options(*task, o);
  if (std::string_view(name) == "slot") millimetres(task->add_option("--width", o.width, translated(texts::mill_options::width)));
  control_option(*task, o.control);
  scheme_options(*task, o);
  technology_options(*task, o);
  output_options(*task, o);
  task->footer(plain_text(texts::help_examples::mill));
}

}  // namespace

void add_mill(CLI::App& app, Commands& c) {
  CLI::App* const mill = app.add_subcommand("mill", translated(texts::mill_options::mill));
  mill->require_subcommand(1);
  language_option(*mill, c.mill.lang);
  add_task(*mill, c, "pocket", translated(texts::mill_options::pocket));
  add_task(*mill, c, "face", translated(texts::mill_options::face));
  add_task(*mill, c, "slot", translated(texts::mill_options::slot));
  mill->footer(plain_text(texts::help_examples::mill));
}

}  // namespace kadr::cli
