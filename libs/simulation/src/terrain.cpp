// SPDX-License-Identifier: BSD-3-Clause
// The ground, and where rays meet it.
#include "vdamf/simulation/terrain.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "vdamf/tracking/types/geometry.h"

namespace vdamf
{
namespace
{
constexpr double kOnGround = 1e-7;  ///< m
constexpr int kMaxSteps = 500;

/// Level or not, but without waves and kerbs: z = gradient . (x, y).
std::optional<SurfaceHit> planeHit(const Eigen::Vector2d& gradient, const Ray& ray, double maxRange)
{
    const double above = ray.origin.z() - gradient.dot(ray.origin.head<2>());
    const double sinking = gradient.dot(ray.direction.head<2>()) - ray.direction.z();
    if (above <= 0.0 || sinking <= 0.0 || above > sinking * maxRange) return std::nullopt;
    const double cosIncidence = sinking / std::sqrt(1.0 + gradient.squaredNorm());
    return SurfaceHit{above / sinking, std::min(cosIncidence, 1.0), Material::Asphalt};
}
}  // namespace

/// The ground is smooth from `begin` to `end` along the ray (m), raised by `raised`.
struct Terrain::Stretch
{
    double begin;
    double end;
    double raised;
};

Terrain::Terrain(const TerrainOptions& options)
    : isFlat_(options.slope == 0.0 && options.bumpAmplitude == 0.0 && options.kerbHeight == 0.0),
      slope_(rotation(options.slopeDirection) * Eigen::Vector2d(0.01 * options.slope, 0.0)),
      waveNumber_(2.0 * kPi / options.bumpWavelength),
      halfAmplitude_(0.5 * options.bumpAmplitude),
      kerbHeight_(options.kerbHeight),
      halfRoad_(0.5 * options.roadWidth),
      roadPoint_(options.roadX, options.roadY),
      roadNormal_(rotation(options.roadHeading) * Eigen::Vector2d::UnitY())
{
}

double Terrain::smoothHeight(const Eigen::Vector2d& place) const
{
    double z = slope_.dot(place);
    if (halfAmplitude_ > 0.0)
    {
        z += halfAmplitude_ *
             (std::sin(waveNumber_ * place.x()) + std::sin(waveNumber_ * place.y()));
    }
    return z;
}

Eigen::Vector2d Terrain::gradient(const Eigen::Vector2d& place) const
{
    if (halfAmplitude_ == 0.0) return slope_;
    return slope_ + halfAmplitude_ * waveNumber_ *
                        Eigen::Vector2d(std::cos(waveNumber_ * place.x()),
                                        std::cos(waveNumber_ * place.y()));
}

/// Distance from the road's middle line, positive to the left.
double Terrain::aside(const Eigen::Vector2d& place) const
{
    return roadNormal_.dot(place - roadPoint_);
}

double Terrain::height(const Eigen::Vector2d& place) const
{
    if (isFlat_) return 0.0;
    const bool isBesideRoad = kerbHeight_ > 0.0 && std::abs(aside(place)) > halfRoad_;
    return smoothHeight(place) + (isBesideRoad ? kerbHeight_ : 0.0);
}

std::optional<SurfaceHit> Terrain::firstHit(const Ray& ray, double maxRange) const
{
    if (kerbHeight_ > 0.0) return kerbedHit(ray, maxRange);
    if (halfAmplitude_ > 0.0) return smoothHit(ray, {0.0, maxRange, 0.0});
    return planeHit(slope_, ray, maxRange);
}

/// Steps that the ground's curvature cannot outrun. Along the ray, the height f above the ground
/// has f'' >= -m, so that f is positive up to the root of f + f' s - m s^2 / 2; near a hit these
/// are Newton's steps.
std::optional<SurfaceHit> Terrain::smoothHit(const Ray& ray, const Stretch& stretch) const
{
    const Eigen::Vector2d direction = ray.direction.head<2>();
    const double m = halfAmplitude_ * waveNumber_ * waveNumber_ * direction.squaredNorm() + 1e-12;
    double range = stretch.begin;
    for (int step = 0; step < kMaxSteps && range <= stretch.end; ++step)
    {
        const Eigen::Vector2d place = ray.origin.head<2>() + range * direction;
        const double above =
            ray.origin.z() + range * ray.direction.z() - smoothHeight(place) - stretch.raised;
        if (step == 0 && above < -kOnGround) return std::nullopt;
        const Eigen::Vector2d rise = gradient(place);
        const double growth = ray.direction.z() - rise.dot(direction);
        if (above < kOnGround && growth < 0.0)
        {
            const double cosIncidence = -growth / std::sqrt(1.0 + rise.squaredNorm());
            return SurfaceHit{range, std::min(cosIncidence, 1.0), Material::Asphalt};
        }
        const double height = std::max(above, 0.0);
        range += growth < 0.0
                     ? 2.0 * height / (std::sqrt(growth * growth + 2.0 * m * height) - growth)
                     : (growth + std::sqrt(growth * growth + 2.0 * m * height)) / m;
        range += kOnGround;  // off a point that the ray only touches
    }
    return std::nullopt;
}

std::optional<SurfaceHit> Terrain::kerbedHit(const Ray& ray, double maxRange) const
{
    const Eigen::Vector2d direction = ray.direction.head<2>();
    const double start = aside(ray.origin.head<2>());
    const double drift = roadNormal_.dot(direction);
    std::array<double, 2> kerbs = {maxRange, maxRange};
    if (drift != 0.0)
    {
        kerbs = {(-halfRoad_ - start) / drift, (halfRoad_ - start) / drift};
        if (kerbs[0] > kerbs[1]) std::swap(kerbs[0], kerbs[1]);
    }
    double begin = 0.0;
    for (const double kerb : {kerbs[0], kerbs[1], maxRange})
    {
        const double end = std::min(kerb, maxRange);
        if (end <= begin) continue;
        const bool isBesideRoad = std::abs(start + 0.5 * (begin + end) * drift) > halfRoad_;
        const double raised = isBesideRoad ? kerbHeight_ : 0.0;
        if (const auto hit = smoothHit(ray, {begin, end, raised})) return hit;
        if (kerb >= maxRange) return std::nullopt;
        // At a kerb from the road's side: its face.
        const Eigen::Vector3d point = ray.origin + end * ray.direction;
        const bool isBelowKerb = point.z() < smoothHeight(point.head<2>()) + kerbHeight_;
        if (!isBesideRoad && isBelowKerb)
        {
            return SurfaceHit{end, std::min(std::abs(drift), 1.0), Material::Concrete};
        }
        begin = end;
    }
    return std::nullopt;
}

}  // namespace vdamf
