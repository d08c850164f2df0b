// Measures whether the server uses more memory than permitted. Used by view/page/page_session and cli/serve; tested by
// tests/serve_attacks.py.

#include "view/memory_bound.h"

#include <unistd.h>

#include <chrono>
#include <fstream>

namespace kadr {

std::size_t memory_in_use() {
  std::ifstream file("/proc/self/statm");
  std::size_t all = 0, resident = 0;
  return file >> all >> resident ? resident * std::size_t(::sysconf(_SC_PAGESIZE)) : 0;
}

bool MemoryBound::is_full() const {
  using namespace std::chrono;
  constexpr std::int64_t every_ms = 50;
  const std::int64_t now = duration_cast<milliseconds>(steady_clock::now().time_since_epoch()).count();
  if (std::int64_t last = asked_; now - last >= every_ms && asked_.compare_exchange_strong(last, now)) full_ = memory_in_use() > most_;
  return full_;
}

}  // namespace kadr
