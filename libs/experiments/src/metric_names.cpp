// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/experiments/metric_names.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "vdamf/evaluation/evaluation.h"
#include "vdamf/evaluation/evaluation_json.h"
#include "vdamf/files/nearest_name.h"
#include "vdamf/files/text_file.h"

namespace vdamf
{
namespace
{
using Json = nlohmann::ordered_json;

TrackRow trackAt(std::uint64_t id, double x, double probability)
{
    TrackRow row;
    row.report.id = id;
    row.report.status = TrackStatus::Confirmed;
    row.report.vehicleProbability = probability;
    row.report.box = {x, 0.0, 0.0, 4.0, 2.0};
    return row;
}

// A car, a track on it and one on nothing: enough for the evaluation to have all of its keys.
Evaluation smallestEvaluation()
{
    TruthRow car;
    car.objectId = "car";
    car.objectClass = "Car";
    const TrackRow onCar = trackAt(1, 0.0, 0.9);
    car.box = onCar.report.box;
    car.sensor = PlanePose{-10.0, 0.0, 0.0};
    return evaluate({car}, {onCar, trackAt(2, 50.0, 0.1)});
}

void collect(const Json& json, const std::string& prefix, std::vector<std::string>& names)
{
    for (const auto& [key, value] : json.items())
    {
        if (value.is_object())
            collect(value, prefix + key + ".", names);
        else if (value.is_number() || value.is_null())
            names.push_back(prefix + key);
    }
}

std::vector<std::string> allNames()
{
    Json json = Json::parse(toJson(smallestEvaluation()));
    json.erase("options");
    std::vector<std::string> names;
    collect(json, "", names);
    return names;
}

// Nothing where the evaluation knows nothing of a whole block (the discriminator).
std::optional<double> numberIn(const Json& json, const std::string& name)
{
    const std::size_t dot = name.find('.');
    const Json& value = json.at(name.substr(0, dot));
    if (value.is_null()) return std::nullopt;
    if (dot == std::string::npos) return value.get<double>();
    return numberIn(value, name.substr(dot + 1));
}
}  // namespace

const std::vector<std::string>& metricNames()
{
    static const std::vector<std::string> names = allNames();
    return names;
}

void checkMetricName(const std::string& name)
{
    const std::vector<std::string>& known = metricNames();
    if (std::find(known.begin(), known.end(), name) != known.end()) return;
    const std::string nearest = nearestName(name, known);
    throw std::runtime_error("unknown metric " + inQuotes(name) +
                             (nearest.empty() ? "; 'vdamf-sweep --print-metrics' lists them"
                                              : "; did you mean '" + nearest + "'?"));
}

std::vector<std::optional<double>> readMetrics(const std::filesystem::path& file,
                                               const std::vector<std::string>& names)
{
    try
    {
        const Json json = Json::parse(readTextFile(file));
        std::vector<std::optional<double>> values;
        for (const std::string& name : names) values.push_back(numberIn(json, name));
        return values;
    }
    catch (const nlohmann::json::exception&)
    {
        throw std::runtime_error(file.string() + ": is damaged");
    }
}

}  // namespace vdamf
