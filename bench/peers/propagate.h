/* The exact solution of x' = a x, for programs that declare STATES and include <math.h> and <string.h> before. */
/* Replaces the m numbers x by exp(a t) x, with the Taylor series of the exponential. */
static void propagate(int m, double a[STATES][STATES], double t, double *x) {
    double term[STATES], next[STATES];
    memcpy(term, x, m * sizeof *x);
    for (int k = 1; k < 80; k++) {
        double size = 0, all = 0;
        for (int i = 0; i < m; i++) {
            next[i] = 0;
            for (int l = 0; l < m; l++) next[i] += a[i][l] * term[l];
            next[i] *= t / k;
        }
        for (int i = 0; i < m; i++) {
            term[i] = next[i]; x[i] += next[i];
            size = fmax(size, fabs(next[i])); all = fmax(all, fabs(x[i]));
        }
        if (size <= 1e-17 * all) return;
    }
}
