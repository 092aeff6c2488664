// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/experiments/setting_configuration.h"

#include <algorithm>
#include <set>
#include <stdexcept>
#include <string_view>

#include "split.h"
#include "vdamf/files/numbers.h"
#include "vdamf/files/text_file.h"
#include "vdamf/rawlog/configuration.h"

namespace vdamf
{
namespace
{
// How the strict reader names what came by IniDocument::set().
constexpr std::string_view kSetMark = "--set: ";

// The same of what concerns several keys, of which others are from a file.
constexpr std::string_view kSetAmongOthersMark = "--set, ";

// Nothing came from a command line here.
std::string withoutSetMark(const std::string& message)
{
    std::string all;
    for (const std::string& line : split(message, '\n'))
    {
        std::size_t mark = 0;
        for (const std::string_view one : {kSetMark, kSetAmongOthersMark})
            if (line.rfind(one, 0) == 0) mark = one.size();
        all += "\n" + line.substr(mark);
    }
    return all;
}

// What concerns the one key that was set, under the name of its place in the sweep's file. What
// concerns several keys together is checked setting by setting.
std::string problemsOfKey(const std::string& message, const std::string& where)
{
    std::string problems;
    for (const std::string& line : split(message, '\n'))
        if (line.rfind(kSetMark, 0) == 0) problems += where + line.substr(kSetMark.size()) + "\n";
    return problems;
}

bool namesFile(const std::string& key)
{
    const std::vector<NamedInput> files = filesNamedBy({});
    return std::any_of(files.begin(), files.end(),
                       [&](const NamedInput& one) { return one.name == key; });
}

// Files are named as seen from the sweep's file, or else from the configuration.
std::string assignment(const SweepFile& file, const IniDocument& base, const std::string& key,
                       const std::string& value)
{
    if (value.empty() || !namesFile(key)) return key + "=" + value;
    const std::filesystem::path besideBase = std::filesystem::path(base.fileName()).parent_path();
    for (const std::filesystem::path& path : {file.resolved(value), besideBase / value})
        if (std::filesystem::exists(path)) return key + "=" + path.string();
    return key + "=" + value;
}

std::string problemsOfValue(const SweepFile& file, const IniDocument& base, const std::string& key,
                            const std::string& value, const std::string& where)
{
    IniDocument document = base;
    try
    {
        document.set(assignment(file, base, key, value));
        readConfiguration(document);
    }
    catch (const IniError& error)
    {
        return problemsOfKey(error.what(), where);
    }
    catch (const std::runtime_error& error)
    {
        return where + error.what() + "\n";
    }
    return "";
}

// Of the values that were written, the first one that the key does not take.
std::string problemsOfValues(const SweepFile& file, const IniDocument& base, const SweptKey& key,
                             const std::vector<std::string>& values, const std::string& where)
{
    for (const std::string& value : values)
    {
        const std::string found = problemsOfValue(file, base, key.name, value, where);
        if (!found.empty()) return found;
    }
    return "";
}

// Where the ends are right and numbers between them are not, the key takes whole numbers alone: two
// places, as a wide interval may have a whole number of six digits at one.
std::string problemsOfInterval(const SweepFile& file, const IniDocument& base, const SweptKey& key,
                               const std::string& where)
{
    const SweptInterval& interval = *key.interval;
    const std::string from = valueAt(interval, 0.0);
    const std::string to = valueAt(interval, 1.0);
    const std::string atEnds = problemsOfValues(file, base, key, {from, to}, where);
    if (!atEnds.empty()) return atEnds;
    const std::vector<std::string> between = {valueAt(interval, 0.381966),
                                              valueAt(interval, 0.00381966)};
    const std::string found = problemsOfValues(file, base, key, between, where);
    if (found.empty()) return "";
    return found + where + key.name + ": a range without a step takes any number between " + from +
           " and " + to + "; give it one, as in '" + from + " : 1 : " + to +
           "', or list the values\n";
}

std::string problemsOfSweptKey(const SweepFile& file, const IniDocument& base, const SweptKey& key)
{
    const std::string where = file.path.string() + ":" + std::to_string(key.line) + ": ";
    if (key.interval) return problemsOfInterval(file, base, key, where);
    return problemsOfValues(file, base, key, key.values, where);
}

std::string nameOf(const std::string& assignment)
{
    return std::string(trimmed(split(assignment, '=').front()));
}

std::string valueOf(const std::string& assignment)
{
    const std::size_t equals = assignment.find('=');
    return equals == std::string::npos ? "" : std::string(trimmed(assignment.substr(equals + 1)));
}

std::vector<std::string> assignmentsOf(const RecordingGroup& group)
{
    return group.set.empty() ? std::vector<std::string>() : split(group.set, ',');
}

std::string problemsOfGroup(const SweepFile& file, const IniDocument& base,
                            const RecordingGroup& group)
{
    std::string problems;
    const std::string where = file.path.string() + ":" + std::to_string(group.setLine) +
                              ": [recordings" + (group.name.empty() ? "" : " " + group.name) +
                              "] set: ";
    std::set<std::string> names;
    for (const std::string& set : assignmentsOf(group))
    {
        if (set.find('=') == std::string::npos)
        {
            problems += where + "expected section.key=value, found " + inQuotes(set) + "\n";
            continue;
        }
        if (!names.insert(nameOf(set)).second)
            problems += where + nameOf(set) + " stands there twice; remove one\n";
        for (const SweptKey& key : file.keys)
            if (nameOf(set) == key.name)
                problems += where + key.name + " is varied as well; remove one\n";
        problems += problemsOfValue(file, base, nameOf(set), valueOf(set), where);
    }
    return problems;
}
}  // namespace

IniDocument baseDocument(const SweepFile& file)
{
    if (file.sweep.config.empty()) return IniDocument::parse("", "built-in configuration");
    return IniDocument::load(file.resolved(file.sweep.config));
}

void checkKeys(const SweepFile& file, const IniDocument& base)
{
    readConfiguration(base);  // its own problems, under its own name
    std::string problems;
    for (const SweptKey& key : file.keys) problems += problemsOfSweptKey(file, base, key);
    for (const RecordingGroup& group : file.groups) problems += problemsOfGroup(file, base, group);
    if (!problems.empty()) throw std::runtime_error(problems.substr(0, problems.size() - 1));
}

std::string configurationOf(const SweepFile& file, const IniDocument& base,
                            const RecordingGroup& group, const SweepSetting& setting)
{
    IniDocument document = base;
    for (const std::string& set : assignmentsOf(group))
        document.set(assignment(file, base, nameOf(set), valueOf(set)));
    for (std::size_t k = 0; k < file.keys.size(); ++k)
        document.set(assignment(file, base, file.keys[k].name, setting.values[k]));
    try
    {
        return toIni(readConfiguration(document));
    }
    catch (const IniError& error)
    {
        throw std::runtime_error(file.path.string() + ": setting " + inWords(file, setting) + ":" +
                                 withoutSetMark(error.what()));
    }
}

void checkSetting(const SweepFile& file, const IniDocument& base, const SweepSetting& setting)
{
    for (const RecordingGroup& group : file.groups) configurationOf(file, base, group, setting);
}

std::vector<NamedInput> filesOfSweep(const SweepFile& file, const IniDocument& base)
{
    std::vector<NamedInput> all;
    const auto add = [&](const IniDocument& document)
    {
        for (const NamedInput& one : filesNamedBy(readConfiguration(document))) all.push_back(one);
    };
    const auto addWith = [&](const std::string& key, const std::string& value)
    {
        if (!namesFile(key)) return;
        IniDocument document = base;
        document.set(assignment(file, base, key, value));
        add(document);
    };
    add(base);
    for (const RecordingGroup& group : file.groups)
        for (const std::string& set : assignmentsOf(group)) addWith(nameOf(set), valueOf(set));
    for (const SweptKey& key : file.keys)
        for (const std::string& value : key.values) addWith(key.name, value);
    return all;
}

std::string inWords(const SweepFile& file, const SweepSetting& setting)
{
    std::string words;
    for (std::size_t k = 0; k < file.keys.size(); ++k)
        words += (k > 0 ? ", " : "") + file.keys[k].name + " = " + setting.values[k];
    return words;
}

}  // namespace vdamf
