#pragma once
// MemoryBound: a common memory limit for all sessions of a server.

#include <atomic>
#include <cstddef>
#include <cstdint>

namespace kadr {

class MemoryBound {
 public:
  /// `most`: the number of bytes that the process may use.
  explicit MemoryBound(std::size_t most) : most_(most) {}
  /// True if the process uses more than the limit. May be called often and from any thread: the system is queried once in 50 ms at most.
  bool is_full() const;

 private:
  std::size_t most_;
  mutable std::atomic<std::int64_t> asked_ = 0;  // time of the last query of the system, ms of the steady clock
  mutable std::atomic<bool> full_ = false;
};

/// Returns the memory that this process uses, in bytes; 0 if the system does not report it.
std::size_t memory_in_use();

}  // namespace kadr
