// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/tracking/estimation/vehicle_kalman_filter.h"

#include <mrpt/bayes/CKalmanFilterCapable.h>

#include <Eigen/Cholesky>
#include <array>

namespace vdamf
{
class VehicleKalmanFilter::Engine : public mrpt::bayes::CKalmanFilterCapable<7, 4, 0, 0>
{
public:
    explicit Engine(const MotionOptions& options)
        : options_(options),
          variableAxis_(options),
          steady_(steadyOptions(options)),
          independent_(options)
    {
        KF_options.method = mrpt::bayes::kfEKFNaive;
        KF_options.use_analytic_transition_jacobian = true;
        KF_options.use_analytic_observation_jacobian = true;
        KF_options.enable_profiler = false;
        m_xkk.resize(7);
        m_pkk.setSize(7, 7);
    }

    const MotionOptions& options() const { return options_; }

    VehicleState step(const VehicleState& state, double dt, const BoxMeasurement* measurement)
    {
        dt_ = dt;
        model_ = &modelFor(state.steering);
        measurement_ = measurement;
        m_xkk.asEigen() = state.mean;
        m_pkk.asEigen() = state.covariance;
        runOneKalmanIteration();
        VehicleState next = state;
        next.mean = m_xkk.asEigen();
        next.covariance = m_pkk.asEigen();
        return next;
    }

protected:
    void OnGetAction(KFArray_ACT&) const override {}

    void OnTransitionModel(const KFArray_ACT&, KFArray_VEH& x, bool& skip) const override
    {
        skip = dt_ == 0.0;
        if (!skip) x.asEigen() = model_->predicted(x.asEigen(), dt_);
    }

    void OnTransitionJacobian(KFMatrix_VxV& f) const override
    {
        f.asEigen() = model_->jacobian(m_xkk.asEigen(), dt_);
    }

    void OnTransitionNoise(KFMatrix_VxV& q) const override
    {
        q.asEigen() = model_->noise(m_xkk.asEigen(), dt_);
    }

    void OnGetObservationNoise(KFMatrix_OxO& r) const override
    {
        r.setIdentity();
        if (measurement_ == nullptr) return;
        r.asEigen() = measurement_->covariance.topLeftCorner<4, 4>();
        if (measurement_->lag == 0.0) return;
        const StateMatrix q = model_->noise(m_xkk.asEigen(), measurement_->lag);
        r.asEigen() += q(kMeasured, kMeasured);
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
        z[0].asEigen() = measurement_->box.head<4>();
    }

    void OnObservationModel(const std::vector<size_t>&,
                            vector_KFArray_OBS& predictions) const override
    {
        predictions.resize(1);
        predictions[0].asEigen() = stateWhenMeasured()(kMeasured);
    }

    void OnObservationJacobians(size_t, KFMatrix_OxV& hx, KFMatrix_OxF&) const override
    {
        const double lag = measurement_ != nullptr ? measurement_->lag : 0.0;
        hx.asEigen() = model_->jacobian(m_xkk.asEigen(), lag)(kMeasured, Eigen::indexing::all);
    }

    void OnSubstractObservationVectors(KFArray_OBS& a, const KFArray_OBS& b) const override
    {
        a.asEigen() -= b.asEigen();
        a[2] = wrapAngle(a[2]);
    }

    // Called after each prediction and update. MRPT's P = (I - K H) P loses symmetry by rounding.
    void OnNormalizeStateVector() override
    {
        m_xkk.asEigen() = model_->bounded(m_xkk.asEigen());
        m_pkk.asEigen() = (0.5 * (m_pkk.asEigen() + m_pkk.asEigen().transpose())).eval();
    }

private:
    static constexpr std::array<int, 4> kMeasured{kX, kY, kHeading, kLength};

    const MotionModel& modelFor(Steering steering) const
    {
        if (steering == Steering::Independent) return independent_;
        return steering == Steering::Steady ? steady_ : variableAxis_;
    }

