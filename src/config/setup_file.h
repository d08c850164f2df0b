#pragma once
// A set-up as a person writes it: each key asked for (config/setup_keys), its place told where it is wrong.

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "base/file_door.h"
#include "config/setup.h"

namespace kadr {

struct ControlDef;               // config/control_def.h
enum class Lang : std::uint8_t;  // config/alarm_texts.h

/// What is wrong with a set-up, for people.
struct SetupFault {
  std::string key;     // "work_offsets.G54.x"
  std::string en, ru;  // empty: nothing is
  bool empty() const { return en.empty(); }
};

using KeyLines = std::map<std::string, std::uint32_t>;  // "offsets.1.length", "events[0].when" → line, from 1

/// Line of the key, or of the nearest one above it; 0: not known.
std::uint32_t line_of(const KeyLines& lines, std::string_view key);

/// A set-up and where it comes from: a file's name, or the option that says it.
struct SetupSource {
  std::string place;
  std::string json;
};

struct PlacedSetup {
  Setup setup;
  KeyLines lines;  // of the first source
  /// "offsets.1.length", "work_offsets.G54", "zeros.1", "correctors.17": what is given and not null.
  std::set<std::string> stated;
};

/// Each source laid over those before it. Each key must be one that the control has; `def` nullptr: that any control has.
///   returns  an error sentence naming the line and the key that is unknown, impossible, of the wrong form, or not served yet
tl::expected<PlacedSetup, std::string> read_setup(const std::vector<SetupSource>& sources, const ControlDef* def, Lang lang);

/// Text of a set-up file. returns  an error sentence, if it cannot be read
tl::expected<SetupSource, std::string> setup_source(const std::string& file, const FileDoor* door = nullptr);

}  // namespace kadr
