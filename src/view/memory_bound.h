#pragma once
// MemoryBound: a common memory limit for all sessions of a server.

#include <atomic>
#include <cstddef>
#include <cstdint>

namespace kadr {

class MemoryBound {
 public:
  /// `most`: greatest number of bytes that the process may use.
  explicit MemoryBound(std::size_t most) : most_(most) {}
  /// Returns true if the process uses more memory than the limit. May be called often and from any thread, because the system is queried at
  /// most once in 50 ms.
  bool is_full() const;

 private:
  std::size_t most_;
  mutable std::atomic<std::int64_t> asked_ = 0;  // time of the last query of the system, in ms of the steady clock
  mutable std::atomic<bool> full_ = false;
};

/// Returns the memory in bytes that this process uses; 0 if the system does not report it.
std::size_t memory_in_use();

}  // namespace kadr
