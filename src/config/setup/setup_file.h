#pragma once
// Reads set-ups that people have written: checks each key (config/setup/setup_keys) and reports the location of a fault.

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
  std::string key;     // name of the faulty key: "work_offsets.G54.x"
  std::string en, ru;  // the fault in English and Russian; empty: there is no fault
  bool empty() const { return en.empty(); }
};

// Full name of a key, such as "offsets.1.length" or "events[0].when" → its line number, from 1
using KeyLines = std::map<std::string, std::uint32_t>;

/// Returns the line number of the key; if it is unknown, of the nearest key that contains it; 0 if neither is known.
std::uint32_t line_of(const KeyLines& lines, std::string_view key);

/// The text of a set-up and its origin: the name of a file, or the option that contains the text.
struct SetupSource {
  std::string place;
  std::string json;
};

struct PlacedSetup {
  Setup setup;
  KeyLines lines;  // line numbers of the keys of the first source, for messages
  /// Keys of which some source states a value other than null: "offsets.1.length", "work_offsets.G54", "zeros.1", "correctors.17".
  std::set<std::string> stated;
};

/// Reads the sources; a later source overrides an earlier one. Each key must exist on the control `def`; if it is nullptr, on at least one
/// control.
///   returns  on failure, an error sentence with line and key; the key is unknown, impossible, of a wrong form, or not supported yet
tl::expected<PlacedSetup, std::string> read_setup(const std::vector<SetupSource>& sources, const ControlDef* def, Lang lang);

/// Returns the text of a set-up file as a source. Returns an error sentence if the file cannot be read.
tl::expected<SetupSource, std::string> setup_source(const std::string& file, const FileAccess* door = nullptr);

}  // namespace kadr
