#pragma once
// Bodies that a person names: blanks and fixtures. For cli/cut and view/part_run.

#include <memory>
#include <optional>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "base/file_door.h"
#include "config/machine_bodies.h"
#include "stock/blank/blank.h"

namespace kadr {

struct NamedBody {
  std::shared_ptr<const Blank> body;
  std::vector<std::string> notes;  // what of a file had to be repaired
};

/// box:X0,Y0,Z0,X1,Y1,Z1, cylinder:X,Y,Z0,Z1,D or a file .stl or .3mf, in mm.
///   most_bytes  that reading a file may take
///   returns     an error sentence
tl::expected<NamedBody, std::string> body_of(const std::string& text, double most_bytes, const FileDoor* door = nullptr);

/// They name a file, by their ending.
bool names_mesh_file(const std::string& text);

/// The same words as a shape; nothing: they are none, or name a file.
std::optional<BodyShape> shape_of_words(const std::string& text);

/// X0,Y0,Z0,X1,Y1,Z1, mm.
///   returns  an error sentence
tl::expected<Box3, std::string> window_of(const std::string& text);

}  // namespace kadr
