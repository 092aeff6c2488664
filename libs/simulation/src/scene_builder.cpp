// SPDX-License-Identifier: BSD-3-Clause
#include "scene_builder.h"

#include <algorithm>
#include <filesystem>
#include <stdexcept>
#include <utility>

#include "scene_problems.h"
#include "traffic.h"
#include "vdamf/files/csv.h"
#include "vdamf/simulation/segments.h"
#include "vdamf/simulation/towed_motion.h"

namespace vdamf
{
namespace
{
constexpr std::string_view kObjectPrefix = "object ";

BodySize sizeOf(const ObjectOptions& options)
{
    const BodySize usual = typicalSize(options.objectClass);
    return {options.length > 0.0 ? options.length : usual.length,
            options.width > 0.0 ? options.width : usual.width,
            options.height > 0.0 ? options.height : usual.height};
}

/// Builds the scene and collects what is wrong with its parts.
class SceneBuilder
{
public:
    SceneBuilder(const IniDocument& document, double duration)
        : document_(document), problems_(document), duration_(duration)
    {
    }

    void setPlatform(const PlatformOptions& options)
    {
        const MotionState start{options.x, options.y, options.heading, options.speed, 0.0};
        scene_.platform = Trajectory(start, segments("platform", options.segments, options.speed));
    }

    void add(const NamedObject& named)
    {
        const ObjectOptions& options = named.options;
        if (named.name != cellText(named.name))
        {
            problems_.add(named.section, "class",
                          std::string("the object's name must be ") + kCellText);
        }
        SceneObject object;
        object.name = named.name;
        object.objectClass = options.objectClass;
        object.size = sizeOf(options);
        object.rearAxleOffset = rearAxleOffsetOf(options.objectClass, object.size.length);
        object.trajectory = options.towedBy.empty() ? driven(named, object.rearAxleOffset)
                                                    : towedBehind(named, object);
        try
        {
            object.body = makeBody(object.objectClass, object.size);
        }
        catch (const std::runtime_error& error)
        {
            problems_.add(named.section, "length_m", error.what());
        }
        scene_.objects.push_back(std::move(object));
    }

    void addTraffic(const TrafficOptions& options)
    {
        if (!options.argoverseLog.empty() && !options.table.empty())
        {
            problems_.add("traffic", "table", "cannot be given together with argoverse_log");
            return;
        }
        const std::string key = options.table.empty() ? "argoverse_log" : "table";
        const std::string& name = options.table.empty() ? options.argoverseLog : options.table;
        if (name.empty())
        {
            if (document_.find("traffic") != nullptr)
                problems_.add("traffic", "table",
                              "is missing: [traffic] needs it, or argoverse_log instead");
            return;
        }
        try
        {
            const std::filesystem::path path = document_.fileOf("traffic", key, name);
            const Recording recording =
                options.table.empty() ? readArgoverseLog(path) : readTruthTable(path);
            addRecording(key, path, recording, options.smoothing);
        }
        catch (const std::runtime_error& error)
        {
            problems_.add("traffic", key, error.what());
        }
    }

    BuiltScene finish() &&
    {
        problems_.throwIfAny();
        return {std::move(scene_), std::move(warnings_)};
    }

private:
    Trajectory driven(const NamedObject& named, double axleOffset)
    {
        const ObjectOptions& options = named.options;
        const OrientedBox box{options.x, options.y, options.heading, 0.0, 0.0};
        return Trajectory(startOf(box, axleOffset, options.speed),
                          segments(named.section, options.segments, options.speed));
    }

    Trajectory towedBehind(const NamedObject& named, const SceneObject& object)
    {
        for (const char* key : {"x_m", "y_m", "heading_deg", "speed_mps", "segments"})
        {
            if (document_.find(named.section, key) == nullptr) continue;
            problems_.add(named.section, key, "follows from what tows it: remove this key");
        }
        const auto vehicle = std::find_if(scene_.objects.begin(), scene_.objects.end(),
                                          [&](const SceneObject& other)
                                          { return other.name == named.options.towedBy; });
        if (vehicle == scene_.objects.end())
        {
            problems_.add(named.section, "towed_by",
                          "expected the name of an object that stands above in the file");
            return {};
        }
        const TowBar bar{0.5 * vehicle->size.length - vehicle->rearAxleOffset,
                         named.options.drawbar + 0.5 * object.size.length + object.rearAxleOffset};
        return towed(vehicle->trajectory, bar, duration_);
    }

    void addRecording(const std::string& key, const std::filesystem::path& path,
                      const Recording& recording, double smoothing)
    {
        if (recording.platform.size() >= 2)
        {
            if (document_.find("platform") != nullptr)
            {
                problems_.add("traffic", key,
                              "says how the platform moves: remove the section [platform]");
            }
            scene_.platform = smoothed(recording.platform, 0.0, smoothing);
        }
        TrafficObjects traffic = trafficOf(recording, smoothing);
        for (const std::string& warning : traffic.warnings)
            warnings_.push_back(path.string() + ": " + warning);
        for (SceneObject& object : traffic.objects)
        {
            const bool isTaken =
                std::any_of(scene_.objects.begin(), scene_.objects.end(),
                            [&](const SceneObject& other) { return other.name == object.name; });
            if (isTaken) problems_.add("traffic", key, "holds another object " + object.name);
            scene_.objects.push_back(std::move(object));
        }
    }

    std::vector<MotionSegment> segments(const std::string& section, const std::string& text,
                                        double speed)
    {
        try
        {
            return parseSegments(text, speed);
        }
        catch (const std::runtime_error& error)
        {
            problems_.add(section, "segments", error.what());
            return {};
        }
    }

    const IniDocument& document_;
    SceneProblems problems_;
    double duration_;
    Scene scene_;
    std::vector<std::string> warnings_;
};
}  // namespace

ObjectSections readObjects(const IniDocument& document, IniReader& reader)
{
    ObjectSections sections;
    reader.read("traffic", sections.traffic);
    for (const IniSection& section : document.sections())
    {
        if (section.name.substr(0, kObjectPrefix.size()) != kObjectPrefix) continue;
        NamedObject object{section.name, section.name.substr(kObjectPrefix.size()), {}};
        reader.read(section.name, object.options);
        sections.objects.push_back(std::move(object));
    }
    return sections;
}

BuiltScene buildScene(const IniDocument& document, const PlatformOptions& platform,
                      const ObjectSections& sections, double duration)
{
    SceneBuilder builder(document, duration);
    builder.setPlatform(platform);
    for (const NamedObject& object : sections.objects) builder.add(object);
    builder.addTraffic(sections.traffic);
    return std::move(builder).finish();
}

}  // namespace vdamf
