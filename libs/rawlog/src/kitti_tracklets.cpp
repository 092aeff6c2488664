// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/rawlog/kitti_tracklets.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <pugixml.hpp>
#include <stdexcept>
#include <utility>

#include "vdamf/files/numbers.h"
#include "vdamf/files/text_file.h"

namespace vdamf
{
namespace
{
// Names of the data set, and those of truth.csv.
constexpr std::pair<const char*, const char*> kClasses[] = {
    {"Car", "Car"},         {"Van", "Van"},
    {"Truck", "Truck"},     {"Tram", "Tram"},
    {"Cyclist", "Cyclist"}, {"Pedestrian", "Pedestrian"},
    {"Misc", "Other"},      {"Person (sitting)", "Pedestrian"},
};

class TrackletFile
{
public:
    TrackletFile(const std::filesystem::path& path, std::size_t frames)
        : fileName_(path.string()), bytes_(readTextFile(path)), frames_(frames)
    {
        const pugi::xml_parse_result result = document_.load_buffer(bytes_.data(), bytes_.size());
        if (!result) fail(result.offset, std::string("not valid XML: ") + result.description());
    }

    std::vector<KittiTracklet> tracklets() const
    {
        const pugi::xml_node list = document_.child("boost_serialization").child("tracklets");
        if (!list) fail(0, "there is no <boost_serialization><tracklets>; is it a tracklet file?");
        checkCount(list);
        std::vector<KittiTracklet> all;
        for (const pugi::xml_node& item : list.children("item")) all.push_back(trackletOf(item));
        return all;
    }

private:
    [[noreturn]] void fail(std::ptrdiff_t offset, const std::string& what) const
    {
        const auto end =
            bytes_.begin() +
            std::clamp<std::ptrdiff_t>(offset, 0, static_cast<std::ptrdiff_t>(bytes_.size()));
        const std::ptrdiff_t line = 1 + std::count(bytes_.begin(), end, '\n');
        throw std::runtime_error(fileName_ + ":" + std::to_string(line) + ": " + what);
    }

    pugi::xml_node childOf(const pugi::xml_node& node, const char* name) const
    {
        const pugi::xml_node child = node.child(name);
        if (child) return child;
        fail(node.offset_debug(), std::string("<") + node.name() + "> has no <" + name + ">");
    }

    double number(const pugi::xml_node& node, const char* name) const
    {
        const pugi::xml_node child = childOf(node, name);
        const std::optional<double> value = parseNumber(trimmed(child.child_value()));
        if (value) return *value;
        fail(child.offset_debug(), std::string("<") + name + ">: expected a number, found " +
                                       inQuotes(child.child_value()));
    }

    double size(const pugi::xml_node& node, const char* name) const
    {
        const double value = number(node, name);
        if (value > 0.0) return value;
        fail(childOf(node, name).offset_debug(),
             std::string("<") + name + ">: expected a size above 0 m, found " + toText(value));
    }

    std::size_t count(const pugi::xml_node& node, const char* name) const
    {
        const pugi::xml_node child = childOf(node, name);
        const std::optional<std::int64_t> value = parseInteger(trimmed(child.child_value()));
        if (value && *value >= 0) return static_cast<std::size_t>(*value);
        fail(child.offset_debug(), std::string("<") + name + ">: expected a whole number, found " +
                                       inQuotes(child.child_value()));
    }

    void checkCount(const pugi::xml_node& list) const
    {
        const auto items = list.children("item");
        const auto found = static_cast<std::size_t>(std::distance(items.begin(), items.end()));
        if (count(list, "count") == found) return;
        fail(list.child("count").offset_debug(),
             "<count> is " + std::to_string(count(list, "count")) + ", but there are " +
                 std::to_string(found) + " <item>");
    }

    std::string classOf(const pugi::xml_node& item) const
    {
        const pugi::xml_node type = childOf(item, "objectType");
        const std::string_view name = trimmed(type.child_value());
        for (const auto& [kitti, ours] : kClasses)
        {
            if (name == kitti) return ours;
        }
        fail(type.offset_debug(), "unknown <objectType> " + inQuotes(name));
    }

    KittiTracklet trackletOf(const pugi::xml_node& item) const
    {
        KittiTracklet tracklet;
        tracklet.objectClass = classOf(item);
        tracklet.length = size(item, "l");
        tracklet.width = size(item, "w");
        tracklet.height = size(item, "h");
        tracklet.firstFrame = count(item, "first_frame");
        const pugi::xml_node poses = childOf(item, "poses");
        checkCount(poses);
        for (const pugi::xml_node& pose : poses.children("item"))
        {
            tracklet.poses.push_back(
                {number(pose, "tx"), number(pose, "ty"), number(pose, "tz"), number(pose, "rz")});
        }
        // One after the other: their sum may not fit.
        if (tracklet.firstFrame > frames_ || tracklet.poses.size() > frames_ - tracklet.firstFrame)
        {
            fail(item.offset_debug(),
                 "the " + std::to_string(tracklet.poses.size()) + " poses from frame " +
                     std::to_string(tracklet.firstFrame) + " on reach beyond the drive's " +
                     std::to_string(frames_) + " scans");
        }
        return tracklet;
    }

    std::string fileName_;
    std::string bytes_;
    std::size_t frames_;
    pugi::xml_document document_;
};
}  // namespace

std::vector<KittiTracklet> readKittiTracklets(const std::filesystem::path& path, std::size_t frames)
{
    return TrackletFile(path, frames).tracklets();
}

}  // namespace vdamf
