// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "vdamf/simulation/scene.h"

namespace vdamf
{
/// What vehicles do not drive through.
inline bool isSolid(const SceneObject& object)
{
    return object.objectClass != ObjectClass::Bush && object.objectClass != ObjectClass::Tree;
}

}  // namespace vdamf
