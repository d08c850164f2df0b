// Writes a 3MF model with one object, for the export of the cut part. Used by cli/cut_meshes.

#include <charconv>

#include "stock/mesh/threemf.h"
#include "stock/mesh/zip.h"

namespace kadr {
namespace {

constexpr std::size_t bytes_at_once = 1 << 16;

constexpr std::string_view content_types =
    R"(<?xml version="1.0" encoding="UTF-8"?>
<Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types">
 <Default Extension="rels" ContentType="application/vnd.openxmlformats-package.relationships+xml"/>
 <Default Extension="model" ContentType="application/vnd.ms-package.3dmanufacturing-3dmodel+xml"/>
</Types>
)";

constexpr std::string_view written_relationships =
    R"(<?xml version="1.0" encoding="UTF-8"?>
<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships">
 <Relationship Target="/3D/3dmodel.model" Id="rel0" Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/>
</Relationships>
)";

constexpr std::string_view model_begins =
    R"(<?xml version="1.0" encoding="UTF-8"?>
<model unit="millimeter" xml:lang="en-US" xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02">
 <metadata name="Application">Kadr</metadata>
 <resources>
  <object id="1" type="model">
   <mesh>
    <vertices>
)";

constexpr std::string_view model_ends = R"(    </triangles>
   </mesh>
  </object>
 </resources>
 <build>
  <item objectid="1"/>
 </build>
</model>
)";

/// Appends an attribute. The number has the fewest digits from which a reader gets exactly the same value.
template <class Number>
void put_attribute(std::string& out, std::string_view name, Number value) {
  char text[32];
  const auto end = std::to_chars(text, text + sizeof text, value).ptr;
  out.append(name).append("=\"").append(text, end).push_back('"');
}

bool put_model(const Mesh& mesh, const ByteSink& sink) {
  std::string out(model_begins);
  const auto pass_on = [&](std::size_t least) {
    if (out.size() < least) return true;
    const bool taken = sink(out);
    out.clear();
    return taken;
  };
  for (std::size_t i = 0; i < mesh.point_count(); ++i) {
    out += "<vertex";
    put_attribute(out, " x", mesh.points[3 * i]);
    put_attribute(out, " y", mesh.points[3 * i + 1]);
    put_attribute(out, " z", mesh.points[3 * i + 2]);
    out += "/>\n";
    if (!pass_on(bytes_at_once)) return false;
  }
  out += "    </vertices>\n    <triangles>\n";
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    out += "<triangle";
    put_attribute(out, " v1", mesh.triangles[3 * t]);
    put_attribute(out, " v2", mesh.triangles[3 * t + 1]);
    put_attribute(out, " v3", mesh.triangles[3 * t + 2]);
    out += "/>\n";
    if (!pass_on(bytes_at_once)) return false;
  }
  out += model_ends;
  return pass_on(1);
}

}  // namespace

std::string write_3mf(const Mesh& mesh, const ByteSink& sink) {
  ZipWriter zip(sink);
  if (std::string wrong = zip.add("[Content_Types].xml", [](const ByteSink& to) { return to(content_types); }); !wrong.empty())
    return wrong;
  if (std::string wrong = zip.add("_rels/.rels", [](const ByteSink& to) { return to(written_relationships); }); !wrong.empty())
    return wrong;
  if (std::string wrong = zip.add("3D/3dmodel.model", [&](const ByteSink& to) { return put_model(mesh, to); }); !wrong.empty())
    return wrong;
  return zip.finish();
}

}  // namespace kadr
