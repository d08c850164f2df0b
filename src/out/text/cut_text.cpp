// Describes the result of a cut in words and as JSON. This file is used by cli/cut and tested by tests/run_cut.py.

#include "out/text/cut_text.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "out/text/cut_load_text.h"
#include "out/text/summary.h"
#include "texts/cut_summary.h"

namespace kadr {
namespace {

using nlohmann::ordered_json;

constexpr double least_reported = 0.05;  // least time in the air that is printed, s; a shorter time would be rounded to 0.0

/// Rounds a value in mm or mm³ to three decimals, since further decimals are not significant.
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

std::string difference_row(PlainText name, const PartDifference& d, Lang lang) {
  if (!(d.deepest > 0)) return summary_row(plain_text(name, lang), plain_text(texts::cut_summary::none, lang));
  std::string text = translated_in(lang, texts::cut_summary::difference, d.volume, d.deepest, d.at.x, d.at.y, d.at.z);
  Origin last_cut;
  last_cut.line = d.line;
  if (d.line != 0) text += ", " + line_words(last_cut, d.program, lang);
  return summary_row(plain_text(name, lang), text);
}

/// Returns the depth of the thread below its crest, mm. The depth is negative if the tip of the insert has not reached the crest.
double thread_depth(const ThreadCut& t) { return (t.is_outer ? 1 : -1) * (*t.crest_radius - t.middle_radius()); }

std::string left_out_words(const TurnedResult::LeftOut& left, Lang lang) {
  return translated_in(lang, texts::cut_summary::motions_left_out, left.tool, left.motions, line_words(left.origin, left.program, lang));
}

ordered_json turned_json(const TurnedResult& turned) {
  ordered_json json{{"surface", rounded(turned.surface)}, {"machined", rounded(turned.machined)}};
  for (const TurnedResult::LeftOut& left : turned.left_out) {
    ordered_json one;
    add_place(one, left.origin, left.program);
    one["tool"] = left.tool;
    one["motions"] = left.motions;
    json["left_out"].push_back(one);
  }
  return json;
}

std::string thread_words(const ThreadCut& t, Lang lang) {
  std::string text = translated_in(lang, texts::cut_summary::thread, t.tool, t.origin.line, 2 * t.from_radius, t.from_z, 2 * t.to_radius,
                                   t.to_z, t.passes);
  if (t.lead != 0) text += ", " + translated_in(lang, texts::cut_summary::thread_lead, t.lead);
  text += "; ";
  return text + (t.crest_radius ? translated_in(lang, texts::cut_summary::thread_depth, thread_depth(t), 2 * *t.crest_radius)
                                : translated_in(lang, texts::cut_summary::no_material_there));
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
  const double removed = r.window ? r.window->stock - r.window->left : r.stock - r.left, cell = r.window ? r.window->cell : r.cell;
  if (r.turned) return translated_in(lang, texts::cut_summary::removed_of_body, removed);
  return translated_in(lang, texts::cut_summary::removed_with_cell, removed, cell);
}

std::string cut_summary(const CutResult& r, Lang lang) {
  const auto row = [&](PlainText name, const std::string& value) { return summary_row(plain_text(name, lang), value); };
  const auto volume = [&](double v) { return translated_in(lang, texts::cut_summary::volume_within, v, r.error_bound); };
  const std::string cell =
      r.turned ? std::string() : row(texts::cut_summary::cell, translated_in(lang, texts::cut_summary::length, r.cell));
  std::string text = cell + row(texts::cut_summary::blank, translated_in(lang, texts::cut_summary::volume, r.stock)) +
                     row(texts::cut_summary::left, volume(r.left)) + row(texts::cut_summary::removed, volume(r.stock - r.left));
  if (r.turned)
    text += row(texts::cut_summary::surface, translated_in(lang, texts::cut_summary::areas, r.turned->surface, r.turned->machined));
  if (const auto& in = r.window)
    text += row(texts::cut_summary::window, translated_in(lang, texts::cut_summary::window_volumes, in->cell, in->stock, in->left,
                                                          in->error_bound, in->stock - in->left, in->error_bound));
  const char* name = plain_text(texts::cut_summary::tools, lang);
  const auto next_of_list = [&](const std::string& value) {
    text += summary_row(name, value);
    name = "";
  };
  for (const ToolRemoval& t : r.tools)
    next_of_list(translated_in(lang, texts::cut_summary::tool_removal, t.tool, t.removed, duration_text(t.seconds), t.greatest_rate));
  name = plain_text(texts::cut_summary::threads, lang);
  for (const ThreadCut& t : r.threads) next_of_list(thread_words(t, lang));
  name = plain_text(texts::cut_summary::heaviest, lang);
  for (const BlockLoad& load : r.heaviest) next_of_list(load_words(load, lang));
  name = plain_text(texts::cut_summary::in_the_air, lang);
  for (const AirCut& air : r.emptiest)
    if (air.seconds >= least_reported) next_of_list(air_words(air, lang));
  name = plain_text(texts::cut_summary::left_out, lang);
  if (r.turned)
    for (const TurnedResult::LeftOut& left : r.turned->left_out) next_of_list(left_out_words(left, lang));
  const std::size_t count = r.collisions.size() + r.not_listed;
  if (r.part)
    text += difference_row(texts::cut_summary::left_on, r.part->left_on, lang) +
            difference_row(texts::cut_summary::gouged, r.part->gouged, lang);
  if (r.simplified)
    text += row(texts::cut_summary::simplified,
                translated_in(lang, texts::cut_summary::fewer_triangles, r.simplified->triangles, r.simplified->exact, r.simplified->off));
  return text + row(texts::cut_summary::collisions, count == 0 ? translated_in(lang, texts::cut_summary::none) : std::to_string(count));
}

std::string too_coarse_message(const CutResult& r, Lang lang) {
  if (r.finer_than_cell.empty()) return {};
  std::string tools;
  for (const std::uint32_t number : r.finer_than_cell) tools += fmt::format("{}T{}", tools.empty() ? "" : ", ", number);
  const double cell = r.window ? r.window->cell : r.cell;
  return translated_in(lang, texts::cut_summary::tools_too_thin, tools, cell);
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
  if (r.turned) json["turned"] = turned_json(*r.turned);
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
