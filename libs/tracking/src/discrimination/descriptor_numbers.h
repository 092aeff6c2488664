// SPDX-License-Identifier: BSD-3-Clause
// The descriptors one by one, as the pairs take them: names, knots, what each one needs.
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "discrimination/descriptors.h"
#include "discrimination/knots.h"

namespace vdamf
{
enum class Needs
{
    Nothing,
    Heights
};

/// Which others a descriptor makes pairs with.
enum class Role
{
    Core,   ///< with all
    Other,  ///< with all but the bands'
    Band    ///< of the hits at some height: with those of the core and of other bands
};

struct DescriptorNumber
{
    const char* name;
    Knots knots;
    Needs needs;
    Role role;
    std::optional<double> (*of)(const Descriptors&);
};

inline constexpr std::size_t kDescriptorNumbers = 46;

const std::array<DescriptorNumber, kDescriptorNumbers>& descriptorNumbers();

}  // namespace vdamf
