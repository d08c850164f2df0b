#pragma once
// PanelContent: what belongs to a machine of the hub besides the machine itself, and the form in which its events are saved.

#include <mutex>

#include "panel/panel_hub.h"
#include "panel/panel_journal.h"
#include "view/panel_program.h"

namespace kadr {

struct PanelContent {
  explicit PanelContent(OpenedProgram opened, OpeningWish wish) : program(std::move(opened), std::move(wish)) {}
  PanelProgram program;
  std::mutex edits;  // held from the check to the answer: one edit at a time
};

inline PanelContent& content_of(const PanelHub::Place& place) { return *static_cast<PanelContent*>(place.content.get()); }

/// A log entry as JSON: the present time, kind, text, line of the program (0: none).
std::string log_entry(const std::string& kind, const std::string& text, std::uint32_t line);
/// The location of a machine as JSON, and its reverse.
std::string spot_text(const PanelSpot& spot);
std::optional<PanelSpot> spot_of(const std::string& text);

}  // namespace kadr
