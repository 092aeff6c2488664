// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/evaluation/error_summary.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <utility>

namespace vdamf
{
namespace
{
using Condition = std::function<bool(const PoseError&)>;

std::vector<double> valuesOf(const std::vector<PoseError>& errors, double PoseError::*member)
{
    std::vector<double> values;
    values.reserve(errors.size());
    for (const PoseError& error : errors) values.push_back(error.*member);
    return values;
}

std::vector<double> valuesOf(const std::vector<PoseError>& errors,
                             std::optional<double> PoseError::*member)
{
    std::vector<double> values;
    for (const PoseError& error : errors)
    {
        if (error.*member) values.push_back(*(error.*member));
    }
    return values;
}

std::vector<ErrorGroup> grouped(const std::vector<PoseError>& errors,
                                const std::vector<std::pair<std::string, Condition>>& conditions)
{
    std::vector<ErrorGroup> groups;
    for (const auto& [name, holds] : conditions)
    {
        std::vector<PoseError> members;
        for (const PoseError& error : errors)
        {
            if (holds(error)) members.push_back(error);
        }
        groups.push_back({name, summaryOf(members)});
    }
    return groups;
}

// Each group from its value up to that of the next one.
std::vector<ErrorGroup> groupedBy(std::optional<double> PoseError::*member,
                                  const std::vector<PoseError>& errors,
                                  const std::vector<std::pair<std::string, double>>& groups)
{
    std::vector<std::pair<std::string, Condition>> conditions;
    for (std::size_t k = 0; k < groups.size(); ++k)
    {
        const double low = groups[k].second;
        const double high =
            k + 1 < groups.size() ? groups[k + 1].second : std::numeric_limits<double>::infinity();
        conditions.emplace_back(groups[k].first,
                                [=](const PoseError& e)
                                {
                                    const std::optional<double>& value = e.*member;
                                    return value && *value >= low && *value < high;
                                });
    }
    return grouped(errors, conditions);
}

Condition pointsFrom(int low, int high)
{
    return [=](const PoseError& e) { return e.points >= low && e.points <= high; };
}

Condition facesAre(bool end, bool side)
{
    return [=](const PoseError& e)
    { return e.facesSeen.seesEnd() == end && e.facesSeen.seesSide() == side; };
}
}  // namespace

std::optional<double> ErrorSummary::frontShare() const
{
    if (pairs == 0) return std::nullopt;
    return static_cast<double>(pairs - flips) / static_cast<double>(pairs);
}

ErrorSummary summaryOf(const std::vector<PoseError>& errors)
{
    const auto of = [&](auto member) { return statisticsOf(valuesOf(errors, member)); };
    ErrorSummary result;
    result.pairs = errors.size();
    const auto count = [&](auto holds)
    { return static_cast<std::size_t>(std::count_if(errors.begin(), errors.end(), holds)); };
    constexpr double kSure = 0.99;  // probability
    result.flips = count([](const PoseError& e) { return e.flipped; });
    result.exchanged = count([](const PoseError& e) { return e.exchanged; });
    result.exchangedThoughSure =
        count([](const PoseError& e) { return e.exchanged && e.axesProbability >= kSure; });
    result.position = of(&PoseError::position);
    result.longitudinal = of(&PoseError::longitudinal);
    result.lateral = of(&PoseError::lateral);
    result.corner = of(&PoseError::corner);
    result.heading = of(&PoseError::heading);
    result.headingAxis = of(&PoseError::headingAxis);
    result.speed = of(&PoseError::speed);
    result.yawRate = of(&PoseError::yawRate);
    result.length = of(&PoseError::length);
    result.width = of(&PoseError::width);
    result.overlap = of(&PoseError::overlap);
    return result;
}

std::vector<ErrorGroup> byRange(const std::vector<PoseError>& errors)
{
    return groupedBy(
        &PoseError::range, errors,
        {{"0-10", 0.0}, {"10-20", 10.0}, {"20-40", 20.0}, {"40-60", 40.0}, {"60+", 60.0}});
}

std::vector<ErrorGroup> byPoints(const std::vector<PoseError>& errors)
{
    constexpr int kMany = std::numeric_limits<int>::max();
    return grouped(errors, {{"0-19", pointsFrom(0, 19)},
                            {"20-49", pointsFrom(20, 49)},
                            {"50-199", pointsFrom(50, 199)},
                            {"200+", pointsFrom(200, kMany)}});
}

std::vector<ErrorGroup> byFaces(const std::vector<PoseError>& errors)
{
    return grouped(errors, {{"end only", facesAre(true, false)},
                            {"side only", facesAre(false, true)},
                            {"both", facesAre(true, true)},
                            {"none", facesAre(false, false)}});
}

std::vector<ErrorGroup> byLengthSigma(const std::vector<PoseError>& errors)
{
    return groupedBy(&PoseError::lengthSigma, errors,
                     {{"0-25", 0.0}, {"25-50", 0.25}, {"50-100", 0.5}, {"100+", 1.0}});
}

std::size_t flipsOfMoving(const std::vector<PoseError>& errors, double stillSpeed)
{
    return static_cast<std::size_t>(std::count_if(
        errors.begin(), errors.end(),
        [&](const PoseError& e) { return e.flipped && std::abs(e.trueSpeed) >= stillSpeed; }));
}

ErrorStatistics phantomSpeed(const std::vector<PoseError>& errors, double stillSpeed)
{
    std::vector<double> speeds;
    for (const PoseError& error : errors)
    {
        if (std::abs(error.trueSpeed) < stillSpeed) speeds.push_back(error.trackSpeed);
    }
    return statisticsOf(speeds);
}

ErrorStatistics standingScatter(const std::vector<PoseError>& errors, double stillSpeed)
{
    std::map<std::pair<std::string, std::uint64_t>, std::vector<Eigen::Vector2d>> places;
    for (const PoseError& error : errors)
    {
        if (std::abs(error.trueSpeed) < stillSpeed)
            places[{error.objectId, error.trackId}].emplace_back(error.longitudinal, error.lateral);
    }
    std::vector<double> distances;
    for (const auto& [names, all] : places)
    {
        Eigen::Vector2d mean = Eigen::Vector2d::Zero();
        for (const Eigen::Vector2d& place : all) mean += place / static_cast<double>(all.size());
        for (const Eigen::Vector2d& place : all) distances.push_back((place - mean).norm());
    }
    return statisticsOf(distances);
}

}  // namespace vdamf
