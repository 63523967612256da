/* R w = P differentiated twice, and solved for R'' with R = P/w and R' = (P' - w' R)/w put in. */
void counterexample(double *x)
{
    for (int k = 0; k < 6; k++)
        x[k] = k == 0 || k == 3 || k == 4; /* P = 1, w = w' = 1, all others 0 */
}

double first(double p, double q, double w, double u) { return (q * w - p * u) / (w * w); }

double second(double p, double q, double s, double w, double u, double v)
{
    return (s - v * (p / w) - 2 * u * first(p, q, w, u)) / w;
}
