/* Ceres reports through glog, whose only switch is global.  So the places where it would report are never reached.
 * They are, in Ceres 2.1: options that are not valid; a start that is out of bounds or where the residuals are not
 * defined; residuals or derivatives that are not finite; a linear system that cannot be solved; too many steps, one
 * after the other, without any gain in the model. */
#include "core/fit/ceres.h"

#include <ceres/cost_function.h>
#include <ceres/iteration_callback.h>
#include <ceres/problem.h>
#include <ceres/solver.h>

#include <Eigen/SVD>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <new>
#include <vector>

namespace
{

using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
constexpr double precision = std::numeric_limits<double>::epsilon();

bool has_finite_square(const double x[], int count)
{
    return std::isfinite(Eigen::Map<const Eigen::VectorXd>(x, count).squaredNorm());
}

class Residuals : public ceres::CostFunction
{
  public:
    explicit Residuals(const fit_least_squares &p) : problem(p)
    {
        set_num_residuals(p.rows);
        mutable_parameter_block_sizes()->push_back(p.unknowns);
    }

    bool Evaluate(double const *const *x, double *residuals, double **jacobians) const override
    {
        double *jacobian = jacobians != nullptr ? jacobians[0] : nullptr;
        return problem.residuals(problem.context, x[0], residuals, jacobian) != 0 &&
               has_finite_square(residuals, problem.rows) &&
               (jacobian == nullptr || has_finite_square(jacobian, problem.rows * problem.unknowns));
    }

  private:
    const fit_least_squares &problem;
};

/* Ends a run that has made so many steps without a gain in the model, before Ceres does. */
class Patience : public ceres::IterationCallback
{
  public:
    ceres::CallbackReturnType operator()(const ceres::IterationSummary &step) override
    {
        invalid = step.step_is_valid ? 0 : invalid + 1;
        return is_lost() ? ceres::SOLVER_ABORT : ceres::SOLVER_CONTINUE;
    }
    bool is_lost() const { return invalid == most; }
    static constexpr int most = 5; /* as Ceres has it */

