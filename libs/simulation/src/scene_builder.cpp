// SPDX-License-Identifier: BSD-3-Clause
#include "scene_builder.h"

#include <stdexcept>
#include <utility>

#include "vdamf/simulation/segments.h"

namespace vdamf
{
namespace
{
constexpr std::string_view kObjectPrefix = "object ";

/// The rear axle lies this share of the length behind the middle of a vehicle: half of the usual
/// wheelbase.
constexpr double kRearAxleShare = 0.28;

/// "file:line: section.key: what", of a key where it stands in the file, else of its section.
std::string located(const IniDocument& document, const std::string& section, const std::string& key,
                    const std::string& what)
{
    int line = 0;
    if (const IniSection* found = document.find(section))
    {
        line = found->line;
        for (const IniEntry& entry : found->entries)
        {
            if (entry.key == key) line = entry.line;
        }
    }
    return document.fileName() + ":" + std::to_string(line) + ": " + section + "." + key + ": " +
           what;
}

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
    explicit SceneBuilder(const IniDocument& document) : document_(document) {}

    void setPlatform(const PlatformOptions& options)
    {
        const MotionState start{options.x, options.y, options.heading, options.speed, 0.0};
        scene_.platform = Trajectory(start, segments("platform", options.segments));
    }

    void add(const NamedObject& named)
    {
        const ObjectOptions& options = named.options;
        if (named.name.find(',') != std::string::npos)
        {
            problem(named.section, "class", "the object's name must not hold a comma");
        }
        SceneObject object;
        object.name = named.name;
        object.objectClass = options.objectClass;
        object.size = sizeOf(options);
        object.rearAxleOffset =
            isVehicle(options.objectClass) ? kRearAxleShare * object.size.length : 0.0;
        const OrientedBox box{options.x, options.y, options.heading, 0.0, 0.0};
        object.trajectory = Trajectory(startOf(box, object.rearAxleOffset, options.speed),
                                       segments(named.section, options.segments));
        try
        {
            object.body = makeBody(object.objectClass, object.size);
        }
        catch (const std::runtime_error& error)
        {
            problem(named.section, "length_m", error.what());
        }
        scene_.objects.push_back(std::move(object));
    }

    Scene finish() &&
    {
        if (!problems_.empty()) throw IniError(problems_);
        return std::move(scene_);
    }

private:
    void problem(const std::string& section, const std::string& key, const std::string& what)
    {
        problems_ += (problems_.empty() ? "" : "\n") + located(document_, section, key, what);
    }

    std::vector<MotionSegment> segments(const std::string& section, const std::string& text)
    {
        try
        {
            return parseSegments(text);
        }
        catch (const std::runtime_error& error)
        {
            problem(section, "segments", error.what());
            return {};
        }
    }

    const IniDocument& document_;
    Scene scene_;
    std::string problems_;
};
}  // namespace

std::vector<NamedObject> readObjects(const IniDocument& document, IniReader& reader)
{
    std::vector<NamedObject> objects;
    for (const IniSection& section : document.sections())
    {
        if (section.name.substr(0, kObjectPrefix.size()) != kObjectPrefix) continue;
        NamedObject object{section.name, section.name.substr(kObjectPrefix.size()), {}};
        reader.read(section.name, object.options);
        objects.push_back(std::move(object));
    }
    return objects;
}

Scene buildScene(const IniDocument& document, const PlatformOptions& platform,
                 const std::vector<NamedObject>& objects)
{
    SceneBuilder builder(document);
    builder.setPlatform(platform);
    for (const NamedObject& object : objects) builder.add(object);
    return std::move(builder).finish();
}

}  // namespace vdamf
