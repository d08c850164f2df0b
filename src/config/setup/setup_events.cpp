// Reads keys of the set-up for what happens in parallel with the program: signals and events of the machine's logic, clock, channels.

#include <array>
#include <chrono>
#include <cstdio>

#include "base/ascii.h"
#include "config/setup/setup_reader.h"

namespace kadr::setup_reader {
namespace {

/// Reads the block number at which a block search ends: "N50".
void search_target(const Json& value, const std::string& key, Setup& setup) {
  setup.search = word(value, key);
  const bool fits = setup.search.size() > 1 && setup.search.size() <= 9 && (setup.search[0] == 'N' || setup.search[0] == ':') &&
                    std::all_of(setup.search.begin() + 1, setup.search.end(), is_digit);
  if (!setup.search.empty() && !fits) wrong(key, "a block number, \"N30\"");
}

using When = SetupEvent::When;
using Do = SetupEvent::Do;

constexpr std::array<std::pair<std::string_view, Do>, 12> deeds = {{{"set", Do::set},
                                                                    {"skip", Do::skip},
                                                                    {"start", Do::start},
                                                                    {"answer", Do::answer},
                                                                    {"power_cycle", Do::power_cycle},
                                                                    {"synchronise", Do::synchronise},
                                                                    {"release", Do::release},
                                                                    {"spindle_to_axis", Do::spindle_to_axis},
                                                                    {"axis_to_spindle", Do::axis_to_spindle},
                                                                    {"exchange", Do::exchange},
                                                                    {"reverse", Do::reverse},
                                                                    {"park", Do::park}}};

/// Returns true for an address letter and a number: "N30", ":5", "M90", "G53.1".
bool is_word(std::string_view text, bool (*letter)(char)) {
  const auto digit_or_point = [](char c) { return is_digit(c) || c == '.'; };
  return text.size() >= 2 && letter(text[0]) && text[1] != '.' && std::all_of(text.begin() + 1, text.end(), digit_or_point);
}

Reader to_code_word(std::string& to, bool (*letter)(char), std::string form) {
  return [&to, letter, form = std::move(form)](const Json& value, const std::string& key) {
    to = value.is_string() ? value.get<std::string>() : "";
    if (!is_word(to, letter)) wrong(key, form);
  };
}

/// Reads the time of an event, which has one of the forms {block, at}, {code, count}, {action}, {program}.
void when(const Json& value, const std::string& key, SetupEvent& event) {
  std::string at = "start", action, program;
  read_table(value, key,
             {{"block", to_code_word(
                            event.block, [](char c) { return c == 'N' || c == ':'; }, "a block number, \"N30\"")},
              {"at", to_one_of(at, {"start", "end"})},
              {"code", to_code_word(
                           event.code, [](char c) { return c >= 'A' && c <= 'Z'; }, "a code word, \"M90\"")},
              {"count", to_whole(event.count, 1, max_number)},
              {"action", to_one_of(action, {"stop", "message"})},
              {"program", to_one_of(program, {"end"})}});
  const int kinds = static_cast<int>(!event.block.empty()) + static_cast<int>(!event.code.empty()) + static_cast<int>(!action.empty()) +
                    static_cast<int>(!program.empty());
  const bool fits = kinds == 1 && (!value.contains("at") || !event.block.empty()) && (!value.contains("count") || !event.code.empty());
  if (!fits) wrong(key, "one of {block, at}, {code, count}, {action}, {program}");
  event.when = !event.block.empty()  ? (at == "start" ? When::block_start : When::block_end)
               : !event.code.empty() ? When::code
               : !program.empty()    ? When::program_end
               : action == "stop"    ? When::stop
                                     : When::message;
}

Do deed(const Json& value, const std::string& key) {
  std::string form;
  for (const auto& [name, what] : deeds) {
    if (value == name) return what;
    form += (form.empty() ? "" : ", ") + std::string(name);
  }
  wrong(key, "one of " + form);
}

/// Checks that an event has the keys that the value of its key `do` requires.
void check_event(const Json& value, const std::string& key, const SetupEvent& event) {
  const auto needs = [&](const char* name) {
    if (!value.contains(name)) wrong(key, "a table with '" + std::string(name) + "'");
  };
  needs("when");
  needs("do");
  if (event.what == Do::set) needs("signal"), needs("value");
  if (event.what == Do::skip) needs("switch"), needs("on");
  if (event.what == Do::answer) needs("answer");
  if (event.what == Do::synchronise && event.axes.empty()) needs("spindle"), needs("master");
  if (event.what >= Do::exchange && event.axes.empty()) needs("axes");
}

SetupEvent event(const Json& value, const std::string& key) {
  SetupEvent event;
  read_table(value, key,
             {{"when", [&](const Json& item, const std::string& name) { when(item, name, event); }},
              {"do", [&](const Json& item, const std::string& name) { event.what = deed(item, name); }},
              {"signal", to_word(event.signal)},
              {"value", to_number(event.value)},
              {"switch", to_whole(event.switch_number, 0, max_number)},
              {"on", to_flag(event.on)},
              {"answer", to_one_of(event.answer, {"ok", "yes", "no", "cancel"})},
              {"spindle", to_whole(event.spindle, 1, max_spindles)},
              {"master", to_whole(event.master, 1, max_spindles)},
              {"axis", [&](const Json& item, const std::string& name) { event.axes = {word(item, name)}; }},
              {"axes", [&](const Json& item, const std::string& name) { event.axes = list(item, name, word); }}});
  check_event(value, key, event);
  if (event.what >= Do::exchange && !value.contains("on")) event.on = true;
  return event;
}

/// Reads a date with time, "2014-05-18T15:32:41", which must exist in the calendar.
void clock(const Json& value, const std::string& key, Setup& setup) {
  constexpr std::string_view form = "0000-00-00T00:00:00";
  setup.clock = word(value, key);
  if (setup.clock.empty()) return;
  bool fits = setup.clock.size() == form.size();
  for (std::size_t i = 0; fits && i < form.size(); ++i)
    fits = form[i] == '0' ? setup.clock[i] >= '0' && setup.clock[i] <= '9' : setup.clock[i] == form[i];
  if (fits) {
    const auto part = [&](std::size_t at, std::size_t size) { return static_cast<unsigned>(std::stoul(setup.clock.substr(at, size))); };
    const std::chrono::year year{static_cast<int>(part(0, 4))};
    fits = (year / std::chrono::month{part(5, 2)} / std::chrono::day{part(8, 2)}).ok() && part(11, 2) < 24 && part(14, 2) < 60 &&
           part(17, 2) < 60;
  }
  if (!fits) wrong(key, "a date and time, \"2014-05-18T15:32:41\"");
}

ChannelSetup channel(const Json& value, const std::string& key) {
  ChannelSetup channel;
  read_table(value, key, {{"program", to_word(channel.program)}, {"axes", [&](const Json& item, const std::string& name) {
                                                                    channel.axes = list(item, name, word);
                                                                  }}});
  return channel;
}

}  // namespace

Readers readers_of_events(Setup& s) {
  return {
      {"signals", or_null([&](const Json& v, const std::string& k) {
         for (const auto& [name, value] : table(v, k).items()) s.signals[name] = number(value, k + "." + name);
       })},
      {"events", or_null([&](const Json& v, const std::string& k) {
         if (!v.is_array()) wrong(k, "a list [ … ]");
         for (std::size_t i = 0; i < v.size(); ++i) s.events.push_back(event(v[i], k + "[" + std::to_string(i) + "]"));
       })},
      {"search", or_null([&](const Json& v, const std::string& k) { search_target(v, k, s); })},
      {"clock", or_null([&](const Json& v, const std::string& k) { clock(v, k, s); })},
      {"ini", or_null(to_word(s.ini))},
      {"channel", or_null(to_whole(s.channel, 1, max_channels))},
      {"channels", or_null([&](const Json& v, const std::string& k) {
         numbered(v, k, s.channels, channel, {1, max_channels});
       })},
  };
}

}  // namespace kadr::setup_reader
