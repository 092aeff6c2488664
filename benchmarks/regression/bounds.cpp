// SPDX-License-Identifier: BSD-3-Clause
#include "regression/bounds.h"

#include "vdamf/files/csv.h"
#include "vdamf/files/numbers.h"

namespace vdamf
{
namespace
{
constexpr int kDecimals = 4;

bool isKnown(const std::vector<Bound>& bounds, const Bound& bound)
{
    for (const Bound& other : bounds)
        if (other.scenario == bound.scenario && other.metric == bound.metric) return true;
    return false;
}

std::string violation(const Bound& bound, const std::optional<double>& value)
{
    const std::string what = bound.scenario + ": " + metrics()[bound.metric].name + " ";
    if (!value) return what + "is not known, but has a bound";
    const std::string number = toFixedText(*value, kDecimals);
    if (bound.min && *value < *bound.min) return what + number + " is below " + toText(*bound.min);
    if (bound.max && *value > *bound.max) return what + number + " is above " + toText(*bound.max);
    return "";
}
}  // namespace

std::vector<Bound> readBounds(const std::filesystem::path& path)
{
    std::vector<Bound> bounds;
    CsvReader reader(path, {"scenario", "metric", "min", "max"});
    while (reader.next())
    {
        const std::optional<std::size_t> metric = metricIndex(reader.text("metric"));
        if (!metric)
            reader.fail("metric", "'" + reader.text("metric") +
                                      "' is no metric; regression.csv has the names");
        const Bound bound{reader.text("scenario"), *metric, reader.optionalNumber("min"),
                          reader.optionalNumber("max")};
        if (!bound.min && !bound.max) reader.fail("min", "neither min nor max is given");
        if (bound.min && bound.max && *bound.min > *bound.max) reader.fail("min", "is above max");
        if (isKnown(bounds, bound)) reader.fail("metric", "has bounds in a line above");
        bounds.push_back(bound);
    }
    return bounds;
}

std::vector<std::string> violations(const std::vector<Bound>& bounds,
                                    const std::vector<RegressionRow>& rows)
{
    std::vector<std::string> all;
    for (const RegressionRow& row : rows)
    {
        for (const Bound& bound : bounds)
        {
            if (bound.scenario != row.scenario) continue;
            const std::string sentence = violation(bound, row.values[bound.metric]);
            if (!sentence.empty()) all.push_back(sentence);
        }
    }
    return all;
}

}  // namespace vdamf
