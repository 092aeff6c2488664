// SPDX-License-Identifier: BSD-3-Clause
// What a scenario file says of an object.
#pragma once

#include <string>

#include "vdamf/simulation/body.h"
#include "vdamf/tracking/types/options.h"

namespace vdamf
{
/// A section [object NAME].
struct ObjectOptions
{
    ObjectClass objectClass = ObjectClass::Car;
    double x = 0.0;        ///< centre of the box at the start, scene frame, m
    double y = 0.0;        ///< m
    double heading = 0.0;  ///< rad
    double length = 0.0;   ///< m, 0: typical of the class; so for width and height
    double width = 0.0;
    double height = 0.0;
    double speed = 0.0;  ///< m/s
    std::string segments;
    std::string towedBy;   ///< name of the object that tows it; empty: it drives by itself
    double drawbar = 1.5;  ///< from the towing object's rear to its front, m

    template <class Self, class Visitor>
    static void visit(Self& self, Visitor&& field)
    {
        field(self.objectClass, "class", "shape");
        field(self.x, "x_m", -1e5, 1e5, "centre of the box at the start, to the east");
        field(self.y, "y_m", -1e5, 1e5, "centre of the box at the start, to the north");
        field(self.heading, "heading_deg", -360.0, 360.0, "counter-clockwise from east");
        field(self.length, "length_m", 0.0, 500.0, "along the heading; 0: typical of the class");
        field(self.width, "width_m", 0.0, 500.0, "across; 0: typical of the class");
        field(self.height, "height_m", 0.0, 100.0, "0: typical of the class");
        field(self.speed, "speed_mps", -60.0, 60.0, "at the start");
        field(self.segments, "segments",
              "duration_s acceleration_mps2 curvature_1pm [curvature at the end] or manoeuvres, "
              "with commas between; straight on where empty");
        field(self.towedBy, "towed_by",
              "name of the object in front that tows it; then it has no motion of its own");
        field(self.drawbar, "drawbar_m", 0.1, 20.0,
              "from the rear of what tows it to its front; the hitch is at that rear");
    }
};

}  // namespace vdamf
