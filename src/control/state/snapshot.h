#pragma once
// Snapshot: the state of a control between two blocks, as a value. A snapshot is made from one control and can be restored in another
// control with the same definition, set-up and program.

#include <memory>

namespace kadr {

/// Copies share their content; tables that did not change between two snapshots of one control are shared by both.
class Snapshot {
 public:
  struct Content;  // control/snapshot_content.h
  explicit Snapshot(std::shared_ptr<const Content> content) : content_(std::move(content)) {}
  const Content& content() const { return *content_; }

 private:
  std::shared_ptr<const Content> content_;
};

}  // namespace kadr
