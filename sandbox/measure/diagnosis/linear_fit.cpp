#include "measure/diagnosis/linear_fit.h"

#include <cmath>
#include <cstddef>
#include <utility>

namespace sandbox {
namespace {

using Matrix = std::vector<std::vector<double>>;

/// Solves a x = b in place by elimination with pivoting; `a` is symmetric and positive.
std::vector<double> solved(Matrix a, std::vector<double> b) {
    const std::size_t n = b.size();
    for (std::size_t k = 0; k < n; ++k) {
        std::size_t pivot = k;
        for (std::size_t i = k + 1; i < n; ++i) {
            pivot = std::abs(a[i][k]) > std::abs(a[pivot][k]) ? i : pivot;
        }
        std::swap(a[k], a[pivot]);
        std::swap(b[k], b[pivot]);
        for (std::size_t i = k + 1; i < n; ++i) {
            const double factor = a[i][k] / a[k][k];
            for (std::size_t j = k; j < n; ++j) {
                a[i][j] -= factor * a[k][j];
            }
            b[i] -= factor * b[k];
        }
    }
    for (std::size_t k = n; k-- > 0;) {
        for (std::size_t j = k + 1; j < n; ++j) {
            b[k] -= a[k][j] * b[j];
        }
        b[k] /= a[k][k];
    }
    return b;
}

double product(const std::vector<double> &a, const std::vector<double> &b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        sum += a[i] * b[i];
    }
    return sum;
}

} // namespace

std::optional<std::vector<double>> fitted_factors(const std::vector<std::vector<double>> &columns,
                                                  const std::vector<double> &target) {
    const std::size_t n = columns.size();
    if (n == 0 || target.empty()) {
        return std::nullopt;
    }
    Matrix a(n, std::vector<double>(n));
    std::vector<double> b(n);
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = 0; j < n; ++j) {
            a[i][j] = product(columns[i], columns[j]);
        }
        b[i] = product(columns[i], target);
    }
    // A pull towards 1, a billionth of what the pictures say: it decides only where they say nothing.
    for (std::size_t i = 0; i < n; ++i) {
        const double pull = a[i][i] > 0 ? 1e-9 * a[i][i] : 1;
        a[i][i] += pull;
        b[i] += pull;
    }
    return solved(std::move(a), std::move(b));
}

} // namespace sandbox
