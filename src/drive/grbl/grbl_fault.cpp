// The faults of a conversation with a controller, in words. Used by cli/drive_run and panel/grbl_axes, tested by tests/drive.py.

#include "drive/grbl/grbl_fault.h"

#include <fmt/core.h>

#include "config/texts.h"
#include "texts/drive.h"

namespace kadr::drive {

std::string fault_text(const LinkEvent& e, double seconds) {
  const std::string left = fmt::format("{:.1f}", seconds);
  switch (e.fault) {
    case LinkFault::no_answer: return translated(texts::drive::fault_no_answer);
    case LinkFault::busy: return translated(texts::drive::fault_busy, e.text);
    case LinkFault::line_refused: return translated(texts::drive::fault_line_refused, e.line, e.number, e.text);
    case LinkFault::setup_refused: return translated(texts::drive::fault_setup_refused, e.number, e.text);
    case LinkFault::alarm: return translated(texts::drive::fault_alarm, e.number);
    case LinkFault::reset: return translated(texts::drive::fault_reset);
    case LinkFault::answer_lost: return translated(texts::drive::fault_answer_lost, e.line, e.text);
    case LinkFault::broken_answer: return translated(texts::drive::fault_broken_answer, e.text);
    case LinkFault::extra_answer: return translated(texts::drive::fault_extra_answer);
    case LinkFault::buffer_wrong: return translated(texts::drive::fault_buffer_wrong);
    case LinkFault::overdue: return translated(texts::drive::fault_overdue, e.line);
    case LinkFault::off_path: return translated(texts::drive::fault_off_path, e.line, fmt::format("{:.3f}", e.value));
    case LinkFault::silent: return translated(texts::drive::fault_silent, left);
    case LinkFault::port_lost: return translated(texts::drive::fault_port_lost, left);
  }
  return {};
}

}  // namespace kadr::drive
