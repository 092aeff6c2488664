// SPDX-License-Identifier: BSD-3-Clause
// Whether a vehicle holds its speed better than traffic does, told by how well it was foretold.
#pragma once

namespace vdamf
{
/// Mean surprise (NIS per degree of freedom) of the hypothesis that a vehicle goes on as it is,
/// over the last seconds: the filter's covariance is matched to its innovations (Mehra 1972).
/// Nothing is known of a new vehicle, nor after some time of one that is not seen: then it is 1.
class Unrest
{
public:
    double value() const { return value_; }

    /// What is left of the changes of speed that vehicles in traffic make: share of their variance
    /// while they hold it, and of how often they begin. From 0.03 to 1.
    double calm() const;

    /// `dt` seconds later.
    Unrest later(double dt) const;
    /// After a measurement that surprised by so much (NIS per degree of freedom).
    Unrest after(double surprise) const;

private:
    double value_ = 1.0;
    double unmeasured_ = 0.0;  // s since the last measurement
};

}  // namespace vdamf
