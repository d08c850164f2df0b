// Describes in words and tables what each block removes. This file is used by out/text/cut_text and tested by
// tests/out/cut_load_text_test.cpp.

#include "out/text/cut_load_text.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "out/text/alarm_print.h"
#include "out/text/summary.h"
#include "texts/cut_summary.h"

namespace kadr {
namespace {

using nlohmann::ordered_json;

constexpr int decimals_of_mm = 3, decimals_of_tooth = 5;  // number of decimals of values in mm, and of values in mm per tooth

double cut_to(double value, int decimals) {
  const double scale = std::pow(10, decimals);
  return std::round(value * scale) / scale + 0.0;
}

ordered_json number_or_null(const std::optional<double>& value, int decimals = decimals_of_mm) {
  return value ? ordered_json(cut_to(*value, decimals)) : ordered_json();
}

std::string number_cell(const std::optional<double>& value, int decimals = decimals_of_mm) {
  return value ? fmt::format("{:.{}f}", *value + 0.0, decimals) : std::string();
}

/// Returns the text as a CSV field.
std::string csv_field(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + '"';
}

ordered_json load_json(const BlockLoad& load) {
  ordered_json json;
  add_place(json, load.origin, load.program);
  json["tool"] = load.tool;
  json["rate"] = number_or_null(load.rate);
  json["feed_per_tooth"] = number_or_null(load.feed_per_tooth, decimals_of_tooth);
  json["depth"] = number_or_null(load.depth);
  json["width"] = number_or_null(load.width);
  json["angle"] = number_or_null(load.angle);
  json["volume"] = cut_to(load.volume, decimals_of_mm);
  json["seconds"] = cut_to(load.seconds, decimals_of_mm);
  json["at"] = {
      {"X", cut_to(load.at.x, decimals_of_mm)}, {"Y", cut_to(load.at.y, decimals_of_mm)}, {"Z", cut_to(load.at.z, decimals_of_mm)}};
  json["at_time"] = cut_to(load.begins, decimals_of_mm);
  return json;
}

}  // namespace

std::string line_words(const Origin& origin, const std::string& program, Lang lang) {
  const std::string text = program.empty() ? translated_in(lang, texts::cut_summary::line, origin.line)
                                           : translated_in(lang, texts::cut_summary::line_of_file, origin.line, program);
  const std::string block = block_text(origin);
  return block.empty() ? text : text + ' ' + block;
}

void add_place(ordered_json& json, const Origin& origin, const std::string& program) {
  json["line"] = origin.line;
  if (!program.empty()) json["program"] = program;
  if (origin.has_block) json["block"] = fmt::format("N{:0{}}", origin.block, int(origin.block_digits));
}

ordered_json calls_json(const std::vector<AlarmReport::Call>& calls) {
  ordered_json list = ordered_json::array();
  for (const AlarmReport::Call& call : calls) {
    ordered_json json{{"line", call.line}};
    if (call.has_block) json["block"] = fmt::format("N{}", call.block);
    json["program"] = call.what;
    if (!call.file.empty()) json["file"] = call.file;
    list.push_back(json);
  }
  return list;
}

std::string load_words(const BlockLoad& load, Lang lang) {
  std::string text = fmt::format("{} T{}: ", line_words(load.origin, load.program, lang), load.tool);
  text += translated_in(lang, texts::cut_summary::removal_rate, load.rate.value_or(0));
  if (load.feed_per_tooth) text += ", " + translated_in(lang, texts::cut_summary::feed_per_tooth, *load.feed_per_tooth);
  if (load.width) text += ", " + translated_in(lang, texts::cut_summary::engagement, *load.width, *load.depth, *load.angle);
  return text;
}

std::string air_words(const AirCut& air, Lang lang) {
  return fmt::format("{} T{}: {}", line_words(air.origin, air.program, lang), air.tool, duration_text(air.seconds));
}

void add_loads(ordered_json& json, const CutResult& result) {
  json["heaviest"] = ordered_json::array();
  for (const BlockLoad& load : result.heaviest) json["heaviest"].push_back(load_json(load));
  json["emptiest"] = ordered_json::array();
  for (const AirCut& air : result.emptiest) {
    ordered_json line;
    add_place(line, air.origin, air.program);
    line["tool"] = air.tool;
    line["seconds"] = cut_to(air.seconds, decimals_of_mm);
    json["emptiest"].push_back(line);
  }
}

std::string blocks_heading() { return "line,block,tool,begins,seconds,length,volume,rate,feed_per_tooth,depth,width,angle,program\n"; }

std::string blocks_row(const BlockLoad& b) {
  return fmt::format("{},{},{},{:.4f},{:.4f},{:.4f},{:.4f},{},{},{},{},{},{}\n", b.origin.line, block_text(b.origin), b.tool, b.begins,
                     b.seconds, b.length, b.volume + 0.0, number_cell(b.rate), number_cell(b.feed_per_tooth, decimals_of_tooth),
                     number_cell(b.depth), number_cell(b.width), number_cell(b.angle, 1), csv_field(b.program));
}

}  // namespace kadr
