// Prepares the collision check of the machine's solid bodies. This file is used by cli/cut and view/part_run.

#include "session/cutting/body_watch.h"

#include "session/cutting/named_body.h"
#include "stock/mesh/mesh_file.h"
#include "texts/cutting.h"

namespace kadr {
namespace {

// Memory, bytes, that the collision library FCL needs for a triangle of a mesh and for the bounding volumes around the triangle.
constexpr double bytes_per_triangle = 1000;

/// Converts a blank or fixture for the collision check to a box, cylinder or mesh. A tube of an exact cut, which has no Blank, is a full
/// cylinder.
WorkBody work_body(const NamedWork& work) {
  if (work.body != nullptr) return {work.name, shape_of_words(work.text).value_or(BodyShape{}), work.body->mesh()};
  const bool is_tube = !shape_of_words(work.text);
  return {work.name, shape_of_words(is_tube ? work.text.substr(0, work.text.rfind(',')) : work.text).value_or(BodyShape{}), nullptr};
}

/// Reads the mesh files of the machine's bodies. The memory for the collision check of all meshes is limited.
class BodyFiles {
 public:
  BodyFiles(double most, std::vector<std::string>& notes, const FileAccess* door) : left_(most), notes_(notes), door_(door) {}
  /// Subtracts the memory that the mesh needs from the memory that is still available. Returns an error sentence if it does not suffice,
  /// otherwise an empty string.
  std::string take(const std::string& name, const Mesh& mesh) {
    left_ -= bytes_per_triangle * double(mesh.triangle_count());
    return left_ >= 0 ? std::string() : translated(texts::cutting::body_needs_memory, name);
  }
  tl::expected<Mesh, std::string> read(const std::string& path) {
    MeshRules rules;
    rules.memory = std::size_t(left_);
    auto solid = read_mesh_file(path, rules, door_);
    if (!solid) return tl::unexpected(solid.error());
    notes_.insert(notes_.end(), solid->notes.begin(), solid->notes.end());
    if (const std::string fault = take(path, solid->mesh); !fault.empty()) return tl::unexpected(fault);
    return std::move(solid->mesh);
  }

 private:
  double left_;  // memory that is still available, bytes
  std::vector<std::string>& notes_;
  const FileAccess* door_;
};

}  // namespace

std::vector<NamedWork> work_of(const CutJob& cut, const std::string& stock, const std::vector<std::string>& fixtures,
                               const std::vector<std::string>& shown) {
  std::vector<NamedWork> work{{translated(texts::cutting::blank), stock, cut.blank}};
  for (std::size_t i = 0; i < fixtures.size(); ++i)
    work.push_back({translated(texts::cutting::fixture, shown[i]), fixtures[i], i < cut.fixtures.size() ? cut.fixtures[i] : nullptr});
  return work;
}

tl::expected<std::unique_ptr<MachineWatch>, std::string> watch_bodies(const Session& session, const CutJob& cut,
                                                                      const std::vector<NamedWork>& work, double max_bytes,
                                                                      std::vector<std::string>& notes, const FileAccess* door) {
  if (session.machine().bodies.empty()) return nullptr;
  BodyFiles files(max_bytes, notes, door);
  std::vector<WorkBody> bodies;
  for (const NamedWork& one : work) bodies.push_back(work_body(one));
  for (const WorkBody& body : bodies)
    if (const std::string fault = body.mesh != nullptr ? files.take(body.name, *body.mesh) : ""; !fault.empty())
      return tl::unexpected(fault);
  const Control& control = session.control();
  return MachineWatch::of(session.machine(), control.axes(), AxisRoles::of(control.axes(), control.rotary()), cut, bodies,
                          [&](const std::string& path) { return files.read(path); });
}

}  // namespace kadr
