// Describes the result of a cut in words. Used by cli/cut; tested by tests/out/cut_text_test.cpp.

#include "out/text/cut_text.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "out/text/cut_load_text.h"
#include "out/text/summary.h"

namespace kadr {
namespace {

using nlohmann::ordered_json;

/// The words of the summary in one language.
struct CutWords {
  const char *cell, *blank, *left, *removed, *tools, *none, *rate, *collisions, *further, *left_on, *gouged, *deepest, *line, *heaviest,
      *in_air, *window, *in_window, *simplified, *triangles, *threads, *thread, *lead, *no_crest, *crest;
};
constexpr CutWords cut_english = {"cell",
                                  "blank",
                                  "left",
                                  "removed",
                                  "tools",
                                  "none",
                                  "{} at feed, at most {:.1f} mm³/s",
                                  "collisions",
                                  "and {} more",
                                  "left on",
                                  "gouged",
                                  "{:.1f} {}, {:.3f} {} deep at X{:.2f} Y{:.2f} Z{:.2f}",
                                  ", line {}",
                                  "heaviest",
                                  "in the air",
                                  "window",
                                  "cell {:g} {}; of {:.1f} {} left {:.1f} ± {:.1f}, removed {:.1f} ± {:.1f}",
                                  "simplified",
                                  "{} of {} triangles, {:.4f} {} off at most",
                                  "threads",
                                  "T{}, line {}: Ø{:.3f} Z{:.3f} to Ø{:.3f} Z{:.3f} mm, passes: {}",
                                  ", lead {:g} mm",
                                  "; no material is there",
                                  "; {:.3f} mm deep in Ø{:.3f} mm, which the part keeps"};
constexpr CutWords cut_russian = {"шаг сетки",
                                  "заготовка",
                                  "осталось",
                                  "снято",
                                  "инструменты",
                                  "нет",
                                  "{} на подаче, не более {:.1f} мм³/с",
                                  "столкновений",
                                  "и ещё {}",
                                  "недобор",
                                  "зарез",
                                  "{:.1f} {}, {:.3f} {} в точке X{:.2f} Y{:.2f} Z{:.2f}",
                                  ", строка {}",
                                  "нагрузка",
                                  "в воздухе",
                                  "окно",
                                  "шаг {:g} {}; из {:.1f} {} осталось {:.1f} ± {:.1f}, снято {:.1f} ± {:.1f}",
                                  "упрощено",
                                  "{} треугольников из {}, отклонение не более {:.4f} {}",
                                  "резьбы",
                                  "T{}, строка {}: Ø{:.3f} Z{:.3f} до Ø{:.3f} Z{:.3f} мм, проходов: {}",
                                  ", ход {:g} мм",
                                  "; материала там нет",
                                  "; глубина {:.3f} мм от Ø{:.3f} мм, который у детали остаётся"};

constexpr double told_from = 0.05;  // s in the air, from which on the time is printed: less would be rounded to 0.0

/// Rounds to thousandths of a mm or mm³, since further digits are not significant.
double rounded(double value) { return std::round(value * 1000) / 1000 + 0.0; }

std::string summary_row(std::string_view name, std::string_view text) { return fmt::format("{:<12} {}\n", name, text); }

ordered_json finding_json(const CutFinding& f) {
  ordered_json json{{"id", name_of(f.id)}};
  add_place(json, f.origin, f.program);
  json["tool"] = f.tool;
  json["at"] = {{"X", rounded(f.at.x)}, {"Y", rounded(f.at.y)}, {"Z", rounded(f.at.z)}};
  json["depth"] = rounded(f.depth);
  json["volume"] = rounded(f.volume);
  json["at_time"] = rounded(f.at_time);
  if (!f.calls.empty()) json["calls"] = calls_json(f.calls);
  if (!f.bodies[0].empty()) json["bodies"] = f.bodies;
  return json;
}

ordered_json findings_json(const std::vector<CutFinding>& findings) {
  ordered_json list = ordered_json::array();
  for (const CutFinding& f : findings) list.push_back(finding_json(f));
  return list;
}

ordered_json difference_json(const PartDifference& d) {
  ordered_json json{{"volume", rounded(d.volume)},
                    {"deepest", rounded(d.deepest)},
                    {"line", d.line},
                    {"at", {{"X", rounded(d.at.x)}, {"Y", rounded(d.at.y)}, {"Z", rounded(d.at.z)}}}};
  if (!d.program.empty()) json["program"] = d.program;
  return json;
}

std::string difference_row(const CutWords& w, const char* name, const PartDifference& d, Lang lang) {
  const bool ru = lang == Lang::ru;
  if (!(d.deepest > 0)) return summary_row(name, w.none);
  std::string text =
      fmt::format(fmt::runtime(w.deepest), d.volume, ru ? "мм³" : "mm³", d.deepest, ru ? "мм" : "mm", d.at.x, d.at.y, d.at.z);
  if (d.line != 0) text += fmt::format(fmt::runtime(w.line), d.line) + (d.program.empty() ? "" : (ru ? " файла " : " of ") + d.program);
  return summary_row(name, text);
}

/// Returns the depth of the thread below its crest; negative if the tip of the insert has not reached the crest.
double thread_depth(const ThreadCut& t) { return (t.is_outer ? 1 : -1) * (*t.crest_radius - t.middle_radius()); }

std::string thread_words(const CutWords& w, const ThreadCut& t) {
  std::string text =
      fmt::format(fmt::runtime(w.thread), t.tool, t.origin.line, 2 * t.from_radius, t.from_z, 2 * t.to_radius, t.to_z, t.passes);
  if (t.lead != 0) text += fmt::format(fmt::runtime(w.lead), t.lead);
  return text + (t.crest_radius ? fmt::format(fmt::runtime(w.crest), thread_depth(t), 2 * *t.crest_radius) : std::string(w.no_crest));
}

ordered_json thread_json(const ThreadCut& t) {
  ordered_json json;
  add_place(json, t.origin, t.program);
  json["tool"] = t.tool;
  if (t.lead != 0) json["lead"] = t.lead;
  json["passes"] = t.passes;
  json["outer"] = t.is_outer;
  json["from"] = {{"diameter", rounded(2 * t.from_radius)}, {"Z", rounded(t.from_z)}};
  json["to"] = {{"diameter", rounded(2 * t.to_radius)}, {"Z", rounded(t.to_z)}};
  if (t.crest_radius) json["crest"] = rounded(2 * *t.crest_radius), json["depth"] = rounded(thread_depth(t));
  return json;
}

}  // namespace

std::string names_of_bodies(const CutFinding& f) { return f.bodies[0].empty() ? std::string() : f.bodies[0] + ", " + f.bodies[1]; }

Alarm alarm_of(const CutFinding& f) {
  const std::string place = fmt::format("X{:.2f} Y{:.2f} Z{:.2f}", f.at.x, f.at.y, f.at.z);
  const double tool = f.tool, depth = rounded(f.depth);
  if (f.id == AlarmId::machine) return alarm(f.id, {}, place, names_of_bodies(f));
  return f.id == AlarmId::no_coolant ? warning(f.id, {}, tool, depth, place) : alarm(f.id, {}, tool, depth, place);
}

std::string cut_caption(const CutResult& r, Lang lang) {
  const bool ru = lang == Lang::ru;
  const double removed = r.window ? r.window->stock - r.window->left : r.stock - r.left, cell = r.window ? r.window->cell : r.cell;
  return fmt::format("{} {:.1f} {}, {} {:g} {}", ru ? "снято" : "removed", removed, ru ? "мм³" : "mm³", ru ? "шаг сетки" : "cell", cell,
                     ru ? "мм" : "mm");
}

std::string cut_summary(const CutResult& r, Lang lang) {
  const CutWords& w = lang == Lang::ru ? cut_russian : cut_english;
  const char* const mm = lang == Lang::ru ? "мм" : "mm";
  const char* const mm3 = lang == Lang::ru ? "мм³" : "mm³";
  const auto volume = [&](double v) { return fmt::format("{:.1f} {}", v, mm3); };
  std::string text = summary_row(w.cell, fmt::format("{:g} {}", r.cell, mm)) + summary_row(w.blank, volume(r.stock)) +
                     summary_row(w.left, fmt::format("{:.1f} ± {:.1f} {}", r.left, r.error_bound, mm3)) +
                     summary_row(w.removed, fmt::format("{:.1f} ± {:.1f} {}", r.stock - r.left, r.error_bound, mm3));
  if (const auto& in = r.window)
    text += summary_row(w.window, fmt::format(fmt::runtime(w.in_window), in->cell, mm, in->stock, mm3, in->left, in->error_bound,
                                              in->stock - in->left, in->error_bound));
  const char* name = w.tools;
  for (const ToolRemoval& t : r.tools) {
    text += summary_row(name, fmt::format("T{}: {}, ", t.tool, volume(t.removed)) +
                                  fmt::format(fmt::runtime(w.rate), duration_text(t.seconds), t.greatest_rate));
    name = "";
  }
  name = w.threads;
  for (const ThreadCut& t : r.threads) text += summary_row(name, thread_words(w, t)), name = "";
  name = w.heaviest;
  for (const BlockLoad& load : r.heaviest) text += summary_row(name, load_words(load, lang)), name = "";
  name = w.in_air;
  for (const AirCut& air : r.emptiest)
    if (air.seconds >= told_from) text += summary_row(name, air_words(air, lang)), name = "";
  const std::size_t count = r.collisions.size() + r.not_listed;
  if (r.part) text += difference_row(w, w.left_on, r.part->left_on, lang) + difference_row(w, w.gouged, r.part->gouged, lang);
  if (r.simplified)
    text += summary_row(w.simplified,
                        fmt::format(fmt::runtime(w.triangles), r.simplified->triangles, r.simplified->exact, r.simplified->off, mm));
  return text + summary_row(w.collisions, count == 0 ? std::string(w.none) : std::to_string(count));
}

std::string too_coarse_message(const CutResult& r, Lang lang) {
  if (r.finer_than_cell.empty()) return {};
  std::string tools;
  for (const std::uint32_t number : r.finer_than_cell) tools += fmt::format("{}T{}", tools.empty() ? "" : ", ", number);
  const double cell = r.window ? r.window->cell : r.cell;
  return lang == Lang::ru ? fmt::format(
                                "{} тоньше двух шагов сетки ({:g} мм): снятое ими почти не видно и не измерено; поможет меньший "
                                "--resolution или --window",
                                tools, cell)
                          : fmt::format(
                                "{}: thinner than two cells ({:g} mm): what they cut is hardly seen, and not measured; a smaller "
                                "--resolution, or --window, shows it",
                                tools, cell);
}

ordered_json cut_json(const CutResult& r, std::size_t alarms, std::size_t warnings) {
  ordered_json json{{"stock", rounded(r.stock)},
                    {"left", rounded(r.left)},
                    {"removed", rounded(r.stock - r.left)},
                    {"error_bound", rounded(r.error_bound)},
                    {"resolution", r.cell},
                    {"seconds", rounded(r.seconds)},
                    {"alarms", alarms + r.collisions.size() + r.not_listed},
                    {"warnings", warnings + r.warnings.size()}};
  if (r.window)
    json["window"] = {{"stock", rounded(r.window->stock)},
                      {"left", rounded(r.window->left)},
                      {"removed", rounded(r.window->stock - r.window->left)},
                      {"error_bound", rounded(r.window->error_bound)},
                      {"resolution", r.window->cell}};
  json["tools"] = ordered_json::array();
  for (const ToolRemoval& t : r.tools)
    json["tools"].push_back(
        {{"tool", t.tool}, {"removed", rounded(t.removed)}, {"seconds", rounded(t.seconds)}, {"greatest_rate", rounded(t.greatest_rate)}});
  for (const ThreadCut& t : r.threads) json["threads"].push_back(thread_json(t));
  json["collisions"] = findings_json(r.collisions);
  add_loads(json, r);
  if (r.part) json["part"] = {{"left_on", difference_json(r.part->left_on)}, {"gouged", difference_json(r.part->gouged)}};
  if (r.simplified)
    json["simplified"] = {{"exact", r.simplified->exact}, {"triangles", r.simplified->triangles}, {"off", r.simplified->off}};
  if (!r.finer_than_cell.empty()) json["finer_than_cell"] = r.finer_than_cell;
  if (!r.warnings.empty()) json["warned"] = findings_json(r.warnings);
  return json;
}

}  // namespace kadr
