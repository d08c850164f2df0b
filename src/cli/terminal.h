#pragma once
// Prints everything that people read on standard output and standard error. A message never follows half a progress bar, colours go only to
// terminals, and no control character of a name, a program or a command line reaches a terminal.

#include <fmt/core.h>

#include <cstdio>
#include <string>
#include <string_view>
#include <utility>

#include "out/text/alarm_print.h"

namespace kadr::cli {

/// True if standard error is a terminal with colours, and NO_COLOR (no-color.org) does not forbid them.
bool has_colours();

/// Shows the bar on its line in place of the one before; does nothing unless standard error is a terminal.
void show_bar(const std::string& bar);
/// Removes the bar if there is one: before anything else is written to a terminal, standard output included. Any thread may call it.
void erase_bar();

/// Width of the terminal in characters; 80 if it is not known.
int terminal_width();

/// The colours for alarms on standard error.
inline Colours colours() { return has_colours() ? Colours::terminal : Colours::none; }

/// Writes text for people to standard error; control characters are shown as pictures.
void say(const std::string& text);
/// Writes text of alarm_text(), which has replaced control characters already and may contain colours.
void say_coloured(const std::string& text);

/// Writes data for programs, unchanged. The owner of the file checks that it was written.
void write_data(std::FILE* to, std::string_view data);

/// Writes text for people to standard output or another file; control characters become pictures. came_out() checks that it was written.
void type_into(std::FILE* to, std::string_view text);
template <class... Values>
void type_out(fmt::format_string<Values...> form, Values&&... values) {
  type_into(stdout, fmt::format(form, std::forward<Values>(values)...));
}

}  // namespace kadr::cli
