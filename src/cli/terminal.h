#pragma once
// The terminal on standard error: messages and the progress bar share it. What is written there goes through here, so that a message never
// stands behind half a bar, and colours go to terminals alone.

#include <string>

#include "out/text/alarm_print.h"

namespace kadr::cli {

/// Standard error is a terminal that takes colours, and NO_COLOR (no-color.org) does not forbid them.
bool has_colours();

/// The bar, on its line; replaces the one before. Nothing, unless standard error is a terminal.
void show_bar(const std::string& bar);
/// Takes the bar away, if there is one: before anything else is written to a terminal, standard output too. May be called by any thread.
void erase_bar();

/// Width of the terminal, characters; 80 where it does not say.
int terminal_width();

/// What alarms are to be printed with on standard error.
inline Colours colours() { return has_colours() ? Colours::terminal : Colours::none; }

/// Text for people, to standard error.
void say(const std::string& text);

}  // namespace kadr::cli
