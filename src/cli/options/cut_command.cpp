// kadr cut: its options.

#include <CLI/CLI.hpp>

#include "cli/options/command_parts.h"
#include "cli/options/help_text.h"
#include "cli/options/option_values.h"
#include "config/language.h"

namespace kadr::cli {
namespace {

constexpr double least_cell = 1e-3, max_cell = 1000;    // mm
constexpr double least_memory = 16, most_memory = 1e6;  // MB
constexpr double max_allowed = 1000;                    // mm
constexpr double max_threads = 256;
constexpr double least_simplify = 1e-4;  // mm: the points of the mesh are not more exact

void part_options(CLI::App& app, CutOptions& o) {
  takes(app.add_option("--stock-zero", o.stock_zero,
                       told("work system of blank and fixtures: G54 … (default: that of the first cut)",
                            "система координат заготовки и приспособлений: G54 … (по умолчанию первого реза)")),
        "NAME", "ИМЯ");
  takes_file(app.add_option("--part", o.part,
                            told("the part that is wanted, a closed mesh in the work system of the blank: a file .stl or .3mf",
                                 "деталь, которая должна получиться, замкнутая сетка в системе координат заготовки: файл .stl или .3mf")));
  number(app.add_option("--allow", o.allow,
                        told("that the part may be cut into (default 0.01 and a tenth of the cell)",
                             "на сколько можно врезаться в деталь (по умолчанию 0.01 и десятая шага сетки)")),
         "MM", "ММ", 0, max_allowed);
  number(app.add_option("--allow-left", o.allow_left,
                        told("that may be left on the part (default: any; a roughing program leaves something on)",
                             "сколько можно оставить на детали (по умолчанию сколько угодно: черновая УП оставляет припуск)")),
         "MM", "ММ", 0, max_allowed);
}

void window_options(CLI::App& app, CutOptions& o) {
  takes(app.add_option("--window", o.window,
                       told("a box of the blank that is cut finer: X0,Y0,Z0,X1,Y1,Z1; picture, mesh and --part are of it alone",
                            "часть заготовки с более мелким шагом: X0,Y0,Z0,X1,Y1,Z1; вид, сетка и --part относятся к ней")),
        "BOX", "ОКНО");
  number(app.add_option("--max-memory", o.max_memory, told("for the material", "памяти на материал, не больше")), "MB", "МБ", least_memory,
         most_memory)
      ->capture_default_str();
  whole_number(app.add_option("--threads", o.threads,
                              told("that cut at once (default: as many as the processor has); the result is the same",
                                   "потоков сразу (по умолчанию по числу ядер); результат тот же")),
               1, max_threads);
}

}  // namespace

std::array<CLI::Option*, 2> blank_options(CLI::App& app, CutOptions& o) {
  CLI::Option* const stock = takes(
      app.add_option(
          "--stock", o.stock,
          told("the blank, mm in the work system of the first cut: box:X0,Y0,Z0,X1,Y1,Z1, cylinder:X,Y,Z0,Z1,D or a file .stl, .3mf; "
               "guess: by "
               "where the program cuts, which is told",
               "заготовка, мм в системе координат первого реза: box:X0,Y0,Z0,X1,Y1,Z1, cylinder:X,Y,Z0,Z1,D или файл .stl, .3mf; guess: по "
               "тому, где режет УП, об этом сообщается")),
      "BODY", "ТЕЛО");
  CLI::Option* const tools = takes_file(app.add_option(
      "--tools", o.tools,
      told("what the tools look like: a file .toml, or a library of LinuxCNC, CAMotics, FreeCAD, Fusion; guess: by the program's "
           "comments and the set-up, which is told",
           "вид инструментов: файл .toml или библиотека LinuxCNC, CAMotics, FreeCAD, Fusion; guess: по комментариям "
           "УП и наладке, об этом сообщается")));
  takes(
      app.add_option("--fixture", o.fixtures,
                     told("a body never to be cut, as --stock; repeated", "тело, которое нельзя задевать, как у --stock; можно повторять"))
          ->allow_extra_args(false),
      "BODY", "ТЕЛО");
  return {stock, tools};
}

void cell_option(CLI::App& app, CutOptions& o) {
  number(app.add_option("--resolution", o.resolution,
                        told("cell of the lattice, with --window of the window (default: chosen and told)",
                             "шаг сетки, с --window шаг в окне (по умолчанию выбирается и сообщается)")),
         "MM", "ММ", least_cell, max_cell);
}

void add_cut(CLI::App& app, Commands& c) {
  CutOptions& o = c.cut;
  CLI::App* const cut = app.add_subcommand("cut", told("cut the part: what is left, what collides, what each tool takes away",
                                                       "снять материал: что останется, что столкнётся, сколько снимет каждый инструмент"));
  program_argument(*cut, o.run);
  for (CLI::Option* const needed : blank_options(*cut, o)) needed->required();
  part_options(*cut, o);
  cell_option(*cut, o);
  window_options(*cut, o);
  takes(cut->add_option("--until", o.until,
                        told("end after this line, or after so many seconds of the program: 120, 35.5s",
                             "закончить после этой строки или через столько секунд УП: 120, 35.5s")),
        "LINE|SECONDSs", "СТРОКА|СЕКУНДЫs")
      ->check(CLI::Validator(
          [](const std::string& text) {
            return text.empty() ? told("is empty: want a line, or seconds as in 35.5s", "пусто: нужна строка или секунды, как 35.5s") : "";
          },
          ""));
  cut->add_flag("--coolant", o.coolant, told("warn of cutting without coolant", "предупреждать о резании без охлаждения"));
  writes_file(cut->add_option("--plot", o.run.plot, told("draw the part: a file .svg or .png", "вид детали: файл .svg или .png")));
  one_of(cut->add_option("--colour,--color", o.run.colour,
                         told("of the part in --plot: by tool (default), by age of the cut, by deviation from --part, or by load",
                              "цвет детали на --plot: по инструменту (по умолчанию), по времени реза, по отклонению от --part или по "
                              "нагрузке")),
         {"tool", "age", "deviation", "load"});
  writes_file(cut->add_option("--out", o.out, told("the part: a file .stl or .3mf", "деталь: файл .stl или .3mf")));
  number(
      cut->add_option("--simplify", o.simplify,
                      told("fewer triangles in --out, which are off by no more", "меньше треугольников в --out, с отклонением не больше")),
      "MM", "ММ", least_simplify, max_allowed);
  writes_file(cut->add_option("--deviation", o.deviation,
                              told("the part, coloured by its deviation from --part, which each point carries: a file .ply",
                                   "деталь, окрашенная по отклонению от --part, число у каждой точки: файл .ply")));
  writes_file(
      cut->add_option("--json", o.json, told("what was found, to a file or - for stdout", "найденное: в файл или - на стандартный вывод")));
  writes_file(cut->add_option("--blocks", o.blocks,
                              told("what each block takes away, a row a block: a file .csv or - for stdout",
                                   "что снимает каждый кадр, по строке на кадр: файл .csv или - на стандартный вывод")));
  program_options(*cut, o.run);
  memory_option(*cut, o.run);
  cut->footer(plain_text(texts::help_examples::cut));
}

}  // namespace kadr::cli
