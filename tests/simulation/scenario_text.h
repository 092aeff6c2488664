// SPDX-License-Identifier: BSD-3-Clause
// Scenarios from text, and what is said where they are wrong.
#pragma once

#include <string>

#include "vdamf/files/ini.h"
#include "vdamf/simulation/scenario.h"

namespace vdamf
{
inline Scenario scenarioOf(const std::string& text)
{
    return readScenario(IniDocument::parse(text, "small.ini"));
}

inline std::string errorOf(const std::string& text)
{
    try
    {
        scenarioOf(text);
    }
    catch (const IniError& error)
    {
        return error.what();
    }
    return "no error";
}

}  // namespace vdamf
