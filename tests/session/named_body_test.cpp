// session/cutting/named_body: bodies described in words by the user, and what is refused.

#include "session/cutting/named_body.h"

#include <gtest/gtest.h>

namespace kadr::named_body_test {
namespace {

constexpr double most = 1e8;  // bytes

TEST(NamedBody, BoxAndCylinder) {
  const auto box = body_of("box:-1,-2,-3,1,2,3", most);
  ASSERT_TRUE(box);
  EXPECT_DOUBLE_EQ(box->body->volume(), 48);
  const auto rod = body_of("cylinder:0,0,-10,0,4", most);
  ASSERT_TRUE(rod);
  EXPECT_NEAR(rod->body->volume(), 125.6637, 1e-3);
}

TEST(NamedBody, WhatIsNoneIsRefused) {
  for (const char* text : {"", "box", "box:", "box:0,0,0,1,1", "box:0,0,0,1,1,1,1", "box:0,0,0,-1,1,1", "box:0,0,0,1,1,nan",
                           "box:0,0,0,1,1,inf", "box:0,0,0,1,1,1e300", "box:0,0,0,1,1,1 ", "cylinder:0,0,1,0,5", "cylinder:0,0,0,1,0",
                           "cylinder:0,0,0,1,nan", "ball:1", "/etc/passwd", "nothing.stl", "box:0,0,0,1e6,1,1"})
    EXPECT_FALSE(body_of(text, most)) << text;
}

TEST(NamedBody, Windows) {
  EXPECT_TRUE(window_of("0,0,0,1,1,1"));
  for (const char* text : {"", "0,0,0,1,1", "0,0,0,0,1,1", "0,0,0,1,1,x"}) EXPECT_FALSE(window_of(text)) << text;
}

TEST(NamedBody, WhichWordsAreFiles) {
  EXPECT_TRUE(names_mesh_file("a.STL"));
  EXPECT_TRUE(names_mesh_file("dir/a.3mf"));
  EXPECT_FALSE(names_mesh_file("box:0,0,0,1,1,1"));
}

}  // namespace
}  // namespace kadr::named_body_test
