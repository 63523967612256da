#include "core/fit/ceres.h"

#include "core/number/limits.h"

#include <ceres/cost_function.h>
#include <ceres/loss_function.h>
#include <ceres/problem.h>
#include <ceres/solver.h>
#include <glog/logging.h>

#include <Eigen/SVD>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <limits>

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

/* Point i: (Q - C(t; theta))/sigma, with its derivatives by theta and by t. */
class Distance : public ceres::CostFunction
{
  public:
    Distance(const fit_problem &p, const fit_curve &c, int i)
        : problem(p), curve(c), q(p.Q + static_cast<size_t>(i) * static_cast<size_t>(p.dim)), precision(p.precision[i])
    {
        set_num_residuals(p.dim);
        *mutable_parameter_block_sizes() = {p.unknowns, 1};
    }

    bool Evaluate(double const *const *parameters, double *residuals, double **jacobians) const override
    {
        const double *theta = parameters[0], t = *parameters[1], *u = curve.knots;
        const int p = curve.degree, dim = curve.dim, n = problem.unknowns;
        const int piece = fit_curve_piece(&curve, t), mu = curve.span[piece], low = mu - p;
        const int *reach = problem.reach + problem.first[piece], *end = problem.reach + problem.first[piece + 1];
        double w[MAX_DEGREE + 1], P[(MAX_DEGREE + 1) * 3], N[MAX_DEGREE + 1], N1[MAX_DEGREE + 1];
        std::copy_n(curve.weights + low, p + 1, w);
        std::copy_n(curve.points + low * dim, (p + 1) * dim, P);
        for (const int *k = reach; k < end; k++) {
            const cagd_fit_unknown &is = problem.unknown[*k];
            if (is.is_weight)
                w[is.index - low] = std::exp(theta[*k]);
            else
                P[(is.index - low) * dim + is.coordinate] = theta[*k];
        }
        N[0] = 1;
        for (int k = 1; k <= p; k++) { /* Cox and de Boor; at last the derivatives as well */
            double carry = 0, carry1 = 0;
            for (int m = 0; m < k; m++) {
                int i = mu - k + 1 + m;
                double share = N[m] / (u[i + k] - u[i]);
                N1[m] = carry1 - p * share;
                carry1 = p * share;
                N[m] = carry + (u[i + k] - t) * share;
                carry = (t - u[i]) * share;
            }
            N1[k] = carry1;
            N[k] = carry;
        }
        double W = 0, W1 = 0, C[3] = {0, 0, 0}, C1[3] = {0, 0, 0};
        for (int m = 0; m <= p; m++) {
            W += N[m] *= w[m];
            W1 += N1[m] *= w[m];
            for (int c = 0; c < dim; c++) {
                C[c] += N[m] * P[m * dim + c];
                C1[c] += N1[m] * P[m * dim + c];
            }
        }
        for (int c = 0; c < dim; c++) {
            C[c] /= W;
            residuals[c] = (q[c] - C[c]) * precision;
        }
        if (jacobians != nullptr && jacobians[0] != nullptr) {
            std::fill_n(jacobians[0], dim * n, 0.0);
            for (const int *k = reach; k < end; k++) {
                const cagd_fit_unknown &is = problem.unknown[*k];
                const int m = is.index - low;
                const double share = -precision * N[m] / W;
                for (int c = 0; c < dim; c++)
                    jacobians[0][c * n + *k] = share * (is.is_weight         ? P[m * dim + c] - C[c]
                                                        : c == is.coordinate ? 1
                                                                             : 0);
            }
        }
        if (jacobians != nullptr && jacobians[1] != nullptr)
            for (int c = 0; c < dim; c++)
                jacobians[1][c] = -precision * (C1[c] - W1 * C[c]) / W;
        return true;
    }

  private:
    const fit_problem &problem;
    const fit_curve &curve;
    const double *q;
    double precision;
};

} // namespace

extern "C" int fit_minimise(int unknowns, int rows, fit_function function, void *context, const double low[],
                            const double high[], double tolerance, int max_iterations, double theta[], double *radius,
                            fit_outcome *outcome)
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
    options.gradient_tolerance = 0; /* it would be one in units of the data */
    options.parameter_tolerance = std::numeric_limits<double>::epsilon();
    /* normal equations know half of the digits, which is enough on the way */
    options.linear_solver_type = tolerance > std::sqrt(std::numeric_limits<double>::epsilon())
                                     ? ceres::DENSE_NORMAL_CHOLESKY
                                     : ceres::DENSE_QR;
    options.initial_trust_region_radius = *radius;
    options.use_nonmonotonic_steps = true; /* along curved valleys */
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
        problem.AddResidualBlock(new Distance(*p, *curve, i), loss, theta, feet + i);
    }
    for (int k = 0; k < p->unknowns; k++)
        if (p->unknown[k].is_weight) {
            if (p->low > 0)
                problem.SetParameterLowerBound(theta, k, std::log(p->low));
            if (std::isfinite(p->high))
                problem.SetParameterUpperBound(theta, k, std::log(p->high));
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
    Eigen::MatrixXd A = Eigen::Map<const Matrix>(a, n, n);
    if (!A.allFinite()) { /* the method would not end, or leave its results unset */
        std::fill(U, U + n * n, 0.0);
        std::fill(V, V + n * n, 0.0);
        std::fill(s, s + n, 0.0);
        return 1;
    }
    Eigen::JacobiSVD<Eigen::MatrixXd, Eigen::NoQRPreconditioner> svd(A, Eigen::ComputeFullU | Eigen::ComputeFullV);
    Eigen::Map<Matrix>(U, n, n) = svd.matrixU();
    Eigen::Map<Matrix>(V, n, n) = svd.matrixV();
    Eigen::Map<Eigen::VectorXd>(s, n) = svd.singularValues();
    return 1;
} catch (const std::bad_alloc &) {
    return 0;
}
