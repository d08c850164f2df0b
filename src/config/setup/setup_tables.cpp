// Reads keys of the set-up for tables of the control: offsets, tools, parameters.

#include "base/ascii.h"
#include "config/setup/setup_reader.h"

namespace kadr {
namespace {

bool is_capital_or_digit(char c) { return is_digit(c) || is_capital(c); }
bool is_letter_or_digit(char c) { return is_capital_or_digit(c) || is_lower(c); }

constexpr std::size_t parameter_digits = 4;

}  // namespace

std::optional<ParameterKey> parameter_key(std::string_view text) {
  ParameterKey key;
  if (const std::size_t at = text.find('#'); at != std::string_view::npos) {
    key.bit = text.substr(at + 1);
    if (!all_are(key.bit, is_letter_or_digit)) return std::nullopt;
    text = text.substr(0, at);
  }
  if (const std::size_t at = text.find('.'); at != std::string_view::npos) {
    key.index = text.substr(at + 1);
    if (!all_are(key.index, is_capital_or_digit)) return std::nullopt;
    text = text.substr(0, at);
  }
  if (text.size() < 2 || !is_capital(text[0])) return std::nullopt;
  if (text[0] != 'N' || !is_digit(text[1])) {
    key.name = text;
    return all_are(text, is_capital_or_digit) ? std::optional(key) : std::nullopt;
  }
  text.remove_prefix(1);
  if (text.size() > parameter_digits || !all_are(text, is_digit)) return std::nullopt;
  key.name = std::string(parameter_digits - text.size(), '0') + std::string(text);
  return key;
}

std::string text_of(const ParameterKey& key) {
  std::string text = key.name;
  if (all_are(text, is_digit)) text = "N" + std::string(parameter_digits - std::min(text.size(), parameter_digits), '0') + text;
  if (!key.index.empty()) text += "." + key.index;
  if (!key.bit.empty()) text += "#" + key.bit;
  return text;
}

namespace setup_reader {
namespace {

ToolOffset tool_offset(const Json& value, const std::string& key) {
  ToolOffset offset;
  read_table(value, key,
             {{"length", or_null(to_number(offset.length))},
              {"length_wear", or_null(to_number(offset.length_wear))},
              {"radius", or_null(to_number(offset.radius))},
              {"radius_wear", or_null(to_number(offset.radius_wear))},
              {"corner_radius", or_null(to_number(offset.corner))},
              {"corner_radius_wear", or_null(to_number(offset.corner_wear))},
              {"length_x", or_null(to_number(offset.length_x))},
              {"length_x_wear", or_null(to_number(offset.length_x_wear))},
              {"length_y", or_null(to_number(offset.length_y))},
              {"length_y_wear", or_null(to_number(offset.length_y_wear))},
              {"X", or_null(to_number(offset.length_x))},
              {"X_wear", or_null(to_number(offset.length_x_wear))},
              {"Y", or_null(to_number(offset.length_y))},
              {"Y_wear", or_null(to_number(offset.length_y_wear))},
              {"Z", or_null(to_number(offset.length))},
              {"Z_wear", or_null(to_number(offset.length_wear))},
              {"tip", or_null(to_number(offset.tip_position))},
              {"tip_position", or_null(to_number(offset.tip_position))}});
  return offset;
}

double not_stated_is_0(const Json& value, const std::string& key) { return value.is_null() ? 0 : number(value, key); }

/// Reads one value per axis. The value null means that the set-up does not state it, so it is left out.
AxisValues stated_axes(const Json& value, const std::string& key) {
  Json stated = table(value, key);
  for (auto axis = stated.begin(); axis != stated.end();) axis = axis->is_null() ? stated.erase(axis) : std::next(axis);
  return axis_values(stated, key);
}

/// Reads a work offset: its axes and its basic rotations. A rotation of 0 is left out.
AxisValues work_offset(const Json& value, const std::string& key) {
  AxisValues axes = stated_axes(value, key);
  for (const char* plane : {"G17", "G18", "G19"})
    if (const auto found = axes.find(plane); found != axes.end() && found->second == 0) axes.erase(found);
  return axes;
}

/// Reads the info bits of a tool: letters such as "SENCV", from the highest bit down, or a number.
std::uint32_t tool_info(const Json& value, const std::string& key) {
  if (value.is_number()) return bits(value, key);
  const std::string text = value.is_string() ? value.get<std::string>() : "";
  std::uint32_t info = 0;
  for (std::size_t i = 0; i < text.size() && i < tool_info_letters.size(); ++i) {
    const std::size_t bit = tool_info_letters.size() - 1 - i;
    if (text[i] == tool_info_letters[bit][1]) info |= 1U << bit;
    else if (text[i] != tool_info_letters[bit][0]) info |= 1U << tool_info_letters.size();
  }
  if (text.size() != tool_info_letters.size() || info >> tool_info_letters.size() != 0)
    wrong(key, "a number, or five letters: U or S, E or D, N or L, C or T, I or V");
  return info;
}

Reader to_bits(std::uint32_t& to) {
  return [&to](const Json& value, const std::string& key) { to = bits(value, key); };
}

ToolRow tool_row(const Json& value, const std::string& key) {
  ToolRow row;
  const Reader user = [&](const Json& item, const std::string& name) {
    const std::vector<double> values = list(item, name, number);
    if (values.size() > row.user.size()) wrong(name, "a list of at most " + std::to_string(row.user.size()) + " numbers");
    std::copy(values.begin(), values.end(), row.user.begin());
  };
  read_table(value, key,
             {{"T", to_count(row.type)},
              {"info", [&](const Json& item, const std::string& name) { row.info = tool_info(item, name); }},
              {"form", to_bits(row.form)},
              {"status", to_bits(row.status)},
              {"counter", to_number(row.counter)},
              {"life", to_number(row.life)},
              {"warn", to_number(row.warn)},
              {"H", to_count(row.h)},
              {"D", to_count(row.d)},
              {"G", to_count(row.g)},
              {"W", to_count(row.w)},
              {"S", to_number(row.s)},
              {"F", to_number(row.f)},
              {"user_bits", to_bits(row.user_bits)},
              {"user", user}});
  return row;
}

ToolForm tool_form(const Json& value, const std::string& key) {
  ToolForm form;
  read_table(value, key,
             {{"left", to_count(form.left)},
              {"right", to_count(form.right)},
              {"up", to_count(form.up)},
              {"down", to_count(form.down)},
              {"geometry", to_count(form.geometry)}});
  return form;
}

/// Reads a place table: for each pocket, such as "10/1" (magazine/pocket), the row of the tool table.
void place_table(const Json& value, const std::string& key, PocketTable& to) {
  constexpr std::size_t max_digits = 9;
  for (const auto& [name, row] : table(value, key).items()) {
    const std::size_t slash = std::min(name.find('/'), name.size());
    const std::string magazine = name.substr(0, slash), pocket = name.substr(std::min(slash + 1, name.size()));
    if (!all_are(magazine, is_digit) || !all_are(pocket, is_digit) || std::max(magazine.size(), pocket.size()) > max_digits)
      wrong(key + "." + name, "named magazine/pocket, \"10/1\"");
    to[{std::stoi(magazine), std::stoi(pocket)}] = whole_within(row, key + "." + name, {0, max_number});
  }
}

void parameters(const Json& value, const std::string& key, Parameters& to) {
  for (const auto& [name, item] : table(value, key).items()) {
    const std::optional<ParameterKey> parameter = parameter_key(name);
    if (!parameter) wrong(key + "." + name, "named N0308, N0306#0, N0402.X or N0106.X#1");
    if (!item.is_number() && !item.is_string()) wrong(key + "." + name, "a number or a text");
    const ParameterValue given =
        item.is_string() ? ParameterValue(item.get<std::string>()) : ParameterValue(number(item, key + "." + name));
    if (!to.emplace(*parameter, given).second) wrong(key + "." + name, "given once");
  }
}

}  // namespace

Readers readers_of_tables(Setup& s) {
  return {
      {"offsets", [&](const Json& v, const std::string& k) { numbered(v, k, s.offsets, tool_offset); }},
      {"work_offsets",
       [&](const Json& v, const std::string& k) {
         for (const auto& [name, axes] : table(v, k).items()) {
           s.work_offsets[name] = work_offset(axes, k + "." + name);
         }
       }},
      {"zeros", [&](const Json& v, const std::string& k) { numbered(v, k, s.zeros, stated_axes); }},
      {"correctors", [&](const Json& v, const std::string& k) { numbered(v, k, s.correctors, not_stated_is_0); }},
      {"tool_table", or_null([&](const Json& v, const std::string& k) { numbered(v, k, s.tool_table, tool_row); })},
      {"place_table", or_null([&](const Json& v, const std::string& k) { place_table(v, k, s.place_table); })},
      {"form_table", or_null([&](const Json& v, const std::string& k) { numbered(v, k, s.form_table, tool_form); })},
      {"parameters", or_null([&](const Json& v, const std::string& k) { parameters(v, k, s.parameters); })},
      {"shifts", or_null([&](const Json& v, const std::string& k) {
         for (const auto& [name, axes] : table(v, k).items()) {
           if (name != "G92" && name != "G52") wrong(k + "." + name, "named G92 or G52");
           s.shifts[name] = axis_values(axes, k + "." + name);
         }
       })},
  };
}

}  // namespace setup_reader
}  // namespace kadr
