#pragma once
// A control between two blocks, as a value: taken from one, given to another of the same control, set-up and program.

#include <memory>

namespace kadr {

/// Copies share what they hold, and tables that did not change between two snapshots of one control are shared by them.
class Snapshot {
 public:
  struct Content;  // control/snapshot.cpp
  explicit Snapshot(std::shared_ptr<const Content> content) : content_(std::move(content)) {}
  const Content& content() const { return *content_; }

 private:
  std::shared_ptr<const Content> content_;
};

}  // namespace kadr
