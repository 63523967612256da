/* By polar forms: point i of the new curve is the polar form, at the knots v[i+1] .. v[i+p], of the span that holds v[i+p]
 * or a neighbour of it; in the old span it is computed by de Boor's triangle with one argument a step. */
static double polar(int p, const double *u, const double *c, int m, const double *at)
{
    double d[p + 1];
    for (int j = 0; j <= p; j++)
        d[j] = c[m - p + j];
    for (int r = 1; r <= p; r++)
        for (int j = p; j >= r; j--) {
            double low = u[m - p + j], high = u[m + 1 + j - r];
            d[j] = ((high - at[r - 1]) * d[j - 1] + (at[r - 1] - low) * d[j]) / (high - low);
        }
    return d[p];
}

void refine(int n, int p, const double *u, const double *c, int m, const double *tau, double *v, double *d)
{
    for (int i = 0, j = 0; i + j <= n + p + m;)
        if (j < m && (i > n + p || tau[j] < u[i]))
            v[i + j] = tau[j], j++;
        else
            v[i + j] = u[i], i++;
    for (int i = 0; i < n + m; i++) {
        /* any old span between v[i] and v[i+p+1] that is not empty; where they lie beyond an end, the one beside it */
        int s = -1;
        for (int touching = 0; touching <= 1; touching++)
            for (int k = p; k < n; k++)
                if (s < 0 && u[k] < u[k + 1] && v[i] <= u[k + 1] && u[k] <= v[i + p + 1] &&
                    (touching || (v[i] < u[k + 1] && u[k] < v[i + p + 1])))
                    s = k;
        d[i] = polar(p, u, c, s, v + i + 1);
    }
}

void insert(int n, int p, const double *u, const double *c, double tau, double *v, double *d)
{
    refine(n, p, u, c, 1, &tau, v, d);
}

/* Point i behind m insertions. */
static double refined(int n, int p, const double *u, const double *c, int m, const double *tau, int i)
{
    double v[n + p + m + 1], d[n + m];
    refine(n, p, u, c, m, tau, v, d);
    return d[i];
}
