#pragma once
// What people read, on standard output and standard error: all of it goes through here. A message never stands behind half a bar, colours
// go to terminals alone, and no control character of a name, a program or a word of the command line reaches a terminal.

#include <fmt/core.h>

#include <cstdio>
#include <string>
#include <string_view>
#include <utility>

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

/// Text for people, to standard error. Control characters are shown as pictures.
void say(const std::string& text);
/// Of alarm_text(), which has shown them so already and may have coloured the rest.
void say_coloured(const std::string& text);

/// What programs read, as it is. Whether it came out is asked by who keeps the file.
void write_data(std::FILE* to, std::string_view data);

/// Text for people, to standard output or another file; control characters as pictures. Whether it came out is asked by came_out().
void type_into(std::FILE* to, std::string_view text);
template <class... Values>
void type_out(fmt::format_string<Values...> form, Values&&... values) {
  type_into(stdout, fmt::format(form, std::forward<Values>(values)...));
}

}  // namespace kadr::cli
