#pragma once
// Journal: old values of the table cells and variables that a block has written, so that an alarm in the same block can restore them. The
// state itself (ControlState) is a value, which is restored by copying. Code that writes other data records their old values in the journal
// first.

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <functional>
#include <type_traits>
#include <utility>
#include <vector>

namespace kadr {

class Journal {
 public:
  /// Starts a block: the old values recorded before are discarded.
  void begin() {
    ++block_;
    used_ = 0;
    if (!undos_.empty()) [[unlikely]]
      undos_.clear();
  }
  /// Records the old value of `cell`, which the caller is about to write. The cell must not move in memory before the block is over.
  template <class T>
  void keep(T& cell) {
    static_assert(std::is_trivially_copyable_v<T> && alignof(T) <= alignof(Change));
    std::memcpy(room_for(sizeof cell), &cell, sizeof cell);
    note({&cell, sizeof cell});
  }
  /// Records a function that undoes a change that is not one cell, such as added or removed rows. What `undo` accesses must not move in
  /// memory before the block is over.
  void on_undo(std::function<void()> undo) {
    (void)room_for(0);
    note({nullptr, undos_.size()});
    undos_.push_back(std::move(undo));
  }
  /// Restores all recorded values to those at begin(); the last change is undone first.
  void undo();
  /// Returns the number of the block, which increases with each block.
  std::uint64_t block() const { return block_; }

 private:
  /// The record that follows the bytes of an old value. The record comes after the bytes because undo() reads backwards, so that it finds
  /// the last change first.
  struct alignas(8) Change {  // aligned as the values are, which are 8 bytes long on processors with addresses of 4 bytes too
    void* cell;               // address of the changed cell; nullptr: no cell has changed, and the function undos_[size] undoes the change
    std::size_t size;         // size of the changed cell in bytes, or index of the function in undos_
  };
  static constexpr std::size_t step = alignof(Change);
  static constexpr std::size_t rounded(std::size_t size) { return (size + step - 1) / step * step; }
  std::byte* room_for(std::size_t size) {
    const std::size_t needed = used_ + rounded(size) + sizeof(Change);
    if (needed > bytes_.size()) [[unlikely]]
      bytes_.resize(2 * needed);
    std::byte* const at = bytes_.data() + used_;
    used_ += rounded(size);
    return at;
  }
  void note(Change change) {
    std::memcpy(bytes_.data() + used_, &change, sizeof change);
    used_ += sizeof change;
  }

  std::vector<std::byte> bytes_ = std::vector<std::byte>(1024);
  std::size_t used_ = 0;
  std::vector<std::function<void()>> undos_;
  std::uint64_t block_ = 0;
};

/// A table's link to its journal. The link belongs to the table object, not to its value: a table that another table is copied into keeps
/// its own link.
class JournalLink {
 public:
  JournalLink() = default;
  explicit JournalLink(Journal& journal) : journal_(&journal) {}
  JournalLink(const JournalLink&) {}
  JournalLink& operator=(const JournalLink&) { return *this; }  // NOLINT(bugprone-unhandled-self-assignment): nothing is assigned
  ~JournalLink() = default;
  void relink(Journal& journal) { journal_ = &journal; }

  template <class Undo>
  void on_undo(Undo&& undo) const {
    if (journal_ != nullptr) journal_->on_undo(std::forward<Undo>(undo));
  }
  /// Returns true at the first call in this block: the table then has to record its old state. Without a journal the result is false,
  /// because nothing is restored.
  bool is_first() { return journal_ != nullptr && std::exchange(seen_, journal_->block()) != journal_->block(); }
  /// Makes is_first() return true at its next call, as if the table had recorded nothing in this block.
  void start_again() { seen_ = 0; }
  explicit operator bool() const { return journal_ != nullptr; }

 private:
  Journal* journal_ = nullptr;
  std::uint64_t seen_ = 0;  // number of the block in which is_first() was called last
};

}  // namespace kadr
