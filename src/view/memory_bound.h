#pragma once
// MemoryBound: a memory limit for all sessions of a server together.

#include <atomic>
#include <cstddef>
#include <cstdint>

namespace kadr {

class MemoryBound {
 public:
  /// `most`: bytes of memory of the process.
  explicit MemoryBound(std::size_t most) : most_(most) {}
  /// True if the process uses more. May be called often and from any thread: the system is queried every 50 ms at most.
  bool is_full() const;

 private:
  std::size_t most_;
  mutable std::atomic<std::int64_t> asked_ = 0;  // time of the last query: ms of the steady clock
  mutable std::atomic<bool> full_ = false;
};

/// Memory that this process uses, bytes; 0 if the system does not report it.
std::size_t memory_in_use();

}  // namespace kadr
