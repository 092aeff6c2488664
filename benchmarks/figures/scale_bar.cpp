// SPDX-License-Identifier: BSD-3-Clause
#include "figures/scale_bar.h"

#include "vdamf/files/numbers.h"

namespace vdamf
{
std::string scaleBar(double endX, double y, double scale, double length_m)
{
    const std::string end = toFixedText(endX, 1);
    const std::string at = toFixedText(y, 1);
    return "<path stroke=\"black\" stroke-width=\"2\" d=\"M" +
           toFixedText(endX - scale * length_m, 1) + " " + at + "L" + end + " " + at +
           "\"/>\n<text text-anchor=\"end\" x=\"" + end + "\" y=\"" + toFixedText(y - 5.0, 1) +
           "\">" + toText(length_m) + " m</text>\n";
}

}  // namespace vdamf
