/* Computes the formulas of the thesis, written by hand, for a comparison with frictiongen. Modal data are given. All
 * other formulas are as printed, with the corrections of docs/thesis.md, without which the results would be wrong.
 *
 * The file is compiled once for each number of masses (-DMASSES=n), so that every loop has a constant length. All modes
 * have the same zeta. Undamped scenes have their own, shorter formulas.
 */
#include <complex.h>
#include <math.h>
#include <stddef.h>

#define JOIN_(a, b) a##b
#define JOIN(a, b) JOIN_(a, b)
#define NAME(a) JOIN(a, MASSES)

enum { N = MASSES, GRID = 200, GOLDEN = 40 };
static const double PI = 3.14159265358979323846, GOLD = 0.61803398874989484820;

/* For each mode: sqrt(lambda); residues from load and friction to the contact's relative motion, and to the observed
 * mass; square of the mode's component in the contact. Then the coefficient of the base motion in the relative motion,
 * mu, the inverse effective mass of the contact, and zeta. */
typedef struct {
    double root[N], load[N], friction[N], far_load[N], far_friction[N], share[N];
    double base, mu, inverse_mass, zeta;
} NAME(Thesis);
typedef NAME(Thesis) Thesis;

/* Numbers that depend on the frequency alone. */
typedef struct {
    double r, R[N], u[N], g[N], weight[N]; /* weight: residue from friction to the observed mass over cos(pi/2R) */
    double U, G, Hc;
    double complex V, H, far_V;
} At;

static At at_undamped(const Thesis *s, double r) {
    At a = {.r = r};
    double V = -s->base, H = 0, U = 0;
    for (int i = 0; i < N; i++) {
        double R = r / s->root[i], v = 1 / (1 - R * R), u = tan(PI / (2 * R)) / R;
        V += s->load[i] * v;
        H += s->friction[i] * v;
        U += s->friction[i] * u;
        a.R[i] = R; a.u[i] = u;
    }
    a.V = V; a.H = H; a.U = U;
    return a;
}

static At at_damped(const Thesis *s, double r) {
    At a = {.r = r, .V = -s->base};
    double z = s->zeta, q = sqrt(1 - z * z);
    for (int i = 0; i < N; i++) {
        double R = r / s->root[i];
        double complex v = 1 / (1 - R * R + 2 * I * z * R);
        double sine = sin(PI * q / R), below = cosh(PI * z / R) + cos(PI * q / R);
        double u = sine / (R * q * below), g = (sinh(PI * z / R) - z / q * sine) / below;
        a.V += s->load[i] * v;
        a.H += s->friction[i] * v;
        a.U += s->friction[i] * u;
        a.G += s->friction[i] * g;
        a.Hc += s->share[i] * (g + 2 * z * R * u) / (r * r);
        a.R[i] = R; a.u[i] = u; a.g[i] = g;
    }
    return a;
}

static double start(const Thesis *s, const At *a) { return a->Hc + s->mu * s->inverse_mass / (a->r * a->r); }

/* Velocity constraint (3.15, 5.55), with the maximum of the whole sum over the modes. */
static double constraint_undamped(const Thesis *s, const At *a, double t) {
    double sum = 0, c = cos(t);
    for (int i = 0; i < N; i++) {
        double R = a->R[i];
        sum += s->share[i] * (R * sin(t / R) + a->u[i] * R * R * (c - cos(t / R)));
    }
    return sum / (a->r * a->r * sin(t));
}

/* (7.38) */
static double constraint_damped(const Thesis *s, const At *a, double t) {
    double sum = 0, c = cos(t), z = s->zeta, q = sqrt(1 - z * z);
    for (int i = 0; i < N; i++) {
        double R = a->R[i], e = exp(-z * t / R), sine = e * sin(q * t / R) / q, cosine = e * cos(q * t / R);
        sum += s->share[i] * ((1 + a->g[i]) * R * sine + a->u[i] * R * R * (c - cosine + z * sine));
    }
    return sum / (a->r * a->r * sin(t));
}

/* Displacement (5.29) of the observed mass. */
static double motion_undamped(const Thesis *s, const At *a, double beta, double phi, double t) {
    double sum = 0;
    for (int i = 0; i < N; i++)
        sum += s->far_friction[i] - a->weight[i] * cos((t - PI / 2) / a->R[i]);
    return creal(a->far_V) * cos(t + phi) + beta * sum;
}

/* (7.22), (7.24) */
static double motion_damped(const Thesis *s, const At *a, double beta, double phi, double t) {
    double sum = 0, z = s->zeta, q = sqrt(1 - z * z);
    for (int i = 0; i < N; i++) {
        double R = a->R[i], e = exp(-z * t / R), sine = e * sin(q * t / R) / q, cosine = e * cos(q * t / R);
        sum += s->far_friction[i] * (1 - (1 + a->g[i]) * (cosine + z * sine) - a->u[i] * R * sine);
    }
    return cabs(a->far_V) * cos(t + phi + carg(a->far_V)) + beta * sum;
}

