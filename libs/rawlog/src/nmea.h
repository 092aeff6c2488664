// SPDX-License-Identifier: BSD-3-Clause
// GPS sentences in the text that receivers send.
#pragma once

#include <mrpt/obs/CObservationGPS.h>

#include <optional>
#include <string_view>

namespace vdamf
{
/// `$GPRMC,...*hh` (also of other talkers than GP) with a right check sum; what stands behind it
/// does not count. Nothing for everything else, and for sentences without a position.
std::optional<mrpt::obs::gnss::Message_NMEA_RMC> rmcIn(std::string_view text);

/// `$GPGGA,...*hh`, likewise.
std::optional<mrpt::obs::gnss::Message_NMEA_GGA> ggaIn(std::string_view text);

}  // namespace vdamf
