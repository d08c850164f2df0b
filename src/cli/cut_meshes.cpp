// Writes the surface of a cut part as STL, 3MF or PLY. This file is used by cli/cut.

#include "cli/cut_meshes.h"

#include <fmt/core.h>

#include <cerrno>
#include <cstdio>

#include "config/nearest.h"
#include "config/read_file.h"
#include "out/picture/deviation_colour.h"
#include "stock/mesh/ply.h"
#include "stock/mesh/stl.h"
#include "stock/mesh/threemf.h"
#include "stock/surface/simplified_surface.h"
#include "texts/cut_command.h"

namespace kadr::cli {
namespace {

constexpr double mesh_mb = 1 << 20;      // number of bytes in one megabyte
constexpr double bytes_of_surface = 20;  // number of bytes that a triangle of the surface needs

bool has_ending(const std::string& name, std::string_view ending) { return in_small_letters(name).ends_with(ending); }

/// Simplifies the mesh of the surface and writes it to the file. Prints an error and returns false if the mesh cannot be written, or if
/// simplification needs more memory than --max-memory permits.
bool write_simplified(const CutOptions& options, const Surface& surface, const Cutting& cutting, std::FILE* file, CutResult& result) {
  const std::size_t triangles = surface.triangle_count(), in_window = cutting.window() != nullptr ? cutting.window()->bytes() : 0;
  const double bytes = double(cutting.stock().bytes() + in_window) + double(triangles) * bytes_of_surface + bytes_of_simplifying(triangles);
  if (bytes > options.max_memory * mesh_mb) {
    complain(translated(texts::cut_command::simplifying_too_large, bytes / mesh_mb));
    return false;
  }
  const SimplifiedSurface simple = simplified_surface(surface, {options.simplify, cutting.stock().threads(), options.run.limits.stop});
  result.simplified = {triangles, simple.mesh.triangle_count(), simple.off};
  return write_part(options.out, simple.mesh, file);
}

}  // namespace

ByteSink sink_of(std::FILE* file) {
  return [file](std::string_view bytes) { return std::fwrite(bytes.data(), 1, bytes.size(), file) == bytes.size(); };
}

bool write_part(const std::string& name, const Mesh& mesh, std::FILE* file) {
  const std::string fault = has_ending(name, ".3mf")         ? write_3mf(mesh, sink_of(file))
                            : write_stl(mesh, sink_of(file)) ? std::string()
                                                             : errno_message(errno);
  if (!fault.empty()) complain(name + ": " + fault);
  return fault.empty();
}

bool can_write_meshes(const CutOptions& options) {
  if (options.portion.empty() && !options.out.empty() && options.out != "-" && !has_ending(options.out, ".3mf") &&
      !has_ending(options.out, ".stl")) {
    complain(translated(texts::cut_command::out_is_no_mesh, options.out));
    return false;
  }
  if (!options.deviation.empty() && options.deviation != "-" && !has_ending(options.deviation, ".ply")) {
    complain(translated(texts::cut_command::deviation_is_no_ply, options.deviation));
    return false;
  }
  if (options.simplify > 0 && options.out.empty()) {
    complain(translated(texts::cut_command::simplify_without_out));
    return false;
  }
  return true;
}

bool write_meshes(const CutOptions& options, const Outputs& outputs, const Surface& surface, const PartComparison& held,
                  const Cutting& cutting, CutResult& result) {
  if (std::FILE* const file = outputs.stream("--out"); file != nullptr) {
    const bool written =
        options.simplify > 0 ? write_simplified(options, surface, cutting, file, result) : write_part(options.out, surface, file);
    if (!written) return false;
  }
  std::FILE* const file = outputs.stream("--deviation");
  if (file == nullptr) return true;
  const DeviationScale scale = deviation_scale(held.deviation, result.part->allow);
  const ColourOf colour = [&](float deviation) { return deviation_colour(double(deviation), scale); };
  if (write_ply(surface, held.deviation, colour, sink_of(file))) return true;
  complain(options.deviation + ": " + errno_message(errno));
  return false;
}

}  // namespace kadr::cli
