// SPDX-License-Identifier: BSD-3-Clause
// The grid of the discriminator, layer by layer.
#include <algorithm>
#include <cmath>
#include <functional>
#include <iomanip>
#include <sstream>

#include "vdamf/report/discriminator_plots.h"

namespace vdamf
{
namespace
{
constexpr double kScale = 26.0;  // of a metre
constexpr double kGap = 34.0;    // between layers, with their captions
constexpr double kHead = 64.0;
constexpr int kColumns = 4;

struct Colour
{
    int red, green, blue;
};

int channel(double share)
{
    return static_cast<int>(std::lround(255.0 * std::clamp(share, 0.0, 1.0)));
}

/// White at 0, blue at 1, red at -1.
Colour signedColour(double value)
{
    const double pale = 1.0 - std::min(1.0, std::abs(value));
    if (value > 0.0)
        return {channel(0.13 + 0.87 * pale), channel(0.4 + 0.6 * pale),
                channel(0.67 + 0.33 * pale)};
    return {channel(0.7 + 0.3 * pale), channel(0.09 + 0.91 * pale), channel(0.17 + 0.83 * pale)};
}

Colour greyColour(double value)
{
    const int pale = channel(1.0 - 0.85 * value);
    return {pale, pale, pale};
}

void drawRectangle(std::ostream& out, double x, double y, double w, double h, const Colour& c)
{
    out << "<rect x=\"" << x << "\" y=\"" << y << "\" width=\"" << w << "\" height=\"" << h
        << "\" fill=\"rgb(" << c.red << ',' << c.green << ',' << c.blue << ")\"/>\n";
}

void drawText(std::ostream& out, double x, double y, int size, const std::string& text)
{
    out << "<text x=\"" << x << "\" y=\"" << y << "\" font-size=\"" << size << "\">" << text
        << "</text>\n";
}

/// One layer with its lower left corner at (left, bottom): x to the right, y upwards.
void drawLayer(std::ostream& out, const DiscriminationGrid& grid, int k, double left, double bottom,
               const std::function<Colour(std::size_t)>& colour)
{
    const double dx = kScale * grid.x.cellSize();
    const double dy = kScale * grid.y.cellSize();
    for (int j = 0; j < grid.y.cells; ++j)
        for (int i = 0; i < grid.x.cells; ++i)
            drawRectangle(out, left + i * dx, bottom - (j + 1) * dy, dx, dy,
                          colour(grid.index(i, j, k)));
    const double width = dx * grid.x.cells;
    const double height = dy * grid.y.cells;
    out << "<rect x=\"" << left << "\" y=\"" << bottom - height << "\" width=\"" << width
        << "\" height=\"" << height << "\" fill=\"none\" stroke=\"#888\"/>\n";
    // The two near faces, from the closest corner on.
    const double x0 = left - kScale * grid.x.min;
    const double y0 = bottom + kScale * grid.y.min;
    out << "<path d=\"M" << left + width << ' ' << y0 << " H" << x0 << " V" << bottom - height
        << "\" fill=\"none\" stroke=\"#000\" stroke-dasharray=\"4 3\"/>\n";
    std::ostringstream caption;
    caption << std::setprecision(3) << grid.z.min + k * grid.z.cellSize() << " to "
            << grid.z.min + (k + 1) * grid.z.cellSize() << " m above ground";
    drawText(out, left, bottom + 14.0, 11, caption.str());
}

std::string layersSvg(const DiscriminationGrid& grid, const std::string& title,
                      const std::string& legend, const std::function<Colour(std::size_t)>& colour)
{
    const double w = kScale * (grid.x.max - grid.x.min);
    const double h = kScale * (grid.y.max - grid.y.min);
    const int rows = (grid.z.cells + kColumns - 1) / kColumns;
    const double width = kColumns * (w + kGap) + kGap;
    const double height = rows * (h + kGap) + kHead + kGap;
    std::ostringstream out;
    out << std::fixed << std::setprecision(1);
    out << "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" << width << "\" height=\"" << height
        << "\" font-family=\"sans-serif\">\n<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n";
    drawText(out, kGap, 26.0, 16, title);
    drawText(out, kGap, 46.0, 12, legend);
    for (int k = 0; k < grid.z.cells; ++k)
        drawLayer(out, grid, k, kGap + (k % kColumns) * (w + kGap),
                  kHead + (k / kColumns) * (h + kGap) + h, colour);
    out << "</svg>\n";
    return out.str();
}
}  // namespace

std::string weightsSvg(const DiscriminatorModel& model)
{
    const auto cells = static_cast<std::ptrdiff_t>(model.grid.cells());
    double largest = 0.0;
    for (auto w = model.weights.begin(); w != model.weights.begin() + cells; ++w)
        largest = std::max(largest, std::abs(*w));
    const double scale = largest > 0.0 ? 1.0 / largest : 0.0;
    return layersSvg(model.grid, "Weights of the discriminator in space",
                     "Blue: hits here speak for a vehicle; red: against it. Right along the side, "
                     "up along the end, both from the corner closest to the sensor (dashed).",
                     [&](std::size_t c) { return signedColour(scale * model.weights[c]); });
}

std::string cellsSvg(const DiscriminationGrid& grid, const std::vector<double>& cells,
                     const std::string& title)
{
    double largest = 0.0;
    for (const double c : cells) largest = std::max(largest, c);
    const double scale = largest > 0.0 ? 1.0 / largest : 0.0;
    return layersSvg(grid, title,
                     "Mean square root of each cell's share of the hits: dark where they are.",
                     [&](std::size_t c) { return greyColour(scale * cells[c]); });
}

}  // namespace vdamf
