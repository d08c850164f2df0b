#pragma once
// Creates the faults of a set-up that are found only when a run starts.

#include <string>
#include <utility>

#include "config/setup/setup_file.h"
#include "config/texts.h"

namespace kadr {

/// Returns the fault of a key of the set-up, in both languages.
template <std::size_t Holes, typename... Args>
SetupFault start_fault_of(std::string key, TextId<Holes> text, const Args&... args) {
  return {std::move(key), translated_in(Lang::en, text, args...), translated_in(Lang::ru, text, args...)};
}

}  // namespace kadr