/* Returns the largest |f| over (0, top): 200 points, then a golden-section search about the best point. */
#define LARGEST(f, top)                                                                         \
    double best = 0, place = 0, width = (top) / (GRID + 1);                                     \
    for (int k = 1; k <= GRID; k++) {                                                           \
        double value = fabs(f(k * width));                                                      \
        if (value > best) { best = value; place = k * width; }                                  \
    }                                                                                           \
    double low = place - width, high = place + width;                                           \
    double left = high - GOLD * (high - low), right = low + GOLD * (high - low);                \
    double at_left = fabs(f(left)), at_right = fabs(f(right));                                  \
    for (int k = 0; k < GOLDEN; k++) {                                                          \
        if (at_left > at_right) {                                                               \
            high = right; right = left; at_right = at_left;                                     \
            left = high - GOLD * (high - low); at_left = fabs(f(left));                         \
        } else {                                                                                \
            low = left; left = right; at_left = at_right;                                       \
            right = low + GOLD * (high - low); at_right = fabs(f(right));                       \
        }                                                                                       \
    }                                                                                           \
    best = fmax(best, fmax(at_left, at_right));

/* (5.65), (7.49) and (6.11). */
static void answer(const Thesis *s, const At *a, double S, double *out) {
    out[0] = cabs(a->V) / sqrt(a->U * a->U + S * S);
    out[1] = cabs(a->V) / (s->mu * cabs(a->H));
}

static void answer_undamped(const Thesis *s, const At *a, double S, double *out) {
    double V = fabs(creal(a->V));
    out[0] = V / sqrt(a->U * a->U + S * S);
    out[1] = V / (s->mu * fabs(creal(a->H)));
}

/* Each of the following functions takes pairs of r and beta. */
void NAME(limits_without_search_undamped_)(const Thesis *s, size_t n, const double (*p)[2], double (*out)[2]) {
    for (size_t k = 0; k < n; k++) {
        At a = at_undamped(s, p[k][0]);
        answer_undamped(s, &a, start(s, &a), out[k]);
    }
}

void NAME(limits_without_search_damped_)(const Thesis *s, size_t n, const double (*p)[2], double (*out)[2]) {
    for (size_t k = 0; k < n; k++) {
        At a = at_damped(s, p[k][0]);
        answer(s, &a, start(s, &a), out[k]);
    }
}

void NAME(limits_undamped_)(const Thesis *s, size_t n, const double (*p)[2], double (*out)[2]) {
    for (size_t k = 0; k < n; k++) {
        At a = at_undamped(s, p[k][0]);
#define F(t) constraint_undamped(s, &a, t)
        LARGEST(F, PI / 2)
#undef F
        answer_undamped(s, &a, fmax(best, start(s, &a)), out[k]);
    }
}

void NAME(limits_damped_)(const Thesis *s, size_t n, const double (*p)[2], double (*out)[2]) {
    for (size_t k = 0; k < n; k++) {
        At a = at_damped(s, p[k][0]);
        /* With damping, S is the maximum of the value and not of its modulus. */
#define F(t) fmax(constraint_damped(s, &a, t), 0)
        LARGEST(F, PI)
#undef F
        answer(s, &a, fmax(best, start(s, &a)), out[k]);
    }
}

/* Computes the exact amplitude of the observed mass, at points at which the motion is known to be continuous. */
void NAME(amplitude_undamped_)(const Thesis *s, size_t n, const double (*p)[2], double (*out)[2]) {
    for (size_t k = 0; k < n; k++) {
        double beta = p[k][1];
        At a = at_undamped(s, p[k][0]);
        double V = fabs(creal(a.V)), far = 0;
        for (int i = 0; i < N; i++) {
            far += s->far_load[i] / (1 - a.R[i] * a.R[i]);
            a.weight[i] = s->far_friction[i] / cos(PI / (2 * a.R[i]));
        }
        a.far_V = far;
        double phi = atan2(-beta * a.U, sqrt(V * V - beta * beta * a.U * a.U)) - carg(a.V);
#define F(t) motion_undamped(s, &a, beta, phi, t)
        LARGEST(F, PI)
#undef F
        out[k][0] = out[k][1] = fmax(best, fabs(motion_undamped(s, &a, beta, phi, 0)));
    }
}

void NAME(amplitude_damped_)(const Thesis *s, size_t n, const double (*p)[2], double (*out)[2]) {
    for (size_t k = 0; k < n; k++) {
        double beta = p[k][1], z = s->zeta;
        At a = at_damped(s, p[k][0]);
        double V = cabs(a.V);
        for (int i = 0; i < N; i++) a.far_V += s->far_load[i] / (1 - a.R[i] * a.R[i] + 2 * I * z * a.R[i]);
        double phi = atan2(-beta * a.U, sqrt(V * V - beta * beta * a.U * a.U)) - carg(a.V);
#define F(t) motion_damped(s, &a, beta, phi, t)
        LARGEST(F, PI)
#undef F
        out[k][0] = out[k][1] = fmax(best, fabs(motion_damped(s, &a, beta, phi, 0)));
    }
}
