/* With R0 = (-1, 0), R1 = (0, h), R2 = (1, 0) and the weights 1, w, 1 the curve is on the conic with A = w^2, C = (1 + ...): it is a circle just
 * when w is the cosine of the angle at R0, w^2 = 1/(1 + h^2); here h = 1 and w = 1/2. */
void counterexample(double *x)
{
    x[0] = 1;
    x[1] = 1.0 / 2;
}

double invariant(double l, double h) { return l * l / (l * l + h * h); }

double squaredradius(double l, double h)
{
    double r = (l * l + h * h) * l / h; /* of the circle that touches both legs at their ends: l / sin of the angle */
    return r * r / (l * l + h * h);
}
