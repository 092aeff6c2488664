// SPDX-License-Identifier: BSD-3-Clause
#include "recordings.h"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <stdexcept>

#include "vdamf/evaluation/tables.h"

namespace vdamf
{
void checkFiles(const std::string& name, const std::filesystem::path& rawlog,
                const std::filesystem::path& truth)
{
    namingRecording(name,
                    [&]
                    {
                        if (!std::ifstream(rawlog))
                            throw std::runtime_error(rawlog.string() +
                                                     ": cannot read: " + std::strerror(errno));
                        if (readTruth(truth).empty())
                            throw std::runtime_error(
                                truth.string() + ": has no rows: nothing can be learned from it");
                    });
}

std::vector<Recording> readRecordings(const IniDocument& document)
{
    IniReader reader(document);
    std::vector<Recording> recordings = readRecordings<RecordingKeys>(reader, document);
    reader.finish();
    if (recordings.empty())
        throw std::runtime_error(document.fileName() +
                                 ": names no recordings: expected sections [recording NAME]");
    return recordings;
}

}  // namespace vdamf
