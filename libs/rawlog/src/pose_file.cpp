// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/rawlog/pose_file.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>
#include <string>
#include <string_view>

#include "kitti_numbers.h"
#include "time_unit.h"
#include "vdamf/files/numbers.h"
#include "vdamf/files/text_file.h"
#include "vdamf/rawlog/kitti_drive.h"

namespace vdamf
{
namespace
{
constexpr std::size_t kLargestFile = std::size_t{512} << 20;
constexpr std::size_t kTum = 8;
constexpr std::size_t kKitti = 12;
constexpr double kRotationTolerance = 1e-3;  // of what should be a rotation

void forEachLine(const std::string& bytes, const std::string& name,
                 const std::function<void(std::string_view, const std::string&)>& use)
{
    std::string_view rest = bytes;
    for (int line = 1; !rest.empty(); ++line)
    {
        const std::size_t end = std::min(rest.find('\n'), rest.size());
        const std::string_view text = trimmed(rest.substr(0, end));
        rest.remove_prefix(std::min(end + 1, rest.size()));
        if (text.empty() || text.front() == '#') continue;
        use(text, name + ":" + std::to_string(line));
    }
}

std::size_t countWords(std::string_view text)
{
    std::size_t count = 0;
    bool inWord = false;
    for (const char c : text)
    {
        const bool blank = c == ' ' || c == '\t';
        count += !blank && !inWord ? 1 : 0;
        inWord = !blank;
    }
    return count;
}

/// The time is the line's first number.
void checkTime(double time, std::string_view line, const std::string& where)
{
    if (isTimeInSeconds(time)) return;
    throw std::runtime_error(where + ": " + inQuotes(line.substr(0, line.find_first_of(" \t"))) +
                             " is no time in seconds; expected 0 (1970, or the begin of the "
                             "recording) or more, and less than 1e11");
}

FilePose fromTum(const std::vector<double>& n, const std::string& where)
{
    const Eigen::Quaterniond q(n[7], n[4], n[5], n[6]);
    if (!(std::abs(q.norm() - 1.0) < kRotationTolerance))
        throw std::runtime_error(where + ": qx qy qz qw are no rotation: their norm is " +
                                 toText(q.norm()) + "; expected 1");
    FilePose pose;
    pose.time = n[0];
    pose.pose.linear() = q.normalized().toRotationMatrix();
    pose.pose.translation() = Eigen::Vector3d(n[1], n[2], n[3]);
    return pose;
}

FilePose fromKitti(const std::vector<double>& n, const std::string& where)
{
    const Eigen::Matrix<double, 3, 4> m =
        Eigen::Map<const Eigen::Matrix<double, 3, 4, Eigen::RowMajor>>(n.data());
    const Eigen::Matrix3d r = m.leftCols<3>();
    const double error = (r * r.transpose() - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff();
    if (!(error < kRotationTolerance) || r.determinant() < 0.0)
        throw std::runtime_error(where + ": columns 1 to 3 of the matrix are no rotation");
    FilePose pose;
    pose.pose.linear() = Eigen::Quaterniond(r).normalized().toRotationMatrix();
    pose.pose.translation() = m.col(3);
    return pose;
}
}  // namespace

std::vector<FilePose> readPoseFile(const std::filesystem::path& path)
{
    std::vector<FilePose> poses;
    std::size_t columns = 0;
    const auto use = [&](std::string_view text, const std::string& where)
    {
        if (columns == 0) columns = countWords(text);
        if (columns != kTum && columns != kKitti)
            throw std::runtime_error(where + ": " + std::to_string(columns) +
                                     " columns; expected 8 (TUM: time tx ty tz qx qy qz qw) or 12 "
                                     "(KITTI: a 3x4 matrix by rows)");
        const std::vector<double> numbers = numbersOf(text, where, columns);
        if (columns == kTum) checkTime(numbers.front(), text, where);
        poses.push_back(columns == kTum ? fromTum(numbers, where) : fromKitti(numbers, where));
        const bool rises = columns == kKitti || poses.size() < 2 ||
                           *poses.back().time > *poses[poses.size() - 2].time;
        if (!rises) throw std::runtime_error(where + ": its time is not later than the one before");
    };
    forEachLine(readTextFile(path, kLargestFile), path.string(), use);
    if (poses.empty()) throw std::runtime_error(path.string() + ": holds no pose");
    return poses;
}

std::vector<double> readTimeFile(const std::filesystem::path& path)
{
    const std::string bytes = readTextFile(path, kLargestFile);
    std::vector<double> times;
    if (bytes.substr(0, bytes.find('\n')).find(':') != std::string::npos)
    {
        for (const mrpt::Clock::time_point time : readKittiTimestamps(path))
            times.push_back(mrpt::Clock::toDouble(time));
        return times;
    }
    const auto use = [&](std::string_view text, const std::string& where)
    {
        const double time = numbersOf(text, where, 1).front();
        checkTime(time, text, where);
        if (!times.empty() && time <= times.back())
            throw std::runtime_error(where + ": its time is not later than the one before");
        times.push_back(time);
    };
    forEachLine(bytes, path.string(), use);
    if (times.empty()) throw std::runtime_error(path.string() + ": holds no time");
    return times;
}

}  // namespace vdamf
