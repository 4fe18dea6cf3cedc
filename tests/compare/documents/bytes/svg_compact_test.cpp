#include "compare/documents/bytes/svg_compact.hpp"

#include <gtest/gtest.h>

#include <string>

namespace {

using validate::compact_svg;

std::string plot(int number, const std::string& colour, const std::string& points) {
  return "\t<g id=\"gnuplot_plot_" + std::to_string(number) + "a\" ><title>gnuplot_plot</title>\n" +
         "<g fill=\"none\">\n</g>\n<g fill=\"none\">\n\t<g stroke='none'>\n\t\t<polygon fill = '" + colour +
         "' points = '" + points + " '/>\n\t</g>\n</g>\n\t</g>\n";
}

const std::string triangle = "94.39,471.68 88.25,477.82 94.39,477.82 94.39,471.68";

TEST(CompactSvg, TrianglesOfOneColourBecomeOnePath) {
  const std::string svg = compact_svg("<svg>\n" + plot(1, "red", triangle) + plot(2, "blue", triangle) +
                                      plot(3, "red", "0,0 10,0 0,10 0,0") + "</svg>\n");
  EXPECT_EQ(svg,
            "<svg>\n<g fill=\"none\">\n\t<g stroke='none'>\n"
            "<path fill='blue' d='M94.4,471.7l-6.1,6.1 6.1,0z'/>\n"
            "<path fill='red' d='M94.4,471.7l-6.1,6.1 6.1,0zM0,0l10,0 -10,10z'/>\n\t</g>\n</g>\n</svg>\n");
}

/// Rounding does not add up: the corners of a long strip of triangles come back where they were, to 0.05.
TEST(CompactSvg, CornersStayWithinATwentiethOfAPixel) {
  const std::string svg = compact_svg(plot(1, "red", "0.04,0.04 1.08,0.04 1.08,1.12"));
  EXPECT_NE(svg.find("d='M0,0l1.1,0 0,1.1z'"), std::string::npos) << svg;
}

TEST(CompactSvg, StrokesShareTheirGroupAndTextStays) {
  const auto stroke = [](int n) {
    return "\t<g id=\"gnuplot_plot_" + std::to_string(n) +
           "a\" ><title>t</title>\n<g stroke-width=\"1\">\n\t<path d='M" + std::to_string(n) + ",0'/></g>\n\t</g>\n";
  };
  EXPECT_EQ(compact_svg(stroke(1) + stroke(2) + "<text>x</text>\n"),
            "<g stroke-width=\"1\">\n\t<path d='M1,0'/>\n\t<path d='M2,0'/>\n</g>\n<text>x</text>\n");
}

TEST(CompactSvg, GroupsAlikeBecomeOne) {
  const std::string a = "<g fill=\"none\">\n", b = "<g fill=\"red\">\n", p = "<path d='M0,0'/>\n", end = "</g>\n";
  EXPECT_EQ(compact_svg(a + p + end + a + end + a + p + end + b + p + end), a + p + p + end + b + p + end);
}

TEST(CompactSvg, EmptyGroupsAndPolygonsWithoutAreaGo) {
  EXPECT_EQ(compact_svg("<g fill=\"none\">\n</g>\n<text>x</text>\n"), "<text>x</text>\n");
  const std::string svg = compact_svg(plot(1, "red", "5,5 5.01,5 5,5.01"));
  EXPECT_EQ(svg.find('M'), std::string::npos) << svg;
}

}  // namespace
