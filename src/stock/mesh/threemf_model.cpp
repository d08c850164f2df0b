// Converts the XML elements of a 3MF model into objects. Used by stock/mesh/threemf_read.

#include "stock/mesh/threemf_model.h"

#include <charconv>
#include <cmath>

#include "stock/mesh/mesh_word_reader.h"
#include "stock/mesh/xml_scan.h"
#include "texts/threemf.h"

namespace kadr {
namespace {

using Failed = tl::unexpected<std::string>;

// Greatest number of objects in a model; also the greatest number of components and build items together, which are references to objects.
constexpr std::size_t max_objects = 100'000;

struct Unit {
  std::string_view name;
  double mm;
};
constexpr Unit units[] = {{"micron", 0.001}, {"millimeter", 1}, {"centimeter", 10}, {"inch", 25.4}, {"foot", 304.8}, {"meter", 1000}};

class ModelReader {
 public:
  ModelReader(std::string_view text, std::size_t max_triangles) : scan_(text), most_triangles_(max_triangles) {}
  tl::expected<Model, std::string> read();

 private:
  bool take(std::string_view name);
  bool take_root();
  bool take_object();
  bool take_vertex();
  bool take_triangle();
  bool take_item(std::vector<ModelItem>& items);
  bool in_mesh();
  bool transform(ModelTransform& matrix);
  bool number(std::string_view name, double& value);
  bool count(std::string_view name, std::uint32_t& value);
  bool wrong(const std::string& why);
  bool wrong_attribute(std::string_view name);

  XmlScan scan_;
  std::size_t most_triangles_, triangles_ = 0, items_ = 0;
  std::string prefix_;  // prefix of the core namespace in element names, as the root element has it
  Model model_;
  ModelObject* object_ = nullptr;
  std::string fault_;
};

bool ModelReader::wrong(const std::string& why) {
  fault_ = scan_.location_here() + why;
  return false;
}

bool ModelReader::wrong_attribute(std::string_view name) {
  const std::string* const text = scan_.attribute(name);
  const std::string element = shown(scan_.name());
  if (text == nullptr) return wrong(translated(texts::threemf::no_attribute, element, name));
  return wrong(translated(texts::threemf::bad_attribute, name, shown(*text), element));
}

bool ModelReader::number(std::string_view name, double& value) {
  const std::string* const text = scan_.attribute(name);
  return (text != nullptr && number_of(*text, value)) || wrong_attribute(name);
}

bool ModelReader::count(std::string_view name, std::uint32_t& value) {
  const std::string* const text = scan_.attribute(name);
  if (text == nullptr) return wrong_attribute(name);
  const auto [end, error] = std::from_chars(text->data(), text->data() + text->size(), value);
  return (error == std::errc() && end == text->data() + text->size() && !text->empty()) || wrong_attribute(name);
}

bool ModelReader::transform(ModelTransform& matrix) {
  const std::string* const text = scan_.attribute("transform");
  if (text == nullptr) return true;
  MeshWordReader words(*text);
  for (double& m : matrix)
    if (!number_of(words.next(), m)) return wrong_attribute("transform");
  return !words.more() || wrong_attribute("transform");
}

/// Reads the prefix and the length unit from the root element. Refuses a file that requires extensions of 3MF; optional extensions are
/// ignored.
bool ModelReader::take_root() {
  const std::string_view root = scan_.name();
  const std::size_t colon = root.find(':');
  prefix_ = colon == std::string_view::npos ? "" : root.substr(0, colon + 1);
  if (root.substr(prefix_.size()) != "model") return wrong(translated(texts::threemf::root_not_model));
  if (const std::string* const needs = scan_.attribute("requiredextensions"); needs != nullptr && MeshWordReader(*needs).more())
    return wrong(translated(texts::threemf::unknown_extension, shown(*needs)));
  const std::string* const name = scan_.attribute("unit");
  if (name == nullptr) return true;
  for (const Unit& unit : units)
    if (unit.name == *name) {
      model_.unit = unit.mm;
      return true;
    }
  return wrong_attribute("unit");
}

bool ModelReader::take_object() {
  std::uint32_t id = 0;
  if (!count("id", id)) return false;
  if (model_.objects.size() >= max_objects) return wrong(translated(texts::threemf::too_many_objects));
  const auto [place, is_new] = model_.objects.try_emplace(id);
  if (!is_new) return wrong(translated(texts::threemf::second_object, id));
  object_ = &place->second;
  const std::string* const type = scan_.attribute("type");
  object_->is_body = type == nullptr || *type == "model" || *type == "solidsupport";
  return true;
}

bool ModelReader::in_mesh() { return object_ != nullptr || wrong(translated(texts::threemf::in_no_object, shown(scan_.name()))); }

bool ModelReader::take_vertex() {
  double x = 0, y = 0, z = 0;
  if (!in_mesh() || !number("x", x) || !number("y", y) || !number("z", z)) return false;
  if (object_->mesh.point_count() >= 3 * most_triangles_) return wrong(translated(texts::threemf::too_many_vertices));
  for (const double v : {x, y, z}) object_->mesh.points.push_back(float(v));
  return true;
}

bool ModelReader::take_triangle() {
  std::uint32_t corner[3];
  if (!in_mesh() || !count("v1", corner[0]) || !count("v2", corner[1]) || !count("v3", corner[2])) return false;
  if (++triangles_ > most_triangles_) return wrong(translated(texts::threemf::too_many_triangles, most_triangles_));
  for (const std::uint32_t c : corner) {
    if (c >= object_->mesh.point_count()) return wrong(translated(texts::threemf::no_vertex, c));
    object_->mesh.triangles.push_back(c);
  }
  return true;
}

bool ModelReader::take_item(std::vector<ModelItem>& items) {
  if (++items_ > max_objects) return wrong(translated(texts::threemf::too_many_parts));
  ModelItem item;
  if (!count("objectid", item.object) || !transform(item.transform)) return false;
  items.push_back(item);
  return true;
}

bool ModelReader::take(std::string_view name) {
  if (name == "object") return take_object();
  if (name == "vertex") return take_vertex();
  if (name == "triangle") return take_triangle();
  if (name == "component") return in_mesh() && take_item(object_->parts);
  if (name == "item") return take_item(model_.build);
  return true;
}

tl::expected<Model, std::string> ModelReader::read() {
  while (true) {
    const XmlScan::Event event = scan_.next();
    if (event == XmlScan::Event::fault) return Failed(scan_.fault());
    if (event == XmlScan::Event::ends) return std::move(model_);
    if (event == XmlScan::Event::opens && scan_.depth() == 1) {
      if (!take_root()) return Failed(fault_);
      continue;
    }
    if (!scan_.name().starts_with(prefix_)) continue;
    const std::string_view name = scan_.name().substr(prefix_.size());
    if (event == XmlScan::Event::closes) {
      if (name == "object") object_ = nullptr;
    } else if (!take(name)) {
      return Failed(fault_);
    }
  }
}

}  // namespace

tl::expected<Model, std::string> read_model(std::string_view text, std::size_t max_triangles) {
  return ModelReader(text, max_triangles).read();
}

}  // namespace kadr
