// SPDX-License-Identifier: BSD-3-Clause
#include "regression/variation.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <utility>

#include "vdamf/files/numbers.h"
#include "vdamf/simulation/object_class.h"
#include "vdamf/simulation/random_stream.h"

namespace vdamf
{
namespace
{
constexpr std::uint64_t kVariation = 1U << 21;  // unlike the streams of sensors and INS
constexpr double kLength = 0.06;
constexpr double kAcross = 0.04;      // of width and height
constexpr double kAlongScene = 1.0;   // m
constexpr double kAcrossScene = 0.3;  // m

const std::string* valueOf(const IniSection& section, const std::string& key)
{
    for (const IniEntry& entry : section.entries)
        if (entry.key == key) return &entry.value;
    return nullptr;
}

// Where the scenario has a number, it, else what is usual.
double numberOf(const IniSection& section, const std::string& key, double usual)
{
    const std::string* value = valueOf(section, key);
    return value == nullptr ? usual : parseNumber(*value).value_or(usual);
}

std::string assignment(const std::string& section, const std::string& key, double value)
{
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.3f", value);
    return section + "." + key + "=" + text.data();
}

ObjectClass classOf(const IniSection& object)
{
    const std::string* value = valueOf(object, "class");
    for (const auto& [objectClass, name] : EnumNames<ObjectClass>::names())
        if (value != nullptr && *value == name) return objectClass;
    return ObjectClass::Car;
}

double factor(RandomStream& random, double sigma)
{
    return 1.0 + sigma * std::clamp(random.gaussian(), -2.0, 2.0);
}
}  // namespace

std::vector<std::string> variationOf(const IniDocument& scenario, std::uint64_t seed)
{
    RandomStream random(seed, streamIndex(kVariation, 0));
    std::vector<std::string> assignments;
    for (const IniSection& section : scenario.sections())
    {
        if (section.name == "platform")
            for (const auto& [key, range] : {std::pair{"x_m", kAlongScene}, {"y_m", kAcrossScene}})
                assignments.push_back(assignment(
                    section.name, key,
                    numberOf(section, key, 0.0) + range * (2.0 * random.uniform() - 1.0)));
        if (section.name.rfind("object ", 0) != 0 || !isVehicle(classOf(section))) continue;
        const BodySize usual = typicalSize(classOf(section));
        const auto vary = [&](const std::string& key, double size, double sigma)
        {
            assignments.push_back(assignment(section.name, key,
                                             numberOf(section, key, size) * factor(random, sigma)));
        };
        vary("length_m", usual.length, kLength);
        vary("width_m", usual.width, kAcross);
        vary("height_m", usual.height, kAcross);
    }
    return assignments;
}

}  // namespace vdamf
