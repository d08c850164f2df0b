// config/machine/machine_bodies_file: [[bodies]] of machines/*.toml.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <tuple>

#include "config/machine/machine_profile.h"
#include "own_place.h"

namespace kadr::machine_bodies_test {
namespace {

const std::string head =
    "id = 'a'\n"
    "[axes]\n"
    "X = {}\n"
    "Y = {}\n"
    "Z = {}\n"
    "C = {}\n";
const std::string chains =
    "[kinematics]\n"
    "tool = ['X', 'Y', 'Z']\n"
    "part = ['C']\n";

std::filesystem::path a_file() { return own_place("bodies.toml"); }

tl::expected<MachineProfile, std::string> loaded(const std::string& toml) {
  std::ofstream(a_file()) << toml;
  auto profile = load_machine(a_file().string());
  std::filesystem::remove(a_file());
  return profile;
}

std::string refusal(const std::string& body) {
  const auto profile = loaded(head + chains + "[[bodies]]\n" + body);
  EXPECT_FALSE(profile) << body;
  return profile ? "" : profile.error().substr(a_file().string().size());
}

TEST(machine_bodies, shapes_and_carriers) {
  const auto profile = loaded(head + chains +
                              "[[bodies]]\nname = 'head'\non = 'Z'\nbox = [-1, -2, 0, 1, 2, 30.5]\n"
                              "[[bodies]]\nname = 'стол'\non = 'C'\ncylinder = [10, 20, -450, -400, 320]\n"
                              "[[bodies]]\nname = 'bed'\non = 'bed'\nfile = 'meshes/bed.STL'\n"
                              "[[bodies]]\nname = 'cover'\non = 'bed'\nfile = '/cover.3mf'\n");
  ASSERT_TRUE(profile) << profile.error();
  ASSERT_EQ(profile->bodies.size(), 4U);
  const auto& [box, cylinder, mesh, cover] = std::tie(profile->bodies[0], profile->bodies[1], profile->bodies[2], profile->bodies[3]);
  EXPECT_EQ(box.name, "head");
  EXPECT_EQ(box.on, "Z");
  EXPECT_EQ(box.shape.form, BodyShape::Form::box);
  EXPECT_EQ(box.shape.least, (Vec3{-1, -2, 0}));
  EXPECT_EQ(box.shape.most, (Vec3{1, 2, 30.5}));
  EXPECT_EQ(cylinder.on, "C");
  EXPECT_EQ(cylinder.shape.form, BodyShape::Form::cylinder);
  EXPECT_EQ(cylinder.shape.centre, (Vec2{10, 20}));
  EXPECT_EQ(cylinder.shape.bottom, -450);
  EXPECT_EQ(cylinder.shape.top, -400);
  EXPECT_EQ(cylinder.shape.diameter, 320);
  EXPECT_EQ(mesh.on, "");
  EXPECT_EQ(mesh.shape.file, (a_file().parent_path() / "meshes/bed.STL").string());  // in the folder of the machine's file
  EXPECT_EQ(cover.shape.file, "/cover.3mf");
}

// Without [kinematics] the axes X, Y and Z move the tool.
TEST(machine_bodies, without_chains) {
  EXPECT_TRUE(loaded(head + "[[bodies]]\nname = 'head'\non = 'Z'\nbox = [0, 0, 0, 1, 1, 1]\n"));
  const auto other = loaded(head + "[[bodies]]\nname = 'table'\non = 'C'\nbox = [0, 0, 0, 1, 1, 1]\n");
  ASSERT_FALSE(other);
  EXPECT_EQ(other.error().substr(a_file().string().size()),
            ":9: 'on' must be \"bed\" or an axis that carries the tool or the part: bed, X, Y, Z");
}

TEST(machine_bodies, mistakes_have_a_line) {
  EXPECT_EQ(refusal("on = 'Z'\nbox = [0, 0, 0, 1, 1, 1]"), ":10: a body needs a name, 1 to 100 bytes");
  EXPECT_EQ(refusal("name = '" + std::string(101, 'n') + "'\non = 'Z'\nbox = [0, 0, 0, 1, 1, 1]"),
            ":11: a body needs a name, 1 to 100 bytes");
  EXPECT_EQ(refusal("name = 'h'\nbox = [0, 0, 0, 1, 1, 1]"),
            ":10: 'on' must be \"bed\" or an axis that carries the tool or the part: bed, X, Y, Z, C");
  EXPECT_EQ(refusal("name = 'h'\non = 'W'\nbox = [0, 0, 0, 1, 1, 1]"),
            ":12: 'on' must be \"bed\" or an axis that carries the tool or the part: bed, X, Y, Z, C");
  EXPECT_EQ(refusal("name = 'h'\non = 'Z'\nbocks = [0, 0, 0, 1, 1, 1]"), ":13: unknown key 'bocks'");
  const std::string one_of = ":10: a body is one of box = […], cylinder = […], file = \"….stl\"";
  EXPECT_EQ(refusal("name = 'h'\non = 'Z'"), one_of);
  EXPECT_EQ(refusal("name = 'h'\non = 'Z'\nbox = [0, 0, 0, 1, 1, 1]\nfile = 'a.stl'"), one_of);
  EXPECT_EQ(refusal("name = 'h'\non = 'Z'\nfile = 'head.obj'"), ":13: file must be the name of a file .stl or .3mf");
  EXPECT_EQ(refusal("name = 'h'\non = 'Z'\nfile = 3"), ":13: file must be the name of a file .stl or .3mf");
}

TEST(machine_bodies, no_size_is_beyond_every_machine) {
  const std::string number = "a number, -10000000 to 10000000 mm or degrees";
  for (const char* box : {"[0, 0, 0, 1, 1]", "[0, 0, 0, 1, 1, 0]", "[0, 0, 0, 1, 1, 1e8]", "[0, 0, 0, 1, 1, nan]", "[0, 0, 0, 1, 1, inf]",
                          "1", "['0', 0, 0, 1, 1, 1]"})
    EXPECT_EQ(refusal(std::string("name = 'h'\non = 'Z'\nbox = ") + box),
              ":13: box must be [X0, Y0, Z0, X1, Y1, Z1], the first corner below the second in each axis, each " + number)
        << box;
  for (const char* cylinder : {"[0, 0, 0, 1]", "[0, 0, 1, 1, 5]", "[0, 0, 0, 1, 0]", "[0, 0, 0, 1, -5]", "[0, 0, 0, 1, 1e9]"})
    EXPECT_EQ(refusal(std::string("name = 'h'\non = 'Z'\ncylinder = ") + cylinder),
              ":13: cylinder must be [X, Y, Z0, Z1, D]: its axis, its bottom, its top above that, its diameter above 0, each " + number)
        << cylinder;
}

TEST(machine_bodies, they_are_tables) {
  for (const char* bodies : {"bodies = 1\n", "bodies = 'head'\n"}) {
    const auto profile = loaded(bodies + head);
    ASSERT_FALSE(profile);
    EXPECT_EQ(profile.error().substr(a_file().string().size()), ":1: bodies are tables: [[bodies]]");
  }
  const auto profile = loaded("bodies = [1]\n" + head);
  ASSERT_FALSE(profile);
  EXPECT_EQ(profile.error().substr(a_file().string().size()), ":1: a body is a table: [[bodies]]");
}

}  // namespace
}  // namespace kadr::machine_bodies_test
