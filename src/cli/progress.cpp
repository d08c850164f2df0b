#include "cli/progress.h"

#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>
#include <string>

namespace kadr::cli {
namespace {

constexpr auto first_after = std::chrono::milliseconds(800);
constexpr auto again_after = std::chrono::milliseconds(200);
constexpr int width = 40;  // characters of the bar

}  // namespace

Progress::Progress(bool quiet) : on_(!quiet && isatty(STDERR_FILENO) != 0) {}

Progress::~Progress() {
  if (shown_) fmt::print(stderr, "\r{:{}}\r", "", width + 40);
}

bool Progress::is_due() const {
  if (!on_) return false;
  const auto now = Clock::now();
  return now - start_ >= first_after && now - last_ >= again_after;
}

void Progress::show(const Control& control) {
  if (control.bytes() == 0) return;
  show(static_cast<double>(control.bytes_read()) / static_cast<double>(control.bytes()), fmt::format("{} blocks", control.blocks()));
}

void Progress::show(double part, const std::string& what) {
  last_ = Clock::now();
  shown_ = true;
  part = std::clamp(part, 0.0, 1.0);
  const int full = static_cast<int>(part * width);
  fmt::print(stderr, "\r[{}{}] {:3.0f} %  {:<24}", std::string(static_cast<std::size_t>(full), '#'),
             std::string(static_cast<std::size_t>(width - full), '.'), part * 100, what);
  std::fflush(stderr);
}

}  // namespace kadr::cli
