#pragma once
// MemoryBound: what all sessions of a server may hold together.

#include <atomic>
#include <cstddef>
#include <cstdint>

namespace kadr {

class MemoryBound {
 public:
  /// `most`: bytes of memory of the process.
  explicit MemoryBound(std::size_t most) : most_(most) {}
  /// It holds more. From any thread, often: the system is asked every 50 ms.
  bool is_full() const;

 private:
  std::size_t most_;
  mutable std::atomic<std::int64_t> asked_ = 0;  // ms of the steady clock
  mutable std::atomic<bool> full_ = false;
};

/// Memory that this process has in use, bytes; 0: the system does not say.
std::size_t memory_in_use();

}  // namespace kadr
