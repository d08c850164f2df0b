// Setup: reads set-ups (--setup FILE.json). Used by config, control, machine, motion, session; tested by tests/config/setup_test.cpp.

#include "config/setup/setup.h"

#include "base/ascii.h"
#include "config/alarm_texts.h"
#include "config/json_scan.h"
#include "config/read_file.h"
#include "config/setup/setup_check.h"
#include "config/setup/setup_file.h"
#include "config/setup/setup_reader.h"

namespace kadr {
namespace setup_reader {
namespace {

/// Reads the plane, such as "XC": the names of two axes, of up to three characters each.
void plane(const Json& value, const std::string& key, Setup& setup) {
  constexpr std::size_t longest = 6;
  setup.plane = word(value, key);
  if (setup.plane.empty()) return;
  const auto is_symbol = [](char c) { return is_digit(c) || is_capital(c) || c == '_'; };
  const bool known =
      setup.plane.size() >= 2 && setup.plane.size() <= longest && std::all_of(setup.plane.begin(), setup.plane.end(), is_symbol);
  if (!known) wrong(key, "the names of its two axes, \"XY\"");
}

/// Returns readers for the keys of the state in which a run starts: axes, start position, modes …
Readers readers_of_state(Setup& s) {
  return {
      {"axes", [&](const Json& v, const std::string& k) { s.axes = list(v, k, word); }},
      {"start", [&](const Json& v, const std::string& k) { s.start = axis_values(v, k); }},
      {"start_frame",
       [&](const Json& v, const std::string& k) {
         if (v != "work" && v != "machine") wrong(k, "\"work\" or \"machine\"");
         s.start_in_work = v == "work";
       }},
      {"modal", [&](const Json& v, const std::string& k) { s.modal = list(v, k, word); }},
      {"feed",
       [&](const Json& v, const std::string& k) { s.feed = v.is_null() ? std::nullopt : std::optional(within(v, k, ranges::feed)); }},
      {"plane", or_null([&](const Json& v, const std::string& k) { plane(v, k, s); })},
      {"diameter", or_null([&](const Json& v, const std::string& k) {
         for (const auto& [axis, on] : table(v, k).items()) s.diameter[axis] = flag(on, k + "." + axis);
       })},
      {"variables",
       [&](const Json& v, const std::string& k) {
         for (const auto& [name, value] : table(v, k).items()) s.variables[name] = number_or_vacant(value, k + "." + name);
       }},
      {"tool", [&](const Json& v, const std::string& k) { s.tool = whole(v, k); }},
      {"points", [&](const Json& v, const std::string& k) { s.points = list(v, k, number); }},
      {"watch", [&](const Json& v, const std::string& k) { s.watch = list(v, k, word); }},
  };
}

/// Returns readers for every key of a set-up or a printed state (tests/golden/README.md).
Readers readers_of(Setup& setup) {
  Readers readers = readers_of_state(setup);
  readers.merge(readers_of_tables(setup));
  readers.merge(readers_of_machine(setup));
  readers.merge(readers_of_events(setup));
  // Reader for keys that Kadr accepts and ignores: they are for the runner of the golden cases, or for people, or are not supported yet.
  const Reader nothing = [](const Json&, const std::string&) {};
  for (const char* key : {"frame", "files", "main_file", "notes"}) readers.emplace(key, nothing);
  return readers;
}

}  // namespace
}  // namespace setup_reader

const SpindleSetup& Setup::spindle() const {
  static const SpindleSetup stands;
  const auto found = spindles.find(1);
  return found == spindles.end() ? stands : found->second;
}

namespace {

using setup_reader::Json;

/// Returns the sentence with its location in front: "shop.json:3: …", "--zero G54=X1: …". If `place` is empty, returns the sentence alone.
std::string placed(const std::string& place, std::uint32_t line, const std::string& sentence) {
  std::string text = place;
  if (line != 0 && !place.empty() && !place.starts_with("--")) text += ":" + std::to_string(line);
  return text.empty() ? sentence : text + ": " + sentence;
}

/// Merges `from` into `to`. Tables are merged key by key; any other value replaces the old value. Null replaces it too, because null may
/// have a meaning (an acceleration without limit).
void lay_over(Json& to, const Json& from) {
  for (const auto& [key, value] : from.items()) {
    if (value.is_object() && to.contains(key) && to[key].is_object()) lay_over(to[key], value);
    else to[key] = value;
  }
}

}  // namespace

tl::expected<PlacedSetup, std::string> read_setup(const std::vector<SetupSource>& sources, const ControlDef* def, Lang lang) {
  std::vector<JsonLines> parts;
  Json whole = Json::object();
  for (const SetupSource& source : sources) {
    if (std::string fault = json_fault_message(source.json, source.place); !fault.empty()) return tl::unexpected(fault);
    auto part = json_with_lines(source.json);
    if (!part) return tl::unexpected(placed(source.place, part.error().line, lang == Lang::ru ? part.error().ru : part.error().en));
    if (part->value.is_object()) lay_over(whole, part->value);
    parts.push_back(std::move(*part));
  }
  PlacedSetup result;
  for (std::size_t i = 0; i < sources.size(); ++i) {
    const auto line = [&](const std::string& key) { return line_of(parts[i].lines, key); };
    if (const auto fault = fault_of(parts[i].value, whole, def, lang))
      return tl::unexpected(placed(sources[i].place, line(fault->key), fault->sentence));
    try {
      Setup read;
      setup_reader::read_table(parts[i].value, "", setup_reader::readers_of(read));
      // Reading the values finds faults that the check of the keys does not find: dates, combinations of keys, limits with a unit
    } catch (const setup_reader::Wrong& error) {
      return tl::unexpected(placed(sources[i].place, line(error.key), error.sentence));
    }
  }
  try {
    setup_reader::read_table(whole, "", setup_reader::readers_of(result.setup));
    if (def == nullptr || def->machine_axes()) setup_reader::give_kinematics(result.setup);  // other controls read the key itself
    // A fault that only the merged set-up has, because each source by itself has been read without a fault
  } catch (const setup_reader::Wrong& error) {
    return tl::unexpected(error.sentence);
  }
  result.stated = stated_in(whole);
  if (!parts.empty()) result.lines = std::move(parts.front().lines);
  return result;
}

tl::expected<Setup, std::string> parse_setup(std::string_view json) {
  auto read = read_setup({{"", std::string(json)}}, nullptr, Lang::en);
  if (!read) return tl::unexpected(read.error());
  return std::move(read->setup);
}

tl::expected<Setup, std::string> load_setup(const std::string& file) {
  auto source = setup_source(file);
  if (!source) return tl::unexpected(source.error());
  auto read = read_setup({std::move(*source)}, nullptr, Lang::en);
  if (!read) return tl::unexpected(read.error());
  return std::move(read->setup);
}

tl::expected<SetupSource, std::string> setup_source(const std::string& file, const FileAccess* door) {
  auto text = read_file(file, limits::config_file_bytes, door);
  if (!text) return tl::unexpected(text.error());
  return SetupSource{file, std::move(*text)};
}

}  // namespace kadr
