// SPDX-License-Identifier: BSD-3-Clause
#include "kitti_numbers.h"

#include <algorithm>
#include <optional>
#include <stdexcept>

#include "vdamf/files/numbers.h"
#include "vdamf/files/text_file.h"

namespace vdamf
{
namespace
{
struct CalibrationLine
{
    std::vector<double> values;
    std::string where;  ///< "file:line"
};

// The numbers behind `key` at the start of a line.
CalibrationLine lineOf(const std::string& bytes, const std::string& fileName, std::string_view key,
                       std::size_t count)
{
    std::string_view rest = bytes;
    for (int line = 1; !rest.empty(); ++line)
    {
        const std::size_t end = std::min(rest.find('\n'), rest.size());
        const std::string_view text = trimmed(rest.substr(0, end));
        rest.remove_prefix(std::min(end + 1, rest.size()));
        if (text.substr(0, key.size()) != key) continue;
        const std::string where = fileName + ":" + std::to_string(line);
        return {numbersOf(text.substr(key.size()), where, count), where};
    }
    throw std::runtime_error(fileName + ": there is no line '" + std::string(key) + " ...'");
}
}  // namespace

std::vector<double> numbersOf(std::string_view text, const std::string& where, std::size_t count)
{
    std::vector<double> values;
    for (text = trimmed(text); !text.empty(); text = trimmed(text))
    {
        const std::size_t end = std::min(text.find_first_of(" \t\r\n"), text.size());
        const std::optional<double> value = parseNumber(text.substr(0, end));
        if (!value)
        {
            throw std::runtime_error(where + ": value " + std::to_string(values.size() + 1) +
                                     ": expected a finite number, found " +
                                     inQuotes(text.substr(0, end)));
        }
        values.push_back(*value);
        text.remove_prefix(end);
    }
    if (values.size() == count) return values;
    throw std::runtime_error(where + ": expected " + std::to_string(count) + " numbers, found " +
                             std::to_string(values.size()));
}

Eigen::Isometry3d readRigidTransform(const std::filesystem::path& path)
{
    const std::string bytes = readTextFile(path);
    const CalibrationLine rotation = lineOf(bytes, path.string(), "R:", 9);
    const CalibrationLine translation = lineOf(bytes, path.string(), "T:", 3);
    const Eigen::Matrix3d r =
        Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(rotation.values.data());
    // The files give seven digits.
    const double error = (r * r.transpose() - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff();
    if (error > 1e-4 || r.determinant() < 0.0)
    {
        throw std::runtime_error(rotation.where + ": R is not a rotation matrix");
    }
    Eigen::Isometry3d transform = Eigen::Isometry3d::Identity();
    transform.linear() = Eigen::Quaterniond(r).normalized().toRotationMatrix();
    transform.translation() = Eigen::Map<const Eigen::Vector3d>(translation.values.data());
    return transform;
}

}  // namespace vdamf
