// SPDX-License-Identifier: BSD-3-Clause
#include "tracker/vehicles_among.h"

#include <cmath>
#include <optional>
#include <utility>

#include "tracker/new_sightings.h"
#include "vdamf/tracking/estimation/start_state.h"

namespace vdamf
{
namespace
{
constexpr double kSigma = 0.1;  // m, of the place of a box just measured
// Most pieces are a hedge's; a vehicle among them is measured again, as itself.
constexpr Attention kAttention{{0.0, true}, true};

bool mayBeCar(const Cluster& piece, bool isPlanar, const LifecycleOptions& options)
{
    return piece.size() >= static_cast<std::size_t>(options.minHits) &&
           isHighEnough(piece, isPlanar, options) && heightOf(piece) < kLowestTruck;
}

// `piece`: a frame of it alone.
std::optional<PredictedTarget> vehicleIn(const SegmentedFrame& piece, const Neighbourhood& around,
                                         const Discriminator& discriminator,
                                         const TrackerOptions& options)
{
    HitsAtOneTime seen;
    seen.hits = Lent<Hits>::from(piece.hits.front());
    seen.each = Lent<Cluster>::from(piece.clusters.front());
    const double height = heightOf(piece.clusters.front());
    const OrientedBox start =
        startBox(*seen.hits, piece.sensor, widestEnd(height), options.measurement.fit);
    if (std::hypot(start.length, start.width) > options.lifecycle.maxExtent) return std::nullopt;
    const Measurement m = withLikelierAxes(sightingOf(piece, {0}, seen, start, std::nullopt,
                                                      options.measurement, kAttention),
                                           around, options)
                              .measurement;
    if (discriminator.vehicleProbability(m, piece, {0}) < kSurelyAVehicle) return std::nullopt;
    PredictedTarget vehicle;
    vehicle.box = startState(m, height, piece.sensor, {}, options.visibility, options.motion).box();
    vehicle.positionSigma = {kSigma, kSigma};
    vehicle.isBounded = true;
    return vehicle;
}
}  // namespace

std::vector<PredictedTarget> vehiclesAmong(std::vector<Cluster> pieces, const SegmentedFrame& frame,
                                           const Neighbourhood& around,
                                           const Discriminator& discriminator,
                                           const TrackerOptions& options)
{
    std::vector<PredictedTarget> found;
    SegmentedFrame alone;
    alone.time = frame.time;
    alone.sensor = frame.sensor;
    alone.sensorZ = frame.sensorZ;
    alone.points = frame.points;
    alone.planar = frame.planar;
    alone.profile = frame.profile;
    for (Cluster& piece : pieces)
    {
        if (!mayBeCar(piece, frame.planar, options.lifecycle)) continue;
        alone.hits = {projected(piece, options.measurement.mergeCell, frame.planar)};
        alone.clusters = {std::move(piece)};
        if (const auto vehicle = vehicleIn(alone, around, discriminator, options))
            found.push_back(*vehicle);
    }
    return found;
}

}  // namespace vdamf
