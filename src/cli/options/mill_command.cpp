// kadr mill: its options.

#include <CLI/CLI.hpp>
#include <limits>

#include "cli/options/command_parts.h"
#include "cli/options/help_text.h"
#include "cli/options/option_values.h"
#include "config/language.h"

namespace kadr::cli {
namespace {

CLI::Option* millimetres(CLI::Option* option) { return number(option, "MM", "ММ"); }
CLI::Option* degrees(CLI::Option* option) { return number(option, "DEG", "ГРАД"); }
CLI::Option* feed(CLI::Option* option) { return number(option, "MM/MIN", "ММ/МИН"); }

/// Options: what is milled, and how deep.
void zone_options(CLI::App& app, MillOptions& o) {
  app.add_option(told("CONTOUR", "КОНТУР"), o.contour,
                 told("drawing: DXF, SVG or text (- for standard input)", "чертёж: DXF, SVG или текст (- стандартный ввод)"))
      ->required();
  millimetres(app.add_option("--tool-diameter", o.tool_diameter, told("diameter of the tool", "диаметр фрезы")))->required();
  millimetres(app.add_option("--depth", o.depth, told("below the top", "глубина от верха материала")))->required();
  millimetres(app.add_option("--pass", o.pass,
                             told("depth of a layer at most (default: all at once)", "наибольшая глубина слоя (по умолчанию — за один)")));
  millimetres(app.add_option("--allowance", o.allowance, told("left on walls", "припуск на стенках")))->capture_default_str();
  millimetres(app.add_option("--top", o.top, told("Z of the material", "уровень верха материала по Z")))->capture_default_str();
}

/// Options: how the zone is covered.
void scheme_options(CLI::App& app, MillOptions& o) {
  known_by(app.add_option(
               "--scheme", o.scheme,
               told("zigzag 1zigzag 2zigzag spiral-out spiral-in comb 1comb 2comb, or ЗИГЗАГ СПИР АСПИР ШТИП …",
                    "ЗИГЗАГ, «1 ЗИГЗАГ», «2 ЗИГЗАГ», СПИР, АСПИР, ШТИП, «1 ШТИП», «2 ШТИП», также «СПИР ПЧС»; или zigzag, spiral-out …")),
           "SCHEME", "СХЕМА", is_scheme, scheme_names());
  known_by(app.add_option("--direction", o.direction,
                          told("of going round: ccw or cw (default: climb milling)",
                               "направление обхода: ПЧС (ccw) или ЧС (cw); по умолчанию попутное фрезерование")),
           "ccw|cw", "ПЧС|ЧС", is_direction, direction_names());
  takes(app.add_option("--stepover", o.stepover,
                       told("mm, or % of the diameter (default: 50%, face 70%)",
                            "шаг между проходами, мм или % диаметра (по умолчанию 50%, для face 70%)")),
        "MM|N%", "ММ|N%");
  known_by(app.add_option("--plunge", o.plunge,
                          told("how the tool goes down: hole, tangential or ramp (ЗАСВ, КАС, СПУСК)",
                               "врезание: ЗАСВ (hole), КАС (tangential) или СПУСК (ramp)")),
           "hole|tangential|ramp", "ЗАСВ|КАС|СПУСК", is_plunge, plunge_names())
      ->capture_default_str();
  number(app.add_option("--hole", o.hole,
                        told("of the hole drilled before (default: named by Kadr)",
                             "заранее засверленное отверстие (по умолчанию точку называет Kadr)")),
         "X Y", "X Y")
      ->expected(2);
  degrees(app.add_option("--ramp-angle", o.ramp_angle, told("of the ramp", "наклон спуска")))->capture_default_str();
  millimetres(app.add_option("--clearance", o.clearance, told("above the top: free way", "высота над материалом, где путь свободен")))
      ->capture_default_str();
  millimetres(app.add_option("--overrun", o.overrun, told("of the tool beyond open sides", "выход фрезы за открытые стороны")))
      ->capture_default_str();
  degrees(app.add_option("--angle", o.angle, told("of the rows to X", "угол строк к оси X")))->capture_default_str();
}

void technology_options(CLI::App& app, MillOptions& o) {
  feed(app.add_option("--feed", o.feed, told("working feed", "рабочая подача")))->capture_default_str();
  feed(app.add_option("--plunge-feed", o.plunge_feed, told("default: a third of the feed", "подача врезания; по умолчанию треть рабочей")));
  number(app.add_option("--speed", o.speed,
                        told("of the spindle (default: not written)", "частота вращения шпинделя (по умолчанию не пишется)")),
         "REV/MIN", "ОБ/МИН");
  whole_number(
      app.add_option("--tool", o.tool, told("number of the tool (default: not called)", "номер инструмента (по умолчанию не вызывается)")),
      0, std::numeric_limits<std::uint32_t>::max());
  app.add_flag("--coolant", o.coolant, told("switch the coolant on and off", "включать и выключать охлаждение"));
}

void output_options(CLI::App& app, MillOptions& o) {
  one_of(app.add_option("--mark", o.mark, told("end of block written out", "записываемый конец кадра")), {"ПС", "LF"});
  writes_file(app.add_option("--output", o.output, told("the program (default: standard output)", "УП (по умолчанию стандартный вывод)")));
  writes_file(app.add_option("--plot", o.plot,
                             told("draw contour and path: a file .svg or .png", "чертёж контура и траектории: файл .svg или .png")));
  quiet_option(app, o.quiet);
  language_option(app, o.lang);
}

void add_task(CLI::App& mill, Commands& c, const char* name, const std::string& what) {
  CLI::App* const task = mill.add_subcommand(name, what);
  MillOptions& o = c.mill;
  zone_options(*task, o);
  if (std::string_view(name) == "slot")
    millimetres(
        task->add_option("--width", o.width,
                         told("of the slot along a line (default: that of the tool)", "ширина паза вдоль линии (по умолчанию по фрезе)")));
  control_option(*task, o.control);
  scheme_options(*task, o);
  technology_options(*task, o);
  output_options(*task, o);
  task->footer(plain_text(texts::help_examples::mill));
}

}  // namespace

void add_mill(CLI::App& app, Commands& c) {
  CLI::App* const mill = app.add_subcommand("mill", told("make a program that mills an area", "составить УП фрезерования зоны"));
  mill->require_subcommand(1);
  language_option(*mill, c.mill.lang);
  add_task(*mill, c, "pocket",
           told("a zone within walls, with islands; open sides where the drawing says so",
                "карман: зона в стенках, с островками; открытые стороны — где указано на чертеже"));
  add_task(*mill, c, "face",
           told("a zone without walls: the tool runs over its edges", "плоскость: зона без стенок, фреза выходит за края"));
  add_task(*mill, c, "slot", told("along a line, or a pocket in the shape of a slot", "паз: вдоль линии или карман в форме паза"));
  mill->footer(plain_text(texts::help_examples::mill));
}

}  // namespace kadr::cli
