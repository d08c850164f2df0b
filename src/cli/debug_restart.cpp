// Prints the answers of the debugger about a start in mid-program. This file is used by cli/debug and tested by tests/debug.py.

#include "cli/debug_restart.h"

#include <fmt/core.h>

#include "cli/job/terminal.h"
#include "out/text/in_force_text.h"
#include "session/block_search.h"
#include "texts/debug.h"

namespace kadr::cli {
namespace {

void list(const std::string& title, const std::vector<InForce>& things, Lang lang) {
  if (!things.empty()) type_out("{}:\n{}", title, in_force_text(things, lang));
}

void list(const std::string& title, const std::vector<BlockSearch::Code>& codes) {
  if (codes.empty()) return;
  std::string text;
  for (const auto& code : codes) text += " " + translated(texts::debug::code_in_line, code.text, code.origin.line);
  type_out("{}:{}\n", title, text);
}

}  // namespace

void print_restart(Session& session, const Stepping& stepping, const Restart& begins, double clearance, Lang lang) {
  // Distance in mm above the restart position from which the last motion is at feed, and this feed in mm/min.
  constexpr double above = 2, feed = 100;
  const auto restart = restart_here(session, stepping);
  if (!restart) return;
  std::vector<InForce> required;
  for (const Difference& d : differences(restart->in_force, begins.in_force))
    if (d.required) required.push_back(*d.required);
  const ControlDef& def = session.def();
  const auto path = path_there(begins.stand, *restart, {clearance, above, feed}, session.control().axes().size());
  const auto blocks = restart_blocks(def, required, restart->in_force, in_work_coordinates(path, *restart, def));
  if (!blocks) return type_out("{}\n", translated(texts::debug::no_room_in_word));
  for (const std::string& block : blocks->blocks) type_out("{}\n", block);
  list(translated(texts::debug::by_hand), blocks->by_hand, lang);
}

void print_search(Session& session, Stepping& stepping, const StopPoint& target, Lang lang) {
  const auto search = search_block(session, stepping, target);
  if (!search) return;
  list(translated(texts::debug::carried_out_at_end), search->carried_out);
  list(translated(texts::debug::of_no_group), search->of_no_group);
  list(translated(texts::debug::forgotten), search->forgotten, lang);
}

}  // namespace kadr::cli
