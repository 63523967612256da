#include "core/fit/ceres.h"

#include <ceres/ceres.h>
#include <glog/logging.h>

#include <Eigen/SVD>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <vector>

namespace
{

/* Ceres reports through glog, which prints: only what ends the program is let through. */
class Silence
{
  public:
    Silence() : before(FLAGS_minloglevel) { FLAGS_minloglevel = google::GLOG_FATAL; }
    ~Silence() { FLAGS_minloglevel = before; }

  private:
    int before;
};

class Reduced : public ceres::CostFunction
{
  public:
    Reduced(int unknowns, int rows, fit_function f, void *c) : function(f), context(c)
    {
        set_num_residuals(rows);
        mutable_parameter_block_sizes()->push_back(unknowns);
    }
    bool Evaluate(double const *const *theta, double *residuals, double **jacobians) const override
    {
        return function(context, theta[0], residuals, jacobians ? jacobians[0] : nullptr) != 0;
    }

  private:
    fit_function function;
    void *context;
};

int report(const ceres::Solver::Summary &summary, fit_outcome *outcome)
{
    outcome->termination = summary.termination_type == ceres::CONVERGENCE      ? CAGD_FIT_CONVERGED
                           : summary.termination_type == ceres::NO_CONVERGENCE ? CAGD_FIT_NOT_CONVERGED
                                                                               : CAGD_FIT_FAILED;
    std::strncpy(outcome->message, summary.message.c_str(), sizeof outcome->message - 1);
    outcome->message[sizeof outcome->message - 1] = 0;
    size_t steps = summary.iterations.size();
    outcome->history = static_cast<cagd_fit_step *>(std::malloc((steps + 1) * sizeof *outcome->history));
    if (outcome->history == nullptr)
        return 0;
    outcome->steps = static_cast<int>(steps);
    outcome->iterations = std::max(0, outcome->steps - 1);
    for (size_t i = 0; i < steps; i++) {
        const ceres::IterationSummary &s = summary.iterations[i];
        outcome->history[i] = {s.iteration, s.step_is_successful || i == 0, s.cost, s.gradient_max_norm,
                               s.step_norm, s.trust_region_radius};
    }
    return 1;
}

ceres::Solver::Options quiet(double tolerance, int max_iterations)
{
    ceres::Solver::Options options;
    options.logging_type = ceres::SILENT;
    options.minimizer_progress_to_stdout = false;
    options.function_tolerance = tolerance;
    options.gradient_tolerance = tolerance;
    options.parameter_tolerance = tolerance;
    options.max_num_iterations = max_iterations;
    return options;
}

/* Point i: (Q - C(t; theta))/sigma. */
class Distance
{
  public:
    Distance(const fit_problem &p, const fit_curve &c, int i)
        : problem(p), curve(c), q(p.Q + static_cast<size_t>(i) * static_cast<size_t>(p.dim)), precision(p.precision[i])
    {
    }

    /* As AutoDiffCostFunction and as DynamicAutoDiffCostFunction call it. */
    template <typename T> bool operator()(const T *theta, const T *t, T *residuals) const
    {
        int degree = curve.degree, dim = curve.dim, piece = fit_curve_piece(&curve, value(*t));
        int mu = curve.span[piece], low = mu - degree;
        const double *u = curve.knots;
        T N[65], w[65], P[65 * 3], total(0.0), sum[3] = {T(0.0), T(0.0), T(0.0)};
        for (int m = 0; m <= degree; m++) {
            w[m] = T(curve.weights[low + m]);
            for (int c = 0; c < dim; c++)
                P[m * dim + c] = T(curve.points[(low + m) * dim + c]);
        }
        for (int j = problem.first[piece]; j < problem.first[piece + 1]; j++) {
            int k = problem.reach[j];
            const cagd_fit_unknown &is = problem.unknown[k];
            if (is.is_weight)
                w[is.index - low] = exp(theta[k]);
            else
                P[(is.index - low) * dim + is.coordinate] = theta[k];
        }
        N[0] = T(1.0);
        for (int k = 1; k <= degree; k++) {
            T carry(0.0);
            for (int m = 0; m < k; m++) {
                int i = mu - k + 1 + m;
                T share = N[m] / (u[i + k] - u[i]);
                N[m] = carry + (u[i + k] - *t) * share;
                carry = (*t - u[i]) * share;
            }
            N[k] = carry;
        }
        for (int m = 0; m <= degree; m++) {
            N[m] *= w[m];
            total += N[m];
            for (int c = 0; c < dim; c++)
                sum[c] += N[m] * P[m * dim + c];
        }
        for (int c = 0; c < dim; c++)
            residuals[c] = (q[c] - sum[c] / total) * precision;
        return true;
    }
    template <typename T> bool operator()(T const *const *parameters, T *residuals) const
    {
        return (*this)(parameters[0], parameters[1], residuals);
    }

