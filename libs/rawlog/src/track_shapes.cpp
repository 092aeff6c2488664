// SPDX-License-Identifier: BSD-3-Clause
#include "track_shapes.h"

#include <mrpt/opengl/CBox.h>
#include <mrpt/opengl/CSetOfLines.h>
#include <mrpt/opengl/CText.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace vdamf
{
mrpt::img::TColor colourOf(const TrackReport& track)
{
    const double hue = std::fmod(static_cast<double>(track.id) * 0.618033988749895, 1.0) * 6.0;
    const auto channel = [&](double shift)
    {
        const double k = std::fmod(shift + hue, 6.0);
        const double v = std::min(1.0, std::max(0.0, std::min(k, 4.0 - k)));
        return static_cast<std::uint8_t>(80 + 175 * (1.0 - v));
    };
    const std::uint8_t alpha = track.status == TrackStatus::Coasting ? 120 : 255;
    return {channel(5.0), channel(3.0), channel(1.0), alpha};
}

mrpt::opengl::CRenderizable::Ptr boxOf(const TrackReport& track)
{
    const double l = 0.5 * track.box.length;
    const double w = 0.5 * track.box.width;
    auto box = mrpt::opengl::CBox::Create(mrpt::math::TPoint3D(-l, -w, 0.0),
                                          mrpt::math::TPoint3D(l, w, std::max(0.1, track.height)),
                                          true, 2.0F);
    box->setColor_u8(colourOf(track));
    box->setBoxBorderColor(colourOf(track));
    box->setPose(mrpt::poses::CPose3D(track.box.x, track.box.y, track.z, track.box.heading, 0, 0));
    return box;
}

mrpt::opengl::CRenderizable::Ptr headingLine(const TrackReport& track)
{
    auto line = mrpt::opengl::CSetOfLines::Create();
    const double reach = 0.5 * track.box.length + 1.0;
    const double c = std::cos(track.box.heading);
    const double s = std::sin(track.box.heading);
    const double z = track.z + track.height;
    line->appendLine(track.box.x, track.box.y, z, track.box.x + reach * c, track.box.y + reach * s,
                     z);
    line->setColor_u8(colourOf(track));
    line->setLineWidth(2.0F);
    return line;
}

mrpt::opengl::CRenderizable::Ptr nameOf(const TrackReport& track)
{
    auto text = mrpt::opengl::CText::Create();
    text->setString(std::to_string(track.id));
    text->setColor_u8(colourOf(track));
    text->setLocation(track.box.x, track.box.y, track.z + track.height + 0.5);
    return text;
}
}  // namespace vdamf
