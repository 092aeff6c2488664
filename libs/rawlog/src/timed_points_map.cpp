// SPDX-License-Identifier: BSD-3-Clause
#include "timed_points_map.h"

#include <mrpt/serialization/CArchive.h>

#include <stdexcept>
#include <string>

namespace vdamf
{
namespace
{
using mrpt::maps::CPointsMapXYZI;
using mrpt::rtti::TRuntimeClassId;
using mrpt::serialization::CArchive;

const TRuntimeClassId& classId()
{
    static const TRuntimeClassId id{
        "mrpt::maps::CPointsMapXYZIRT",
        []() -> std::shared_ptr<mrpt::rtti::CObject> { return std::make_shared<TimedPointsMap>(); },
        []() -> const TRuntimeClassId* { return &CPointsMapXYZI::GetRuntimeClassIdStatic(); }};
    return id;
}

template <class Values>
void write(CArchive& out, const Values& values)
{
    out.WriteAs<std::uint32_t>(values.size());
    if (!values.empty()) out.WriteBufferFixEndianness(values.data(), values.size());
}

/// As many values as points, or none.
template <class Values>
bool read(CArchive& in, Values& values, std::size_t points)
{
    const auto count = in.ReadAs<std::uint32_t>();
    if (count != 0 && count != points)
        throw std::runtime_error("a cloud of " + std::to_string(points) + " points has " +
                                 std::to_string(count) + " values of a field");
    values.resize(count);
    if (count > 0) in.ReadBufferFixEndianness(values.data(), count);
    return count > 0;
}
}  // namespace

void TimedPointsMap::registerClass()
{
    if (mrpt::rtti::findRegisteredClass(classId().className) == nullptr)
        mrpt::rtti::registerClass(&classId());
}

const TRuntimeClassId* TimedPointsMap::GetRuntimeClass() const
{
    return &classId();
}

void TimedPointsMap::serializeTo(CArchive& out) const
{
    write(out, m_x);
    for (const auto* values : {&m_y, &m_z})
        if (!values->empty()) out.WriteBufferFixEndianness(values->data(), values->size());
    if (hasIntensities_)
        write(out, m_intensity);
    else
        out.WriteAs<std::uint32_t>(0);
    write(out, rings_);
    write(out, times_);
    insertionOptions.writeToStream(out);
    likelihoodOptions.writeToStream(out);
}

void TimedPointsMap::serializeFrom(CArchive& in, std::uint8_t version)
{
    if (version != 0)
        throw std::runtime_error("CPointsMapXYZIRT of version " + std::to_string(version) +
                                 ", known is 0");
    mark_as_modified();
    const auto points = in.ReadAs<std::uint32_t>();
    for (auto* values : {&m_x, &m_y, &m_z})
    {
        values->resize(points);
        if (points > 0) in.ReadBufferFixEndianness(values->data(), points);
    }
    hasIntensities_ = read(in, m_intensity, points);
    read(in, rings_, points);
    read(in, times_, points);
    m_intensity.resize(points);
    insertionOptions.readFromStream(in);
    likelihoodOptions.readFromStream(in);
}

}  // namespace vdamf
