#pragma once
// StoredPlaces: places of a text, each with the state that a reader or a run had there; and NotedSource, which tells how much of the text
// such a state depends on. Used by checks that continue in the middle of a changed text (check_memory.h).

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "lang/text/line_reader.h"

namespace kadr {

/// A source of bytes that notes how far it has been read.
class NotedSource final : public ByteSource {
 public:
  static constexpr std::uint64_t all = ~std::uint64_t{0};

  explicit NotedSource(std::shared_ptr<ByteSource> source) : source_(std::move(source)) {}

  /// Reads as the source does. After the beginning of the text it reads small pieces, so that no reader is far ahead of its block.
  std::size_t read(std::uint64_t offset, char* to, std::size_t size) override;
  std::uint64_t size() const override { return source_->size(); }
  /// Returns the number of bytes, from the first on, that the results of reading so far depend on; `all` if the end has been met.
  std::uint64_t known() const { return known_; }

 private:
  std::shared_ptr<ByteSource> source_;
  std::atomic<std::uint64_t> known_ = 0;  // atomic, because a control may read ahead in its own thread
};

template <class State>
class StoredPlaces {
 public:
  /// Removes the places whose states depend on more than the first `unchanged` bytes.
  void keep_until(std::uint64_t unchanged) {
    while (!all_.empty() && all_.back().known > unchanged) all_.pop_back();
  }
  /// True if a state that depends on the first `known` bytes of a text of `size` bytes is far enough from the last place to be stored.
  bool wants(std::uint64_t known, std::uint64_t size) const {
    constexpr std::uint64_t parts = 16, least_bytes = 32 * 1024;
    const std::uint64_t before = all_.empty() ? 0 : all_.back().known;
    return known != NotedSource::all && known >= before + std::max(size / parts, least_bytes);
  }
  void store(std::uint64_t known, State state) { all_.push_back({known, std::move(state)}); }
  /// Returns the last place; nullptr if there is none.
  const State* last() const { return all_.empty() ? nullptr : &all_.back().state; }

 private:
  struct Place {
    std::uint64_t known = 0;
    State state;
  };
  std::vector<Place> all_;
};

}  // namespace kadr
