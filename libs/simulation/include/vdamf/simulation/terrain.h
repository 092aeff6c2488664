// SPDX-License-Identifier: BSD-3-Clause
// The ground: a plane, level or not, with waves and a kerb on either side of a road.
#pragma once

#include <Eigen/Core>
#include <optional>

#include "vdamf/simulation/shapes.h"

namespace vdamf
{
/// Section [terrain]. The default is flat ground at z = 0.
struct TerrainOptions
{
    double slope = 0.0;            ///< rise per way, %
    double slopeDirection = 0.0;   ///< uphill, counter-clockwise from east, rad
    double bumpAmplitude = 0.0;    ///< m
    double bumpWavelength = 20.0;  ///< m
    double kerbHeight = 0.0;       ///< m
    double roadWidth = 8.0;        ///< from kerb to kerb, m
    double roadX = 0.0;            ///< a point on the road's middle, scene frame, m
    double roadY = 0.0;            ///< m
    double roadHeading = 0.0;      ///< rad

    template <class Self, class Visitor>
    static void visit(Self& self, Visitor&& field)
    {
        field(self.slope, "slope_percent", 0.0, 40.0, "rise of the ground");
        field(self.slopeDirection, "slope_direction_deg", -360.0, 360.0,
              "uphill, counter-clockwise from east");
        field(self.bumpAmplitude, "bump_amplitude_m", 0.0, 2.0,
              "waves to the east and to the north, half of it each");
        field(self.bumpWavelength, "bump_wavelength_m", 1.0, 1000.0, "of the waves");
        field(self.kerbHeight, "kerb_height_m", 0.0, 1.0,
              "of the ground beside the road over the road; 0: no kerb");
        field(self.roadWidth, "road_width_m", 1.0, 100.0, "from kerb to kerb");
        field(self.roadX, "road_x_m", -1e5, 1e5, "a point on the road's middle, to the east");
        field(self.roadY, "road_y_m", -1e5, 1e5, "a point on the road's middle, to the north");
        field(self.roadHeading, "road_heading_deg", -360.0, 360.0, "counter-clockwise from east");
    }
};

/// The height of the ground over the plane of the scene:
///
///     z = slope (x cos d + y sin d) + amplitude / 2 (sin kx + sin ky),   k = 2 pi / wavelength
///
/// and higher by the kerb's height beyond half the road's width from the road's middle line.
class Terrain
{
public:
    Terrain() : Terrain(TerrainOptions{}) {}
    explicit Terrain(const TerrainOptions& options);

    /// True where the height is 0 everywhere.
    bool isFlat() const { return isFlat_; }

    double height(const Eigen::Vector2d& place) const;  ///< m

    /// Where a ray from above the ground first meets it, exact to 1e-7 m of height; nothing beyond
    /// `maxRange` or where it starts below the ground.
    std::optional<SurfaceHit> firstHit(const Ray& ray, double maxRange) const;

private:
    struct Stretch;  // of a ray, without a kerb inside

    double smoothHeight(const Eigen::Vector2d& place) const;
    Eigen::Vector2d gradient(const Eigen::Vector2d& place) const;
    double aside(const Eigen::Vector2d& place) const;
    std::optional<SurfaceHit> smoothHit(const Ray& ray, const Stretch& stretch) const;
    std::optional<SurfaceHit> kerbedHit(const Ray& ray, double maxRange) const;

    bool isFlat_ = true;
    Eigen::Vector2d slope_ = Eigen::Vector2d::Zero();
    double waveNumber_ = 0.0;     ///< rad/m
    double halfAmplitude_ = 0.0;  ///< m
    double kerbHeight_ = 0.0;     ///< m
    double halfRoad_ = 0.0;       ///< m
    Eigen::Vector2d roadPoint_ = Eigen::Vector2d::Zero();
    Eigen::Vector2d roadNormal_ = Eigen::Vector2d::UnitY();
};

}  // namespace vdamf
