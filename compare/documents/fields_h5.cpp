#include "compare/documents/fields_h5.hpp"

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
}

}  // namespace validate
