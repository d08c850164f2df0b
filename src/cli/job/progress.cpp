// Progress: shows a progress bar on the terminal while a command works for a long time. It is used by the rest of cli.

#include "cli/job/progress.h"

#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>
#include <string>

#include "cli/job/terminal.h"
#include "out/text/source_line.h"
#include "texts/job.h"

namespace kadr::cli {
namespace {

constexpr auto first_after = std::chrono::milliseconds(800);
constexpr auto again_after = std::chrono::milliseconds(200);
constexpr int max_width = 40, least_width = 5;  // greatest and least length of the bar, in characters
constexpr int reserved = 12;                    // number of characters for the brackets, the percentage, and a gap before the last column

}  // namespace

Progress::Progress(bool quiet) : on_(!quiet && isatty(STDERR_FILENO) != 0) {}

Progress::~Progress() { erase_bar(); }

bool Progress::is_due() const {
  if (!on_) return false;
  const auto now = Clock::now();
  return now - start_ >= first_after && now - last_ >= again_after;
}

void Progress::show(const Control& control) {
  if (control.bytes() == 0) return;
  show(static_cast<double>(control.bytes_read()) / static_cast<double>(control.bytes()), counted(texts::job::blocks, control.blocks()));
}

void Progress::show(double part, const std::string& what) {
  last_ = Clock::now();
  part = std::clamp(part, 0.0, 1.0);
  // the gap is needed, since a terminal might wrap a full line
  const int room = terminal_width() - reserved - static_cast<int>(characters_before(what, what.size()));
  if (room < least_width) return;
  const int width = std::min(room, max_width), full = static_cast<int>(part * width);
  show_bar(fmt::format("[{}{}] {:3.0f} %  {}", std::string(static_cast<std::size_t>(full), '#'),
                       std::string(static_cast<std::size_t>(width - full), '.'), part * 100, what));
}

}  // namespace kadr::cli
