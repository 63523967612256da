"""The problem of bench_fit.c by SciPy's least_squares with a sparse Jacobian: prints seconds, cost, evaluations.

    bench_fit_peers.py POINTS

Unknowns: log w_1, log w_2, P_1, P_2 and a parameter for every point.
"""
import sys
import time

import numpy
from scipy.optimize import least_squares
from scipy.sparse import coo_matrix

Q = numpy.loadtxt(sys.argv[1])
N = len(Q)


def curve(x):
    w = numpy.array([1, numpy.exp(x[0]), numpy.exp(x[1]), 1])
    P = numpy.array([[0, 0], x[2:4], x[4:6], [4, -0.5]])
    t = x[6:]
    r = 1 - t
    B = numpy.array([r**3, 3 * r * r * t, 3 * r * t * t, t**3]).T * w
    B1 = numpy.array([-3 * r * r, 3 * r * r - 6 * r * t, 6 * r * t - 3 * t * t, 3 * t * t]).T * w
    total = B.sum(axis=1, keepdims=True)
    R = B / total
    C = R @ P
    return P, R, C, (B1 @ P - B1.sum(axis=1, keepdims=True) * C) / total


def residuals(x):
    return (curve(x)[2] - Q).ravel()


def jacobian(x):
    P, R, C, C1 = curve(x)
    i = numpy.arange(N)
    entries = []
    for c in (0, 1):
        row = 2 * i + c
        for k in (1, 2):
            entries.append((row, 0 * i + k - 1, R[:, k] * (P[k, c] - C[:, c])))
            entries.append((row, 0 * i + 2 * k + c, R[:, k]))
        entries.append((row, 6 + i, C1[:, c]))
    rows, columns, values = (numpy.concatenate(part) for part in zip(*entries))
    return coo_matrix((values, (rows, columns)), shape=(2 * N, N + 6)).tocsr()


start = numpy.concatenate([[0, 0, 1.3, 2, 2.7, 2.2], numpy.linspace(0.02, 0.98, N)])
begin = time.perf_counter()
fit = least_squares(residuals, start, jacobian, method="trf", tr_solver="lsmr", x_scale="jac",
                    ftol=1e-14, xtol=1e-14, gtol=1e-14, max_nfev=1000)
print(time.perf_counter() - begin, repr(float(fit.cost)), fit.nfev)
