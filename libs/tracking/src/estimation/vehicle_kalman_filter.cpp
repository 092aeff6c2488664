// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/tracking/estimation/vehicle_kalman_filter.h"

#include <mrpt/bayes/CKalmanFilterCapable.h>

#include <Eigen/Cholesky>

namespace vdamf
{
class VehicleKalmanFilter::Engine : public mrpt::bayes::CKalmanFilterCapable<6, 3, 0, 0>
{
public:
    explicit Engine(const MotionOptions& options) : options_(options)
    {
        KF_options.method = mrpt::bayes::kfEKFNaive;
        KF_options.use_analytic_transition_jacobian = true;
        KF_options.use_analytic_observation_jacobian = true;
        KF_options.enable_profiler = false;
        m_xkk.resize(6);
        m_pkk.setSize(6, 6);
    }

    VehicleState step(const VehicleState& state, double dt, const PoseMeasurement* measurement,
                      double length)
    {
        dt_ = dt;
        measurement_ = measurement;
        length_ = length;
        m_xkk.asEigen() = state.mean;
        m_pkk.asEigen() = state.covariance;
        runOneKalmanIteration();
        VehicleState next;
        next.mean = m_xkk.asEigen();
        next.covariance = m_pkk.asEigen();
        return next;
    }

protected:
    void OnGetAction(KFArray_ACT&) const override {}

    void OnTransitionModel(const KFArray_ACT&, KFArray_VEH& x, bool& skip) const override
    {
        skip = dt_ == 0.0;
        if (!skip) x.asEigen() = predictState(x.asEigen(), dt_, length_, options_);
    }

    void OnTransitionJacobian(KFMatrix_VxV& f) const override
    {
        f.asEigen() = transitionJacobian(m_xkk.asEigen(), dt_, options_);
    }

    void OnTransitionNoise(KFMatrix_VxV& q) const override
    {
        q.asEigen() = processNoise(m_xkk.asEigen(), dt_, options_);
    }

    void OnGetObservationNoise(KFMatrix_OxO& r) const override
    {
        if (measurement_ != nullptr)
            r.asEigen() = measurement_->covariance;
        else
            r.setIdentity();
    }

    void OnGetObservationsAndDataAssociation(vector_KFArray_OBS& z, std::vector<int>& association,
                                             const vector_KFArray_OBS&, const KFMatrix&,
                                             const std::vector<size_t>&,
                                             const KFMatrix_OxO&) override
    {
        association.clear();
        z.clear();
        if (measurement_ == nullptr) return;
        z.resize(1);
        z[0].asEigen() = measurement_->pose;
    }

    void OnObservationModel(const std::vector<size_t>&,
                            vector_KFArray_OBS& predictions) const override
    {
        predictions.resize(1);
        predictions[0].asEigen() = m_xkk.asEigen().head<3>();
    }

    void OnObservationJacobians(size_t, KFMatrix_OxV& hx, KFMatrix_OxF&) const override
    {
        hx.setZero();
        hx.asEigen().leftCols<3>().setIdentity();
    }

    void OnSubstractObservationVectors(KFArray_OBS& a, const KFArray_OBS& b) const override
    {
        a.asEigen() -= b.asEigen();
        a[2] = wrapAngle(a[2]);
    }

    // Called after each prediction and update. MRPT's P = (I - K H) P loses symmetry by rounding.
    void OnNormalizeStateVector() override
    {
        m_xkk.asEigen() = withinBounds(m_xkk.asEigen(), length_, options_);
        m_pkk.asEigen() = (0.5 * (m_pkk.asEigen() + m_pkk.asEigen().transpose())).eval();
    }

private:
    MotionOptions options_;
    double dt_ = 0.0;
    double length_ = 0.0;
    const PoseMeasurement* measurement_ = nullptr;
};

VehicleKalmanFilter::VehicleKalmanFilter(const MotionOptions& options)
    : engine_(std::make_unique<Engine>(options))
{
}
VehicleKalmanFilter::~VehicleKalmanFilter() = default;
VehicleKalmanFilter::VehicleKalmanFilter(VehicleKalmanFilter&&) noexcept = default;
VehicleKalmanFilter& VehicleKalmanFilter::operator=(VehicleKalmanFilter&&) noexcept = default;

VehicleState VehicleKalmanFilter::predict(const VehicleState& state, double dt, double length)
{
    if (dt <= 0.0) return state;
    return engine_->step(state, dt, nullptr, length);
}

UpdatedState VehicleKalmanFilter::update(const VehicleState& state,
                                         const PoseMeasurement& measurement, double length)
{
    UpdatedState updated;
    updated.innovation = innovationOf(state, measurement);
    updated.nis = nisOf(state, measurement);
    updated.state = engine_->step(state, 0.0, &measurement, length);
    return updated;
}

Eigen::Vector3d innovationOf(const VehicleState& state, const PoseMeasurement& measurement)
{
    Eigen::Vector3d innovation = measurement.pose - state.mean.head<3>();
    innovation(2) = wrapAngle(innovation(2));
    return innovation;
}

double nisOf(const VehicleState& state, const PoseMeasurement& measurement)
{
    const Eigen::Matrix3d s = state.covariance.topLeftCorner<3, 3>() + measurement.covariance;
    const Eigen::Vector3d innovation = innovationOf(state, measurement);
    return innovation.dot(s.ldlt().solve(innovation));
}

}  // namespace vdamf
