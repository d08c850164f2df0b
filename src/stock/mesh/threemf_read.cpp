// Finds the model file in the archive, and assembles one mesh from its objects. Used by stock/mesh/mesh_file.

#include <algorithm>
#include <utility>

#include "stock/mesh/mesh_word_reader.h"
#include "stock/mesh/threemf.h"
#include "stock/mesh/threemf_model.h"
#include "stock/mesh/xml_scan.h"
#include "stock/mesh/zip.h"
#include "texts/threemf.h"

namespace kadr {
namespace {

using Failed = tl::unexpected<std::string>;

constexpr std::string_view relationships = "_rels/.rels", usual_model = "3D/3dmodel.model";
constexpr std::string_view model_type = "http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel";
constexpr std::size_t relationship_bytes = 1 << 20;
constexpr int deepest_object = 16;  // greatest depth of nested objects; this limit also stops circular references
constexpr std::size_t max_placed = 100'000;

/// Returns the entry with the given name; nullptr if there is none. Upper and lower case are equal, as OPC 6.2.2.3 requires.
const ZipEntry* entry_of(const std::vector<ZipEntry>& entries, std::string_view name) {
  if (name.starts_with('/')) name.remove_prefix(1);
  const auto found = std::find_if(entries.begin(), entries.end(), [&](const ZipEntry& e) { return equal_ignoring_case(e.name, name); });
  return found == entries.end() ? nullptr : &*found;
}

/// Returns the name of the model's file according to the archive; the usual name if the archive gives no readable name.
std::string model_name(std::string_view archive, const std::vector<ZipEntry>& entries) {
  const ZipEntry* const entry = entry_of(entries, relationships);
  if (entry == nullptr) return std::string(usual_model);
  const auto text = zip_file(archive, *entry, relationship_bytes);
  if (!text) return std::string(usual_model);
  XmlScan scan(*text);
  for (XmlScan::Event event = scan.next(); event == XmlScan::Event::opens || event == XmlScan::Event::closes; event = scan.next()) {
    const std::string *const type = scan.attribute("Type"), *const target = scan.attribute("Target");
    if (event == XmlScan::Event::opens && type != nullptr && target != nullptr && *type == model_type) return *target;
  }
  return std::string(usual_model);
}

/// Returns the transform that applies `inner` first, then `outer`.
ModelTransform after(const ModelTransform& inner, const ModelTransform& outer) {
  ModelTransform all{};
  for (std::size_t row = 0; row < 4; ++row)
    for (std::size_t column = 0; column < 3; ++column) {
      for (std::size_t k = 0; k < 3; ++k) all[3 * row + column] += inner[3 * row + k] * outer[3 * k + column];
      if (row == 3) all[9 + column] += outer[9 + column];
    }
  return all;
}

bool mirrors(const ModelTransform& m) {
  return m[0] * (m[4] * m[8] - m[5] * m[7]) - m[1] * (m[3] * m[8] - m[5] * m[6]) + m[2] * (m[3] * m[7] - m[4] * m[6]) < 0;
}

class Builder {
 public:
  Builder(const Model& model, std::size_t max_triangles) : model_(model), most_triangles_(max_triangles) {}
  std::string put(const ModelItem& item, const ModelTransform& outer, int depth);
  Mesh mesh;

 private:
  void put_mesh(const Mesh& from, const ModelTransform& m);

  const Model& model_;
  std::size_t most_triangles_, placed_ = 0;
};

void Builder::put_mesh(const Mesh& from, const ModelTransform& m) {
  const std::uint32_t base = std::uint32_t(mesh.point_count());
  for (std::size_t i = 0; i < from.point_count(); ++i) {
    const Vec3 p = from.point(i);
    for (std::size_t d = 0; d < 3; ++d)
      mesh.points.push_back(float(model_.unit * (p.x * m[d] + p.y * m[3 + d] + p.z * m[6 + d] + m[9 + d])));
  }
  const bool turned = mirrors(m);
  for (std::size_t t = 0; t < from.triangle_count(); ++t) {
    const std::uint32_t a = from.triangles[3 * t], b = from.triangles[3 * t + 1], c = from.triangles[3 * t + 2];
    for (const std::uint32_t corner : {a, turned ? c : b, turned ? b : c}) mesh.triangles.push_back(base + corner);
  }
}

/// Adds an object and its components to the mesh. A short file may use one object many thousand times, so the size is checked before
/// anything is added.
std::string Builder::put(const ModelItem& item, const ModelTransform& outer, int depth) {
  const auto found = model_.objects.find(item.object);
  if (found == model_.objects.end()) return translated(texts::threemf::no_object, item.object);
  if (depth > deepest_object) return translated(texts::threemf::objects_too_deep, item.object);
  const ModelObject& object = found->second;
  if (!object.is_body) return {};
  const bool too_many = ++placed_ > max_placed || object.mesh.triangle_count() > most_triangles_ - mesh.triangle_count() ||
                        object.mesh.point_count() > 3 * most_triangles_ - mesh.point_count();
  if (too_many) return translated(texts::threemf::objects_too_large);
  const ModelTransform here = after(item.transform, outer);
  put_mesh(object.mesh, here);
  for (const ModelItem& part : object.parts)
    if (std::string wrong = put(part, here, depth + 1); !wrong.empty()) return wrong;
  return {};
}

/// Reads the model and builds its mesh. The memory of the model's text is freed as soon as the model is read.
tl::expected<Mesh, std::string> built(std::string_view bytes, const MeshRules& rules) {
  const auto entries = zip_entries(bytes);
  if (!entries) return Failed(entries.error());
  const std::string name = model_name(bytes, *entries);
  const ZipEntry* const entry = entry_of(*entries, name);
  if (entry == nullptr) return Failed(translated(texts::threemf::no_model, shown(name)));
  const std::size_t max_triangles = rules.memory / solid_bytes(1);
  tl::expected<Model, std::string> model;
  {
    const auto text = zip_file(bytes, *entry, rules.memory / 2);
    if (!text) return Failed(text.error());
    model = read_model(*text, max_triangles);
    if (!model) return Failed(shown(name) + ": " + model.error());
  }
  Builder builder(*model, max_triangles);
  for (const ModelItem& item : model->build)
    if (std::string wrong = builder.put(item, as_it_is, 0); !wrong.empty()) return Failed(std::move(wrong));
  return std::move(builder.mesh);
}

}  // namespace

tl::expected<SolidMesh, std::string> read_3mf(std::string_view bytes, const MeshRules& rules) {
  auto mesh = built(bytes, rules);
  if (!mesh) return Failed(std::move(mesh.error()));
  return solid_of(std::move(*mesh), rules);
}

}  // namespace kadr
