// SPDX-License-Identifier: BSD-3-Clause
// From the sections of a scenario file to the scene.
#pragma once

#include <string>
#include <vector>

#include "vdamf/files/ini.h"
#include "vdamf/simulation/object_options.h"
#include "vdamf/simulation/scenario_options.h"
#include "vdamf/simulation/scene.h"
#include "vdamf/simulation/traffic_options.h"

namespace vdamf
{
struct NamedObject
{
    std::string section;
    std::string name;
    ObjectOptions options;
};

/// What the file says of objects.
struct ObjectSections
{
    std::vector<NamedObject> objects;  ///< all sections [object NAME], in the order of the file
    TrafficOptions traffic;            ///< section [traffic]
};

struct BuiltScene
{
    Scene scene;
    std::vector<std::string> warnings;  ///< what recorded traffic lost, each with its place
};

ObjectSections readObjects(const IniDocument& document, IniReader& reader);

/// The scene for times from 0 to `duration` in s. Throws IniError that lists what is wrong with
/// the parts, each with file, line and key.
BuiltScene buildScene(const IniDocument& document, const PlatformOptions& platform,
                      const ObjectSections& sections, double duration);

}  // namespace vdamf
