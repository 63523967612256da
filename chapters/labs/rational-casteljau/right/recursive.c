/* A structure of a homogeneous point, and the triangle as a recursion. */
struct weighted {
    double x, w;
};

static struct weighted at(int r, const double *p, const double *w, double t)
{
    if (r == 0)
        return (struct weighted){w[0] * p[0], w[0]};
    struct weighted a = at(r - 1, p, w, t), b = at(r - 1, p + 1, w + 1, t);
    return (struct weighted){(1 - t) * a.x + t * b.x, (1 - t) * a.w + t * b.w};
}

double point(int n, const double *p, const double *w, double t)
{
    struct weighted m = at(n, p, w, t);
    return m.x / m.w;
}

void homogeneous(int n, const double *p, const double *w, double t, double *h)
{
    struct weighted m = at(n, p, w, t);
    h[0] = m.x;
    h[1] = m.w;
}

void level(int n, int r, const double *p, const double *w, double t, double *q, double *v)
{
    for (int i = 0; i <= n - r; i++) {
        struct weighted m = at(r, p + i, w + i, t);
        q[i] = m.x / m.w;
        v[i] = m.w;
    }
}
