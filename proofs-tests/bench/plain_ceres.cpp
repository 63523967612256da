#include "proofs-tests/bench/plain_ceres.h"

#include "core/fit/problem.h"
#include "core/number/limits.h"

#include <ceres/cost_function.h>
#include <ceres/loss_function.h>
#include <ceres/problem.h>
#include <ceres/solver.h>
#include <glog/logging.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

extern "C" {
#include "core/fit/feet.h"
#include "core/fit/starts.h"
}

namespace
{

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
        const double *theta = parameters[0], t = *parameters[1], *u = curve.spline.knots;
        const int p = curve.spline.degree, dim = curve.spline.dim, n = problem.unknowns;
        const int piece = fit_curve_piece(&curve, t), mu = curve.span[piece], low = mu - p;
        const fit_support &support = problem.support;
        const int *reach = support.unknown + support.first[piece], *end = support.unknown + support.first[piece + 1];
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

/* Curve to theta, log w_j and P_j; and back, weights being put between the bounds. */
void theta_of_curve(const fit_problem *p, const fit_curve *curve, double theta[])
{
    for (int k = 0; k < p->unknowns; k++) {
        cagd_fit_unknown u = p->unknown[k];
        theta[k] = u.is_weight ? std::log(curve->weights[u.index]) : curve->points[u.index * p->dim + u.coordinate];
    }
}

void theta_to_curve(const fit_problem *p, const double theta[], fit_curve *curve)
{
    for (int k = 0; k < p->unknowns; k++) {
        cagd_fit_unknown u = p->unknown[k];
        if (u.is_weight)
            curve->weights[u.index] = std::fmin(std::fmax(std::exp(theta[k]), p->low), p->high);
        else
            curve->points[u.index * p->dim + u.coordinate] = theta[k];
    }
    fit_curve_update(curve);
}

std::unique_ptr<ceres::LossFunction> loss_of(const fit_problem &p)
{
    if (p.loss == CAGD_FIT_HUBER)
        return std::make_unique<ceres::HuberLoss>(p.loss_scale);
    if (p.loss == CAGD_FIT_CAUCHY)
        return std::make_unique<ceres::CauchyLoss>(p.loss_scale);
    return nullptr;
}

/* The logarithms of the weights between those of their bounds. */
void bound_weights(const fit_problem &p, ceres::Problem *problem, double theta[])
{
    for (int k = 0; k < p.unknowns; k++) {
        if (p.unknown[k].is_weight && p.low > 0)
            problem->SetParameterLowerBound(theta, k, std::log(p.low));
        if (p.unknown[k].is_weight && std::isfinite(p.high))
            problem->SetParameterUpperBound(theta, k, std::log(p.high));
    }
}

void solve(const fit_problem &p, const fit_curve &curve, const cagd_fit_options &o, double theta[], double feet[],
           plain_outcome *outcome)
{
    ceres::Problem::Options ownership;
    ownership.loss_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
    std::unique_ptr<ceres::LossFunction> loss = loss_of(p);
    ceres::Problem problem(ownership);
    for (int i = 0; i < p.points; i++)
        problem.AddResidualBlock(new Distance(p, curve, i), loss.get(), theta, feet + i);
    bound_weights(p, &problem, theta);
    ceres::Solver::Options options;
    options.logging_type = ceres::SILENT;
    options.function_tolerance = options.gradient_tolerance = options.parameter_tolerance = o.tolerance;
    options.max_num_iterations = o.max_iterations;
    ceres::Solver::Summary summary;
    ceres::Solve(options, &problem, &summary);
    const double start = fit_curve_start(&curve), end = fit_curve_end(&curve);
    outcome->cost = summary.final_cost;
    outcome->iterations = static_cast<int>(summary.iterations.size()) - 1;
    outcome->converged = summary.termination_type == ceres::CONVERGENCE &&
                         std::all_of(feet, feet + p.points, [=](double t) { return start <= t && t <= end; });
}

} // namespace

extern "C" cagd_status plain_ceres(const cagd_fit_data *data, const cagd_fit_options *options, plain_outcome *outcome)
{
    FLAGS_minloglevel = google::GLOG_FATAL; /* a bench has one thread */
    fit_problem p;
    int where;
    double cost;
    cagd_status status = fit_problem_make(data, options, &fit_usual_strategy, &p, &where);
    fit_curve *curve = status == CAGD_OK ? fit_curve_new(p.degree, p.count, 0, p.dim, p.knots) : nullptr;
    std::vector<double> feet(static_cast<size_t>(data->count));
    if (status == CAGD_OK &&
        (curve == nullptr || !fit_start(&p, 0, curve) || !fit_feet_search(&p, curve, feet.data(), &cost)))
        status = CAGD_NO_MEMORY;
    if (status == CAGD_OK) {
        std::vector<double> theta(static_cast<size_t>(p.unknowns));
        theta_of_curve(&p, curve, theta.data());
        theta_to_curve(&p, theta.data(), curve);
        solve(p, *curve, *options, theta.data(), feet.data(), outcome);
    }
    fit_curve_free(curve);
    fit_problem_free(&p);
    return status;
}
