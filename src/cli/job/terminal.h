#pragma once
// Prints all text for the user on standard output and standard error. A message never appears in the middle of a progress bar. Colours are
// sent only to terminals. Control characters in names, programs or command lines never reach a terminal.

#include <fmt/core.h>

#include <cstdio>
#include <string>
#include <string_view>
#include <utility>

#include "out/text/alarm_print.h"

namespace kadr::cli {

/// True if standard error is a terminal that supports colours and the environment variable NO_COLOR (no-color.org) is not set.
bool has_colours();

/// Shows a progress bar, which replaces the previous one. Does nothing if standard error is not a terminal.
void show_bar(const std::string& bar);
/// Removes the progress bar if the terminal shows one. The function is called before any other output to a terminal, also before output on
/// standard output. It may be called from any thread.
void erase_bar();

/// Returns the width of the terminal in characters; 80 if the width is unknown.
int terminal_width();

/// Returns the colours for alarms on standard error.
inline Colours colours() { return has_colours() ? Colours::terminal : Colours::none; }

/// Prints text for people on standard error. Control characters are replaced by symbols (␀ …).
void write_message(const std::string& text);
/// Prints text that alarm_text() has returned. The text may contain colours, and its control characters have already been replaced.
void write_coloured_message(const std::string& text);

/// Writes data for other programs without changes. The owner of the stream must check that the data was written.
void write_data(std::FILE* to, std::string_view data);

/// Prints text for people on standard output or to another file. Control characters are replaced by symbols. For standard output,
/// came_out() checks later that the text was written.
void type_into(std::FILE* to, std::string_view text);
template <class... Values>
void type_out(fmt::format_string<Values...> form, Values&&... values) {
  type_into(stdout, fmt::format(form, std::forward<Values>(values)...));
}

}  // namespace kadr::cli
