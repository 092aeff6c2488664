// SPDX-License-Identifier: BSD-3-Clause
// What a scenario file says of recorded traffic.
#pragma once

#include <string>

#include "vdamf/tracking/types/options.h"

namespace vdamf
{
/// Section [traffic].
struct TrafficOptions
{
    std::string argoverseLog;
    std::string table;
    double smoothing = 0.4;  ///< s

    template <class Self, class Visitor>
    static void visit(Self& self, Visitor&& field)
    {
        field(self.argoverseLog, "argoverse_log",
              "folder with annotations.csv and city_SE3_egovehicle.csv of Argoverse 2");
        field(self.table, "table", "truth.csv with objects, and the sensor as the platform");
        field(self.smoothing, "smoothing_s", 0.05, 5.0,
              "what moves faster than this is noise of the labels");
    }
};

}  // namespace vdamf
