// SPDX-License-Identifier: BSD-3-Clause
#include "scene_problems.h"

namespace vdamf
{
void SceneProblems::add(const std::string& section, const std::string& key, const std::string& what)
{
    const IniSection* const found = document_.find(section);
    const IniEntry* const entry = document_.find(section, key);
    const int line = entry != nullptr ? entry->line : found != nullptr ? found->line : 0;
    const std::string where =
        line > 0 ? document_.fileName() + ":" + std::to_string(line) : std::string("--set");
    text_ += (text_.empty() ? "" : "\n") + where + ": " + section + "." + key + ": " + what;
}

void SceneProblems::throwIfAny() const
{
    if (!text_.empty()) throw IniError(text_);
}

}  // namespace vdamf
