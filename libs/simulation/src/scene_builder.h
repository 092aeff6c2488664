// SPDX-License-Identifier: BSD-3-Clause
// From the sections of a scenario file to the scene.
#pragma once

#include <string>
#include <vector>

#include "vdamf/files/ini.h"
#include "vdamf/simulation/object_options.h"
#include "vdamf/simulation/scenario_options.h"
#include "vdamf/simulation/scene.h"

namespace vdamf
{
struct NamedObject
{
    std::string section;
    std::string name;
    ObjectOptions options;
};

/// All sections [object NAME], in the order of the file.
std::vector<NamedObject> readObjects(const IniDocument& document, IniReader& reader);

/// Throws IniError that lists what is wrong with the parts, each with file, line and key.
Scene buildScene(const IniDocument& document, const PlatformOptions& platform,
                 const std::vector<NamedObject>& objects);

}  // namespace vdamf
