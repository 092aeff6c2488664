// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/tracking/estimation/vehicle_kalman_filter.h"

#include <mrpt/system/COutputLogger.h>

// The template puts a line for its log together at each update, whether anyone reads it or not:
// a seventh of its time.
#pragma push_macro("MRPT_LOG_DEBUG")
#undef MRPT_LOG_DEBUG
#define MRPT_LOG_DEBUG(line) static_cast<void>(0)
#include <mrpt/bayes/CKalmanFilterCapable.h>
#pragma pop_macro("MRPT_LOG_DEBUG")

#include <algorithm>
#include <array>
#include <type_traits>
#include <utility>

#include "estimation/fixed_point.h"
#include "estimation/length_apart.h"
#include "estimation/transition.h"
#include "types/cholesky.h"

namespace mrpt::math
{
// H P H^T + R as the template writes it, of which it then asks for one element after the other: all
// of them were worked out each time, two fifths of an update.
using EigenSquare = decltype(std::declval<CMatrixFixed<double, 4, 4>&>().asEigen());
using EigenMatrix = decltype(std::declval<CMatrixDynamic<double>&>().asEigen());
using InnovationSum =
    std::remove_const_t<decltype(std::declval<EigenSquare>() * std::declval<EigenMatrix>() *
                                     std::declval<EigenSquare>().transpose() +
                                 std::declval<EigenSquare>())>;

template <>
template <>
inline void CMatrixDynamic<double>::setFromMatrixLike(const Eigen::MatrixBase<InnovationSum>& sum)
{
    setSize(sum.rows(), sum.cols());
    asEigen() = sum;
}
}  // namespace mrpt::math

namespace vdamf
{
namespace
{
// Rows that are measured.
constexpr std::array<int, 4> kMeasured{kX, kY, kHeading, kLength};

// Of speed times curvature, what a linear model leaves out: of a new vehicle neither is known, and
// it may turn. (rad/s)^2
double yawRateVarianceBySecondOrder(const VehicleState& state)
{
    constexpr double kMost = 0.3;  // rad/s, vehicles turn no faster
    const StateMatrix& p = state.covariance;
    const double variance = p(kSpeed, kSpeed) * p(kCurvature, kCurvature) +
                            p(kSpeed, kCurvature) * p(kSpeed, kCurvature);
    return std::min(variance, kMost * kMost);
}

constexpr double kNowhere = 10.0;  // m
}  // namespace

// The part of a state that is measured, when it is measured: pose and length of a box. MRPT's
// template works with matrices of any size; with four rows instead of seven it takes half as long.
class VehicleKalmanFilter::Engine : public mrpt::bayes::CKalmanFilterCapable<4, 4, 0, 0>
{
public:
    explicit Engine(const MotionOptions& options)
        : options_(options),
          variableAxis_(options),
          turning_(optionsOf(Steering::Turning, options)),
          steady_(optionsOf(Steering::Steady, options)),
          independent_(options)
    {
        KF_options.method = mrpt::bayes::kfEKFNaive;
        KF_options.use_analytic_observation_jacobian = true;
        KF_options.enable_profiler = false;
        m_xkk.resize(4);
        m_pkk.setSize(4, 4);
    }

    const MotionOptions& options() const { return options_; }

    // As MRPT's iteration predicts, without the innovation and the line for its log that it works
    // out even where nothing was measured.
    VehicleState predicted(const VehicleState& state, double dt, double calm) const
    {
        const MotionModel& usual = modelFor(state.steering);
        const VariableAxisModel calmer(optionsOf(state.steering, options_, calm));
        const bool isCalmer = calm < 1.0 && state.steering != Steering::Independent;
        const MotionModel& model = isCalmer ? calmer : usual;
        VehicleState next = transitioned(model, state, dt);
        next.mean = model.bounded(next.mean);
        const StateMatrix p = next.covariance;
        next.covariance = 0.5 * (p + p.transpose());
        if (state.steering != Steering::Independent)
            next.covariance(kHeading, kHeading) += dt * dt * yawRateVarianceBySecondOrder(state);
        return next;
    }

    // The rows that are not measured follow those that are by their covariance.
    VehicleState updated(const VehicleState& state, const BoxMeasurement& measurement)
    {
        const MotionModel& model = modelFor(state.steering);
        Eigen::Matrix<double, 7, 4> withMeasured =
            state.covariance(Eigen::indexing::all, kMeasured);
        Eigen::Vector4d mean = state.mean(kMeasured);
        Eigen::Matrix4d covariance = withMeasured(kMeasured, Eigen::indexing::all);
        meanwhile_.setZero();
        if (measurement.lag != 0.0)
        {
            const Eigen::Matrix<double, 4, 7> f =
                model.jacobian(state.mean, measurement.lag)(kMeasured, Eigen::indexing::all);
            withMeasured = state.covariance * f.transpose();
            mean = model.predicted(state.mean, measurement.lag)(kMeasured);
            covariance = f * withMeasured;
            meanwhile_ = model.noise(state.mean, measurement.lag)(kMeasured, kMeasured);
        }
        measurement_ = measurement;
        width_ = state.width;
        m_xkk.asEigen() = mean;
        m_pkk.asEigen() = covariance;
        runOneKalmanIteration();

        const Eigen::Matrix<double, 7, 4> follow =
            Cholesky<4>(covariance).solveFromRight<7>(withMeasured);
        const Eigen::Matrix4d less = covariance - m_pkk.asEigen();
        const StateMatrix p = state.covariance - follow * less * follow.transpose();
        VehicleState next = state;
        next.mean = model.bounded(state.mean + follow * (m_xkk.asEigen() - mean));
        next.covariance = 0.5 * (p + p.transpose());
        return next;
    }

protected:
    void OnGetAction(KFArray_ACT&) const override {}