    StateVector stateWhenMeasured() const
    {
        if (measurement_ == nullptr || measurement_->lag == 0.0) return m_xkk.asEigen();
        return model_->predicted(m_xkk.asEigen(), measurement_->lag);
    }

    MotionOptions options_;
    VariableAxisModel variableAxis_;
    VariableAxisModel steady_;
    IndependentModel independent_;
    const MotionModel* model_ = &variableAxis_;
    double dt_ = 0.0;
    const BoxMeasurement* measurement_ = nullptr;
};

VehicleKalmanFilter::VehicleKalmanFilter(const MotionOptions& options)
    : engine_(std::make_unique<Engine>(options))
{
}
VehicleKalmanFilter::~VehicleKalmanFilter() = default;
VehicleKalmanFilter::VehicleKalmanFilter(VehicleKalmanFilter&&) noexcept = default;
VehicleKalmanFilter& VehicleKalmanFilter::operator=(VehicleKalmanFilter&&) noexcept = default;

const MotionOptions& VehicleKalmanFilter::options() const
{
    return engine_->options();
}

VehicleState VehicleKalmanFilter::predict(const VehicleState& state, double dt)
{
    if (dt <= 0.0) return state;
    return engine_->step(state, dt, nullptr);
}

VehicleState VehicleKalmanFilter::update(const VehicleState& state,
                                         const BoxMeasurement& measurement)
{
    // The width that is known says where the centre is if only one side is seen.
    const BoxMeasurement centred = withKnown(measurement, 4, state.width, state.widthVariance);
    VehicleState next = engine_->step(state, 0.0, &centred);
    const double gain = state.widthVariance / (state.widthVariance + measurement.covariance(4, 4));
    next.width += gain * (measurement.box(4) - state.width);
    next.widthVariance *= 1.0 - gain;
    return next;
}

BoxMeasurement withKnown(const BoxMeasurement& measurement, Eigen::Index row, double value,
                         double variance)
{
    BoxMeasurement m = measurement;
    const Vector5d gain =
        measurement.covariance.col(row) / (measurement.covariance(row, row) + variance);
    m.box += gain * (value - measurement.box(row));
    m.covariance -= gain * measurement.covariance.row(row);
    return m;
}

double Innovation::nis() const
{
    return value.dot(covariance.ldlt().solve(value));
}

Innovation innovationOf(const VehicleState& state, const BoxMeasurement& measurement)
{
    Matrix5d p = Matrix5d::Zero();
    p.topLeftCorner<3, 3>() = state.covariance.topLeftCorner<3, 3>();
    p.block<3, 1>(0, 3) = state.covariance.block<3, 1>(0, kLength);
    p.block<1, 3>(3, 0) = state.covariance.block<1, 3>(kLength, 0);
    p(3, 3) = state.covariance(kLength, kLength);
    p(4, 4) = state.widthVariance;
    Vector5d difference;
    difference << measurement.box.head<3>() - state.mean.head<3>(),
        measurement.box.tail<2>() - state.size();
    difference(2) = wrapAngle(difference(2));
    // d (x, y of the fixed point, heading) / d (x, y, heading, length, width)
    const Eigen::Matrix2d r = rotation(state.mean(kHeading));
    const Eigen::Vector2d offset = 0.5 * measurement.fixedPoint.cwiseProduct(state.size());
    Eigen::Matrix<double, 3, 5> j = Eigen::Matrix<double, 3, 5>::Zero();
    j.leftCols<3>().setIdentity();
    j.block<2, 1>(0, 2) = r * Eigen::Vector2d(-offset.y(), offset.x());
    j.block<2, 2>(0, 3) = r * (0.5 * measurement.fixedPoint).asDiagonal();
    return {j * difference, j * (p + measurement.covariance) * j.transpose()};
}

}  // namespace vdamf
