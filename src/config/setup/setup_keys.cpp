// The keys of a set-up (--setup FILE.json): one table, one row per key. Used by config/setup/setup_names; tested by
// tests/config/setup_keys_test.cpp.

#include "config/setup/setup_keys.h"

#include <algorithm>
#include <array>

#include "config/range.h"

namespace kadr {
namespace {

using F = SetupForm;
using N = SetupNames;
using U = SetupUnit;
using H = SetupNeeds;

constexpr SetupRange any{};
constexpr SetupRange position{ranges::position.least, ranges::position.most};
constexpr SetupRange checked_by_reader(const NumberRange& range) { return {range.least, range.most, true}; }
constexpr SetupRange checked_position = checked_by_reader(ranges::position), rate = checked_by_reader(ranges::rate),
                     feed = checked_by_reader(ranges::feed);
constexpr SetupRange acceleration = checked_by_reader(ranges::acceleration), seconds = checked_by_reader(ranges::seconds);
constexpr SetupRange speed = checked_by_reader(ranges::speed), percent = checked_by_reader(ranges::percent),
                     singular = checked_by_reader(ranges::singular);
constexpr SetupRange distance = checked_by_reader(ranges::distance), diameter = checked_by_reader(ranges::diameter);
constexpr SetupRange count{0, 99'999'999};
constexpr SetupRange bits{0, 4'294'967'295};
constexpr SetupRange channels{1, 8};
constexpr SetupRange spindles{1, 16};

constexpr bool null = true, stated = false;

// clang-format off
// Order: as a person fills in the file; the rows of a table follow it. Columns: path, form, names, range, unit, null, needs, words,
// example, instead, en, ru.
constexpr SetupKey keys[] = {
  {"axes", F::texts, N::any, any, U::none, stated, H::nothing, "", R"(["X", "Y", "Z"])", "", "names of the axes in the order of their numbers; default those of the control. Names in A, B, C are rotary", "имена осей в порядке номеров; по умолчанию оси УЧПУ. Оси A, B, C поворотные"},
  {"start", F::table, N::axis, any, U::none, stated, H::nothing, "", R"({"X": 0, "Y": 150, "Z": -20})", "", "position of the axes before the start", "положение осей перед пуском"},
  {"start.*", F::number, N::fixed, position, U::axis, stated, H::nothing, "", "150", "", "of one axis", "значение для одной оси"},
  {"start_frame", F::one_of, N::fixed, any, U::none, stated, H::nothing, "machine work", R"("work")", "", "what `start` counts in: machine coordinates (default), or the work system in force, tool point", "система координат, в которой задано `start`: станка (по умолчанию) или действующая система координат детали; во втором случае это положение вершины инструмента"},
  {"modal", F::texts, N::any, any, U::none, stated, H::nothing, "", R"(["G90"])", "", "code words in force before the program, H1, D1 too", "слова, действующие в начале программы, в том числе H1, D1"},
  {"feed", F::number, N::fixed, feed, U::mm_min, null, H::nothing, "", "300", "", "F in force", "действующая подача F"},
  {"plane", F::text, N::fixed, any, U::none, null, H::machine_axes, "", R"("XY")", "", "axes of the plane in force, in order", "оси действующей плоскости по порядку"},
  {"diameter", F::table, N::axis, any, U::none, null, H::diameters, "", R"({"X": true})", "", "axes in diameter programming", "оси, программируемые в диаметрах"},
  {"diameter.*", F::flag, N::fixed, any, U::none, stated, H::diameters, "", "true", "", "of one axis", "значение для одной оси"},

  {"offsets", F::table, N::offset, any, U::none, stated, H::nothing, "", R"({"1": {"length": 112.5, "radius": 8}})", "correctors", "tool offsets; H, D and the tool table share the numbers", "корректоры инструмента; номера H, D и таблицы инструментов общие"},
  {"offsets.*", F::table, N::fixed, any, U::none, stated, H::nothing, "", R"({"length": 112.5, "radius": 8})", "", "one number", "один номер"},
  {"offsets.*.length", F::number, N::fixed, position, U::mm, null, H::nothing, "", "112.5", "", "length", "вылет (длина) инструмента"},
  {"offsets.*.length_wear", F::number, N::fixed, position, U::mm, null, H::nothing, "", "-0.05", "", "wear of the length, added to it", "износ по длине, прибавляется к ней"},
  {"offsets.*.radius", F::number, N::fixed, position, U::mm, null, H::nothing, "", "8", "", "radius, not the diameter", "радиус, не диаметр"},
  {"offsets.*.radius_wear", F::number, N::fixed, position, U::mm, null, H::nothing, "", "-0.02", "", "wear of the radius, added to it", "износ по радиусу, прибавляется к нему"},
  {"offsets.*.corner_radius", F::number, N::fixed, position, U::mm, null, H::corner_radius, "", "0.8", "", "rounding of the corner", "радиус при вершине"},
  {"offsets.*.corner_radius_wear", F::number, N::fixed, position, U::mm, null, H::corner_radius, "", "0.01", "", "its wear", "износ по радиусу при вершине"},
  {"offsets.*.length_x", F::number, N::fixed, position, U::mm, null, H::turning_lengths, "", "40", "", "turning tool: length along X", "токарный инструмент: вылет по X"},
  {"offsets.*.length_x_wear", F::number, N::fixed, position, U::mm, null, H::turning_lengths, "", "0.1", "", "its wear", "износ по вылету X"},
  {"offsets.*.length_y", F::number, N::fixed, position, U::mm, null, H::turning_lengths, "", "0", "", "turning tool: length along Y", "токарный инструмент: вылет по Y"},
  {"offsets.*.length_y_wear", F::number, N::fixed, position, U::mm, null, H::turning_lengths, "", "0", "", "its wear", "износ по вылету Y"},
  {"offsets.*.tip_position", F::number, N::fixed, {0, 9}, U::none, null, H::turning_lengths, "", "3", "", "code of the tip's orientation", "код положения вершины резца"},
  {"work_offsets", F::table, N::work_offset, any, U::none, stated, H::work_offsets, "", R"({"G54": {"X": -400, "Y": -250, "Z": -300}})", "zeros", "work zeros by their codes, in machine coordinates", "смещения нуля (системы координат детали) по кодам, в координатах станка"},
  {"work_offsets.*", F::table, N::axis_or_plane, any, U::none, stated, H::work_offsets, "", R"({"X": -400, "Z": -300})", "", "one system", "одна система"},
  {"work_offsets.*.*", F::number, N::fixed, position, U::axis, null, H::work_offsets, "", "-400", "", "of one axis; G17, G18, G19: basic rotation in that plane, degrees", "значение для одной оси; G17, G18, G19 — базовый поворот в этой плоскости, градусы"},
  {"zeros", F::table, N::zero, any, U::none, stated, H::zeros, "", R"({"1": {"X": 40, "Y": -10, "Z": -350}})", "work_offsets", "work zeros by their numbers, in machine coordinates", "плавающие нули по номерам, в координатах станка"},
  {"zeros.*", F::table, N::axis, any, U::none, stated, H::zeros, "", R"({"X": 40})", "", "one zero", "один нуль"},
  {"zeros.*.*", F::number, N::fixed, position, U::axis, null, H::zeros, "", "40", "", "of one axis", "значение для одной оси"},
  {"correctors", F::table, N::corrector, any, U::none, stated, H::correctors, "", R"({"17": -0.35})", "offsets", "axis correctors", "осевые корректоры"},
  {"correctors.*", F::number, N::fixed, position, U::mm, null, H::correctors, "", "-0.35", "", "one corrector", "один корректор"},
  {"tool", F::whole, N::fixed, count, U::none, stated, H::nothing, "", "4", "", "number of the tool in the spindle", "номер инструмента в шпинделе"},
  {"tool_table", F::table, N::tool_row, any, U::none, null, H::tool_management, "", R"({"1": {"T": 16, "info": "SENCV", "H": 1}})", "", "tool management: rows of its table", "строки таблицы управления инструментом"},
  {"tool_table.*", F::table, N::fixed, any, U::none, stated, H::tool_management, "", R"({"T": 16})", "", "one row", "одна строка"},
  {"tool_table.*.T", F::whole, N::fixed, count, U::none, stated, H::tool_management, "", "16", "", "type of the tool", "тип инструмента"},
  {"tool_table.*.info", F::info, N::fixed, bits, U::none, stated, H::tool_management, "", R"("SENCV")", "", "bits of information", "биты информации"},
  {"tool_table.*.form", F::whole, N::fixed, bits, U::none, stated, H::tool_management, "", "2", "", "number of its form", "номер формы"},
  {"tool_table.*.status", F::whole, N::fixed, bits, U::none, stated, H::tool_management, "", "2", "", "state", "состояние"},
  {"tool_table.*.counter", F::number, N::fixed, any, U::none, stated, H::tool_management, "", "1", "", "life used up", "израсходованная стойкость"},
  {"tool_table.*.life", F::number, N::fixed, any, U::none, stated, H::tool_management, "", "3", "", "life", "стойкость"},
  {"tool_table.*.warn", F::number, N::fixed, any, U::none, stated, H::tool_management, "", "2", "", "life at which it is warned", "стойкость, при которой выдаётся предупреждение"},
  {"tool_table.*.H", F::whole, N::fixed, count, U::none, stated, H::tool_management, "", "1", "", "number of the length offset", "номер корректора на длину"},
  {"tool_table.*.D", F::whole, N::fixed, count, U::none, stated, H::tool_management, "", "1", "", "number of the radius offset", "номер корректора на радиус"},
  {"tool_table.*.G", F::whole, N::fixed, count, U::none, stated, H::tool_management, "", "0", "", "column G", "столбец G"},
  {"tool_table.*.W", F::whole, N::fixed, count, U::none, stated, H::tool_management, "", "0", "", "column W", "столбец W"},
  {"tool_table.*.S", F::number, N::fixed, any, U::rev_min, stated, H::tool_management, "", "2400", "", "speed", "частота вращения"},
  {"tool_table.*.F", F::number, N::fixed, any, U::mm_min, stated, H::tool_management, "", "600", "", "feed", "подача"},
  {"tool_table.*.user_bits", F::whole, N::fixed, bits, U::none, stated, H::tool_management, "", "0", "", "bits of the user", "биты пользователя"},
  {"tool_table.*.user", F::numbers, N::fixed, any, U::none, stated, H::tool_management, "", "[0, 1.5]", "", "data of the user, at most 20", "данные пользователя, не более 20"},
  {"place_table", F::table, N::place, any, U::none, null, H::tool_management, "", R"({"1/8": 2})", "", "row of the tool table in a pocket of a magazine; 0: empty", "строка таблицы инструментов в гнезде магазина; 0 — пусто"},
  {"place_table.*", F::whole, N::fixed, {0, 999'999'999}, U::none, stated, H::tool_management, "", "2", "", "one pocket", "одно гнездо"},
  {"form_table", F::table, N::tool_form, any, U::none, null, H::tool_management, "", R"({"2": {"left": 1}})", "", "forms of tools: pockets that they cover", "формы инструментов: соседние гнёзда, которые они занимают"},
  {"form_table.*", F::table, N::fixed, any, U::none, stated, H::tool_management, "", R"({"left": 1})", "", "one form", "одна форма"},
  {"form_table.*.left", F::whole, N::fixed, count, U::none, stated, H::tool_management, "", "1", "", "to the left", "число занятых гнёзд слева"},
  {"form_table.*.right", F::whole, N::fixed, count, U::none, stated, H::tool_management, "", "1", "", "to the right", "число занятых гнёзд справа"},
  {"form_table.*.up", F::whole, N::fixed, count, U::none, stated, H::tool_management, "", "0", "", "up", "число занятых гнёзд сверху"},
  {"form_table.*.down", F::whole, N::fixed, count, U::none, stated, H::tool_management, "", "0", "", "down", "число занятых гнёзд снизу"},
  {"form_table.*.geometry", F::whole, N::fixed, count, U::none, stated, H::tool_management, "", "1", "", "shape", "геометрия"},
  {"variables", F::table, N::variable, any, U::none, stated, H::variables, "", R"({"#100": 2})", "", "values of variables; null: vacant", "значения переменных; null — пустая переменная"},
  {"variables.*", F::number, N::fixed, any, U::none, null, H::variables, "", "2", "", "one variable", "одна переменная"},
  {"parameters", F::table, N::parameter, any, U::none, null, H::parameters, "", R"({"N1501": 0.5, "N0306#0": 1})", "", "parameters: `.` is axis, spindle or channel, `#` a bit, by number or name", "параметры: `.` — ось, шпиндель или канал, `#` — бит, по номеру или имени"},
  {"parameters.*", F::number_or_text, N::fixed, any, U::none, stated, H::parameters, "", "0.5", "", "one parameter or bit", "один параметр или бит"},

  {"skip", F::wholes, N::fixed, {1, 9}, U::none, stated, H::nothing, "", "[1]", "", "skip switches that are on", "включённые переключатели пропуска кадров"},
  {"skip_answers", F::texts, N::any, any, U::none, stated, H::skip_question, "yes no", R"(["yes", "no"])", "", "the operator is asked before a block is skipped; what he says, in order, the last answer from then on", "ответы оператора на запрос перед пропуском кадра, по порядку; последний ответ действует и для остальных кадров"},
  {"disable", F::texts, N::any, any, U::none, stated, H::nothing, "", R"(["word_passed_over"])", "", "warnings and notes that are not told, by their id; an alarm is always told", "обозначения предупреждений и примечаний, которые не выводятся; сообщения об ошибках не отключаются"},
  {"optional_stop", F::flag, N::fixed, any, U::none, stated, H::nothing, "", "true", "", "the switch of M1 is on", "включён переключатель останова по M1"},
  {"single_block", F::flag, N::fixed, any, U::none, null, H::machine_axes, "", "true", "", "the switch block by block is on", "включён покадровый режим"},
  {"mirror", F::texts, N::axis, any, U::none, stated, H::nothing, "", R"(["X"])", "", "axes mirrored by a switch of the panel", "оси, зеркально отражаемые переключателем пульта"},
  {"override", F::table, N::fixed, any, U::none, stated, H::nothing, "", R"({"feed": 80})", "", "override switches", "регуляторы подачи и частоты вращения на пульте"},
  {"override.feed", F::number, N::fixed, percent, U::percent, stated, H::nothing, "", "80", "", "of the feed; default 100", "регулятор рабочей подачи; по умолчанию 100"},
  {"override.rapid", F::number, N::fixed, percent, U::percent, stated, H::nothing, "", "50", "", "of rapid motion; default 100", "регулятор ускоренного перемещения; по умолчанию 100"},
  {"override.spindle", F::number, N::fixed, percent, U::percent, stated, H::nothing, "", "110", "", "of the spindle; default 100", "регулятор частоты вращения шпинделя; по умолчанию 100"},
  {"reference_points", F::table, N::reference_point, any, U::none, stated, H::nothing, "", R"({"1": {"X": 0, "Y": 0, "Z": 0}})", "", "reference points, in machine coordinates", "исходные точки станка, в координатах станка"},
  {"reference_points.*", F::table, N::axis, any, U::none, stated, H::nothing, "", R"({"Z": 0})", "", "one point", "одна точка"},
  {"reference_points.*.*", F::number, N::fixed, position, U::axis, stated, H::nothing, "", "0", "", "of one axis", "значение для одной оси"},

  {"machine", F::table, N::axis_or_all, any, U::none, stated, H::nothing, "", R"({"*": {"rapid": 8000}, "Z": {"limits": [-400, 0]}})", "", "what the axes can do; \"*\": all. Goes before the machine file", "характеристики осей («*» — всех); имеют приоритет над файлом станка"},
  {"machine.*", F::table, N::fixed, any, U::none, stated, H::nothing, "", R"({"rapid": 8000})", "", "one axis", "одна ось"},
  {"machine.*.rapid", F::number, N::fixed, rate, U::mm_min, null, H::nothing, "", "8000", "", "rapid rate", "скорость ускоренного перемещения"},
  {"machine.*.acceleration", F::number, N::fixed, acceleration, U::mm_s2, null, H::nothing, "", "1000", "", "acceleration; null: without limit", "ускорение; null — без ограничения"},
  {"machine.*.jerk_time", F::number, N::fixed, seconds, U::seconds, null, H::nothing, "", "0.04", "", "time in which the acceleration rises; 0: at once", "время нарастания ускорения; 0 — мгновенно"},
  {"machine.*.limits", F::span, N::fixed, checked_position, U::axis, null, H::nothing, "", "[-400, 0]", "", "way of the axis, machine coordinates", "пределы перемещения оси, в координатах станка"},
  {"machine.*.zone3", F::span, N::fixed, checked_position, U::axis, null, H::machine_axes, "", "[0, 100]", "", "forbidden zone 3 of it, machine coordinates", "запретная зона 3 по этой оси, в координатах станка"},
  {"machine.*.switches", F::span, N::fixed, checked_position, U::axis, null, H::machine_axes, "", "[-405, 5]", "", "end-position switches: where the axis hits them, machine coordinates", "конечные выключатели: положения оси, при которых они срабатывают, в координатах станка"},
  {"machine.*.apart", F::number, N::fixed, distance, U::axis, null, H::machine_axes, "", "0.05", "", "of a gantry axis: how far it may be from its master", "для ведомой оси портала: допустимое расхождение с ведущей"},
  {"machine.*.position_error", F::number, N::fixed, distance, U::axis, null, H::machine_axes, "", "0.1", "", "the axis stays that far from the command", "ось не доходит до заданного положения на эту величину"},
  {"spindle", F::table, N::spindle, any, U::none, stated, H::nothing, "", R"({"1": {"rpm": 600, "dir": "cw"}})", "", "spindles before the start", "шпиндели перед пуском"},
  {"spindle.*", F::table, N::fixed, any, U::none, stated, H::nothing, "", R"({"rpm": 600})", "", "one spindle", "один шпиндель"},
  {"spindle.*.rpm", F::number, N::fixed, speed, U::rev_min, stated, H::nothing, "", "600", "", "speed", "частота вращения"},
  {"spindle.*.dir", F::one_of, N::fixed, any, U::none, stated, H::nothing, "cw ccw stop", R"("cw")", "", "direction", "направление вращения"},
  {"spindle.*.angle", F::number, N::fixed, any, U::degrees, null, H::nothing, "", "0", "", "angle", "угловое положение"},
  {"spindle.*.name", F::text, N::fixed, any, U::none, null, H::machine_axes, "", R"("S")", "", "its address in the program", "адрес в программе"},
  {"spindle.*.channel", F::whole, N::fixed, channels, U::none, null, H::machine_axes, "", "1", "", "channel it belongs to", "канал шпинделя"},
  {"spindle.*.ranges", F::spans, N::fixed, any, U::rev_min, null, H::machine_axes, "", "[[50, 1000], [800, 4000]]", "", "least and greatest speed of each gear range", "наименьшая и наибольшая частота вращения каждого диапазона"},
  {"spindle.*.loop", F::one_of, N::fixed, any, U::none, stated, H::machine_axes, "open closed", R"("open")", "", "position loop; of a printed state", "контур положения; из напечатанного состояния"},
  {"spindle.*.surface_speed", F::number, N::fixed, speed, U::m_min, stated, H::machine_axes, "", "100", "", "cutting speed of G96; of a printed state", "скорость резания G96; из напечатанного состояния"},
  {"spindle.*.css_axis", F::whole, N::fixed, {0, 999'999'999}, U::none, null, H::machine_axes, "", "1", "", "axis of G96; of a printed state", "ось G96; из напечатанного состояния"},
  {"spindle.*.master", F::whole, N::fixed, {0, 16}, U::none, null, H::machine_axes, "", "1", "", "spindle it follows; of a printed state", "ведущий шпиндель; из напечатанного состояния"},
  {"probe", F::table, N::probe_input, any, U::none, stated, H::probe, "", R"({"1": {"Z": -10}})", "", "where the signal of a probe comes, in the work system; null: never", "положение срабатывания щупа в координатах детали; null — касания нет"},
  {"probe.*", F::table, N::axis, any, U::none, null, H::probe, "", R"({"Z": -10})", "", "one input", "один вход"},
  {"probe.*.*", F::number, N::fixed, position, U::axis, stated, H::probe, "", "-10", "", "of one axis", "значение для одной оси"},
  {"probe_workpiece", F::table, N::fixed, any, U::none, null, H::probe, "", R"({"tip_radius": 2, "hole": {"center": {"X": 50, "Y": 24}, "diameter": 40, "top": 0, "depth": 30}})", "", "a part with a hole that the probe touches", "деталь с отверстием, которой касается щуп"},
  {"probe_workpiece.tip_radius", F::number, N::fixed, distance, U::mm, stated, H::probe, "", "2", "", "radius of the probe's ball", "радиус шарика щупа"},
  {"probe_workpiece.hole", F::table, N::fixed, any, U::none, stated, H::probe, "", R"({"center": {"X": 50, "Y": 24}, "diameter": 40, "top": 0, "depth": 30})", "", "the hole, in the work system", "отверстие, в системе детали"},
  {"probe_workpiece.hole.center", F::table, N::fixed, any, U::none, stated, H::probe, "", R"({"X": 50, "Y": 24})", "", "its centre", "центр"},
  {"probe_workpiece.hole.center.X", F::number, N::fixed, checked_position, U::mm, stated, H::probe, "", "50", "", "centre, X", "центр, X"},
  {"probe_workpiece.hole.center.Y", F::number, N::fixed, checked_position, U::mm, stated, H::probe, "", "24", "", "centre, Y", "центр, Y"},
  {"probe_workpiece.hole.diameter", F::number, N::fixed, diameter, U::mm, stated, H::probe, "", "40", "", "diameter", "диаметр"},
  {"probe_workpiece.hole.top", F::number, N::fixed, checked_position, U::mm, stated, H::probe, "", "0", "", "Z of its upper edge", "Z верхней кромки"},
  {"probe_workpiece.hole.depth", F::number, N::fixed, distance, U::mm, stated, H::probe, "", "30", "", "depth", "глубина"},

  {"clock", F::text, N::fixed, any, U::none, null, H::clock, "", R"("2014-05-18T15:32:41")", "", "date and time that the program reads", "дата и время, которые читает программа"},
  {"ini", F::text, N::fixed, any, U::none, null, H::ini, "", R"("machine.ini")", "", "ini file of the control, from the folder of the program memory", "ini-файл УЧПУ, путь от папки памяти программ"},
  {"signals", F::table, N::signal, any, U::none, null, H::machine_axes, "", R"({"CP_NOWT": 1})", "", "signals of the machine's logic (PLC)", "сигналы электроавтоматики станка (ПЛК)"},
  {"signals.*", F::number, N::fixed, any, U::none, stated, H::machine_axes, "", "1", "", "one signal; 0: off", "один сигнал; 0 — снят"},
  {"events", F::tables, N::fixed, any, U::none, null, H::machine_axes, "", R"([{"when": {"code": "M90"}, "do": "skip", "switch": 2, "on": true}])", "", "what the logic and the operator do, and when", "действия электроавтоматики и оператора и моменты, когда они происходят"},
  {"events.when", F::table, N::fixed, any, U::none, stated, H::machine_axes, "", R"({"block": "N30", "at": "end"})", "", "{block, at}, {code, count}, {action} or {program}", "{block, at}, {code, count}, {action} или {program}"},
  {"events.when.block", F::text, N::fixed, any, U::none, stated, H::machine_axes, "", R"("N30")", "", "number of a block", "номер кадра"},
  {"events.when.at", F::one_of, N::fixed, any, U::none, stated, H::machine_axes, "start end", R"("end")", "", "before or behind it; default start", "до или после него; по умолчанию start"},
  {"events.when.code", F::text, N::fixed, any, U::none, stated, H::machine_axes, "", R"("M90")", "", "a code that is sent to the machine: M, S, T, …", "код, передаваемый станку: M, S, T, …"},
  {"events.when.count", F::whole, N::fixed, {1, 999'999'999}, U::none, stated, H::machine_axes, "", "3", "", "the n-th time only", "только в n-й раз"},
  {"events.when.action", F::one_of, N::fixed, any, U::none, stated, H::machine_axes, "stop message", R"("message")", "", "a stop or a message", "останов или сообщение"},
  {"events.when.program", F::one_of, N::fixed, any, U::none, stated, H::machine_axes, "end", R"("end")", "", "the end of the program", "конец программы"},
  {"events.do", F::one_of, N::fixed, any, U::none, stated, H::machine_axes, "set skip start answer power_cycle synchronise release spindle_to_axis axis_to_spindle exchange reverse park", R"("skip")", "", "what happens", "действие"},
  {"events.signal", F::text, N::signal, any, U::none, stated, H::machine_axes, "", R"("CP_MINT")", "", "of set: the signal", "для set: сигнал"},
  {"events.value", F::number, N::fixed, any, U::none, stated, H::machine_axes, "", "1", "", "of set: its value", "для set: значение"},
  {"events.switch", F::whole, N::fixed, {1, 9}, U::none, stated, H::machine_axes, "", "2", "", "of skip: the switch", "для skip: переключатель"},
  {"events.on", F::flag, N::fixed, any, U::none, stated, H::machine_axes, "", "true", "", "of skip; of exchange, reverse, park: default true", "для skip: включить или выключить; для exchange, reverse, park: по умолчанию true"},
  {"events.answer", F::one_of, N::fixed, any, U::none, stated, H::machine_axes, "ok yes no cancel", R"("no")", "", "of answer: to the message box", "для answer: ответ в окне сообщения"},
  {"events.spindle", F::whole, N::fixed, spindles, U::none, stated, H::machine_axes, "", "2", "", "of synchronise, release, spindle_to_axis, axis_to_spindle", "для synchronise, release, spindle_to_axis, axis_to_spindle"},
  {"events.master", F::whole, N::fixed, spindles, U::none, stated, H::machine_axes, "", "1", "", "of synchronise: the leading spindle", "для synchronise: ведущий шпиндель"},
  {"events.axis", F::text, N::axis_of_any, any, U::none, stated, H::machine_axes, "", R"("X")", "", "of synchronise, release: the following axis; of exchange: that whose parameter names the other; of reverse, park", "для synchronise, release: ведомая ось; для exchange: ось, в параметре которой задана другая; для reverse, park"},
  {"events.axes", F::texts, N::axis_of_any, any, U::none, stated, H::machine_axes, "", R"(["X", "Y"])", "", "the same, several", "то же, несколько"},
  {"channel", F::whole, N::fixed, channels, U::none, null, H::machine_axes, "", "1", "", "channel of the program", "канал программы"},
  {"channels", F::table, N::channel, any, U::none, null, H::machine_axes, "", R"({"2": {"axes": ["X", "Z"], "program": "M30"}})", "", "the other channels", "другие каналы"},
  {"channels.*", F::table, N::fixed, any, U::none, stated, H::machine_axes, "", R"({"program": "M30"})", "", "one channel", "один канал"},
  {"channels.*.program", F::text, N::fixed, any, U::none, stated, H::machine_axes, "", R"("M30")", "", "text of its program", "текст программы"},
  {"channels.*.axes", F::texts, N::any, any, U::none, stated, H::machine_axes, "", R"(["X", "Z"])", "", "its axes", "его оси"},

  {"points", F::numbers, N::fixed, {0, 1}, U::none, stated, H::nothing, "", "[0.5]", "", "parts of a motion at which the trace says where the tool is", "доли перемещения, для которых в протокол записывается положение"},
  {"watch", F::texts, N::any, any, U::none, stated, H::nothing, "", R"(["#100"])", "", "variables that the last line of the trace holds", "переменные, значения которых выводятся в последней строке протокола"},
  {"shifts", F::table, N::shift, any, U::none, null, H::machine_axes, "", R"({"G92": {"X": 60}})", "", "of a printed state: shifts by G92, G52; not put in force again", "из напечатанного состояния: смещения G92, G52; повторно не применяются"},
  {"shifts.*", F::table, N::axis, any, U::none, stated, H::machine_axes, "", R"({"X": 60})", "", "one shift", "одно смещение"},
  {"shifts.*.*", F::number, N::fixed, position, U::axis, stated, H::machine_axes, "", "60", "", "of one axis", "значение для одной оси"},
  {"files", F::table, N::any, any, U::none, null, H::nothing, "", R"({"sub.nct": "M99"})", "", "of a golden case: the program memory; the runner lays it out, Kadr does not read it here", "только в эталонных тестах: память программ; файлы создаёт программа тестирования, Kadr их отсюда не читает"},
  {"main_file", F::text, N::fixed, any, U::none, null, H::nothing, "", R"("main.nct")", "", "of a golden case: the program's name there", "только в эталонных тестах: имя программы там"},
  {"notes", F::texts, N::any, any, U::none, null, H::nothing, "", R"(["G54: measured on the vice"])", "", "remarks for people; without effect", "пояснения; на отработку не влияют"},
  {"search", F::text, N::fixed, any, U::none, null, H::machine_axes, "", R"("N50")", "", "the run begins with the control's block search for that block", "прогон начинается с поиска этого кадра средствами УЧПУ"},
  {"kinematics", F::table, N::fixed, any, U::none, null, H::machine_axes, "", R"({"type": "table-table", "axes": "AC", "reversed": "AC", "T1": [300, -200, -450], "T2": [0, 4, -60]})", "", "the machine's rotary axes in words: what N3200 to N3224 say; those go before", "кинематика поворотных осей: то же, что N3200–N3224; параметры имеют приоритет"},
  {"kinematics.type", F::one_of, N::fixed, any, U::none, stated, H::machine_axes, "head-head table-table head-table", R"("table-table")", "", "what the rotary axes turn", "тип кинематики: две оси в головке, две в столе или по одной"},
  {"kinematics.axes", F::one_of, N::fixed, any, U::none, stated, H::machine_axes, "CA CB AB BA AC BC", R"("AC")", "", "first and second rotary axis; A turns about X, B about Y, C about Z", "первая и вторая поворотные оси; A — вокруг X, B — вокруг Y, C — вокруг Z"},
  {"kinematics.reversed", F::text, N::fixed, any, U::none, stated, H::machine_axes, "", R"("AC")", "", "axes whose positive motion is left-handed (RD1, RD2 of N3212)", "оси, у которых положительное направление вращения — левое (RD1, RD2 параметра N3212)"},
  {"kinematics.T1", F::numbers, N::fixed, checked_position, U::mm, stated, H::machine_axes, "", "[300, -200, -450]", "", "point of the (first) table's axis, machine coordinates", "точка на оси (первого) стола, в координатах станка"},
  {"kinematics.T2", F::numbers, N::fixed, checked_position, U::mm, stated, H::machine_axes, "", "[0, 4, -60]", "", "from there to the second table's axis", "расстояние от этой точки до оси второго стола"},
  {"kinematics.E", F::numbers, N::fixed, checked_position, U::mm, stated, H::machine_axes, "", "[5, -3, 200]", "", "from the gauge point to the axis nearest to the tool", "расстояние от базовой точки инструмента до ближайшей к нему оси"},
  {"kinematics.D", F::numbers, N::fixed, checked_position, U::mm, stated, H::machine_axes, "", "[20, 8, 50]", "", "from the second axis of the head to the first", "от второй оси головки до первой"},
  {"kinematics.singular", F::number, N::fixed, singular, U::degrees, stated, H::machine_axes, "", "0.05", "", "by how much a vector of G43.5, G43.9 may be missed so that an axis need not whirl near a singular direction; default 0.01, 0: not at all", "допустимое отклонение от вектора G43.5, G43.9, предотвращающее быстрый поворот оси вблизи особого направления; по умолчанию 0.01, 0 — не допускается"},
  {"frame", F::table, N::any, any, U::none, null, H::machine_axes, "", "{}", "", "of a printed state; must be empty", "из напечатанного состояния; должно быть пусто"},
};

constexpr SetupSignal signals[] = {
  {"CP_MINT", "interrupt macro (M96)", "прерывающий макрос (M96)", "23.4"},
  {"CP_NOWT", "channels do not wait for each other", "каналы не ждут друг друга", "14.5"},
  {"CP_LIM2DIS", "zone 2 is suspended", "зона 2 отключена", "22.2"},
  {"CP_LIM3DIS", "zone 3 is suspended", "зона 3 отключена", "22.3"},
  {"AP_SYNCR", "the axis follows its master, which its parameter names", "ось движется вслед за ведущей, названной её параметром", "20.2", true},
  {"AP_PARKR", "the axis is parked", "ось запаркована", "20.2", true},
  {"AP_MIXR", "the axis is exchanged with its partner, which its parameter names", "ось обменяна с парной, названной её параметром", "20.3", true},
  {"AP_MIRR", "the axis goes the other way round", "направление оси обращено", "20.4", true},
};
// clang-format on

/// Checks that each path occurs once, and after the table that contains it.
constexpr bool paths_in_order() {
  for (std::size_t i = 0; i < std::size(keys); ++i) {
    const std::string_view path = keys[i].path;
    const std::size_t point = path.rfind('.');
    bool parent = point == std::string_view::npos;
    for (std::size_t j = 0; j < i; ++j) {
      if (keys[j].path == path) return false;
      if (!parent && keys[j].path == path.substr(0, point)) parent = keys[j].form == F::table || keys[j].form == F::tables;
    }
    if (!parent) return false;
  }
  return true;
}
static_assert(paths_in_order());

}  // namespace

std::span<const SetupKey> setup_keys() { return keys; }

const SetupKey* setup_key(std::string_view path) {
  const auto* const found = std::find_if(std::begin(keys), std::end(keys), [&](const SetupKey& row) { return row.path == path; });
  return found == std::end(keys) ? nullptr : found;
}

std::span<const SetupSignal> setup_signals() { return signals; }

AxisSignal axis_signal(std::string_view name) {
  constexpr std::pair<std::string_view, AxisLink> links[] = {{"AP_SYNCR.", AxisLink::follows},
                                                             {"AP_PARKR.", AxisLink::parked},
                                                             {"AP_MIXR.", AxisLink::exchanged},
                                                             {"AP_MIRR.", AxisLink::reversed}};
  for (const auto& [front, link] : links)
    if (name.starts_with(front)) return {link, name.substr(front.size())};
  return {};
}

SetupWords name_of(SetupUnit unit) {
  constexpr SetupWords names[] = {{"", ""},           {"mm", "мм"}, {"mm, degrees", "мм, градусы"}, {"mm/min", "мм/мин"},
                                  {"mm/s²", "мм/с²"}, {"s", "с"},   {"degrees", "градусы"},         {"rev/min", "об/мин"},
                                  {"m/min", "м/мин"}, {"%", "%"}};
  return names[static_cast<std::size_t>(unit)];
}

}  // namespace kadr
