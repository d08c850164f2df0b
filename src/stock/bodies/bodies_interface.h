#pragma once
// Interface between the program and kadr-bodies.so, the module that uses the library FCL to compute the distance between solid bodies
// (modules/bodies.cpp). The interface is plain C, so neither the program nor the module depends on the other's types. Lengths are in mm. A
// pose is a 3 × 4 matrix, row by row: a rotation matrix in the first three columns, the position in the last.

#include <cstddef>
#include <cstdint>

extern "C" {

/// A set of solid bodies. Each body has a number: 0, 1, 2 … in the order of addition.
struct KadrBodies;

struct KadrBodiesInterface {
  int version;  // version of the interface; must equal kadr_bodies_version
  KadrBodies* (*make)();
  void (*drop)(KadrBodies*);
  /// The origin of a box and of a cylinder is its centre. Each add function returns the number of the new body; -1 if memory runs out or
  /// the arguments describe no valid body.
  int (*add_box)(KadrBodies*, double x, double y, double z);
  int (*add_cylinder)(KadrBodies*, double diameter, double height);
  /// Adds a convex body of revolution about Z, given by circles in ascending order: radius and height of each. A circle of radius 0 is a
  /// point, and permitted only as the first or the last one.
  int (*add_round)(KadrBodies*, const double* circles, int count);
  /// Adds a mesh. `points` holds x, y, z of each point; `triangles` holds three point numbers per triangle.
  int (*add_mesh)(KadrBodies*, const float* points, std::size_t point_count, const std::uint32_t* triangles, std::size_t triangle_count);
  /// Returns the distance between the surfaces of two bodies; negative if they overlap, NaN if it could not be computed.
  ///   nearest  receives six numbers: the closest points on the first and on the second body; unchanged if the bodies overlap
  double (*distance)(KadrBodies*, int a, const double* pose_a, int b, const double* pose_b, double* nearest);
  /// Returns the distance by which one of two overlapping bodies must move so that they no longer overlap; 0 if unknown. The bodies must
  /// not be meshes.
  double (*depth)(KadrBodies*, int a, const double* pose_a, int b, const double* pose_b);
};

/// Type of the only function that the module exports; kadr_bodies_entry is its name.
using KadrBodiesEntry = const KadrBodiesInterface* (*)();
}

inline constexpr int kadr_bodies_version = 1;
inline constexpr const char* kadr_bodies_entry = "kadr_bodies_door";
