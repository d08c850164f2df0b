#pragma once
// Interface between the program and kadr-bodies.so, the module that uses FCL to find the distance between solid bodies
// (modules/bodies.cpp). It is plain C, so neither side depends on the other's types. mm; a pose is three rows of four numbers: a
// rotation matrix, then the position.

#include <cstddef>
#include <cstdint>

extern "C" {

/// A set of bodies. Each has a number, in the order in which they were added.
struct KadrBodies;

struct KadrBodiesDoor {
  int version;  // kadr_bodies_version
  KadrBodies* (*make)();
  void (*drop)(KadrBodies*);
  /// Boxes and cylinders are centred on their origin. The add functions return the body's number; -1 if memory runs out or the input
  /// is no valid body.
  int (*add_box)(KadrBodies*, double x, double y, double z);
  int (*add_cylinder)(KadrBodies*, double diameter, double height);
  /// Adds the convex body of revolution about Z through circles in ascending order, each with radius and height. Radius 0 means a
  /// point and is permitted at the ends only.
  int (*add_round)(KadrBodies*, const double* circles, int count);
  /// `points` holds x, y, z of each point, `triangles` three point numbers per triangle.
  int (*add_mesh)(KadrBodies*, const float* points, std::size_t point_count, const std::uint32_t* triangles, std::size_t triangle_count);
  /// Returns the distance between the surfaces of two bodies; negative if they overlap, NaN if it could not be computed.
  ///   nearest  receives six numbers: the closest points on the first and on the second body; unset for bodies that overlap
  double (*distance)(KadrBodies*, int a, const double* pose_a, int b, const double* pose_b, double* nearest);
  /// Returns the distance by which one of two overlapping bodies must move to separate them; 0 if unknown. Not for meshes.
  double (*depth)(KadrBodies*, int a, const double* pose_a, int b, const double* pose_b);
};

/// Type of the only function that the module exports, under the name kadr_bodies_entry.
using KadrBodiesEntry = const KadrBodiesDoor* (*)();
}

inline constexpr int kadr_bodies_version = 1;
inline constexpr const char* kadr_bodies_entry = "kadr_bodies_door";