  private:
    int invalid = 0;
};

/* What is told of an end, in words of the fit. */
const char *const too_short = "The steps became shorter than binary64 tells apart, and the cost was not least there; "
                              "other starts, or fewer unknowns, may help.";

const char *words_of(ceres::TerminationType type)
{
    return type == ceres::CONVERGENCE      ? "The cost falls no further by more than the tolerance."
           : type == ceres::NO_CONVERGENCE ? "The largest number of iterations was reached."
                                           : "No step leads to a lower cost.";
}

void stop(fit_outcome *outcome, cagd_fit_termination termination, const char *message)
{
    outcome->termination = termination;
    std::snprintf(outcome->message, sizeof outcome->message, "%s", message);
}

/* Whether the residuals are defined at x, and x is within the bounds. */
bool can_start(const fit_least_squares &p, const double x[])
{
    for (int k = 0; k < p.unknowns; k++)
        if (!(std::isfinite(x[k]) && p.low[k] <= x[k] && x[k] <= p.high[k]))
            return false;
    std::vector<double> residuals(static_cast<size_t>(p.rows)),
        jacobian(static_cast<size_t>(p.rows) * static_cast<size_t>(p.unknowns));
    double *jacobians[] = {jacobian.data()};
    return Residuals(p).Evaluate(&x, residuals.data(), jacobians);
}

/* The largest trust region in which the normal equations can be solved.  Scaled to a diagonal of ones their matrix
 * has no eigenvalue below 1/(1 + radius); forming it changes it by at most n g(n+2), and Cholesky's method succeeds
 * with it when this is more than n g(n+1), g(k) being k u/(1 - k u), u half of the precision.  Source: higham-2002,
 * 10.7. */
double largest_radius(int unknowns)
{
    const double n = unknowns;
    return 1 / (2 * precision * n * (n + 2));
}

ceres::Solver::Options options_of(const fit_least_squares &p, double tolerance, int max_iterations, double radius,
                                  Patience *patience)
{
    ceres::Solver::Options options;
    options.logging_type = ceres::SILENT;
    options.minimizer_progress_to_stdout = false;
    options.function_tolerance = tolerance;
    options.gradient_tolerance = 0; /* it would be one in units of the data */
    options.parameter_tolerance = precision;
    options.max_num_iterations = max_iterations;
    options.linear_solver_type = ceres::DENSE_QR;
    if (tolerance > std::sqrt(precision)) { /* normal equations know half of the digits, which is enough on the way */
        options.linear_solver_type = ceres::DENSE_NORMAL_CHOLESKY;
        options.max_trust_region_radius = std::min(options.max_trust_region_radius, largest_radius(p.unknowns));
    }
    options.initial_trust_region_radius = std::min(radius, options.max_trust_region_radius);
    options.use_nonmonotonic_steps = true; /* along curved valleys */
    options.max_num_consecutive_invalid_steps = std::numeric_limits<int>::max();
    options.callbacks.push_back(patience);
    return options;
}

/* The table of steps; returns 0 when there is no memory. */
int copy_history(const std::vector<ceres::IterationSummary> &steps, fit_outcome *outcome)
{
    outcome->history = static_cast<cagd_fit_step *>(std::malloc((steps.size() + 1) * sizeof *outcome->history));
    if (outcome->history == nullptr)
        return 0;
    outcome->steps = static_cast<int>(steps.size());
    outcome->iterations = std::max(0, outcome->steps - 1);
    for (size_t i = 0; i < steps.size(); i++) {
        const ceres::IterationSummary &s = steps[i];
        outcome->history[i] = {s.iteration, s.step_is_successful || i == 0, s.cost, s.gradient_max_norm,
                               s.step_norm, s.trust_region_radius};
    }
    return 1;
}

int minimise(const fit_least_squares &p, double tolerance, int max_iterations, double x[], double *radius,
             fit_outcome *outcome)
{
    Patience patience;
    Residuals residuals(p);
    const ceres::Solver::Options options = options_of(p, tolerance, max_iterations, *radius, &patience);
    ceres::Solver::Summary summary;
    if (!options.IsValid(&summary.message)) { /* the trust region has vanished */
        stop(outcome, CAGD_FIT_FAILED, too_short);
        return copy_history(summary.iterations, outcome);
    }
    if (!can_start(p, x)) {
        stop(outcome, CAGD_FIT_FAILED, "The distances from the first curve have left the range of numbers.");
        return copy_history(summary.iterations, outcome);
    }
    ceres::Problem::Options ownership;
    ownership.cost_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
    ceres::Problem problem(ownership);
    problem.AddResidualBlock(&residuals, nullptr, x);
    for (int k = 0; k < p.unknowns; k++) {
        if (std::isfinite(p.low[k]))
            problem.SetParameterLowerBound(x, k, p.low[k]);
        if (std::isfinite(p.high[k]))
            problem.SetParameterUpperBound(x, k, p.high[k]);
    }
    ceres::Solve(options, &problem, &summary);
    if (patience.is_lost()) {
        summary.iterations.pop_back();
        stop(outcome, CAGD_FIT_FAILED, "Every step leads to curves whose distances leave the range of numbers.");
    } else {
        stop(outcome,
             summary.termination_type == ceres::CONVERGENCE      ? CAGD_FIT_CONVERGED
             : summary.termination_type == ceres::NO_CONVERGENCE ? CAGD_FIT_NOT_CONVERGED
                                                                 : CAGD_FIT_FAILED,
             words_of(summary.termination_type));
    }
    if (!summary.iterations.empty())
        *radius = summary.iterations.back().trust_region_radius;
    return copy_history(summary.iterations, outcome);
}

/* What `body` returns; when it throws, 0 for no memory, and what `otherwise` returns for anything else, whose words are not those of the
 * fit and are left unread. */
template <typename Body, typename Otherwise> int guarded(Body body, Otherwise otherwise)
{
    try {
        return body();
    } catch (const std::bad_alloc &) {
        return 0;
    } catch (...) {
        return otherwise();
    }
}

} // namespace

extern "C" int fit_minimise(const fit_least_squares *problem, double tolerance, int max_iterations, double x[],
                            double *radius, fit_outcome *outcome)
{
    *outcome = {};
    return guarded([&] { return minimise(*problem, tolerance, max_iterations, x, radius, outcome); },
                   [&] {
                       stop(outcome, CAGD_FIT_FAILED, "The minimiser could not go on.");
                       return 1;
                   });
}

extern "C" int fit_svd(int n, const double a[], double U[], double s[], double V[])
{
    auto nothing = [=] {
        std::fill(U, U + n * n, 0.0);
        std::fill(V, V + n * n, 0.0);
        std::fill(s, s + n, 0.0);
        return 1;
    };
    return guarded(
        [=] {
            Eigen::MatrixXd A = Eigen::Map<const Matrix>(a, n, n);
            if (!A.allFinite()) /* the method would not end, or leave its results unset */
                return nothing();
            Eigen::JacobiSVD<Eigen::MatrixXd, Eigen::NoQRPreconditioner> svd(A,
                                                                             Eigen::ComputeFullU | Eigen::ComputeFullV);
            Eigen::Map<Matrix>(U, n, n) = svd.matrixU();
            Eigen::Map<Matrix>(V, n, n) = svd.matrixV();
            Eigen::Map<Eigen::VectorXd>(s, n) = svd.singularValues();
            return 1;
        },
        nothing);
}