    // The time before the measurement has passed already, see predicted().
    void OnTransitionModel(const KFArray_ACT&, KFArray_VEH&, bool& skip) const override
    {
        skip = true;
    }
    void OnTransitionNoise(KFMatrix_VxV& q) const override { q.setZero(); }

    void OnGetObservationNoise(KFMatrix_OxO& r) const override
    {
        const auto toPoint = byBox(measurement_.box(2), measurement_.box(3), measurement_.box(4));
        Eigen::Matrix<double, 4, 5> j = Eigen::Matrix<double, 4, 5>::Zero();
        j.leftCols<4>() = toPoint;
        j.block<2, 1>(0, 4) =
            0.5 * measurement_.fixedPoint.y() * rotation(measurement_.box(2)).col(1);
        r.asEigen() = j * measurement_.covariance * j.transpose();
        if (measurement_.lag == 0.0) return;
        const auto h = byBox(m_xkk[2], m_xkk[3], width_);
        r.asEigen() += h * meanwhile_ * h.transpose();
    }

    void OnGetObservationsAndDataAssociation(vector_KFArray_OBS& z, std::vector<int>& association,
                                             const vector_KFArray_OBS&, const KFMatrix&,
                                             const std::vector<size_t>&,
                                             const KFMatrix_OxO&) override
    {
        association.clear();
        z.clear();
        z.resize(1);
        const Vector5d& box = measurement_.box;
        z[0].asEigen() = pointOf(box.head<4>(), box(4));
    }

    void OnObservationModel(const std::vector<size_t>&,
                            vector_KFArray_OBS& predictions) const override
    {
        predictions.resize(1);
        predictions[0].asEigen() = pointOf(m_xkk.asEigen(), width_);
    }

    void OnObservationJacobians(size_t, KFMatrix_OxV& hx, KFMatrix_OxF&) const override
    {
        hx.asEigen() = byBox(m_xkk[2], m_xkk[3], width_);
    }

    void OnSubstractObservationVectors(KFArray_OBS& a, const KFArray_OBS& b) const override
    {
        a.asEigen() -= b.asEigen();
        a[2] = wrapAngle(a[2]);
    }

private:
    // What is observed is the fixed point: it is known where the centre is not, whatever the
    // headings of box and state.
    Eigen::Vector2d offset(double length, double width) const
    {
        return 0.5 * measurement_.fixedPoint.cwiseProduct(Eigen::Vector2d(length, width));
    }

    // Fixed point, heading and length of a box (x, y, heading, length).
    Eigen::Vector4d pointOf(const Eigen::Vector4d& box, double width) const
    {
        Eigen::Vector4d point = box;
        point.head<2>() += rotation(box(2)) * offset(box(3), width);
        return point;
    }

    // d pointOf / d (x, y, heading, length).
    Eigen::Matrix4d byBox(double heading, double length, double width) const
    {
        const Eigen::Matrix2d r = rotation(heading);
        const Eigen::Vector2d at = offset(length, width);
        Eigen::Matrix4d j = Eigen::Matrix4d::Identity();
        j.block<2, 1>(0, 2) = r * Eigen::Vector2d(-at.y(), at.x());
        j.block<2, 1>(0, 3) = 0.5 * measurement_.fixedPoint.x() * r.col(0);
        return j;
    }

    const MotionModel& modelFor(Steering steering) const
    {
        if (steering == Steering::Independent) return independent_;
        if (steering == Steering::Turning) return turning_;
        return steering == Steering::Steady ? steady_ : variableAxis_;
    }

    MotionOptions options_;
    VariableAxisModel variableAxis_;
    VariableAxisModel turning_;
    VariableAxisModel steady_;
    IndependentModel independent_;
    BoxMeasurement measurement_;
    double width_ = 0.0;
    Eigen::Matrix4d meanwhile_ = Eigen::Matrix4d::Zero();  // noise until it is measured
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

VehicleState VehicleKalmanFilter::predict(const VehicleState& state, double dt, double calm)
{
    if (dt <= 0.0) return state;
    return engine_->predicted(state, dt, calm);
}

VehicleState VehicleKalmanFilter::update(const VehicleState& state,
                                         const BoxMeasurement& measurement)
{
    // The width that is known says where the centre is if only one side is seen.
    const BoxMeasurement centred = withKnown(measurement, 4, state.width, state.widthVariance);
    // What stands keeps what is known of its other end where the place of that point along the box
    // is not told.
    const bool mayMove = state.covariance(kSpeed, kSpeed) > 0.0;
    const bool isApart = mayMove || covarianceAtFixedPoint(measurement)(0, 0) < kNowhere * kNowhere;
    VehicleState next = engine_->updated(
        isApart ? withLengthApart(state, measurement.fixedPoint.x()) : state, centred);
    const double gain = state.widthVariance / (state.widthVariance + measurement.covariance(4, 4));
    const double wider = gain * (measurement.box(4) - state.width);
    // What was observed stays where it is: the centre is farther from it, or nearer.
    next.mean.head<2>() -=
        0.5 * measurement.fixedPoint.y() * wider * rotation(next.mean(kHeading)).col(1);
    next.width += wider;
    next.widthVariance *= 1.0 - gain;
    return next;
}

}  // namespace vdamf
