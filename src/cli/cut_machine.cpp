// The bodies of the machine. For cli/cut.

#include "cli/cut_machine.h"

#include <fmt/core.h>

#include "cli/terminal.h"
#include "config/told.h"
#include "stock/mesh/mesh_file.h"

namespace kadr::cli {
namespace {

constexpr double bytes_of_mb = 1 << 20;
constexpr double bytes_per_triangle = 1000;  // of a mesh for FCL: its boxes and spheres

/// Blank or fixture as the watch takes it. A blank knows no more than its mesh, box or cylinder.
WorkBody work_body(const std::string& name, const std::string& text, const std::shared_ptr<const Blank>& body) {
  return {name, shape_of_words(text).value_or(BodyShape{}), body->mesh()};
}

/// Reads the files of the machine's bodies, as long as there is memory for what becomes of them.
class BodyFiles {
 public:
  explicit BodyFiles(double most) : left_(most) {}
  /// Empty: there is; else an error sentence.
  std::string take(const std::string& name, const Mesh& mesh) {
    left_ -= bytes_per_triangle * double(mesh.triangle_count());
    return left_ >= 0 ? std::string()
                      : name + ": " +
                            told("as a body of a moving machine it takes more than --max-memory",
                                 "как тело движущегося станка не помещается в --max-memory");
  }
  tl::expected<Mesh, std::string> read(const std::string& path) {
    MeshRules rules;
    rules.memory = std::size_t(left_);
    auto solid = read_mesh_file(path, rules);
    if (!solid) return tl::unexpected(solid.error());
    for (const std::string& note : solid->notes) say(note + "\n");
    if (const std::string fault = take(path, solid->mesh); !fault.empty()) return tl::unexpected(fault);
    return std::move(solid->mesh);
  }

 private:
  double left_;  // bytes
};

}  // namespace

std::unique_ptr<MachineWatch> watch_of(const CutOptions& options, const Job& job, const Session& session, const CutJob& cut, bool& failed) {
  if (job.profile.bodies.empty()) return nullptr;
  failed = true;
  std::vector<WorkBody> work{work_body(told("blank", "заготовка"), options.stock, cut.blank)};
  for (std::size_t i = 0; i < options.fixtures.size(); ++i)
    work.push_back(work_body(told("fixture ", "приспособление ") + options.fixtures[i], options.fixtures[i], cut.fixtures[i]));
  BodyFiles files(options.max_memory * bytes_of_mb);
  for (const WorkBody& body : work)
    if (const std::string fault = body.mesh != nullptr ? files.take(body.name, *body.mesh) : ""; !fault.empty())
      return complain(fault), nullptr;
  const Control& control = session.control();
  auto watch = MachineWatch::of(job.profile, control.axes(), AxisRoles::of(control.axes(), control.rotary()), cut, work,
                                [&](const std::string& path) { return files.read(path); });
  if (!watch) return complain(watch.error()), nullptr;
  failed = false;
  return std::move(*watch);
}

}  // namespace kadr::cli
