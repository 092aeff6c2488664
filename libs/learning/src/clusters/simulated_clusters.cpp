// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/learning/clusters/simulated_clusters.h"

#include <cmath>
#include <optional>
#include <stdexcept>

#include "clusters/body_view.h"
#include "clusters/clutter.h"

namespace vdamf
{
namespace
{
constexpr std::size_t kLeastHits = 10;  // as in the tracker

double between(double low, double high, RandomStream& random)
{
    return low + (high - low) * random.uniform();
}

BodySize randomSize(ObjectClass body, RandomStream& random)
{
    if (body == ObjectClass::Van)
        return {between(4.8, 6.5, random), between(1.9, 2.1, random), between(1.9, 2.6, random)};
    if (body == ObjectClass::Bus)
        return {between(10.0, 13.0, random), between(2.5, 2.55, random), between(2.9, 3.3, random)};
    if (body == ObjectClass::Motorcycle)
        return {between(1.9, 2.3, random), between(0.75, 0.9, random), between(1.4, 1.7, random)};
    if (body == ObjectClass::Truck)
        return {between(7.0, 12.0, random), between(2.4, 2.55, random), between(3.0, 3.8, random)};
    return {between(3.8, 5.0, random), between(1.65, 1.95, random), between(1.4, 1.7, random)};
}

VehicleType typeOf(ObjectClass body)
{
    switch (body)
    {
        case ObjectClass::Car:
            return VehicleType::Car;
        case ObjectClass::Van:
            return VehicleType::Van;
        case ObjectClass::Truck:
        case ObjectClass::Bus:
            return VehicleType::Truck;
        case ObjectClass::Motorcycle:
            return VehicleType::TwoWheeler;
        default:
            return VehicleType::Any;
    }
}

// Where the sensor stands in the frame of the vehicle.
Eigen::Vector2d randomView(SimulatedKind::Aspect kind, const BodySize& size, RandomStream& random)
{
    constexpr double kNearest = 8.0;
    constexpr double kFarthest = 60.0;
    const double range = between(kNearest, kFarthest, random) + 0.5 * (size.length - 4.5);
    const double sign = random.uniform() < 0.5 ? -1.0 : 1.0;
    const double across = between(-0.35, 0.35, random);
    if (kind == SimulatedKind::Aspect::End) return {sign * range, across * size.width};
    if (kind == SimulatedKind::Aspect::Side) return {across * size.length, sign * range};
    if (kind == SimulatedKind::Aspect::Neighbour)
    {
        const double along = between(12.0, 30.0, random);
        const double beside = between(3.0, 4.5, random);
        return {sign * along, random.uniform() < 0.5 ? beside : -beside};
    }
    const double aspect = between(-kPi, kPi, random);
    return {range * std::cos(aspect), range * std::sin(aspect)};
}

std::optional<LabelledCluster> drawn(const SimulatedKind& kind, RandomStream& random)
{
    const BodySize size = randomSize(kind.body, random);
    const Eigen::Vector2d view = randomView(kind.aspect, size, random);
    LabelledCluster sample;
    sample.isBody = kind.body != ObjectClass::Box;
    sample.rangeNoise = kind.rangeNoise;
    sample.truth.heading = between(-kPi, kPi, random);
    sample.truth.length = size.length;
    sample.truth.width = size.width;
    sample.height = size.height;
    sample.type = typeOf(kind.body);
    const Eigen::Vector2d centre = -(rotation(sample.truth.heading) * view);
    sample.truth.x = centre.x();
    sample.truth.y = centre.y();

    std::vector<StandingBody> bodies = {vehicle(kind.body, size, sample.truth)};
    if (kind.mirrors)
        for (const StandingBody& mirror : mirrors(size, sample.truth)) bodies.push_back(mirror);
    if (kind.bush) bodies.push_back(bushBeside(sample.truth, random));
    BodyView seen = viewOf(bodies, sample.truth, kind.rangeNoise, random);
    if (kind.hidden) seen = partlyHidden(seen, random);
    if (kind.clutter > 0.0) seen = withClutter(seen, sample.truth, kind.clutter, random);
    if (seen.hitsOn(0) < kLeastHits) return std::nullopt;
    const std::size_t bushHits = kind.bush ? seen.hitsOn(1) : 0;
    if (kind.bush && (bushHits < 5 || bushHits > seen.hitsOn(0))) return std::nullopt;
    if (kind.mirrors && seen.hitsOn(1) + seen.hitsOn(2) < 2) return std::nullopt;
    sample.cluster = seen.cluster;
    sample.inView = facesInView(sample.cluster, sample.truth, sample.sensor);
    return sample;
}
}  // namespace

std::vector<SimulatedKind> simulatedKinds()
{
    using Aspect = SimulatedKind::Aspect;
    const auto car = ObjectClass::Car;
    const auto box = ObjectClass::Box;
    return {
        {"clean", "upright walls, 3 cm range noise"},
        {"noise", "upright walls, 10 cm range noise", box, 0.1},
        {"clutter", "8 % of hits anywhere up to 1 m around and inside", box, 0.03, 0.08},
        {"bush", "a bush 0.3 to 0.6 m beside a face, with at most half of the hits", box, 0.03, 0.0,
         true},
        {"mirrors", "mirrors on both sides", box, 0.03, 0.0, false, true},
        {"end_only", "front or rear alone in view", box, 0.03, 0.0, false, false, false,
         Aspect::End},
        {"side_only", "a side alone in view", box, 0.03, 0.0, false, false, false, Aspect::Side},
        {"half_hidden", "30 to 60 % hidden from one end on", box, 0.03, 0.0, false, false, true},
        {"car", "tapered and rounded car, 2 cm range noise", car, 0.02},
        {"van", "tapered and rounded van, 2 cm range noise", ObjectClass::Van, 0.02},
        {"truck", "truck, 2 cm range noise", ObjectClass::Truck, 0.02},
        {"car_end_only", "front or rear of the car alone", car, 0.02, 0.0, false, false, false,
         Aspect::End},
        {"car_side_only", "a side of the car alone", car, 0.02, 0.0, false, false, false,
         Aspect::Side},
        {"bus", "bus, 2 cm range noise", ObjectClass::Bus, 0.02},
        {"motorcycle", "motorcycle with its rider, 2 cm range noise", ObjectClass::Motorcycle,
         0.02},
        {"car_in_next_lane", "a car one lane beside, its side at a grazing angle", car, 0.02, 0.0,
         false, false, false, Aspect::Neighbour},
    };
}

LabelledClusters simulatedCondition(const SimulatedKind& kind, int count, std::uint64_t seed)
{
    constexpr int kTries = 200;
    LabelledClusters condition{kind.name, kind.description, {}};
    for (int index = 0; index < count; ++index)
    {
        const auto stream = static_cast<std::uint64_t>(index);
        RandomStream random(seed, 2 * stream);
        std::optional<LabelledCluster> sample;
        for (int i = 0; i < kTries && !sample; ++i) sample = drawn(kind, random);
        if (!sample) throw std::runtime_error(kind.name + ": no cluster of ten hits in 200 tries");
        sample->start = perturbed(sample->truth, seed, 2 * stream + 1);
        sample->group = kind.name + ' ' + std::to_string(index);
        condition.samples.push_back(*sample);
    }
    return condition;
}

}  // namespace vdamf
