#pragma once
// Writes the surface meshes of kadr cut for the options --out, --simplify and --deviation. This file is used by cli/cut.

#include <cstdio>
#include <string>

#include "cli/job/outputs.h"
#include "cli/options/options.h"
#include "session/cutting/cutting.h"
#include "stock/cut_result.h"
#include "stock/mesh/byte_sink.h"
#include "stock/part/part_compare.h"
#include "stock/surface/surface.h"

namespace kadr::cli {

/// Returns a sink that writes to the open file.
ByteSink sink_of(std::FILE* file);

/// True if the meshes can be written in the formats that the file names select. Prints an error otherwise.
bool can_write_meshes(const CutOptions& options);

/// Writes a mesh as STL or 3MF, by the ending of the file's name. Prints an error and returns false if the file cannot be written.
bool write_part(const std::string& name, const Mesh& mesh, std::FILE* file);

/// Writes the meshes to the open files. If an error occurs, it is printed and the function returns false.
///   surface  surface of the part after the cut; if --window names a window, the surface in the window
///   result   its member `simplified` receives the result of the simplification
bool write_meshes(const CutOptions& options, const Outputs& outputs, const Surface& surface, const PartComparison& held,
                  const Cutting& cutting, CutResult& result);

}  // namespace kadr::cli
