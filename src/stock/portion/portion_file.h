#pragma once
// Portion files: what a process writes that has cut a portion of the bricks (stock/portion/portion.h), and what the process that joins the
// portions reads. A file contains, in this order: the head, what the portion removed in each batch of sweeps, the end of the batches with
// the comparison with the wanted part, and the triangles brick by brick. Numbers are stored as they are in memory, so all processes must
// run the same build on processors of the same kind; the head contains a mark for both.

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "stock/mesh/byte_sink.h"
#include "stock/part/part_compare.h"
#include "stock/portion/portion.h"
#include "stock/surface/surface.h"

namespace kadr {

/// The bricks and the lattice of a portion.
struct PortionHead {
  Portion portion;
  double cell = 0;
  std::array<int, 3> bricks{};  // of the whole lattice
  bool operator==(const PortionHead&) const = default;
};

/// What is known after the last batch.
struct PortionEnd {
  std::uint64_t fingerprint = 0;                  // Stock::fingerprint()
  std::uint64_t triangles = 0;                    // of the portion
  std::uint64_t first_brick = ~std::uint64_t{0};  // number of the first brick with points
  std::array<float, 3> first_point{};             // the first point of the portion
  std::optional<PartComparison> comparison;       // without deviations; nullopt: no wanted part
};

/// A triangle of the surface, as it is stored.
struct PortionTriangle {
  std::array<std::array<float, 3>, 3> corners;
  std::uint32_t is_cut;  // 1 if a tool has made one of its corners, 0 if all are of the blank
};

class PortionWriter {
 public:
  explicit PortionWriter(ByteSink sink) : sink_(std::move(sink)) {}

  void begin(const PortionHead& head, const std::string& build);
  void add(const PortionCut& cut);
  /// Writes the end: the surface, and the comparison if there is a wanted part.
  void finish(const Surface& surface, std::uint64_t fingerprint, const PartComparison* comparison);
  /// Returns false if the sink has refused bytes; the file is then incomplete.
  bool complete() const { return complete_; }

 private:
  template <class T>
  void put(const T& value);
  template <class T>
  void put_all(const std::vector<T>& values);
  void put_brick(const Surface& surface, const SurfaceBrick& brick);

  ByteSink sink_;
  bool complete_ = true;
};

/// Fills the span with the next bytes of a file. Returns false if the file ends before.
using PortionBytes = std::function<bool(std::span<char>)>;

/// The triangles of one brick.
struct PortionBrick {
  std::uint64_t number = 0;
  std::vector<PortionTriangle> triangles;
};

class PortionReader {
 public:
  explicit PortionReader(PortionBytes source) : source_(std::move(source)) {}

  /// Reads the head. Returns nullopt if the file is no portion file of this build.
  std::optional<PortionHead> begin(const std::string& build);
  /// Reads what the portion removed in the next batch. After the last batch, and in a damaged file, this is nothing.
  PortionCut next_cut();
  /// Reads the end of the batches. Returns nullopt if batches remain, or the file is damaged.
  std::optional<PortionEnd> end();
  /// Reads the next brick. Returns false after the last brick, and in a damaged file (is_sound()).
  bool next(PortionBrick& brick);
  bool is_sound() const { return sound_; }

 private:
  template <class T>
  bool get(T& value);
  template <class T>
  bool get_all(std::vector<T>& values);

  PortionBytes source_;
  bool sound_ = true;
  std::uint32_t mark_ = 0;  // the mark that was read last
};

}  // namespace kadr
