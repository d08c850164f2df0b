// control/sinumerik/frame: chains of frames, their inverse and their parts (spec/sinumerik 11.1).

#include "control/sinumerik/frame.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace kadr::sinumerik_frame_test {
namespace {

using namespace sinumerik;

Frame random_frame() {
  const auto angle = [] { return *rc::gen::inRange(-179, 180) * 1.0; };
  Frame frame;
  frame.linear = rotation_rpy(angle(), angle() / 2.1, angle());
  for (std::size_t j = 0; j < 3; ++j) {
    const double factor = *rc::gen::element(1.0, 2.0, 0.5, -1.0);
    for (std::size_t i = 0; i < 3; ++i) frame.linear[i][j] *= factor;
    frame.shift[j] = *rc::gen::inRange(-500, 500) / 8.0;
  }
  return frame;
}

void expect_near(const Axes& a, const Axes& b) {
  for (std::size_t i = 0; i < 3; ++i) RC_ASSERT(std::fabs(a[i] - b[i]) < 1e-9);
}

RC_GTEST_PROP(frames, chain_applies_the_inner_one_first, ()) {
  const Frame outer = random_frame(), inner = random_frame();
  const Axes point{1, -2, 3};
  expect_near(applied(chained(outer, inner), point), applied(outer, applied(inner, point)));
}

RC_GTEST_PROP(frames, inverse_undoes, ()) {
  const Frame frame = random_frame();
  const auto back = inverse(frame);
  RC_ASSERT(back.has_value());
  const Axes point{4, 5, -6};
  expect_near(applied(*back, applied(frame, point)), point);
}

RC_GTEST_PROP(frames, parts_make_the_same_matrix, ()) {
  const Matrix linear = random_frame().linear;
  const Matrix again = matrix_of(parts_of(linear));
  // With two mirrored axes the parts may name others, but the product is the same.
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) RC_ASSERT(std::fabs(linear[i][j] - again[i][j]) < 1e-9);
}

RC_GTEST_PROP(frames, in_a_plane_are_a_transform, ()) {
  Frame frame;
  const std::size_t axis = *rc::gen::inRange<std::size_t>(0, 3);
  frame.linear = rotation_about(axis, *rc::gen::inRange(-179, 180) * 1.0);
  for (std::size_t j = 0; j < 3; ++j) {
    const double factor = *rc::gen::element(1.0, 2.0, -1.0);
    for (std::size_t i = 0; i < 3; ++i) frame.linear[i][j] *= factor;
    frame.shift[j] = *rc::gen::inRange(-500, 500) / 8.0;
  }
  const auto transform = transform_of(frame);
  RC_ASSERT(transform.has_value());
  const Axes point{1.5, -2.5, 3.5};
  expect_near(transform->to_work(point), applied(frame, point));
  expect_near(transform->to_programmed(applied(frame, point)), point);
}

TEST(frames, in_space_are_no_transform) {
  Frame frame;
  frame.linear = rotation_rpy(30, 0, 40);
  EXPECT_FALSE(transform_of(frame));
  frame.linear = rotation_about(2, 30);
  for (std::size_t j = 0; j < 3; ++j) frame.linear[0][j] *= 2;  // unequal factors after a rotation shear
  EXPECT_FALSE(transform_of(frame));
}

}  // namespace
}  // namespace kadr::sinumerik_frame_test
