#include "config/setup.h"

#include "config/json_scan.h"
#include "config/read_file.h"
#include "config/setup_reader.h"
#include "config/told.h"

namespace kadr {
namespace setup_reader {
namespace {

bool all_of(std::string_view text, bool (*is)(char)) { return std::all_of(text.begin(), text.end(), is); }
bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_symbol(char c) { return is_digit(c) || (c >= 'A' && c <= 'Z') || c == '_'; }

/// "#100", "#_ALM", "#_FOFS1[1]", "R2".
bool names_variable(std::string_view name) {
  constexpr std::size_t longest_number = 7, longest_symbol = 31;
  if (name.size() == 2 && name[0] == 'R') return is_digit(name[1]);
  if (name.size() < 2 || name[0] != '#') return false;
  std::string_view rest = name.substr(1);
  if (rest[0] != '_') return rest.size() <= longest_number && all_of(rest, is_digit);
  if (const std::size_t open = rest.find('['); open != std::string_view::npos) {
    if (rest.back() != ']' || rest.size() - open < 3 || !all_of(rest.substr(open + 1, rest.size() - open - 2), is_digit)) return false;
    rest = rest.substr(0, open);
  }
  return rest.size() >= 2 && rest.size() <= longest_symbol && all_of(rest, is_symbol);
}

void parts_of_motion(const Json& value, const std::string& key, Setup& setup) {
  setup.points = list(value, key, number);
  for (const double part : setup.points)
    if (!(part >= 0 && part <= 1)) wrong(key, "a list of parts, 0 to 1");
}

/// "XC": two axes of up to three characters each.
void plane(const Json& value, const std::string& key, Setup& setup) {
  constexpr std::size_t longest = 6;
  setup.plane = word(value, key);
  if (setup.plane.empty()) return;
  const bool known = setup.plane.size() >= 2 && setup.plane.size() <= longest && all_of(setup.plane, is_symbol);
  if (!known) wrong(key, "the names of its two axes, \"XY\"");
}

/// What a run starts with.
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
         for (const auto& [name, value] : table(v, k).items()) {
           if (!names_variable(name)) wrong(k + "." + name, "named #n, #_NAME, or R0 to R9");
           s.variables[name] = number_or_vacant(value, k + "." + name);
         }
       }},
      {"tool", [&](const Json& v, const std::string& k) { s.tool = whole(v, k); }},
      {"points", [&](const Json& v, const std::string& k) { parts_of_motion(v, k, s); }},
      {"watch", [&](const Json& v, const std::string& k) { s.watch = list(v, k, word); }},
  };
}

/// Every key of tests/golden/README.md, of the set-up and of the state.
Readers readers_of(Setup& setup) {
  Readers readers = readers_of_state(setup);
  readers.merge(readers_of_tables(setup));
  readers.merge(readers_of_machine(setup));
  readers.merge(readers_of_events(setup));
  for (const char* key : {"search", "kinematics", "files", "main_file", "frame"}) readers.emplace(key, only_neutral);
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

/// `file` begins the sentence about what is no JSON; empty: "line 1, column 2: ".
tl::expected<Setup, std::string> read_setup(std::string_view json, const std::string& file) {
  using setup_reader::Json;
  if (std::string fault = told_json_fault(json, file); !fault.empty()) return tl::unexpected(fault);
  const std::string before = file.empty() ? "" : file + ": ";
  Setup setup;
  try {
    setup_reader::read_table(Json::parse(json), "", setup_reader::readers_of(setup));
  } catch (const setup_reader::Wrong& error) {
    return tl::unexpected(before + error.sentence);
  } catch (const Json::exception&) {  // nothing that told_json_fault() lets pass
    return tl::unexpected(before + told("this is not JSON", "это не JSON"));
  }
  return setup;
}

}  // namespace

tl::expected<Setup, std::string> parse_setup(std::string_view json) { return read_setup(json, ""); }

tl::expected<Setup, std::string> load_setup(const std::string& file) {
  const auto text = read_file(file);
  return text ? read_setup(*text, file) : tl::unexpected(text.error());
}

}  // namespace kadr
