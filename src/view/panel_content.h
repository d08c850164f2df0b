#pragma once
// What a machine of the hub is made of besides itself, and how what happens at it is kept.

#include <mutex>

#include "panel/panel_hub.h"
#include "panel/panel_journal.h"
#include "view/panel_program.h"

namespace kadr {

struct PanelContent {
  explicit PanelContent(OpenedProgram opened, OpeningWish wish) : program(std::move(opened), std::move(wish)) {}
  PanelProgram program;
  std::mutex edits;  // one at a time, from the check to the answer
};

inline PanelContent& content_of(const PanelHub::Place& place) { return *static_cast<PanelContent*>(place.content.get()); }

/// An entry of the log: now, what, its text, the line of the program (0: none), as JSON.
std::string log_entry(const std::string& kind, const std::string& text, std::uint32_t line);
/// Where a machine stands, as JSON; and back.
std::string spot_text(const PanelSpot& spot);
std::optional<PanelSpot> spot_of(const std::string& text);

}  // namespace kadr
