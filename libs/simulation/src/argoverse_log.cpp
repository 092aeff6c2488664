// SPDX-License-Identifier: BSD-3-Clause
// Argoverse 2 (Wilson et al., NeurIPS 2021): boxes in the ego frame, and the ego frame's poses.
#include <Eigen/Geometry>
#include <cstdint>
#include <map>
#include <optional>
#include <stdexcept>

#include "recording_span.h"
#include "vdamf/files/csv.h"
#include "vdamf/simulation/recording.h"

namespace vdamf
{
namespace
{
using Nanoseconds = std::int64_t;
using EgoPoses = std::map<Nanoseconds, Eigen::Isometry3d>;

Eigen::Isometry3d poseOf(const CsvReader& reader)
{
    const Eigen::Quaterniond turn(reader.number("qw"), reader.number("qx"), reader.number("qy"),
                                  reader.number("qz"));
    if (turn.norm() < 0.5) reader.fail("qw", "the quaternion is not of length 1");
    const Eigen::Vector3d place(reader.number("tx_m"), reader.number("ty_m"),
                                reader.number("tz_m"));
    return Eigen::Translation3d(place) * turn.normalized();
}

LabelledPose inPlane(const Eigen::Isometry3d& pose, double time)
{
    const Eigen::Vector3d ahead = pose.linear().col(0);
    return {time, pose.translation().x(), pose.translation().y(), std::atan2(ahead.y(), ahead.x())};
}

EgoPoses readEgoPoses(const std::filesystem::path& path)
{
    CsvReader reader(path, {"timestamp_ns", "qw", "qx", "qy", "qz", "tx_m", "ty_m", "tz_m"});
    EgoPoses poses;
    std::optional<double> first;  // s
    while (reader.next())
    {
        const Nanoseconds time = reader.integer("timestamp_ns");
        const double now = 1e-9 * static_cast<double>(time);
        if (!first) first = now;
        const std::string problem = spanProblem(now - *first);
        if (!problem.empty()) reader.fail("timestamp_ns", std::to_string(time) + ": " + problem);
        poses[time] = poseOf(reader);
    }
    return poses;
}

/// Between the two poses around a time.
Eigen::Isometry3d egoAt(const EgoPoses& poses, Nanoseconds time, const CsvReader& reader)
{
    const auto after = poses.lower_bound(time);
    if (after != poses.end() && after->first == time) return after->second;
    if (after == poses.begin() || after == poses.end())
    {
        reader.fail("timestamp_ns", "city_SE3_egovehicle.csv has no poses around this time");
    }
    const auto before = std::prev(after);
    const double share = static_cast<double>(time - before->first) /
                         static_cast<double>(after->first - before->first);
    const Eigen::Quaterniond from(before->second.linear());
    const Eigen::Quaterniond to(after->second.linear());
    const Eigen::Vector3d place =
        (1.0 - share) * before->second.translation() + share * after->second.translation();
    return Eigen::Translation3d(place) * from.slerp(share, to);
}

ObjectClass passengerCarOf(const BodySize& size)
{
    if (size.height > 1.95 || size.length > 5.6) return ObjectClass::Van;
    if (size.height > 1.62) return ObjectClass::Suv;
    return size.length < 4.3 ? ObjectClass::Hatchback : ObjectClass::Car;
}

/// Categories that are not listed are boxes.
ObjectClass classOf(const std::string& category, const BodySize& size)
{
    static const std::map<std::string, ObjectClass> kClasses{
        {"BOX_TRUCK", ObjectClass::Truck},
        {"TRUCK", ObjectClass::Truck},
        {"TRUCK_CAB", ObjectClass::Truck},
        {"VEHICULAR_TRAILER", ObjectClass::Trailer},
        {"BUS", ObjectClass::Bus},
        {"SCHOOL_BUS", ObjectClass::Bus},
        {"ARTICULATED_BUS", ObjectClass::Bus},
        {"RAILED_VEHICLE", ObjectClass::Tram},
        {"MOTORCYCLE", ObjectClass::Motorcycle},
        {"MOTORCYCLIST", ObjectClass::Motorcycle},
        {"BICYCLE", ObjectClass::Bicycle},
        {"BICYCLIST", ObjectClass::Bicycle},
        {"WHEELED_DEVICE", ObjectClass::Bicycle},
        {"WHEELED_RIDER", ObjectClass::Bicycle},
        {"PEDESTRIAN", ObjectClass::Pedestrian},
        {"OFFICIAL_SIGNALER", ObjectClass::Pedestrian},
        {"BOLLARD", ObjectClass::Pole},
        {"CONSTRUCTION_CONE", ObjectClass::Pole},
        {"CONSTRUCTION_BARREL", ObjectClass::Pole},
        {"SIGN", ObjectClass::Sign},
        {"STOP_SIGN", ObjectClass::Sign}};
    if (category == "REGULAR_VEHICLE") return passengerCarOf(size);
    if (category == "LARGE_VEHICLE")
    {
        return size.length > 7.0 ? ObjectClass::Truck : ObjectClass::Van;
    }
    const auto found = kClasses.find(category);
    return found == kClasses.end() ? ObjectClass::Box : found->second;
}

LabelledObject objectOf(const CsvReader& reader)
{
    LabelledObject object;
    object.name = reader.text("track_uuid");
    object.size = {reader.number("length_m"), reader.number("width_m"), reader.number("height_m")};
    object.objectClass = classOf(reader.text("category"), object.size);
    return object;
}

double seconds(Nanoseconds time, Nanoseconds begin)
{
    return 1e-9 * static_cast<double>(time - begin);
}
}  // namespace

Recording readArgoverseLog(const std::filesystem::path& folder)
{
    const EgoPoses ego = readEgoPoses(folder / "city_SE3_egovehicle.csv");
    const std::filesystem::path annotations = folder / "annotations.csv";
    CsvReader reader(annotations, {"timestamp_ns", "track_uuid", "category", "length_m", "width_m",
                                   "height_m", "qw", "qx", "qy", "qz", "tx_m", "ty_m", "tz_m"});
    Recording recording;
    std::map<std::string, std::size_t> indices;
    std::optional<Nanoseconds> begin;
    Eigen::Vector3d origin = Eigen::Vector3d::Zero();
    while (reader.next())
    {
        const Nanoseconds time = reader.integer("timestamp_ns");
        const Eigen::Isometry3d egoPose = egoAt(ego, time, reader);
        if (!begin)
        {
            begin = time;
            origin = egoPose.translation();
        }
        if (time < *begin) reader.fail("timestamp_ns", "labels must be in order of time");
        if (reader.text("category") == "EGO_VEHICLE") continue;
        const auto [at, isNew] =
            indices.emplace(reader.text("track_uuid"), recording.objects.size());
        if (isNew) recording.objects.push_back(objectOf(reader));
        const Eigen::Isometry3d box = Eigen::Translation3d(-origin) * egoPose * poseOf(reader);
        recording.objects[at->second].poses.push_back(inPlane(box, seconds(time, *begin)));
    }
    if (!begin) throw std::runtime_error(annotations.string() + ": holds no label");
    for (const auto& [time, pose] : ego)
    {
        recording.platform.push_back(
            inPlane(Eigen::Translation3d(-origin) * pose, seconds(time, *begin)));
    }
    return recording;
}

}  // namespace vdamf
