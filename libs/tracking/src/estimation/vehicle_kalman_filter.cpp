// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/tracking/estimation/vehicle_kalman_filter.h"

#include <mrpt/bayes/CKalmanFilterCapable.h>

#include <Eigen/Cholesky>
#include <array>

namespace vdamf
{
namespace
{
// The state with its length known apart from its motion: told from a point of the box, what else
// is known holds whatever the length is. Where a vehicle's heading jitters and its rear does not,
// motion seems to tell of a long way between the two; that is not believed.
VehicleState withLengthApart(const VehicleState& state, double fixedPoint)
{
    StateVector byLength = StateVector::Zero();
    byLength.head<2>() = -0.5 * fixedPoint * rotation(state.mean(kHeading)).col(0);
    if (state.steering != Steering::Independent) byLength(kAxis) = -0.5 * fixedPoint;
    byLength(kLength) = 1.0;
    StateMatrix apart = StateMatrix::Identity();  // all but the length, from that point
    apart.col(kLength) -= byLength;
    VehicleState next = state;
    next.covariance = apart * state.covariance * apart.transpose() +
                      state.covariance(kLength, kLength) * byLength * byLength.transpose();
    return next;
}
}  // namespace

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
        KF_options.use_analytic_observation_jacobian = true;
        KF_options.enable_profiler = false;
        m_xkk.resize(7);
        m_pkk.setSize(7, 7);
    }

    const MotionOptions& options() const { return options_; }

    // As MRPT's iteration predicts, without the innovation and the line for its log that it works
    // out even where nothing was measured.
    VehicleState predicted(const VehicleState& state, double dt) const
    {
        const MotionModel& model = modelFor(state.steering);
        const StateMatrix f = model.jacobian(state.mean, dt);
        const StateMatrix p = f * state.covariance * f.transpose() + model.noise(state.mean, dt);
        VehicleState next = state;
        next.mean = model.bounded(model.predicted(state.mean, dt));
        next.covariance = 0.5 * (p + p.transpose());
        return next;
    }

    VehicleState updated(const VehicleState& state, const BoxMeasurement& measurement)
    {
        model_ = &modelFor(state.steering);
        measurement_ = measurement;
        width_ = state.width;
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
        const StateMatrix q = model_->noise(m_xkk.asEigen(), measurement_.lag);
        const auto h = byBox(m_xkk[kHeading], m_xkk[kLength], width_);
        r.asEigen() += h * q(kMeasured, kMeasured) * h.transpose();
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
        predictions[0].asEigen() = pointOf(stateWhenMeasured()(kMeasured), width_);
    }

    void OnObservationJacobians(size_t, KFMatrix_OxV& hx, KFMatrix_OxF&) const override
    {
        const StateVector then = stateWhenMeasured();
        hx.asEigen() =
            byBox(then(kHeading), then(kLength), width_) *
            model_->jacobian(m_xkk.asEigen(), measurement_.lag)(kMeasured, Eigen::indexing::all);
    }

    void OnSubstractObservationVectors(KFArray_OBS& a, const KFArray_OBS& b) const override
    {
        a.asEigen() -= b.asEigen();
        a[2] = wrapAngle(a[2]);
    }

    // Called after each update. MRPT's P = (I - K H) P loses symmetry by rounding.
    void OnNormalizeStateVector() override
    {
        m_xkk.asEigen() = model_->bounded(m_xkk.asEigen());
        m_pkk.asEigen() = (0.5 * (m_pkk.asEigen() + m_pkk.asEigen().transpose())).eval();
    }

private:
    static constexpr std::array<int, 4> kMeasured{kX, kY, kHeading, kLength};

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
        return steering == Steering::Steady ? steady_ : variableAxis_;
    }

    StateVector stateWhenMeasured() const
    {
        if (measurement_.lag == 0.0) return m_xkk.asEigen();
        return model_->predicted(m_xkk.asEigen(), measurement_.lag);
    }

    MotionOptions options_;
    VariableAxisModel variableAxis_;
    VariableAxisModel steady_;
    IndependentModel independent_;
    const MotionModel* model_ = &variableAxis_;
    double width_ = 0.0;
    BoxMeasurement measurement_;
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
    return engine_->predicted(state, dt);
}

VehicleState VehicleKalmanFilter::update(const VehicleState& state,
                                         const BoxMeasurement& measurement)
{
    // The width that is known says where the centre is if only one side is seen.
    const BoxMeasurement centred = withKnown(measurement, 4, state.width, state.widthVariance);
    VehicleState next =
        engine_->updated(withLengthApart(state, measurement.fixedPoint.x()), centred);
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
