#pragma once
// Reads the solids that a user describes as text, which are blanks and fixtures. It is used by cli/cut and view/part_run.

#include <memory>
#include <optional>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "base/file_access.h"
#include "config/machine/machine_bodies.h"
#include "stock/blank/blank.h"
#include "stock/turned/turned_stock.h"

namespace kadr {

struct NamedBody {
  std::shared_ptr<const Blank> body;
  std::vector<std::string> notes;  // sentences about repairs of the mesh that the file describes
};

/// Reads the description of a solid: a box (box:X0,Y0,Z0,X1,Y1,Z1), a cylinder (cylinder:X,Y,Z0,Z1,D), a tube
/// about X0 Y0 (cylinder:0,0,Z0,Z1,D,BORE) or the name of a mesh file (which ends in .stl or .3mf). All lengths are in mm.
///   max_bytes  memory limit for reading a file
///   returns    an error sentence if the text or the file is not valid
tl::expected<NamedBody, std::string> body_of(const std::string& text, double max_bytes, const FileAccess* door = nullptr);

/// True if the text ends like the name of a mesh file.
bool names_mesh_file(const std::string& text);

/// Returns the box or cylinder that the text describes; nullopt if the text is not valid or is the name of a file.
std::optional<BodyShape> shape_of_words(const std::string& text);

/// Returns the region of a body of revolution about X0 Y0, by its words: cylinder:0,0,Z0,Z1,D, or with a bore cylinder:0,0,Z0,Z1,D,BORE;
/// nullopt for any other text.
std::optional<TurnedRegion> turned_region_of(const std::string& text);

/// Reads two opposite corners of a window: X0,Y0,Z0,X1,Y1,Z1, mm.
///   returns  an error sentence if the text is not valid
tl::expected<Box3, std::string> window_of(const std::string& text);

}  // namespace kadr
