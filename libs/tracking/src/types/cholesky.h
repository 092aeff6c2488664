// SPDX-License-Identifier: BSD-3-Clause
// Decomposition L D L^T of small symmetric matrices. Eigen's are loops over blocks, made for large
// ones; of known size and without roots all is straight arithmetic, in a third of the time.
#pragma once

#include <Eigen/Core>
#include <cmath>

namespace vdamf
{
template <int kSize>
class Cholesky
{
public:
    using Matrix = Eigen::Matrix<double, kSize, kSize>;
    using Vector = Eigen::Matrix<double, kSize, 1>;

    /// The lower half of the matrix is read.
    explicit Cholesky(const Matrix& a)
    {
#pragma GCC unroll 8
        for (int j = 0; j < kSize; ++j)
        {
            double pivot = a(j, j);
#pragma GCC unroll 8
            for (int k = 0; k < j; ++k) pivot -= l_[j][k] * l_[j][k] * pivots_[k];
            pivots_[j] = pivot;
            reciprocals_[j] = 1.0 / pivot;
#pragma GCC unroll 8
            for (int i = j + 1; i < kSize; ++i)
            {
                double sum = a(i, j);
#pragma GCC unroll 8
                for (int k = 0; k < j; ++k) sum -= l_[i][k] * l_[j][k] * pivots_[k];
                l_[i][j] = sum * reciprocals_[j];
            }
        }
    }

    bool isPositive() const
    {
        bool all = true;
        for (int k = 0; k < kSize; ++k) all = all && pivots_[k] > 0.0;
        return all;
    }

    double determinant() const
    {
        double product = 1.0;
        for (int k = 0; k < kSize; ++k) product *= pivots_[k];
        return product;
    }

    /// v^T A^-1 v.
    double squaredNorm(const Vector& v) const
    {
        const Vector u = forward(v);
        double sum = 0.0;
        for (int k = 0; k < kSize; ++k) sum += u(k) * u(k) * reciprocals_[k];
        return sum;
    }

    /// A^-1 v.
    Vector solve(const Vector& v) const
    {
        Vector u = forward(v);
#pragma GCC unroll 8
        for (int i = kSize - 1; i >= 0; --i)
        {
            u(i) *= reciprocals_[i];
#pragma GCC unroll 8
            for (int k = i + 1; k < kSize; ++k) u(i) -= l_[k][i] * u(k);
        }
        return u;
    }

    /// B A^-1.
    template <int kRows>
    Eigen::Matrix<double, kRows, kSize> solveFromRight(
        const Eigen::Matrix<double, kRows, kSize>& b) const
    {
        Eigen::Matrix<double, kRows, kSize> x = b;
#pragma GCC unroll 8
        for (int i = 0; i < kSize; ++i)
#pragma GCC unroll 8
            for (int k = 0; k < i; ++k) x.col(i) -= l_[i][k] * x.col(k);
#pragma GCC unroll 8
        for (int i = kSize - 1; i >= 0; --i)
        {
            x.col(i) *= reciprocals_[i];
#pragma GCC unroll 8
            for (int k = i + 1; k < kSize; ++k) x.col(i) -= l_[k][i] * x.col(k);
        }
        return x;
    }

private:
    // L^-1 v.
    Vector forward(const Vector& v) const
    {
        Vector u = v;
#pragma GCC unroll 8
        for (int i = 0; i < kSize; ++i)
#pragma GCC unroll 8
            for (int k = 0; k < i; ++k) u(i) -= l_[i][k] * u(k);
        return u;
    }

    double l_[kSize][kSize];  // below the diagonal
    double pivots_[kSize];
    double reciprocals_[kSize];
};

}  // namespace vdamf
