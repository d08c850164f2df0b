// Detects whether an STL file is binary or text, and reads its triangles. Used by stock/mesh/mesh_file.

#include <bit>
#include <cmath>
#include <utility>

#include "config/read_file.h"
#include "stock/mesh/mesh_word_reader.h"
#include "stock/mesh/stl.h"
#include "texts/mesh_file.h"

namespace kadr {
namespace {

using Failed = tl::unexpected<std::string>;
using ReadMesh = tl::expected<Mesh, std::string>;

constexpr std::size_t header_bytes = 84, record_bytes = 50, normal_bytes = 12;

std::uint32_t number_at(std::string_view bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i) value |= std::uint32_t(static_cast<unsigned char>(bytes[at + i])) << (8 * i);
  return value;
}

void add_triangle(Mesh& mesh) {
  const std::uint32_t first = std::uint32_t(mesh.triangles.size());
  for (std::uint32_t i = 0; i < 3; ++i) mesh.triangles.push_back(first + i);
}

ReadMesh read_binary(std::string_view bytes, const MeshRules& rules, std::vector<std::string>& notes) {
  const std::size_t body = bytes.size() - header_bytes, count = body / record_bytes, stated = number_at(bytes, header_bytes - 4);
  if (body % record_bytes != 0) return Failed(translated(texts::mesh_file::ends_within_triangle, count + 1, bytes.size(), stated));
  if (std::string wrong = too_many_message(count, rules); !wrong.empty()) return Failed(std::move(wrong));
  if (stated != count) notes.push_back(translated(texts::mesh_file::other_count_in_header, stated, count));
  Mesh mesh;
  mesh.points.reserve(9 * count), mesh.triangles.reserve(3 * count);
  for (std::size_t t = 0; t < count; ++t) {
    for (std::size_t i = 0; i < 9; ++i)
      mesh.points.push_back(std::bit_cast<float>(number_at(bytes, header_bytes + t * record_bytes + normal_bytes + 4 * i)));
    add_triangle(mesh);
  }
  return mesh;
}

/// Formats a word of the file for a message, in quotation marks. An empty word means that the file has ended; the result is then a phrase
/// for the end of the file.
std::string word_shown(std::string_view word) { return word.empty() ? translated(texts::mesh_file::end_of_file) : "'" + shown(word) + "'"; }

/// Reads text STL. The format is: solid NAME { facet normal x y z outer loop { vertex x y z } x3 endloop endfacet } endsolid NAME, repeated
/// any number of times.
class TextStl {
 public:
  TextStl(std::string_view text, const MeshRules& rules) : words_(text), rules_(rules) {}
  ReadMesh read();

 private:
  bool expect(std::string_view word);
  bool number(float& value);
  bool facet();
  Failed failed() const { return Failed(location_prefix("", words_.line(), words_.column()) + fault_); }

  MeshWordReader words_;
  const MeshRules& rules_;
  Mesh mesh_;
  std::string fault_;
};

bool TextStl::expect(std::string_view word) {
  const std::string_view found = words_.next();
  if (equal_ignoring_case(found, word)) return true;
  fault_ = translated(texts::mesh_file::word_expected, word, word_shown(found));
  return false;
}

bool TextStl::number(float& value) {
  const std::string_view found = words_.next();
  double read = 0;
  if (number_of(found, read) && std::isfinite(float(read))) {
    value = float(read);
    return true;
  }
  fault_ = translated(texts::mesh_file::coordinate_expected, shown(found));
  return false;
}

/// Reads a facet after the word "facet". The normal in the file is skipped, because some programs write "nan" as the normal of a triangle
/// without area.
bool TextStl::facet() {
  if (!expect("normal")) return false;
  for (int i = 0; i < 3; ++i) (void)words_.next();
  if (!expect("outer") || !expect("loop")) return false;
  for (int i = 0; i < 3; ++i) {
    if (!expect("vertex")) return false;
    for (int d = 0; d < 3; ++d) {
      float value = 0;
      if (!number(value)) return false;
      mesh_.points.push_back(value);
    }
  }
  add_triangle(mesh_);
  fault_ = too_many_message(mesh_.triangle_count(), rules_);
  return fault_.empty() && expect("endloop") && expect("endfacet");
}

ReadMesh TextStl::read() {
  while (words_.more()) {
    if (!expect("solid")) return failed();
    words_.rest_of_line();
    while (true) {
      const std::string_view word = words_.next();
      if (equal_ignoring_case(word, "endsolid")) break;
      if (!equal_ignoring_case(word, "facet")) {
        fault_ = translated(texts::mesh_file::facet_expected, word_shown(word));
        return failed();
      }
      if (!facet()) return failed();
    }
    words_.rest_of_line();
  }
  return std::move(mesh_);
}

/// Returns true if the file is binary. The length and the content decide, because a binary file too may begin with "solid".
bool is_binary(std::string_view bytes) {
  if (bytes.size() < header_bytes) return false;
  if (bytes.size() == header_bytes + record_bytes * std::size_t(number_at(bytes, header_bytes - 4))) return true;
  return !equal_ignoring_case(bytes.substr(0, 5), "solid") || bytes.find('\0') != std::string_view::npos;
}

}  // namespace

tl::expected<SolidMesh, std::string> read_stl(std::string_view bytes, const MeshRules& rules) {
  std::vector<std::string> notes;
  if (!is_binary(bytes) && !equal_ignoring_case(MeshWordReader(bytes).next(), "solid"))
    return Failed(translated(texts::mesh_file::not_stl));
  ReadMesh mesh = is_binary(bytes) ? read_binary(bytes, rules, notes) : TextStl(bytes, rules).read();
  if (!mesh) return Failed(std::move(mesh.error()));
  auto solid = solid_of(std::move(*mesh), rules);
  if (solid) solid->notes.insert(solid->notes.begin(), notes.begin(), notes.end());
  return solid;
}

}  // namespace kadr
