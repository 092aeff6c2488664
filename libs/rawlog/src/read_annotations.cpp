// SPDX-License-Identifier: BSD-3-Clause
#include <mrpt/obs/CObservationComment.h>
#include <mrpt/obs/CObservationRawDAQ.h>
#include <mrpt/obs/CObservationRobotPose.h>

#include <cmath>
#include <sstream>
#include <stdexcept>

#include "vdamf/files/numbers.h"
#include "vdamf/rawlog/annotated_rawlog.h"
#include "vdamf/rawlog/annotation.h"
#include "vdamf/rawlog/annotation_table.h"
#include "vdamf/rawlog/rawlog_reader.h"

namespace vdamf
{
namespace
{
/// Values of the head's own section by key. They are free text, so they are not read as strict ini.
std::map<std::string, std::string> valuesOf(const std::string& section)
{
    std::map<std::string, std::string> values;
    std::istringstream lines(section);
    for (std::string line; std::getline(lines, line);)
    {
        const std::size_t sign = line.find(" = ");
        if (sign != std::string::npos) values[line.substr(0, sign)] = line.substr(sign + 3);
    }
    return values;
}

std::vector<std::string> split(const std::string& text)
{
    std::vector<std::string> parts;
    std::istringstream stream(text);
    for (std::string part; std::getline(stream, part, ',');) parts.push_back(part);
    return parts;
}

class Reading
{
public:
    void take(const mrpt::serialization::CSerializable& object)
    {
        if (isHead(object))
            takeHead(static_cast<const mrpt::obs::CObservationComment&>(object).text);
        else if (const auto* table = dynamic_cast<const mrpt::obs::CObservationRawDAQ*>(&object))
            takeTable(*table);
        else if (const auto* pose = dynamic_cast<const mrpt::obs::CObservationRobotPose*>(&object))
            takeAlignment(*pose);
    }

    Annotations annotations;

private:
    void takeHead(const std::string& text)
    {
        const std::size_t end = std::min(text.find("\n\n"), text.size());
        auto values = valuesOf(text.substr(0, end));
        annotations.version = values["version"];
        annotations.origin = values["origin"];
        annotations.insSource = values["ins"];
        columns_ = split(values["table_columns"]);
        try
        {
            annotations.configuration =
                readSettings(IniDocument::parse(text.substr(end), "the rawlog's head"));
            annotations.configurationProblem.clear();
        }
        catch (const std::exception& error)
        {
            annotations.configuration = {};
            annotations.configurationProblem = error.what();
        }
    }

    void takeAlignment(const mrpt::obs::CObservationRobotPose& pose)
    {
        if (pose.sensorLabel != kAlignmentLabel) return;
        const mrpt::poses::CPose3D& mean = pose.pose.mean;
        if (!std::isfinite(mean.yaw() + mean.x() + mean.y())) return;
        annotations.alignments.emplace(pose.timestamp,
                                       PlaneMotion{mean.yaw(), {mean.x(), mean.y()}});
    }

    void takeTable(const mrpt::obs::CObservationRawDAQ& table)
    {
        if (table.sensorLabel != kTableLabel) return;
        if (columns_.empty())
            throw std::runtime_error(
                "has tables of tracks, but no head before them that names "
                "their columns: was its first entry cut off?");
        try
        {
            const bool isNew =
                annotations.tables.emplace(table.timestamp, tracksOf(columns_, table.AIN_double))
                    .second;
            annotations.tablesRepeated += isNew ? 0 : 1;
        }
        catch (const std::runtime_error& error)
        {
            if (annotations.tablesDamaged++ > 0) return;
            const double time = mrpt::Clock::toDouble(table.timestamp);
            annotations.firstDamaged = toFixedText(time, 6) + " s: " + error.what();
        }
    }

    std::vector<std::string> columns_;
};
}  // namespace

Annotations readAnnotations(const std::filesystem::path& path)
{
    RawlogReader reader(path);
    Reading reading;
    try
    {
        while (const auto entry = reader.next())
            if (entry->object) reading.take(*entry->object);
    }
    catch (const ReadError&)
    {
        throw;  // it names the file
    }
    catch (const std::runtime_error& error)
    {
        throw std::runtime_error(path.string() + ": " + error.what());
    }
    reading.annotations.read = reader.summary();
    if (reading.annotations.tables.empty() && reading.annotations.tablesDamaged > 0)
        throw std::runtime_error(
            path.string() + ": none of its " + std::to_string(reading.annotations.tablesDamaged) +
            " tables of tracks can be read; the first one, at " + reading.annotations.firstDamaged);
    if (reading.annotations.tables.empty())
        throw std::runtime_error(path.string() + ": has no tables of tracks ('" + kTableLabel +
                                 "'): write it with vdamf-track -o, [output] annotate_table = "
                                 "true");
    return std::move(reading.annotations);
}

}  // namespace vdamf
