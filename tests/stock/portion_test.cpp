// stock/portion: the results of portions, joined, are those of the whole stock, bit for bit.

#include "stock/portion/portion.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cstring>

#include "stock/blank/mesh_blank.h"
#include "stock/part/part_compare.h"
#include "stock/portion/joined_surface.h"
#include "stock/some_meshes.h"
#include "stock/stock_samples.h"
#include "stock/surface/surface.h"

namespace kadr::portion_test {
namespace {

using namespace test;

constexpr double cell = 0.55;

/// A file in memory: what a writer has written is read.
struct MemoryFile {
  std::string bytes;
  std::size_t read = 0;

  ByteSink sink() {
    return [this](std::string_view more) {
      bytes += more;
      return true;
    };
  }
  PortionBytes source() {
    return [this](std::span<char> to) {
      if (to.size() > bytes.size() - read) return false;
      std::memcpy(to.data(), bytes.data() + read, to.size());
      read += to.size();
      return true;
    };
  }
};

std::vector<Sweep> sweeps_of(const std::vector<Vec3>& path, std::uint16_t tool, bool tilted) {
  const double side = tilted ? 0.3 : 0, up = std::sqrt(1 - side * side);
  std::vector<Sweep> sweeps;
  for (std::size_t i = 1; i < path.size(); ++i)
    sweeps.push_back({path[i - 1], path[i], tool, i % 3 == 0, {0, 0, 1}, i % 2 == 0 ? Vec3{side, 0, up} : Vec3{0, side, up}});
  return sweeps;
}

struct Program {
  std::shared_ptr<const Blank> blank;
  std::vector<ToolShape> tools;
  std::vector<Sweep> sweeps;
  Mesh part;
};

/// A stock with the tools and sweeps of the program, which are not executed yet.
std::unique_ptr<Stock> stock_of(const Program& program, const std::optional<BrickBox>& own = std::nullopt) {
  auto stock = std::make_unique<Stock>(program.blank, cell, 2, own);
  for (const ToolShape& tool : program.tools) (void)stock->add_tool(tool);
  for (const Sweep& sweep : program.sweeps) stock->add(sweep);
  return stock;
}

std::string stl_of(const Mesh& mesh) {
  MemoryFile file;
  (void)write_stl(mesh, file.sink());
  return file.bytes;
}

bool same_touch(const Touch& a, const Touch& b) {
  return a.sweep == b.sweep && a.part == b.part && a.volume == b.volume && a.rings == b.rings && a.around.least == b.around.least &&
         a.around.most == b.around.most;
}

bool same_offence(const PartOffence& a, const PartOffence& b) {
  return a.volume == b.volume && a.deepest == b.deepest && a.at == b.at && a.sweep == b.sweep;
}

/// Cuts the program in `count` portions through files, joins them, and compares all results with those of the whole stock.
void expect_the_same(const Program& program, int count) {
  const auto whole = stock_of(program);
  const std::vector<Touch> touches = whole->cut();
  const Surface surface = surface_of(*whole);
  const PartComparison held = compare(*whole, surface, program.part);

  const Lattice& lattice = whole->lattice();
  std::vector<MemoryFile> files(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) {
    const BrickBox own = bricks_of(lattice, {i + 1, count});
    const auto portion = stock_of(program, own);
    (void)portion->cut();
    PortionWriter writer(files[std::size_t(i)].sink());
    writer.begin({{i + 1, count}, cell, {lattice.bricks(0), lattice.bricks(1), lattice.bricks(2)}}, "test");
    writer.add(portion->portion_cut());
    const bool any = portion->lattice().size() > 0;
    const Surface part = any ? surface_of(*portion) : Surface();
    const PartComparison compared = any ? compare(*portion, part, program.part) : PartComparison();
    writer.finish(part, portion->fingerprint(), &compared);
  }

  const auto joined = stock_of(program, no_bricks);
  (void)joined->cut();
  std::vector<PortionReader> readers;
  std::vector<PortionCut> cuts;
  for (MemoryFile& file : files) {
    readers.emplace_back(file.source());
    ASSERT_TRUE(readers.back().begin("test").has_value());
    cuts.push_back(readers.back().next_cut());
  }
  const std::vector<Touch> joined_touches = joined->add_portions(cuts);
  ASSERT_EQ(joined_touches.size(), touches.size());
  for (std::size_t i = 0; i < touches.size(); ++i) EXPECT_TRUE(same_touch(joined_touches[i], touches[i]));
  for (std::size_t i = 0; i < whole->sweeps(); ++i) {
    EXPECT_EQ(joined->removed_by(i), whole->removed_by(i));
    EXPECT_EQ(joined->depth_of(i), whole->depth_of(i));
    EXPECT_EQ(joined->cuts_anything(i), whole->cuts_anything(i));
  }

  std::vector<PortionEnd> ends;
  std::vector<PartComparison> comparisons;
  std::uint64_t triangles = 0;
  for (PortionReader& reader : readers) {
    ends.push_back(reader.end().value());
    EXPECT_EQ(ends.back().fingerprint, whole->fingerprint());
    triangles += ends.back().triangles;
    comparisons.push_back(ends.back().comparison.value());
  }
  const PartComparison all = join_comparisons(comparisons);
  EXPECT_TRUE(same_offence(all.left_on, held.left_on));
  EXPECT_TRUE(same_offence(all.gouged, held.gouged));
  MemoryFile stl;
  StlWriter writer(stl.sink(), std::uint32_t(triangles));
  const JoinedSurface found = join_surfaces(readers, ends, &writer);
  EXPECT_TRUE(writer.finish() && found.sound);
  EXPECT_EQ(found.triangles, surface.triangle_count());
  EXPECT_EQ(found.volume, volume_of(surface));
  EXPECT_EQ(found.area, area_of(surface));
  EXPECT_TRUE(stl.bytes == stl_of(surface)) << "the meshes differ";
}

Program program_of(std::shared_ptr<const Blank> blank, ToolKind kind, const std::vector<Vec3>& path, bool tilted) {
  Program program{std::move(blank), {tool_of(kind, 6, 8), tool_of(ToolKind::flat, 3, 12)}, sweeps_of(path, 0, tilted), {}};
  for (const Sweep& sweep : sweeps_of({{40, -5, -4}, {-5, 28, -6}, {35, 35, -3}}, 1, false)) program.sweeps.push_back(sweep);
  program.part = box_mesh({2, 3, -9.5}, {31, 27, -4.2});
  return program;
}

const std::vector<Vec3> wave{{-5, -5, -2}, {12, 9, -3.3}, {25, 4, -6}, {33, 31, -2}, {7, 22, -8}, {16, 16, -12}, {16, 16, 5}, {-4, 12, -1}};
const Box3 plate{{0, 0, -10}, {32, 29, 0}};

TEST(portions, divide_all_bricks) {
  const Lattice lattice(plate, cell);
  for (int count = 1; count <= 40; ++count) {
    std::vector<int> owners(lattice.size(), 0);
    for (int i = 1; i <= count; ++i) {
      const BrickBox box = bricks_of(lattice, {i, count});
      for (std::size_t b = 0; b < lattice.size(); ++b) owners[b] += box.holds(lattice.place(b));
    }
    EXPECT_EQ(std::count(owners.begin(), owners.end(), 1), std::ptrdiff_t(lattice.size())) << count;
  }
}

TEST(portions, joined_are_the_whole) {
  for (const int count : {2, 3, 4, 7}) expect_the_same(program_of(box_blank(plate), ToolKind::ball, wave, false), count);
  for (const ToolKind kind : {ToolKind::flat, ToolKind::bull, ToolKind::taper})
    expect_the_same(program_of(box_blank(plate), kind, wave, false), 4);
}

TEST(portions, of_tilted_tools) {
  for (const int count : {2, 4, 5}) expect_the_same(program_of(box_blank(plate), ToolKind::ball, wave, true), count);
}

TEST(portions, of_other_blanks) {
  expect_the_same(program_of(cylinder_blank({16, 15}, -10, 0, 30), ToolKind::ball, wave, false), 4);
  expect_the_same(program_of(mesh_blank(torus_mesh(48, 14, 5)), ToolKind::flat, wave, false), 3);
  // A part far beyond the blank, and more portions than bricks along an axis: some are empty.
  Program program = program_of(box_blank({{0, 0, -10}, {9, 4, 0}}), ToolKind::ball, wave, false);
  program.part = box_mesh({-30, -2, -20}, {8, 50, -3});
  for (const int count : {2, 5, 13}) expect_the_same(program, count);
}

RC_GTEST_PROP(portions, of_random_programs, ()) {
  std::vector<Vec3> path;
  const auto place = [](int from, int to) { return *rc::gen::inRange(from, to) / 10.0; };
  for (int i = 0; i < 8; ++i) path.push_back({place(-60, 380), place(-60, 350), place(-120, 20)});
  const ToolKind kind = *rc::gen::element(ToolKind::ball, ToolKind::flat, ToolKind::bull);
  expect_the_same(program_of(box_blank(plate), kind, path, *rc::gen::arbitrary<bool>()), *rc::gen::inRange(2, 10));
}

TEST(portion_file, other_builds_and_damaged_files_are_detected) {
  const Program program = program_of(box_blank(plate), ToolKind::ball, wave, false);
  const auto portion = stock_of(program, bricks_of(Lattice(plate, cell), {1, 2}));
  (void)portion->cut();
  MemoryFile file;
  PortionWriter writer(file.sink());
  writer.begin({{1, 2}, cell, {6, 5, 2}}, "test");
  writer.add(portion->portion_cut());
  writer.finish(surface_of(*portion), portion->fingerprint(), nullptr);
  const auto read = [](MemoryFile bytes, const std::string& build) {
    std::vector<PortionReader> readers;
    readers.emplace_back(bytes.source());
    if (!readers[0].begin(build)) return false;
    (void)readers[0].next_cut();
    const auto end = readers[0].end();
    return end && join_surfaces(readers, {*end}, nullptr).sound;
  };
  EXPECT_TRUE(read(file, "test"));
  EXPECT_FALSE(read(file, "next"));
  for (const double share : {0.0, 0.0001, 0.01, 0.2, 0.5, 0.9, 0.99999}) {
    MemoryFile shorter{file.bytes.substr(0, std::size_t(share * double(file.bytes.size()))), 0};
    EXPECT_FALSE(read(shorter, "test")) << share;
  }
  for (std::size_t at = 0; at < file.bytes.size(); at += 1 + at / 3) {  // a changed byte never leads to a crash
    MemoryFile changed = file;
    changed.bytes[at] = char(changed.bytes[at] ^ 0x55);
    (void)read(changed, "test");
  }
}

}  // namespace
}  // namespace kadr::portion_test
