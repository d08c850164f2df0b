// NotedSource: notes how far a text has been read. Used by session/checklist/check_memory; tested by tests/session/check_memory_test.cpp.

#include "session/checklist/stored_places.h"

namespace kadr {

std::size_t NotedSource::read(std::uint64_t offset, char* to, std::size_t size) {
  // The beginning is read as a whole, since the encoding is guessed from it.
  constexpr std::size_t piece = 16 * 1024;
  const std::size_t wanted = offset == 0 ? size : std::min(size, piece);
  const std::size_t got = source_->read(offset, to, wanted);
  const std::uint64_t known = got < wanted ? all : offset + got;
  std::uint64_t before = known_;
  while (before < known && !known_.compare_exchange_weak(before, known)) {
  }
  return got;
}

}  // namespace kadr
