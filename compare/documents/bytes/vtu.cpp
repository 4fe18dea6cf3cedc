#include "compare/documents/bytes/vtu.hpp"

#include <fmt/format.h>

#include <iterator>

#include "compare/base/file.hpp"

namespace validate {
namespace {

using Text = std::back_insert_iterator<std::string>;

template <class Values>
void data_array(Text out, const char* type, const std::string& name, int components, const Values& values) {
  fmt::format_to(out, "<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"ascii\">\n", type, name,
                 components);
  int in_line = 0;
  for (const auto& value : values) fmt::format_to(out, "{}{}", value, ++in_line % 9 == 0 ? '\n' : ' ');
  fmt::format_to(out, "\n</DataArray>\n");
}

void columns(Text out, const char* element, const std::vector<SheetColumn>& list) {
  fmt::format_to(out, "<{}>\n", element);
  for (const SheetColumn& c : list) data_array(out, "Float64", c.key, c.components, c.values);
  fmt::format_to(out, "</{}>\n", element);
}

void totals(Text out, const std::vector<SheetTotal>& list) {
  fmt::format_to(out, "<FieldData>\n");
  for (const SheetTotal& t : list)
    fmt::format_to(out,
                   "<DataArray type=\"Float64\" Name=\"{}\" NumberOfTuples=\"1\" format=\"ascii\">{}</DataArray>\n",
                   t.key, t.value);
  fmt::format_to(out, "</FieldData>\n");
}

std::vector<double> deformed(const SheetPicture& picture) {
  std::vector<double> x = picture.displacement;
  for (int n = 0; n < picture.mesh.node_count(); ++n)
    for (int c : {0, 1}) x[3 * n + c] += picture.mesh.nodes[n][c];
  return x;
}

void cells(Text out, const membrane::Mesh& mesh) {
  std::vector<int> corners, offsets, types(mesh.triangles.size(), 5);  // 5: VTK_TRIANGLE
  for (const auto& triangle : mesh.triangles) {
    corners.insert(corners.end(), triangle.nodes.begin(), triangle.nodes.end());
    offsets.push_back(static_cast<int>(corners.size()));
  }
  fmt::format_to(out, "<Cells>\n");
  data_array(out, "Int32", "connectivity", 1, corners);
  data_array(out, "Int32", "offsets", 1, offsets);
  data_array(out, "UInt8", "types", 1, types);
  fmt::format_to(out, "</Cells>\n");
}

}  // namespace

void write_vtu(const SheetPicture& picture, const std::filesystem::path& file) {
  std::string text;
  const Text out(text);
  fmt::format_to(out,
                 "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"0.1\" "
                 "byte_order=\"LittleEndian\">\n<UnstructuredGrid>\n");
  totals(out, picture.totals);
  fmt::format_to(out, "<Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n", picture.mesh.node_count(),
                 picture.mesh.triangles.size());
  fmt::format_to(out, "<Points>\n");
  data_array(out, "Float64", "position_A", 3, deformed(picture));
  fmt::format_to(out, "</Points>\n");
  cells(out, picture.mesh);
  columns(out, "PointData", picture.nodes);
  columns(out, "CellData", picture.triangles);
  fmt::format_to(out, "</Piece>\n</UnstructuredGrid>\n</VTKFile>\n");
  write_file(file, text);
}

void write_pvd(const std::vector<SheetPicture>& pictures, const std::filesystem::path& folder,
               const std::string& name) {
  std::string text =
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\" "
      "byte_order=\"LittleEndian\">\n<Collection>\n";
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    const std::string file = fmt::format("{}-{}.vtu", name, i);
    write_vtu(pictures[i], folder / file);
    text += fmt::format("<DataSet timestep=\"{}\" part=\"0\" file=\"{}\"/>\n", pictures[i].level, file);
  }
  write_file(folder / (name + ".pvd"), text + "</Collection>\n</VTKFile>\n");
}

}  // namespace validate
