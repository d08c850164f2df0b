#pragma once
// Prints all text for the user on standard output and standard error. A message never appears in the middle of a progress bar, colours
// are sent to terminals only, and control characters in names, programs or command lines never reach a terminal.

#include <fmt/core.h>

#include <cstdio>
#include <string>
#include <string_view>
#include <utility>

#include "out/text/alarm_print.h"

namespace kadr::cli {

/// True if standard error is a terminal that supports colours, and the variable NO_COLOR (no-color.org) is not set.
bool has_colours();

/// Shows the progress bar, which replaces the previous one; does nothing if standard error is not a terminal.
void show_bar(const std::string& bar);
/// Removes the progress bar if there is one; called before any other output to a terminal, also on standard output. Thread-safe.
void erase_bar();

/// Width of the terminal in characters; 80 if it is not known.
int terminal_width();

/// The colours for alarms on standard error.
inline Colours colours() { return has_colours() ? Colours::terminal : Colours::none; }

/// Writes text for people to standard error; control characters are replaced by symbols (␀ …).
void say(const std::string& text);
/// Writes text returned by alarm_text(): control characters are replaced already, and it may contain colours.
void say_coloured(const std::string& text);

/// Writes data for programs, unchanged. The owner of the stream checks that it was written.
void write_data(std::FILE* to, std::string_view data);

/// Writes text for people to standard output or another file; control characters are replaced by symbols. came_out() checks that it was
/// written.
void type_into(std::FILE* to, std::string_view text);
template <class... Values>
void type_out(fmt::format_string<Values...> form, Values&&... values) {
  type_into(stdout, fmt::format(form, std::forward<Values>(values)...));
}

}  // namespace kadr::cli
