#pragma once
// PanelContent: what the page needs for a panel machine besides the machine itself, and the JSON in which the events of the machine are
// saved.

#include <mutex>

#include "panel/panel_hub.h"
#include "panel/panel_journal.h"
#include "view/panel_program.h"

namespace kadr {

struct PanelContent {
  explicit PanelContent(OpenedProgram opened, OpeningRequest request) : program(std::move(opened), std::move(request)) {}
  PanelProgram program;
  // Mutex that is locked from the check of an edit until the answer, so that only one edit of the tables is made at a time.
  std::mutex edits;
};

inline PanelContent& content_of(const PanelHub::HubMachine& place) { return *static_cast<PanelContent*>(place.content.get()); }

/// Returns a log entry as JSON: the present time, the kind of the entry, a text, and a line of the program (0: no line).
std::string log_entry(const std::string& kind, const std::string& text, std::uint32_t line);
/// Converts the location of a machine in its program to JSON, and back.
std::string spot_text(const PanelLocation& spot);
std::optional<PanelLocation> spot_of(const std::string& text);

}  // namespace kadr
