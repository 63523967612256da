/* net_type.tmpl.h -- the net of a Bézier surface as the kernels take it: degrees n and m, dim, and the points P_ij of
 * bezier_surface.tmpl.h. */
struct G(net) {
    int n, m, dim;
    const G(num) * points;
};

static inline struct G(net) G(net)(int n, int m, int dim, const G(num) P[]) { return (struct G(net)){n, m, dim, P}; }
