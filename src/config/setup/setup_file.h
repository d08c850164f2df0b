#pragma once
// Reads set-ups as people write them: checks each key (config/setup/setup_keys) and reports the location of a fault.

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "base/file_access.h"
#include "config/setup/setup.h"

namespace kadr {

struct ControlDef;               // config/control/control_def.h
enum class Lang : std::uint8_t;  // config/alarm_texts.h

/// A fault of a set-up, as sentences in English and Russian.
struct SetupFault {
  std::string key;     // "work_offsets.G54.x"
  std::string en, ru;  // empty: no fault
  bool empty() const { return en.empty(); }
};

using KeyLines = std::map<std::string, std::uint32_t>;  // name of a key, "offsets.1.length", "events[0].when" → line, from 1

/// Returns the line of the key, or of the nearest key above it in the hierarchy; 0 if unknown.
std::uint32_t line_of(const KeyLines& lines, std::string_view key);

/// A set-up and its origin: the name of a file, or the option that contains it.
struct SetupSource {
  std::string place;
  std::string json;
};

struct PlacedSetup {
  Setup setup;
  KeyLines lines;  // lines of the keys in the first source
  /// Keys that are given and not null: "offsets.1.length", "work_offsets.G54", "zeros.1", "correctors.17".
  std::set<std::string> stated;
};

/// Reads the sources; later ones override earlier ones. Each key must exist on the control; with `def` nullptr, on some control.
///   returns  on failure, an error sentence with line and key: unknown, impossible, of the wrong form, or not supported yet
tl::expected<PlacedSetup, std::string> read_setup(const std::vector<SetupSource>& sources, const ControlDef* def, Lang lang);

/// Reads the text of a set-up file. Returns an error sentence if it cannot be read.
tl::expected<SetupSource, std::string> setup_source(const std::string& file, const FileAccess* door = nullptr);

}  // namespace kadr
