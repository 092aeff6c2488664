// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/experiments/sweep_file.h"

#include <algorithm>
#include <stdexcept>

#include "split.h"
#include "vdamf/experiments/metric_names.h"
#include "vdamf/files/numbers.h"
#include "vdamf/files/text_file.h"

namespace vdamf
{
namespace
{
constexpr std::string_view kGroup = "recordings";

// Section [vary]: its keys are those of another file.
struct VarySection
{
    std::vector<IniEntry> entries;

    template <class Self, class Visitor>
    static void visit(Self& self, Visitor&& field)
    {
        for (auto& entry : self.entries) field(entry.value, entry.key.c_str(), "");
    }
};

bool isGroup(const std::string& section)
{
    return section == kGroup || section.rfind(std::string(kGroup) + " ", 0) == 0;
}

class Collector
{
public:
    explicit Collector(const IniDocument& document) : document_(document) {}

    template <class Call>
    void attempt(const std::string& section, const std::string& key, Call call)
    {
        try
        {
            call();
        }
        catch (const std::runtime_error& error)
        {
            note(section, key, error.what());
        }
    }

    void note(const std::string& section, const std::string& key, const std::string& problem)
    {
        const int line = lineOf(section, key);
        problems_ += (problems_.empty() ? "" : "\n") + document_.fileName() +
                     (line > 0 ? ":" + std::to_string(line) : "") + ": " + section +
                     (key.empty() ? "" : "." + key) + ": " + problem;
    }

    void finish() const
    {
        if (!problems_.empty()) throw std::runtime_error(problems_);
    }

private:
    int lineOf(const std::string& name, const std::string& key) const
    {
        const IniSection* section = document_.find(name);
        if (section == nullptr) return 0;
        for (const IniEntry& entry : section->entries)
            if (entry.key == key) return entry.line;
        return section->line;
    }

    const IniDocument& document_;
    std::string problems_;
};

SweepGoal goalOf(const std::string& text)
{
    const std::size_t blank = std::min(text.find(' '), text.size());
    const std::string way = text.substr(0, blank);
    if (way != "max" && way != "min")
        throw std::runtime_error("expected 'max' or 'min' and a metric, found " + inQuotes(text));
    SweepGoal goal{std::string(trimmed(std::string_view(text).substr(blank))), way == "max"};
    checkMetricName(goal.metric);
    return goal;
}

// The goal's metric comes last where the list does not have it.
std::vector<std::string> metricsOf(const std::string& text)
{
    std::vector<std::string> metrics = split(text, ',');
    for (const std::string& metric : metrics) checkMetricName(metric);
    std::vector<std::string> sorted = metrics;
    std::sort(sorted.begin(), sorted.end());
    const auto twice = std::adjacent_find(sorted.begin(), sorted.end());
    if (twice != sorted.end()) throw std::runtime_error(inQuotes(*twice) + " stands twice");
    return metrics;
}

// The sections themselves, key by key.
SweepFile readSections(const IniDocument& document, VarySection& vary)
{
    SweepFile file;
    IniReader reader(document);
    reader.read("sweep", file.sweep);
    reader.read("slurm", file.slurm);
    if (const IniSection* section = document.find("vary")) vary.entries = section->entries;
    reader.read("vary", vary);
    for (const IniSection& section : document.sections())
    {
        if (!isGroup(section.name)) continue;
        RecordingGroup group;
        reader.read(section.name, group);
        group.name = std::string(trimmed(std::string_view(section.name).substr(kGroup.size())));
        for (const IniEntry& entry : section.entries)
            if (entry.key == "set") group.setLine = entry.line;
        file.groups.push_back(std::move(group));
    }
    // Named in messages about sections that are misspelt.
    RecordingGroup none;
    if (file.groups.empty()) reader.read(std::string(kGroup), none);
    reader.finish();
    return file;
}
}  // namespace

SweepFile readSweepFile(const std::filesystem::path& path)
{
    const IniDocument document = IniDocument::load(path);
    VarySection vary;
    SweepFile file = readSections(document, vary);
    file.path = path;
    Collector problems(document);
    if (file.groups.empty())
        problems.note("recordings", "", "name the rawlogs in a section [recordings]");
    for (const RecordingGroup& group : file.groups)
    {
        const std::string section =
            std::string(kGroup) + (group.name.empty() ? "" : " " + group.name);
        if (group.rawlogs.empty()) problems.note(section, "", "has no key rawlogs");
        if (group.frames.last != 0 && group.frames.last <= group.frames.first)
            problems.note(section, "last_frame", "is not behind first_frame: no frame is left");
    }
    if (vary.entries.empty())
        problems.note("vary", "", "name the keys to vary, as 'section.key = values'");
    for (const IniEntry& entry : vary.entries)
        problems.attempt(
            "vary", entry.key,
            [&] { file.keys.push_back(parseSweptKey(entry.key, entry.value, entry.line)); });
    problems.attempt("sweep", "metrics", [&] { file.metrics = metricsOf(file.sweep.metrics); });
    problems.attempt("sweep", "goal", [&] { file.goal = goalOf(file.sweep.goal); });
    problems.finish();
    if (std::find(file.metrics.begin(), file.metrics.end(), file.goal.metric) == file.metrics.end())
        file.metrics.push_back(file.goal.metric);
    return file;
}

}  // namespace vdamf
