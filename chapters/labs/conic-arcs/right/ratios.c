static double sign(double x) { return x > 0 ? 1 : x < 0 ? -1 : 0; }

double kind(const double *w) { return sign(w[1] / w[0] - w[2] / w[1]); }

void arc(double r, double u, double *x, double *y, double *w)
{
    double q = u * u, *point[2] = {x, y};
    for (int side = -1; side <= 1; side += 2) {
        point[0][1 + side] = r * (1 - q) / (1 + q);
        point[1][1 + side] = side * 2 * r * u / (1 + q);
        w[1 + side] = 1;
    }
    point[0][1] = r * (1 + q) / (1 - q);
    point[1][1] = 0;
    w[1] = 2 / (1 + q) - 1;
}

double shoulder(const double *w) { return 1 - (w[0] + w[2]) / (w[0] + w[1] + w[1] + w[2]); }
