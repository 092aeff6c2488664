// SPDX-License-Identifier: BSD-3-Clause
#include "cloud_times.h"

#include <optional>
#include <stdexcept>

#include "time_unit.h"
#include "vdamf/files/numbers.h"

namespace vdamf
{
namespace
{
namespace fs = std::filesystem;

/// The time that a file's name says: since 1970, in a unit that its size tells.
std::optional<double> timeInName(const fs::path& file)
{
    constexpr double kLeast = 1e8;  // s, in 1973; what is less is a number without a unit
    const std::string stem = file.stem().string();
    const auto number = parseNumber(stem);
    if (!number || *number < 0.0) return std::nullopt;
    const bool hasPoint = stem.find('.') != std::string::npos;
    const double time = *number * secondsPerUnit(*number);
    if (!isTimeInSeconds(time) || (time < kLeast && !hasPoint)) return std::nullopt;
    return time;
}

std::optional<CloudTimes> timesInNames(const std::vector<fs::path>& clouds)
{
    CloudTimes times{{}, "the names of the files"};
    for (const fs::path& cloud : clouds)
    {
        const auto time = timeInName(cloud);
        if (!time) return std::nullopt;
        times.seconds.push_back(*time);
    }
    return times;
}

CloudTimes timesInFile(const CloudImport& job, std::size_t clouds)
{
    CloudTimes times{readTimeFile(job.times), job.times.string()};
    if (times.seconds.size() == clouds) return times;
    throw std::runtime_error(job.times.string() + ": holds " +
                             std::to_string(times.seconds.size()) + " times, " +
                             job.folder.string() + " has " + std::to_string(clouds) + " clouds");
}

CloudTimes foundTimes(const CloudImport& job, const std::vector<fs::path>& clouds,
                      const std::vector<FilePose>& poses)
{
    if (!job.times.empty()) return timesInFile(job, clouds.size());
    if (job.rate)
    {
        CloudTimes times{{}, toText(*job.rate) + " a second, as asked for"};
        for (std::size_t i = 0; i < clouds.size(); ++i)
            times.seconds.push_back(static_cast<double>(i) / *job.rate);
        return times;
    }
    const bool hasTimes = !poses.empty() && poses.front().time;
    if (hasTimes && poses.size() == clouds.size())
    {
        CloudTimes times{{}, job.poses.string()};
        for (const FilePose& pose : poses) times.seconds.push_back(*pose.time);
        return times;
    }
    if (auto times = timesInNames(clouds)) return *times;
    throw std::runtime_error(
        job.folder.string() +
        ": the times of the clouds are not known; name a file with --times, or "
        "their --rate");
}
}  // namespace

CloudTimes cloudTimes(const CloudImport& job, const std::vector<fs::path>& clouds,
                      const std::vector<FilePose>& poses)
{
    CloudTimes times = foundTimes(job, clouds, poses);
    for (std::size_t i = 1; i < clouds.size(); ++i)
        if (!(times.seconds[i] > times.seconds[i - 1]))
            throw std::runtime_error(clouds[i].string() + ": its time is not later than that of " +
                                     clouds[i - 1].filename().string() + " (from " + times.source +
                                     ")");
    return times;
}

}  // namespace vdamf
