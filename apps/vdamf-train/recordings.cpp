// SPDX-License-Identifier: BSD-3-Clause
#include "recordings.h"

#include <stdexcept>

namespace vdamf
{
std::vector<Recording> readRecordings(const IniDocument& document)
{
    IniReader reader(document);
    std::vector<Recording> recordings = readRecordings<RecordingOptions>(reader, document);
    reader.finish();
    if (recordings.empty())
        throw std::runtime_error(document.fileName() +
                                 ": names no recordings: expected sections [recording NAME]");
    return recordings;
}

}  // namespace vdamf
