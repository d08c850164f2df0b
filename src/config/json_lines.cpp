// Parses JSON and records the line number of each key, for messages. Used by config/setup/setup_check.

#include "config/json_lines.h"

#include <fmt/core.h>

#include <iterator>
#include <vector>

#include "config/setup/setup_file.h"
#include "texts/json_lines.h"

namespace kadr {
namespace {

using Json = nlohmann::json;

constexpr int deepest_table = 64;  // greatest nesting depth of tables, far more than any set-up has

/// Iterates over the text and counts the lines. The parser reads no byte in advance, so the count is the line of the current byte.
class CountingIterator {
 public:
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  CountingIterator(const char* at, std::uint32_t* line) : at_(at), line_(line) {}
  reference operator*() const { return *at_; }
  CountingIterator& operator++() {
    if (*at_ == '\n') ++*line_;
    ++at_;
    return *this;
  }
  CountingIterator operator++(int) {
    CountingIterator before = *this;
    ++*this;
    return before;
  }
  bool operator==(const CountingIterator& other) const { return at_ == other.at_; }
  bool operator!=(const CountingIterator& other) const { return at_ != other.at_; }

 private:
  const char* at_;
  std::uint32_t* line_;
};

struct TooDeep {};

/// Receives the events of the parser and records the line number of each key.
class Listener {
 public:
  Listener(JsonLines& to, const std::uint32_t& line) : to_(to), line_(line) {}

  void event(int depth, Json::parse_event_t event, const Json& parsed) {
    if (depth > deepest_table) throw TooDeep();
    switch (event) {
      case Json::parse_event_t::object_start: open(false); break;
      case Json::parse_event_t::array_start: open(true); break;
      case Json::parse_event_t::key: key(parsed.get<std::string>()); break;
      case Json::parse_event_t::value: next(); break;
      case Json::parse_event_t::object_end:
      case Json::parse_event_t::array_end:
        path_.pop_back();
        next();
        break;
    }
  }

 private:
  struct Level {
    std::string name;  // name of the table or list whose keys are being read
    bool is_list;
    std::size_t item = 0;
    std::string key;
  };

  std::string here() const {
    if (path_.empty()) return {};
    const Level& level = path_.back();
    return level.is_list ? fmt::format("{}[{}]", level.name, level.item) : below(level.name, level.key);
  }
  void open(bool is_list) {
    const std::string name = here();
    to_.lines.emplace(name, line_);
    path_.push_back({name, is_list, 0, {}});
  }
  void key(const std::string& name) {
    path_.back().key = name;
    to_.lines.emplace(here(), line_);
  }
  void next() {
    if (!path_.empty() && path_.back().is_list) ++path_.back().item;
  }

  JsonLines& to_;
  const std::uint32_t& line_;
  std::vector<Level> path_;
};

}  // namespace

std::uint32_t line_of(const KeyLines& lines, std::string_view key) {
  for (std::string name(key); !name.empty();) {
    if (const auto found = lines.find(name); found != lines.end()) return found->second;
    const std::size_t cut = name.find_last_of(".[");
    name.resize(cut == std::string::npos ? 0 : cut);
  }
  return 0;
}

tl::expected<JsonLines, JsonFault> json_with_lines(std::string_view text) {
  JsonLines result;
  std::uint32_t line = 1;
  Listener listener(result, line);
  const char* const end = text.data() + text.size();
  try {
    result.value = Json::parse(CountingIterator(text.data(), &line), CountingIterator(end, &line),
                               [&](int depth, Json::parse_event_t event, Json& parsed) {
                                 listener.event(depth, event, parsed);
                                 return true;
                               });
  } catch (const TooDeep&) {
    constexpr PlainText too_deep = texts::json_lines::too_deep;
    return tl::unexpected(JsonFault{line, plain_text(too_deep, Lang::en), plain_text(too_deep, Lang::ru)});
  } catch (const Json::exception& error) {
    // The library's message starts with a prefix such as "[json.exception.parse_error.101] parse error at line 1, column 2: ", which is
    // removed
    std::string_view what = error.what();
    if (const std::size_t bracket = what.find("] "); bracket != std::string_view::npos) what.remove_prefix(bracket + 2);
    if (const std::size_t colon = what.find(": "); what.starts_with("parse error at") && colon != std::string_view::npos)
      what.remove_prefix(colon + 2);
    constexpr TextId<1> not_json = texts::json_lines::not_json;
    return tl::unexpected(JsonFault{line, translated_in(Lang::en, not_json, what), translated_in(Lang::ru, not_json, what)});
  }
  return result;
}

}  // namespace kadr
