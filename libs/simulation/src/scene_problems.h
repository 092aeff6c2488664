// SPDX-License-Identifier: BSD-3-Clause
// What is wrong with the values of a scenario file, collected.
#pragma once

#include <string>

#include "vdamf/files/ini.h"

namespace vdamf
{
class SceneProblems
{
public:
    explicit SceneProblems(const IniDocument& document) : document_(document) {}

    /// Notes "file:line: section.key: what", with the line of the key, else of its section.
    void add(const std::string& section, const std::string& key, const std::string& what);

    /// Throws IniError that lists them, if there are any.
    void throwIfAny() const;

private:
    const IniDocument& document_;
    std::string text_;
};

}  // namespace vdamf
