// SPDX-License-Identifier: BSD-3-Clause
// Line scanners after their data sheets.
#pragma once

#include "vdamf/simulation/spinning_ladar.h"

namespace vdamf
{
SpinningLadar lms291();
SpinningLadar lms511();

/// The shots of one turn of the mirror that lie in the field of view.
Sweep lineSweep(const SpinningLadar& ladar, double fieldOfView);

}  // namespace vdamf
