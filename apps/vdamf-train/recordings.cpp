// SPDX-License-Identifier: BSD-3-Clause
#include "recordings.h"

#include <stdexcept>

namespace vdamf
{
namespace
{
const std::string kPrefix = "recording ";
}

std::vector<Recording> readRecordings(const IniDocument& document)
{
    IniReader reader(document);
    std::vector<Recording> recordings;
    const std::filesystem::path folder = std::filesystem::path(document.fileName()).parent_path();
    for (const IniSection& section : document.sections())
    {
        if (section.name.rfind(kPrefix, 0) != 0) continue;
        Recording r;
        r.name = section.name.substr(kPrefix.size());
        reader.read(section.name, r.options);
        reader.require(!r.options.rawlog.empty(),
                       "[" + section.name + "] names no rawlog: add 'rawlog = ...'");
        reader.require(!r.options.truth.empty(),
                       "[" + section.name + "] names no truth: add 'truth = ...'");
        r.rawlog = folder / r.options.rawlog;
        r.truth = folder / r.options.truth;
        recordings.push_back(r);
    }
    reader.finish();
    if (recordings.empty())
        throw std::runtime_error(document.fileName() +
                                 ": names no recordings: expected sections [recording NAME]");
    return recordings;
}

}  // namespace vdamf
