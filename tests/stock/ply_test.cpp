// stock/mesh/ply: the content of the bytes as a reader finds it.

#include "stock/mesh/ply.h"

#include <gtest/gtest.h>

#include <cstring>

#include "stock/some_meshes.h"

namespace kadr::ply_test {
namespace {

using namespace test;

float float_at(const std::string& bytes, std::size_t at) {
  float value = 0;
  std::memcpy(&value, bytes.data() + at, sizeof value);
  return value;
}

TEST(ply, points_with_colour_and_deviation_then_triangles) {
  const Mesh mesh = box_mesh({0, 0, 0}, {1, 2, 3});
  std::vector<float> deviation(8);
  for (std::size_t i = 0; i < 8; ++i) deviation[i] = float(i) / 8;
  std::string bytes;
  const auto colour = [](float d) { return d > 0 ? 0x102030U : 0xFFFEFDU; };
  ASSERT_TRUE(write_ply(mesh, deviation, colour, [&](std::string_view more) {
    bytes += more;
    return true;
  }));
  const std::string end = "end_header\n";
  const std::size_t first = bytes.find(end) + end.size();
  EXPECT_TRUE(bytes.starts_with("ply\nformat binary_little_endian 1.0\n"));
  EXPECT_NE(bytes.find("element vertex 8\n"), std::string::npos);
  EXPECT_NE(bytes.find("property float deviation\nelement face 12\n"), std::string::npos);
  constexpr std::size_t vertex = 3 * 4 + 3 + 4, face = 1 + 3 * 4;
  ASSERT_EQ(bytes.size(), first + 8 * vertex + 12 * face);
  EXPECT_EQ(bytes.substr(first + 12, 3), "\xFF\xFE\xFD");
  EXPECT_EQ(bytes.substr(first + vertex + 12, 3), "\x10\x20\x30");
  for (std::size_t i = 0; i < 8; ++i) {
    EXPECT_EQ(float_at(bytes, first + i * vertex), mesh.points[3 * i]);
    EXPECT_EQ(float_at(bytes, first + i * vertex + 15), deviation[i]);
  }
  EXPECT_EQ(bytes[first + 8 * vertex], '\3');
  EXPECT_EQ(std::uint8_t(bytes[first + 8 * vertex + 5]), mesh.triangles[1]);
}

TEST(ply, a_sink_that_is_full) {
  const Mesh mesh = box_mesh({0, 0, 0}, {1, 2, 3});
  EXPECT_FALSE(write_ply(
      mesh, std::vector<float>(8), [](float) { return 0U; }, [](std::string_view) { return false; }));
}

}  // namespace
}  // namespace kadr::ply_test