  private:
    static double value(double t) { return t; }
    template <typename T, int N> static double value(const ceres::Jet<T, N> &t) { return t.a; }
    const fit_problem &problem;
    const fit_curve &curve;
    const double *q;
    double precision;
};

template <int DIM, int M> ceres::CostFunction *sized(const fit_problem &p, const fit_curve &c, int i)
{
    return new ceres::AutoDiffCostFunction<Distance, DIM, M, 1>(new Distance(p, c, i));
}

/* Where the compiler knows the sizes, as it does here for weights and inner points of conics and cubics, automatic
 * differentiation is several times faster. */
ceres::CostFunction *distance(const fit_problem &p, const fit_curve &c, int i)
{
    switch (p.dim * 100 + p.unknowns) {
    case 203:
        return sized<2, 3>(p, c, i);
    case 206:
        return sized<2, 6>(p, c, i);
    case 304:
        return sized<3, 4>(p, c, i);
    case 308:
        return sized<3, 8>(p, c, i);
    default:
        auto *f = new ceres::DynamicAutoDiffCostFunction<Distance, 8>(new Distance(p, c, i));
        f->AddParameterBlock(p.unknowns);
        f->AddParameterBlock(1);
        f->SetNumResiduals(p.dim);
        return f;
    }
}

} // namespace

extern "C" int fit_minimise(int unknowns, int rows, fit_function function, void *context, const double low[],
                            const double high[], double tolerance, int valley, int max_iterations, double theta[],
                            double *radius, fit_outcome *outcome)
try {
    Silence silence;
    ceres::Problem problem;
    problem.AddResidualBlock(new Reduced(unknowns, rows, function, context), nullptr, theta);
    for (int k = 0; k < unknowns; k++) {
        if (std::isfinite(low[k]))
            problem.SetParameterLowerBound(theta, k, low[k]);
        if (std::isfinite(high[k]))
            problem.SetParameterUpperBound(theta, k, high[k]);
    }
    ceres::Solver::Options options = quiet(tolerance, max_iterations);
    options.linear_solver_type = ceres::DENSE_QR;
    options.initial_trust_region_radius = *radius;
    options.use_nonmonotonic_steps = valley != 0;
    ceres::Solver::Summary summary;
    ceres::Solve(options, &problem, &summary);
    if (!summary.iterations.empty())
        *radius = summary.iterations.back().trust_region_radius;
    return report(summary, outcome);
} catch (const std::bad_alloc &) {
    return 0;
}

extern "C" int fit_minimise_plain(const fit_problem *p, const fit_curve *curve, double tolerance, int max_iterations,
                                  double theta[], double feet[], fit_outcome *outcome)
try {
    Silence silence;
    ceres::Problem problem;
    for (int i = 0; i < p->points; i++) {
        ceres::LossFunction *loss = p->loss == CAGD_FIT_HUBER ? new ceres::HuberLoss(p->loss_scale)
                                    : p->loss == CAGD_FIT_CAUCHY
                                        ? static_cast<ceres::LossFunction *>(new ceres::CauchyLoss(p->loss_scale))
                                        : nullptr;
        problem.AddResidualBlock(distance(*p, *curve, i), loss, theta, feet + i);
    }
    for (int k = 0; k < p->unknowns; k++)
        if (p->unknown[k].is_weight) {
            if (std::isfinite(p->low))
                problem.SetParameterLowerBound(theta, k, p->low);
            if (std::isfinite(p->high))
                problem.SetParameterUpperBound(theta, k, p->high);
        }
    ceres::Solver::Summary summary;
    ceres::Solve(quiet(tolerance, max_iterations), &problem, &summary);
    return report(summary, outcome);
} catch (const std::bad_alloc &) {
    return 0;
}

extern "C" int fit_svd(int n, const double a[], double U[], double s[], double V[])
try {
    using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
    auto fill = [&](const auto &svd) {
        Eigen::Map<Matrix>(U, n, n) = svd.matrixU();
        Eigen::Map<Matrix>(V, n, n) = svd.matrixV();
        Eigen::Map<Eigen::VectorXd>(s, n) = svd.singularValues();
    };
    const int both = Eigen::ComputeFullU | Eigen::ComputeFullV;
    Eigen::MatrixXd A = Eigen::Map<const Matrix>(a, n, n);
    if (!A.allFinite()) { /* the methods would not end, or leave their results unset */
        std::fill(U, U + n * n, 0.0);
        std::fill(V, V + n * n, 0.0);
        std::fill(s, s + n, 0.0);
        return 1;
    }
    if (n <= 32) /* Jacobi's method is the more accurate one, and slow for large n */
        fill(Eigen::JacobiSVD<Eigen::MatrixXd>(A, both));
    else
        fill(Eigen::BDCSVD<Eigen::MatrixXd>(A, both));
    return 1;
} catch (const std::bad_alloc &) {
    return 0;
}
