/* With other operations: the point of the curve whose only point is 1, by de Boor's algorithm in the span of t. */
double basis(int i, int p, const double *u, double t)
{
    int m = -1;
    for (int j = 0; j <= p; j++)
        if (u[i + j] <= t && t < u[i + j + 1])
            m = j;
    if (m < 0)
        return 0;
    /* the points that matter are those of i+m-p .. i+m; only the one of i is 1, and only knots of its support are read */
    double d[p + 1];
    for (int j = 0; j <= p; j++)
        d[j] = j == p - m;
    for (int k = 1; k <= p; k++)
        for (int j = p; j >= k; j--) {
            int a = m - p + j, b = m + 1 + j - k;
            double left = d[j - 1], right = d[j];
            if (a < 0 || b > p + 1) {
                d[j] = 0; /* both are 0 there: the support is not reached */
                continue;
            }
            double x = (t - u[i + a]) / (u[i + b] - u[i + a]);
            d[j] = (1 - x) * left + x * right;
        }
    return d[p];
}

int span(int n, int p, const double *u, double t)
{
    int low = p, high = n;
    if (t == u[n]) {
        while (u[high - 1] == u[n] && high > p + 1)
            high--;
        return high - 1;
    }
    while (high - low > 1) {
        int middle = (low + high) / 2;
        if (u[middle] <= t)
            low = middle;
        else
            high = middle;
    }
    return low;
}
