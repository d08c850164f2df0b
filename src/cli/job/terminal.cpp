// Prints text for people on the terminal. This file is used by the rest of cli and tested by tests/every_command.py (names, texts and no
// reader).

#include "cli/job/terminal.h"

#include <fmt/core.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <mutex>

#include "cli/options/options.h"
#include "config/read_file.h"
#include "out/text/source_line.h"

namespace kadr::cli {
namespace {

// locked during output to the terminal, since the thread that waits for Ctrl-C also erases the progress bar
std::mutex writing;
std::size_t characters_shown = 0;  // number of characters of the progress bar that the terminal shows now

void erase_shown() {
  if (characters_shown == 0) return;
  // blanks erase the bar, since not every terminal understands escape sequences
  fmt::print(stderr, "\r{}\r", std::string(characters_shown, ' '));
  std::fflush(stderr);
  characters_shown = 0;
}

bool is_set(const char* variable) {
  const char* const value = std::getenv(variable);
  return value != nullptr && *value != '\0';
}

}  // namespace

bool has_colours() {
  static const bool has = [] {
    const char* const kind = std::getenv("TERM");
    return ::isatty(STDERR_FILENO) != 0 && !is_set("NO_COLOR") && kind != nullptr && *kind != '\0' && std::string_view(kind) != "dumb";
  }();
  return has;
}

void show_bar(const std::string& bar) {
  const std::lock_guard lock(writing);
  const std::size_t characters = characters_before(bar, bar.size());
  const std::size_t rest = characters_shown > characters ? characters_shown - characters : 0;
  fmt::print(stderr, "\r{}{}", bar, std::string(rest, ' '));
  std::fflush(stderr);
  characters_shown = characters + rest;
}

void erase_bar() {
  const std::lock_guard lock(writing);
  erase_shown();
}

int terminal_width() {
  constexpr int usual = 80;
  winsize size{};
  return ::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : usual;
}

void write_coloured_message(const std::string& text) {
  const std::lock_guard lock(writing);
  erase_shown();
  std::fwrite(text.data(), 1, text.size(), stderr);
}

void write_message(const std::string& text) { write_coloured_message(visible(text)); }

void write_data(std::FILE* to, std::string_view data) { std::fwrite(data.data(), 1, data.size(), to); }

void type_into(std::FILE* to, std::string_view text) { write_data(to, visible(text)); }

void complain(const std::string& text) { write_message("kadr: " + text + "\n"); }

void complain_of_writing(const std::string& name, int error) {
  if (error != EPIPE) complain(name + ": " + errno_message(error));
}

}  // namespace kadr::cli
