// Reads the keyboard without waiting. Used by kadr drive.

#include "cli/job/keyboard.h"

#include <poll.h>
#include <unistd.h>

#include <utility>

namespace kadr::cli {

void Keyboard::read() {
  pollfd input = {STDIN_FILENO, POLLIN, 0};
  if (ended_ || ::poll(&input, 1, 0) <= 0) return;
  char byte = 0;  // one by one: what follows a line may be for another reader
  const ssize_t got = ::read(STDIN_FILENO, &byte, 1);
  if (got > 0) typed_ += byte;
  else ended_ = true;
}

char Keyboard::next() {
  read();
  while (!typed_.empty()) {
    const char key = typed_.front();
    typed_.erase(0, 1);
    if (key > ' ') return key;
  }
  return 0;
}

std::optional<std::string> Keyboard::line() {
  do {
    if (const std::size_t end = typed_.find('\n'); end != std::string::npos) {
      std::string line = typed_.substr(0, end);
      typed_.erase(0, end + 1);
      return line;
    }
    const std::size_t before = typed_.size();
    read();
    if (typed_.size() == before && !ended_) return std::nullopt;
  } while (!ended_);
  return std::exchange(typed_, {});
}

}  // namespace kadr::cli
