#include "compare/documents/bytes/fields_h5.hpp"

#include <array>
#include <cstddef>

#include "compare/base/errors.hpp"

namespace validate {
namespace {

void describe_set(h5::Object set, const std::string& unit, const std::string& meaning, int components) {
  set.attribute("unit", unit);
  set.attribute("meaning", meaning);
  set.attribute("components", components);
}

void write_columns(h5::Group& group, const std::vector<SheetColumn>& columns) {
  for (const SheetColumn& c : columns) describe_set(group.data_set(c.key, c.values), c.unit, c.meaning, c.components);
}

/// Shapes as blocks: depth by depth, then node or triangle.
void write_earlier(h5::Group& group, const SheetPicture& picture) {
  std::vector<double> depth, force;
  std::vector<float> displacement, stress, state;
  const auto append = [](std::vector<float>& all, const std::vector<float>& one) {
    all.insert(all.end(), one.begin(), one.end());
  };
  for (const SheetShape& shape : picture.earlier) {
    depth.push_back(shape.depth_A), force.push_back(shape.force_eV_per_A);
    append(displacement, shape.displacement_A);
    append(stress, shape.cauchy_1_eV_per_A3);
    append(state, shape.state);
  }
  const std::size_t levels = depth.size(), nodes = picture.mesh.nodes.size(), triangles = picture.mesh.triangles.size();
  describe_set(group.data_set("depth_A", depth), "Å", "depth of record", 1);
  describe_set(group.data_set("force_eV_per_A", force), "eV/Å", "force of the tip on the sheet", 1);
  describe_set(group.data_set("displacement_A", displacement, std::array{levels, nodes, std::size_t{3}}), "Å",
               "displacement from the flat sheet", 3);
  describe_set(group.data_set("cauchy_1_eV_per_A3", stress, std::array{levels, triangles}), "eV/Å³",
               "larger principal Cauchy stress", 1);
  describe_set(group.data_set("state", state, std::array{levels, triangles}), "", "0 taut, 1 wrinkled, 2 slack", 1);
}

}  // namespace

void write_fields(h5::Group& parent, const std::string& name, const SheetPicture& picture) {
  h5::Group group = parent.group(name);
  std::vector<double> nodes;
  for (const auto& X : picture.mesh.nodes) nodes.insert(nodes.end(), {X.x(), X.y(), 0});
  std::vector<int> corners;
  for (const auto& t : picture.mesh.triangles) corners.insert(corners.end(), t.nodes.begin(), t.nodes.end());
  group.attribute("level", picture.level);
  group.attribute("copies", picture.mesh.copies);
  group.attribute("thickness_A", picture.thickness_A);
  for (const SheetTotal& t : picture.totals) group.attribute(t.key, t.value);
  describe_set(group.data_set("nodes_A", nodes), "Å", "nodes of the flat sheet", 3);
  describe_set(group.data_set("triangles", corners), "", "node numbers of each triangle, counter-clockwise", 3);
  h5::Group of_nodes = group.group("at_nodes");
  write_columns(of_nodes, picture.nodes);
  h5::Group of_triangles = group.group("at_triangles");
  write_columns(of_triangles, picture.triangles);
  if (picture.earlier.empty()) return;
  h5::Group earlier = group.group("earlier");
  write_earlier(earlier, picture);
}

namespace {

[[noreturn]] void refuse(const std::string& what) {
  throw Error(ExitCode::file_failed, "run.h5, fields of a sheet: " + what);
}

/// Columns with a whole number of values for each of `count` things.
std::vector<SheetColumn> read_columns(const std::optional<h5::ReadGroup>& group, std::size_t count) {
  std::vector<SheetColumn> columns;
  if (!group) return columns;
  for (const std::string& name : group->data_set_names()) {
    h5::NumberSet set = group->number_set(name);
    if (set.values.size() != count * static_cast<std::size_t>(set.components)) refuse(name + " has another length");
    columns.push_back({name, set.unit, set.meaning, set.components, std::move(set.values)});
  }
  return columns;
}

membrane::Mesh read_mesh(const h5::ReadGroup& group) {
  membrane::Mesh mesh;
  const std::vector<double> nodes = group.column("nodes_A"), corners = group.column("triangles");
  if (nodes.size() % 3 != 0 || corners.size() % 3 != 0) refuse("nodes or triangles are not threes");
  for (std::size_t i = 0; i < nodes.size(); i += 3) mesh.nodes.emplace_back(nodes[i], nodes[i + 1]);
  for (std::size_t i = 0; i < corners.size(); i += 3) {
    membrane::Triangle& triangle = mesh.triangles.emplace_back();
    for (std::size_t k = 0; k < 3; ++k) {
      if (!(corners[i + k] >= 0 && corners[i + k] < static_cast<double>(mesh.nodes.size())))
        refuse("a triangle has no such node");
      triangle.nodes[k] = static_cast<int>(corners[i + k]);
    }
  }
  const double copies = group.has_attribute("copies") ? group.number("copies") : 1;
  if (copies != 1 && copies != 2 && copies != 4) refuse("a sheet of so many copies");
  mesh.copies = static_cast<int>(copies);
  return mesh;
}

/// Shapes of the picture's mesh, of which each block has a row a depth.
std::vector<SheetShape> read_earlier(const h5::ReadGroup& group, const SheetPicture& picture) {
  const std::vector<double> depth = group.column("depth_A"), force = group.column("force_eV_per_A");
  if (force.size() != depth.size()) refuse("depths and forces of shapes differ in number");
  const auto rows = [&](const char* name, std::size_t width) {
    std::vector<float> values = group.block(name).values;
    if (values.size() != depth.size() * width) refuse(std::string(name) + " of shapes has another length");
    return [values = std::move(values), width](std::size_t i) {
      const auto start = values.begin() + static_cast<std::ptrdiff_t>(i * width);
      return std::vector<float>(start, start + static_cast<std::ptrdiff_t>(width));
    };
  };
  const auto displacement = rows("displacement_A", 3 * picture.mesh.nodes.size());
  const auto stress = rows("cauchy_1_eV_per_A3", picture.mesh.triangles.size());
  const auto state = rows("state", picture.mesh.triangles.size());
  std::vector<SheetShape> shapes;
  for (std::size_t i = 0; i < depth.size(); ++i)
    shapes.push_back({depth[i], force[i], displacement(i), stress(i), state(i)});
  return shapes;
}

}  // namespace

SheetPicture read_fields(const h5::ReadGroup& group) {
  SheetPicture picture;
  picture.mesh = read_mesh(group);
  picture.nodes = read_columns(group.group("at_nodes"), picture.mesh.nodes.size());
  picture.triangles = read_columns(group.group("at_triangles"), picture.mesh.triangles.size());
  for (const SheetColumn& c : picture.nodes)
    if (c.key == "displacement_A") picture.displacement = c.values;
  for (const std::string& name : group.attribute_names()) {
    if (name == "level")
      picture.level = group.number(name);
    else if (name == "thickness_A")
      picture.thickness_A = group.number(name);
    else if (name != "copies")
      picture.totals.push_back({name, {}, {}, group.number(name)});
  }
  if (const auto earlier = group.group("earlier")) picture.earlier = read_earlier(*earlier, picture);
  return picture;
}

}  // namespace validate
