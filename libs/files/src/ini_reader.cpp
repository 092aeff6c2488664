// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <optional>

#include "degrees.h"
#include "vdamf/files/ini.h"
#include "vdamf/files/nearest_name.h"
#include "vdamf/files/numbers.h"
#include "vdamf/files/text_file.h"

namespace vdamf
{
namespace
{
std::string whereIs(const IniDocument& document, int line)
{
    return line > 0 ? document.fileName() + ":" + std::to_string(line) : "--set";
}

std::string joined(const std::vector<std::string>& names, const std::string& separator)
{
    std::string all;
    for (const std::string& name : names) all += (all.empty() ? "" : separator) + name;
    return all;
}

// What to write instead of an unknown name.
std::string suggestion(const std::string& name, const std::vector<std::string>& known)
{
    const std::string nearest = nearestName(name, known);
    if (!nearest.empty()) return "; did you mean '" + nearest + "'?";
    return known.empty() ? "" : "; known: " + joined(known, ", ");
}
}  // namespace

void IniReader::beginSection(const std::string& section)
{
    section_ = section;
    known_[section];
}

const IniEntry* IniReader::entry(const char* key)
{
    known_[section_].emplace_back(key);
    return document_.find(section_, key);
}

void IniReader::problem(const IniEntry& entry, const std::string& expected)
{
    problems_.push_back(whereIs(document_, entry.line) + ": " + section_ + "." + entry.key + " = " +
                        inQuotes(entry.value) + ": expected " + expected);
}

void IniReader::operator()(double& v, const char* key, double min, double max, const char*)
{
    const IniEntry* found = entry(key);
    if (found == nullptr) return;
    const std::optional<double> value = parseNumber(found->value);
    if (!value || *value < min || *value > max)
    {
        problem(*found, "a number from " + toText(min) + " to " + toText(max));
        return;
    }
    v = keyIsInDegrees(key) ? radians(*value) : *value;
}

void IniReader::operator()(int& v, const char* key, int min, int max, const char*)
{
    const IniEntry* found = entry(key);
    if (found == nullptr) return;
    const std::optional<std::int64_t> value = parseInteger(found->value);
    if (!value || *value < min || *value > max)
    {
        problem(*found,
                "a whole number from " + std::to_string(min) + " to " + std::to_string(max));
        return;
    }
    v = static_cast<int>(*value);
}

void IniReader::operator()(bool& v, const char* key, const char*)
{
    const IniEntry* found = entry(key);
    if (found == nullptr) return;
    if (found->value == "true" || found->value == "false")
    {
        v = found->value == "true";
        return;
    }
    problem(*found, "true or false");
}

void IniReader::operator()(std::string& v, const char* key, const char*)
{
    const IniEntry* found = entry(key);
    if (found == nullptr) return;
    if (!standsInIni(found->value)) problem(*found, kIniText);
    v = found->value;
}

int IniReader::readEnum(const char* key, const std::vector<std::string>& names, const char*)
{
    const IniEntry* found = entry(key);
    if (found == nullptr) return -1;
    const auto name = std::find(names.begin(), names.end(), found->value);
    if (name != names.end()) return static_cast<int>(name - names.begin());
    problem(*found, "one of " + joined(names, ", "));
    return -1;
}

void IniReader::findUnknown()
{
    std::vector<std::string> knownSections;
    for (const auto& [name, keys] : known_) knownSections.push_back(name);
    for (const IniSection& section : document_.sections())
    {
        const auto known = known_.find(section.name);
        if (known == known_.end())
        {
            problems_.push_back(whereIs(document_, section.line) + ": unknown section [" +
                                section.name + "]" + suggestion(section.name, knownSections));
            continue;
        }
        const std::vector<std::string>& keys = known->second;
        for (const IniEntry& e : section.entries)
        {
            if (std::find(keys.begin(), keys.end(), e.key) != keys.end()) continue;
            problems_.push_back(whereIs(document_, e.line) + ": unknown key " + section.name + "." +
                                e.key + suggestion(e.key, keys));
        }
    }
}

void IniReader::require(bool condition, const std::string& problem, int line)
{
    const std::string place = line > 0 ? ":" + std::to_string(line) : "";
    if (!condition) problems_.push_back(document_.fileName() + place + ": " + problem);
}

void IniReader::require(bool condition, const std::string& problem,
                        const std::vector<std::pair<std::string, std::string>>& keys)
{
    if (condition) return;
    std::vector<std::string> places;
    for (const auto& [section, key] : keys)
    {
        const std::string place = document_.placeOf(section, key);
        if (std::find(places.begin(), places.end(), place) == places.end()) places.push_back(place);
    }
    problems_.push_back(joined(places, ", ") + ": " + problem);
}

void IniReader::finish()
{
    findUnknown();
    if (problems_.empty()) return;
    throw IniError(joined(problems_, "\n"));
}

}  // namespace vdamf
