#pragma once
// The door between the program and kadr-bodies.so, the module that asks FCL how far solid bodies are from each other (modules/bodies.cpp).
// Plain C, so that neither side sees the other's types. mm; a pose is three rows of four: a turn, then a place.

#include <cstddef>
#include <cstdint>

extern "C" {

/// Bodies, each with a number in the order in which they were added.
struct KadrBodies;

struct KadrBodiesDoor {
  int version;  // kadr_bodies_version
  KadrBodies* (*make)();
  void (*drop)(KadrBodies*);
  /// Each about its own middle. What adds a body returns its number; -1: there is not enough memory, or it is no body.
  int (*add_box)(KadrBodies*, double x, double y, double z);
  int (*add_cylinder)(KadrBodies*, double diameter, double height);
  /// The convex body of revolution about Z through circles, upwards: radius and height of each. A radius of 0 is a point; only at the ends.
  int (*add_round)(KadrBodies*, const double* circles, int count);
  /// `points`: x, y, z of each; `triangles`: three points each.
  int (*add_mesh)(KadrBodies*, const float* points, std::size_t point_count, const std::uint32_t* triangles, std::size_t triangle_count);
  /// Between the surfaces of two bodies; below 0: they overlap. NaN: it could not be found.
  ///   nearest  six numbers: the places nearest to each other, on the first, on the second; not of bodies that overlap
  double (*distance)(KadrBodies*, int a, const double* pose_a, int b, const double* pose_b, double* nearest);
  /// By how much one must be moved for the two to part, of bodies without meshes that overlap; 0: not known.
  double (*depth)(KadrBodies*, int a, const double* pose_a, int b, const double* pose_b);
};

/// The one function that the module exports, by this name.
using KadrBodiesEntry = const KadrBodiesDoor* (*)();
}

inline constexpr int kadr_bodies_version = 1;
inline constexpr const char* kadr_bodies_entry = "kadr_bodies_door";
