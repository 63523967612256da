"""The problem of bench_fit.c by SciPy's orthogonal distance regression (ODRPACK): prints seconds, cost, iterations.

    bench_fit_peers.py POINTS

The parameters of the points are ODRPACK's errors in the input: they cost nothing, so that only distances count.
"""
import sys
import time

import numpy
from scipy import odr

Q = numpy.loadtxt(sys.argv[1]).T
N = Q.shape[1]


def curve(beta, t):
    w1, w2 = numpy.exp(beta[:2])
    r = 1 - t
    B = numpy.array([r**3, 3 * r * r * t * w1, 3 * r * t * t * w2, t**3])
    P = numpy.array([[0, beta[2], beta[4], 4], [0, beta[3], beta[5], -0.5]])
    return P @ B / B.sum(axis=0)


begin = time.perf_counter()
data = odr.Data(numpy.linspace(0.02, 0.98, N), Q, wd=1e-20)
fit = odr.ODR(data, odr.Model(curve), beta0=[0, 0, 1.3, 2, 2.7, 2.2], maxit=1000, sstol=1e-15, partol=1e-15)
fit.set_job(fit_type=0, deriv=1)
out = fit.run()
seconds = time.perf_counter() - begin
cost = 0.5 * ((curve(out.beta, out.xplus) - Q) ** 2).sum()
print(seconds, repr(float(cost)), int(fit.iwork[0]) if getattr(fit, "iwork", None) is not None else 0)
