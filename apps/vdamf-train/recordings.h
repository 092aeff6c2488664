// SPDX-License-Identifier: BSD-3-Clause
// What to train on: an ini file with a section [recording NAME] for each recording.
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "vdamf/files/ini.h"

namespace vdamf
{
enum class RecordingUse
{
    Train,
    Test  ///< never trained on: told how well the model does there
};

template <>
struct EnumNames<RecordingUse>
{
    static std::vector<std::pair<RecordingUse, const char*>> names()
    {
        return {{RecordingUse::Train, "train"}, {RecordingUse::Test, "test"}};
    }
};

/// Section [recording NAME].
struct RecordingKeys
{
    std::string rawlog;
    std::string truth;
    RecordingUse use = RecordingUse::Train;
    std::string scene;
    double regionFov = 0.0;  ///< rad
    double maxRange = 0.0;   ///< m
    int minPoints = 10;
    int weight = 1;

    template <class Self, class Visitor>
    static void visit(Self& self, Visitor&& field)
    {
        field(self.rawlog, "rawlog", "from the folder of this file, of --set from the current one");
        field(self.truth, "truth", "its truth.csv");
        field(self.use, "use", "what it is for");
        field(self.scene, "scene",
              "recordings of one scene are never split between training and test; empty: tracks "
              "are split");
        field(self.regionFov, "region_fov_deg", 0.0, 360.0,
              "labelled sector ahead of the sensor; 0: all around");
        field(self.maxRange, "max_range_m", 0.0, 1e4, "labelled range; 0: all");
        field(self.minPoints, "min_points", 0, 1000000, "vehicles with fewer hits are left out");
        field(self.weight, "weight", 1, 1000,
              "how many times its frames count in training and calibration; results count once");
    }
};

/// `Options`: RecordingKeys, or with more keys.
template <class Options>
struct RecordingWith
{
    std::string name;
    std::filesystem::path rawlog;
    std::filesystem::path truth;
    Options options;
};

using Recording = RecordingWith<RecordingKeys>;

/// All sections [recording NAME]. Throws IniError or std::runtime_error that names file and
/// section.
template <class Options>
std::vector<RecordingWith<Options>> readRecordings(IniReader& reader, const IniDocument& document)
{
    const std::string prefix = "recording ";
    std::vector<RecordingWith<Options>> recordings;
    for (const IniSection& section : document.sections())
    {
        if (section.name.rfind(prefix, 0) != 0) continue;
        RecordingWith<Options> r;
        r.name = section.name.substr(prefix.size());
        reader.read(section.name, r.options);
        reader.require(!r.options.rawlog.empty(),
                       "[" + section.name + "] names no rawlog: add 'rawlog = ...'");
        reader.require(!r.options.truth.empty(),
                       "[" + section.name + "] names no truth: add 'truth = ...'");
        r.rawlog = document.fileOf(section.name, "rawlog", r.options.rawlog);
        r.truth = document.fileOf(section.name, "truth", r.options.truth);
        recordings.push_back(std::move(r));
    }
    return recordings;
}

/// Throws std::runtime_error that names the recording where a file cannot be read or the truth has
/// no rows: before others are worked on for long.
void checkFiles(const std::string& name, const std::filesystem::path& rawlog,
                const std::filesystem::path& truth);

template <class Options>
void checkFiles(const std::vector<RecordingWith<Options>>& recordings)
{
    for (const RecordingWith<Options>& r : recordings) checkFiles(r.name, r.rawlog, r.truth);
}

/// What `work` throws, with the recording's name before it.
template <class Work>
auto namingRecording(const std::string& name, const Work& work)
{
    try
    {
        return work();
    }
    catch (const std::runtime_error& error)
    {
        throw std::runtime_error("recording " + name + ": " + error.what());
    }
}

/// A list of nothing else, with one at least. Throws as above.
std::vector<Recording> readRecordings(const IniDocument& document);

}  // namespace vdamf
