// SPDX-License-Identifier: BSD-3-Clause
// Numbers that are times of a recording.
#pragma once

namespace vdamf
{
/// The unit, in s, of a time since 1970. Its size tells: 1e8 s, 1e11 ms, 1e14 us and 1e17 ns are
/// all in 1973.
inline double secondsPerUnit(double time)
{
    if (time >= 1e17) return 1e-9;
    if (time >= 1e14) return 1e-6;
    if (time >= 1e11) return 1e-3;
    return 1.0;
}

/// From 0 (1970, or the begin of the recording) to what would be milliseconds. Earlier ones MRPT's
/// clock gives back as others.
inline bool isTimeInSeconds(double time)
{
    return time >= 0.0 && secondsPerUnit(time) == 1.0;
}

}  // namespace vdamf
