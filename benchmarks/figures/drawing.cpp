// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cstdio>

#include "figures/view.h"

namespace vdamf
{
namespace
{
constexpr double kTile = 300.0;      // pixels
constexpr double kScale = 34.0;      // pixels a metre
constexpr double kEndStrip = 0.75;   // m, Table 1
constexpr double kSideStrip = 0.5;   // m
constexpr double kMagnified = 10.0;  // of ellipse and sector
constexpr double kLongest = 2.2;     // m, of an axis of the ellipse as drawn

std::string text(const char* pattern, double a, double b = 0.0, double c = 0.0, double d = 0.0)
{
    std::array<char, 256> buffer{};
    std::snprintf(buffer.data(), buffer.size(), pattern, a, b, c, d);
    return buffer.data();
}

Eigen::Vector2d pixel(const Eigen::Vector2d& at)
{
    return {0.5 * kTile + kScale * at.x(), 0.5 * kTile + 8.0 - kScale * at.y()};
}

std::string polygon(const std::vector<Eigen::Vector2d>& points, const std::string& style)
{
    std::string svg = "<polygon points=\"";
    for (const Eigen::Vector2d& p : points) svg += text("%.1f,%.1f ", pixel(p).x(), pixel(p).y());
    return svg + "\" " + style + "/>\n";
}

/// A rectangle of the box's frame: from (x0, y0) to (x1, y1), in the coordinates of the view.
std::vector<Eigen::Vector2d> part(const OrientedBox& box, double x0, double y0, double x1,
                                  double y1)
{
    std::vector<Eigen::Vector2d> points;
    for (const Eigen::Vector2d& p : {Eigen::Vector2d(x0, y0), Eigen::Vector2d(x1, y0),
                                     Eigen::Vector2d(x1, y1), Eigen::Vector2d(x0, y1)})
        points.push_back(box.centre() + rotation(box.heading) * p);
    return points;
}

std::string seenEdges(const Measurement& m)
{
    const double l = 0.5 * m.box.length;
    const double w = 0.5 * m.box.width;
    const double end = std::min(kEndStrip, l);
    const double side = std::min(kSideStrip, w);
    const std::string style = "fill=\"#d33\" fill-opacity=\"0.15\"";
    std::string svg;
    if (m.facesSeen.has(Face::Front)) svg += polygon(part(m.box, l - end, -w, l, w), style);
    if (m.facesSeen.has(Face::Back)) svg += polygon(part(m.box, -l, -w, end - l, w), style);
    if (m.facesSeen.has(Face::Left)) svg += polygon(part(m.box, -l, w - side, l, w), style);
    if (m.facesSeen.has(Face::Right)) svg += polygon(part(m.box, -l, -w, l, side - w), style);
    return svg;
}

std::string uncertainty(const Measurement& m)
{
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(m.covariance.topLeftCorner<2, 2>());
    const Eigen::Vector2d sigma =
        kMagnified * axes.eigenvalues().cwiseMax(0.0).cwiseSqrt().cwiseMin(kLongest / kMagnified);
    const double turn = std::min(kPi / 2.0, kMagnified * std::sqrt(m.covariance(2, 2)));
    std::vector<Eigen::Vector2d> ellipse;
    std::vector<Eigen::Vector2d> sector = {m.box.centre()};
    for (int k = 0; k < 36; ++k)
    {
        const double a = 2.0 * kPi * k / 36.0;
        ellipse.push_back(m.box.centre() +
                          axes.eigenvectors() *
                              Eigen::Vector2d(sigma.x() * std::cos(a), sigma.y() * std::sin(a)));
    }
    for (int k = -8; k <= 8; ++k)
        sector.push_back(m.box.centre() + rotation(m.box.heading + turn * k / 8.0) *
                                              Eigen::Vector2d(0.5 * m.box.length, 0.0));
    return polygon(sector, "fill=\"#2a2\" fill-opacity=\"0.25\" stroke=\"#171\"") +
           polygon(ellipse, "fill=\"none\" stroke=\"#171\" stroke-width=\"1.5\"");
}

std::string viewSvg(const FigureView& view)
{
    std::string svg = "<rect width=\"298\" height=\"298\" fill=\"white\" stroke=\"#ccc\"/>\n";
    const OrientedBox& box = view.measured.box;
    if (view.measured.hits > 0)
    {
        const double l = 0.5 * box.length;
        const double w = 0.5 * box.width;
        svg +=
            seenEdges(view.measured) +
            polygon(part(box, -l - kEndStrip, -w - kSideStrip, l + kEndStrip, w + kSideStrip),
                    "fill=\"none\" stroke=\"#36c\" stroke-dasharray=\"6 4\"") +
            polygon(part(box, -l, -w, l, w), "fill=\"none\" stroke=\"#d11\" stroke-width=\"2\"") +
            uncertainty(view.measured);
    }
    const Eigen::Vector2d to =
        pixel(box.centre() + 6.0 * (view.sensor - box.centre()).normalized());
    svg += text("<path d=\"M%.1f %.1fL%.1f %.1f\" stroke=\"black\" stroke-dasharray=\"5 4\"/>\n",
                pixel(box.centre()).x(), pixel(box.centre()).y(), to.x(), to.y());
    for (const Eigen::Vector3d& hit : view.hits)
        svg += text("<circle cx=\"%.1f\" cy=\"%.1f\" r=\"1.3\" fill=\"#036\"/>",
                    pixel(hit.head<2>()).x(), pixel(hit.head<2>()).y());
    return svg + "\n<text x=\"6\" y=\"16\">" + view.caption + "</text>\n";
}

std::string framed(double width, double height, const std::string& content)
{
    return text(
               "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%.0f\" height=\"%.0f\" "
               "font-family=\"sans-serif\" font-size=\"13\">\n",
               width, height) +
           "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n" + content + "</svg>\n";
}
}  // namespace

std::string viewsSvg(const std::vector<FigureView>& views, int columns)
{
    std::string svg;
    for (std::size_t i = 0; i < views.size(); ++i)
    {
        const int at = static_cast<int>(i);
        svg += text("<svg x=\"%.0f\" y=\"%.0f\" width=\"300\" height=\"300\">\n",
                    kTile * (at % columns), kTile * (at / columns)) +
               viewSvg(views[i]) + "</svg>\n";
    }
    const int rows = (static_cast<int>(views.size()) + columns - 1) / columns;
    return framed(kTile * columns, kTile * rows, svg);
}

std::string obliqueSvg(const FigureView& view)
{
    // Seen from the sensor's side: depth runs up and to the right.
    const double towards = std::atan2(view.sensor.y(), view.sensor.x());
    const auto project = [&](const Eigen::Vector2d& at, double z)
    {
        const Eigen::Vector2d seen = rotation(-towards + 0.6) * at;
        return Eigen::Vector2d(300.0 + 70.0 * (seen.y() - 0.25 * seen.x()),
                               230.0 - 70.0 * z + 26.0 * seen.x());
    };
    std::string svg;
    for (const double z : {0.0, 1.6})
    {
        svg += "<polygon fill=\"none\" stroke=\"#d11\" points=\"";
        for (const Eigen::Vector2d& corner : corners(view.measured.box))
            svg += text("%.1f,%.1f ", project(corner, z).x(), project(corner, z).y());
        svg += "\"/>\n";
    }
    for (const Eigen::Vector3d& hit : view.hits)
    {
        const Eigen::Vector2d p = project(hit.head<2>(), hit.z());
        svg += text("<circle cx=\"%.1f\" cy=\"%.1f\" r=\"1.6\" fill=\"#036\"/>", p.x(), p.y());
    }
    return framed(600.0, 340.0, svg + "\n<text x=\"6\" y=\"16\">" + view.caption + "</text>\n");
}

}  // namespace vdamf
