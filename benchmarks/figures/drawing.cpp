// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <array>

#include "figures/formatted.h"
#include "figures/scale_bar.h"
#include "figures/view.h"

namespace vdamf
{
namespace
{
constexpr double kTile = 300.0;      // pixels
constexpr double kTileScale = 34.0;  // pixels a metre
constexpr double kEndStrip = 0.75;   // m, Table 1
constexpr double kSideStrip = 0.5;   // m
constexpr double kMagnified = 10.0;  // of ellipse and sector
constexpr double kLongest = 2.2;     // m, of an axis of the ellipse as drawn

Eigen::Vector2d tilePixel(const Eigen::Vector2d& at)
{
    return {0.5 * kTile + kTileScale * at.x(), 0.5 * kTile + 8.0 - kTileScale * at.y()};
}

std::string polygon(const std::vector<Eigen::Vector2d>& points, const std::string& style)
{
    std::string svg = "<polygon points=\"";
    for (const Eigen::Vector2d& p : points)
        svg += formatted("%.1f,%.1f ", tilePixel(p).x(), tilePixel(p).y());
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
        tilePixel(box.centre() + 6.0 * (view.sensor - box.centre()).normalized());
    svg +=
        formatted("<path d=\"M%.1f %.1fL%.1f %.1f\" stroke=\"black\" stroke-dasharray=\"5 4\"/>\n",
                  tilePixel(box.centre()).x(), tilePixel(box.centre()).y(), to.x(), to.y());
    for (const Eigen::Vector3d& hit : view.hits)
        svg += formatted("<circle cx=\"%.1f\" cy=\"%.1f\" r=\"1.3\" fill=\"#036\"/>",
                         tilePixel(hit.head<2>()).x(), tilePixel(hit.head<2>()).y());
    return svg + "\n<text x=\"6\" y=\"16\">" + view.caption + "</text>\n";
}

std::string captionAt(double x, double y, const std::string& words)
{
    return formatted("<text x=\"%.0f\" y=\"%.0f\">", x, y) + words + "</text>\n";
}

std::string framed(double width, double height, const std::string& content)
{
    return formatted(
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
        svg += formatted("<svg x=\"%.0f\" y=\"%.0f\" width=\"300\" height=\"300\">\n",
                         kTile * (at % columns), kTile * (at / columns)) +
               viewSvg(views[i]) + "</svg>\n";
    }
    const int rows = (static_cast<int>(views.size()) + columns - 1) / columns;
    const double below = kTile * rows;
    svg += captionAt(6.0, below + 20.0,
                     "blue dots: hits; red: box of the fit, with its seen edges filled; dashed "
                     "blue: surround; dashed black: line of sight") +
           captionAt(6.0, below + 40.0,
                     "green: ten standard deviations of the centre (ellipse, cut at 2.2 m) and of "
                     "the heading (sector)") +
           scaleBar(kTile * columns - 20.0, below + 36.0, kTileScale, 2.0);
    return framed(kTile * columns, below + 50.0, svg);
}

std::string obliqueSvg(const FigureView& view)
{
    // Seen from the sensor's side: depth runs up and to the right.
    constexpr double kLarge = 80.0;   // pixels a metre
    constexpr double kMargin = 24.0;  // pixels
    const double towards = std::atan2(view.sensor.y(), view.sensor.x());
    const auto project = [&](const Eigen::Vector2d& at, double z)
    {
        const Eigen::Vector2d seen = rotation(-towards + 0.6) * at;
        return Eigen::Vector2d(kLarge * (seen.y() - 0.25 * seen.x()),
                               kLarge * (0.37 * seen.x() - z));
    };
    double top = 0.0;
    std::vector<Eigen::Vector2d> dots;
    for (const Eigen::Vector3d& hit : view.hits)
    {
        dots.push_back(project(hit.head<2>(), hit.z()));
        top = std::max(top, hit.z());
    }
    std::vector<std::array<Eigen::Vector2d, 2>> lines;
    const auto ring = corners(view.measured.box);
    for (std::size_t k = 0; k < ring.size(); ++k)
    {
        const Eigen::Vector2d& next = ring[(k + 1) % ring.size()];
        lines.push_back({project(ring[k], 0.0), project(next, 0.0)});
        lines.push_back({project(ring[k], top), project(next, top)});
        lines.push_back({project(ring[k], 0.0), project(ring[k], top)});
    }
    Eigen::AlignedBox2d all;
    for (const Eigen::Vector2d& dot : dots) all.extend(dot);
    for (const auto& line : lines) all.extend(line[0]).extend(line[1]);
    const Eigen::Vector2d shift = Eigen::Vector2d::Constant(kMargin) - all.min();
    std::string svg = formatted("<g transform=\"translate(%.1f,%.1f)\">\n", shift.x(), shift.y());
    for (const auto& line : lines)
        svg += formatted("<path stroke=\"#d11\" d=\"M%.1f %.1fL%.1f %.1f\"/>\n", line[0].x(),
                         line[0].y(), line[1].x(), line[1].y());
    for (const Eigen::Vector2d& dot : dots)
        svg += formatted("<circle cx=\"%.1f\" cy=\"%.1f\" r=\"1.6\" fill=\"#036\"/>", dot.x(),
                         dot.y());
    const Eigen::Vector2d size = all.sizes() + Eigen::Vector2d::Constant(2.0 * kMargin);
    return framed(size.x(), size.y() + kMargin,
                  svg + "</g>\n" +
                      captionAt(kMargin, size.y() + 6.0, "hits (blue) and box of the fit (red)"));
}

}  // namespace vdamf
