/* Computes steady states with one elastic contact (a Jenkins element: a spring in series with a slider), to compare them
 * with those of frictiongen. There are two methods: a plain exact event stepper, and harmonic balance with alternating
 * frequency and time.
 *
 *   elastic stepper MASSES CONTACT EXCITED ZETA STIFFNESS R BETA REPEATS [RUNS]
 *   elastic balance MASSES CONTACT EXCITED ZETA STIFFNESS R BETA HARMONICS [RUNS]
 *
 * A chain of equal masses and springs on the base, with one contact of mass CONTACT with the wall and modal damping ZETA.
 * STIFFNESS is the stiffness of the contact divided by that of a spring. A harmonic force acts on mass EXCITED.
 *
 * The stepper runs from rest and takes steps of 1/50 cycle with the exact propagator of the present phase, sliding or stuck. An
 * event is a change of sign at the end of a step, which is bisected to 1e-12 of a rad. The run ends when the state
 * repeats from cycle to cycle within REPEATS.
 *
 * The balance has HARMONICS odd harmonics of the motion of the contact, up to order 2 HARMONICS - 1. The motion of the
 * masses follows from these harmonics by the receptances of the modes. 16 samples for each order give the force of the
 * element and its derivatives. Newton's method starts from the motion without friction, halves steps that do not
 * improve the residual, and ends at a residual of 1e-12.
 *
 * Prints: microseconds (median of RUNS), cycles or Newton steps, "settles" or "moves-on", amplitude of the contact.
 */
#include <complex.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "timing.h"

enum { MOST = 10, STATES = 2 * MOST, STEPS = 50, MOST_CYCLES = 20000, MOST_NEWTON = 60 };
static const double PI = 3.14159265358979323846, EVENT = 1e-12;

typedef struct {
    int n, j;                    /* number of masses, index of the mass in contact */
    double r, beta, kappa;       /* frequency ratio, friction over load, stiffness of the contact over that of a spring */
    double phi[MOST][MOST];      /* mode shapes, [mode][mass] */
    double lambda[MOST], zeta;   /* squares of the natural frequencies, damping ratio */
    double load[MOST];           /* load on each mode */
    double a[2][STATES][STATES]; /* matrices of x' = a x + b cos t + g: sliding, stuck; x has displacements, then velocities */
    double e[2][STATES][STATES]; /* exp(a h) for one step h */
    double complex v[2][STATES]; /* complex amplitudes of the states under the load */
    double push[2][STATES];      /* static state under a force of 1 from the wall on the mass in contact */
} Scene;

typedef struct { double t; int way; double anchor, x[STATES]; } State; /* anchor: place at which the element has no force */
typedef struct { int steps, settles; double contact; } Found;

/* Solves the complex system m x = b by Gauss's elimination with row exchanges. The solution overwrites b. */
static void solve(int n, int wide, double complex *m, double complex *b) {
    for (int i = 0; i < n; i++) {
        int best = i;
        for (int k = i + 1; k < n; k++) if (cabs(m[k * wide + i]) > cabs(m[best * wide + i])) best = k;
        if (best != i) {
            for (int k = i; k < n; k++) {
                double complex s = m[i * wide + k]; m[i * wide + k] = m[best * wide + k]; m[best * wide + k] = s;
            }
            double complex s = b[i]; b[i] = b[best]; b[best] = s;
        }
        for (int k = i + 1; k < n; k++) {
            double complex f = m[k * wide + i] / m[i * wide + i];
            if (f == 0) continue;
            for (int l = i; l < n; l++) m[k * wide + l] -= f * m[i * wide + l];
            b[k] -= f * b[i];
        }
    }
    for (int i = n - 1; i >= 0; i--) {
        for (int k = i + 1; k < n; k++) b[i] -= m[i * wide + k] * b[k];
        b[i] /= m[i * wide + i];
    }
}

/* The modes of the chain have a closed form: lambda = 4 sin^2, shapes are sines. */
static void prepare(Scene *s, int n, int contact, int excited, double zeta, double kappa, double r, double beta) {
    memset(s, 0, sizeof *s);
    s->n = n; s->j = contact - 1; s->r = r; s->beta = beta; s->kappa = kappa; s->zeta = zeta;
    for (int i = 0; i < n; i++) {
        double angle = PI * (2 * i + 1) / (2 * n + 1), norm = 0;
        s->lambda[i] = 4 * sin(angle / 2) * sin(angle / 2);
        for (int k = 0; k < n; k++) { s->phi[i][k] = sin(angle * (k + 1)); norm += s->phi[i][k] * s->phi[i][k]; }
        for (int k = 0; k < n; k++) s->phi[i][k] /= sqrt(norm);
        s->load[i] = s->phi[i][excited - 1];
    }
}

#include "propagate.h"

/* Makes matrices, propagators, and the answers to load and constant force, of both phases. */
static void prepare_steps(Scene *s) {
    int n = s->n, m = 2 * n;
    double r2 = s->r * s->r;
    for (int stuck = 0; stuck < 2; stuck++) {
        for (int i = 0; i < n; i++) {
            s->a[stuck][i][n + i] = 1;
            for (int k = 0; k < n; k++) for (int l = 0; l < n; l++) {
                s->a[stuck][n + k][l] -= s->lambda[i] * s->phi[i][k] * s->phi[i][l] / r2;
                s->a[stuck][n + k][n + l] -= 2 * s->zeta * sqrt(s->lambda[i]) / s->r * s->phi[i][k] * s->phi[i][l];
            }
        }
        if (stuck) s->a[stuck][n + s->j][s->j] -= s->kappa / r2;
        double complex matrix[STATES * STATES], right[STATES];
        for (int which = 0; which < 2; which++) {
            for (int i = 0; i < m; i++) for (int k = 0; k < m; k++)
                matrix[i * STATES + k] = (i == k && !which ? I : 0) - s->a[stuck][i][k];
            memset(right, 0, sizeof right);
            for (int i = 0; i < n; i++) for (int k = 0; k < n; k++)
                if (!which) right[n + k] += s->phi[i][k] * s->load[i] / r2;
            if (which) right[n + s->j] = 1 / r2;
            solve(m, STATES, matrix, right);
            for (int i = 0; i < m; i++) {
                if (which) s->push[stuck][i] = creal(right[i]); else s->v[stuck][i] = right[i];
            }
        }
        for (int k = 0; k < m; k++) {
            double x[STATES] = {0};
            x[k] = 1;
            propagate(m, s->a[stuck], 2 * PI / STEPS, x);
            for (int i = 0; i < m; i++) s->e[stuck][i][k] = x[i];
        }
    }
}

static double force(const Scene *s, const State *x) {
    return x->way ? x->way * s->beta : s->kappa * (x->x[s->j] - x->anchor);
}

/* Returns the state after a time t. If `whole` is set, t is one step, whose propagator is known. */
static State after(Scene *s, const State *x, double t, int whole) {
    int m = 2 * s->n, stuck = x->way == 0;
    double constant = stuck ? s->kappa * x->anchor : -x->way * s->beta, d[STATES], g[STATES];
    double complex here = cexp(I * x->t), there = cexp(I * (x->t + t));
    State y = *x;
    y.t = x->t + t;
    for (int i = 0; i < m; i++) d[i] = x->x[i] - creal(s->v[stuck][i] * here) - constant * s->push[stuck][i];
    if (whole) {
        for (int i = 0; i < m; i++) { g[i] = 0; for (int k = 0; k < m; k++) g[i] += s->e[stuck][i][k] * d[k]; }
    } else {
        memcpy(g, d, sizeof g);
        propagate(m, s->a[stuck], t, g);
    }
    for (int i = 0; i < m; i++) y.x[i] = g[i] + creal(s->v[stuck][i] * there) + constant * s->push[stuck][i];
    return y;
}

/* Returns 1 if the state shows that the present phase has ended. */
static int over(const Scene *s, const State *x) {
    return x->way ? x->way * x->x[s->n + s->j] <= 0 : fabs(force(s, x)) > s->beta;
}

static Found follow(Scene *s, double repeats) {
    State x = {0}, before;
    Found found = {0};
    for (found.steps = 1; found.steps <= MOST_CYCLES; found.steps++) {
        before = x;
        found.contact = 0;
        for (int k = 1; k <= STEPS; k++) {
            double end = 2 * PI * k / STEPS;
            for (int whole = 1;; whole = 0) {
                State y = after(s, &x, end - x.t, whole);
                if (!over(s, &y)) { x = y; break; }
                double low = 0, high = end - x.t;
                while (high - low > EVENT) {
                    double middle = (low + high) / 2;
                    y = after(s, &x, middle, 0);
                    if (over(s, &y)) high = middle; else low = middle;
                }
                y = after(s, &x, high, 0);
                double f = force(s, &y);
                if (x.way) { y.way = 0; y.anchor = y.x[s->j] - x.way * s->beta / s->kappa; }
                else y.way = f > 0 ? 1 : -1;
                found.contact = fmax(found.contact, fabs(y.x[s->j]));
                x = y;
                if (end - x.t <= 0) break;
            }
            x.t = end;
            found.contact = fmax(found.contact, fabs(x.x[s->j]));
        }
        x.t = 0;
        double moved = 0;
        for (int i = 0; i < 2 * s->n; i++) moved = fmax(moved, fabs(x.x[i] - before.x[i]));
        if (moved <= repeats) { found.settles = 1; return found; }
    }
    found.steps = MOST_CYCLES;
    return found;
}

/* Arrays of the balance: samples of cosines and sines, displacement and force, derivatives of the force, system of equations. */
typedef struct { int h, unknowns, samples; double *turn, *z, *f, *df, *force, *system, *step, *there, *x, *trial; } Balance;

static Balance make(int harmonics) {
    Balance b = {.h = harmonics, .unknowns = 2 * harmonics, .samples = 16 * (2 * harmonics - 1)};
    size_t u = b.unknowns, n = b.samples;
    b.turn = malloc(n * u * sizeof *b.turn); b.z = malloc(n * sizeof *b.z); b.f = malloc(n * sizeof *b.f);
    b.df = malloc(n * u * sizeof *b.df); b.system = malloc(u * u * sizeof *b.system); b.step = malloc(u * sizeof *b.step);
    b.force = malloc(u * sizeof *b.force); b.there = malloc(u * sizeof *b.there);
    b.x = malloc(u * sizeof *b.x); b.trial = malloc(u * sizeof *b.trial);
    for (int i = 0; i < b.samples; i++) for (int k = 0; k < harmonics; k++) {
        double angle = 2 * PI * ((long)i * (2 * k + 1) % b.samples) / b.samples;
        b.turn[i * u + 2 * k] = cos(angle); b.turn[i * u + 2 * k + 1] = sin(angle);
    }
    return b;
}

static void drop(Balance *b) {
    free(b->turn); free(b->z); free(b->f); free(b->df); free(b->force); free(b->system);
    free(b->step); free(b->there); free(b->x); free(b->trial);
}

/* Returns the motion of the contact under the load of order 1, or under a force of order n on the mass in contact. */
static double complex receptance(const Scene *s, double order, int under_load) {
    double complex sum = 0;
    for (int i = 0; i < s->n; i++) {
        double rate = order * s->r;
        sum += s->phi[i][s->j] * (under_load ? s->load[i] : s->phi[i][s->j]) /
               (s->lambda[i] - rate * rate + 2 * I * s->zeta * sqrt(s->lambda[i]) * rate);
    }
    return sum;
}

/* Computes residual z + H f - V at `x`, and with `slopes` its derivatives. Returns the residual's norm. */
static double residual(const Scene *s, Balance *b, const double *x, double *out, int slopes) {
    int u = b->unknowns, n = b->samples;
    for (int i = 0; i < n; i++) {
        b->z[i] = 0;
        for (int k = 0; k < u; k++) b->z[i] += b->turn[i * u + k] * x[k];
    }
    /* The loop covers two periods, because the force is steady in the second. */
    double f = 0;
    for (int i = 1; i <= 2 * n; i++) {
        int now = i % n, last = (i - 1) % n;
        double trial = f + s->kappa * (b->z[now] - b->z[last]);
        f = fmin(fmax(trial, -s->beta), s->beta);
        b->f[now] = f;
        if (slopes && i > n / 2) {
            if (f != trial) memset(b->df + now * u, 0, u * sizeof *b->df);
            else for (int k = 0; k < u; k++)
                b->df[now * u + k] = (i > n / 2 + 1 ? b->df[last * u + k] : 0) + s->kappa * (b->turn[now * u + k] - b->turn[last * u + k]);
        }
    }
    /* Computes harmonics from samples, as products with a matrix.  The longest loop runs over neighbours in memory. */
    memset(b->force, 0, u * sizeof *b->force);
    if (slopes) memset(b->system, 0, u * u * sizeof *b->system);
    for (int i = 0; i < n; i++) for (int k = 0; k < u; k++) {
        double turn = b->turn[i * u + k] * 2 / n, *row = b->system + k * u;
        const double *df = b->df + i * u;
        b->force[k] += turn * b->f[i];
        for (int l = 0; slopes && l < u; l++) row[l] += turn * df[l];
    }
    double norm = 0;
    for (int k = 0; k < b->h; k++) {
        double complex h = receptance(s, 2 * k + 1, 0), load = k ? 0 : receptance(s, 1, 1);
        double c = creal(h), d = cimag(h), *f = b->force + 2 * k;
        out[2 * k] = x[2 * k] + c * f[0] + d * f[1] - creal(load);
        out[2 * k + 1] = x[2 * k + 1] - d * f[0] + c * f[1] + cimag(load);
        norm += out[2 * k] * out[2 * k] + out[2 * k + 1] * out[2 * k + 1];
        double *even = b->system + 2 * k * u, *odd = even + u;
        for (int l = 0; slopes && l < u; l++) {
            double p = even[l], q = odd[l];
            even[l] = c * p + d * q + (l == 2 * k);
            odd[l] = c * q - d * p + (l == 2 * k + 1);
        }
    }
    return sqrt(norm);
}

/* Solves m x = b by Gauss's elimination with row exchanges. The solution overwrites b. */
static void solve_real(int n, double *m, double *b) {
    for (int i = 0; i < n; i++) {
        int best = i;
        for (int k = i + 1; k < n; k++) if (fabs(m[k * n + i]) > fabs(m[best * n + i])) best = k;
        for (int k = i; k < n; k++) { double s = m[i * n + k]; m[i * n + k] = m[best * n + k]; m[best * n + k] = s; }
        double s = b[i]; b[i] = b[best]; b[best] = s;
        for (int k = i + 1; k < n; k++) {
            double f = m[k * n + i] / m[i * n + i];
            for (int l = i; l < n; l++) m[k * n + l] -= f * m[i * n + l];
            b[k] -= f * b[i];
        }
    }
    for (int i = n - 1; i >= 0; i--) {
        for (int k = i + 1; k < n; k++) b[i] -= m[i * n + k] * b[k];
        b[i] /= m[i * n + i];
    }
}

static Found balance(const Scene *s, int harmonics) {
    Balance b = make(harmonics);
    Found found = {0};
    double complex first = receptance(s, 1, 1);
    memset(b.x, 0, b.unknowns * sizeof *b.x);
    b.x[0] = creal(first); b.x[1] = -cimag(first);
    double size = residual(s, &b, b.x, b.step, 1);
    for (; found.steps < MOST_NEWTON && size > 1e-12; found.steps++) {
        solve_real(b.unknowns, b.system, b.step);
        double part = 1, next = INFINITY;
        for (int tries = 0; tries < 12; tries++, part /= 2) {
            for (int k = 0; k < b.unknowns; k++) b.trial[k] = b.x[k] - part * b.step[k];
            next = residual(s, &b, b.trial, b.there, 0);
            if (next < size) break;
        }
        memcpy(b.x, b.trial, b.unknowns * sizeof *b.x);
        size = residual(s, &b, b.x, b.step, 1);
    }
    found.settles = size <= 1e-12;
    /* The amplitude is the largest of close samples, refined by a parabola. */
    int fine = 64 * b.h;
    double best = 0, at[3] = {0};
    for (int i = 0; i < fine; i++) {
        double value[3];
        for (int side = 0; side < 3; side++) {
            value[side] = 0;
            for (int k = 0; k < b.h; k++) {
                double angle = PI * (2 * k + 1) * (i + side - 1) / fine;
                value[side] += b.x[2 * k] * cos(angle) + b.x[2 * k + 1] * sin(angle);
            }
        }
        if (fabs(value[1]) > best) { best = fabs(value[1]); memcpy(at, value, sizeof at); }
    }
    double bend = at[0] - 2 * at[1] + at[2], slope = (at[2] - at[0]) / 2;
    found.contact = fabs(at[1] - (bend != 0 ? slope * slope / (2 * bend) : 0));
    drop(&b);
    return found;
}

int main(int count, char **text) {
    if (count < 10) { fprintf(stderr, "elastic stepper|balance MASSES CONTACT EXCITED ZETA STIFFNESS R BETA REPEATS|HARMONICS [RUNS]\n"); return 2; }
    int steps = !strcmp(text[1], "stepper"), n = atoi(text[2]), contact = atoi(text[3]), excited = atoi(text[4]);
    int runs = count > 10 ? atoi(text[10]) : 1;
    if (n < 1 || n > MOST || contact < 1 || contact > n || excited < 1 || excited > n || runs < 1) return 2;
    double *times = malloc(runs * sizeof *times);
    Scene s;
    Found found = {0};
    for (int i = 0; i < runs; i++) {
        double start = now();
        prepare(&s, n, contact, excited, atof(text[5]), atof(text[6]), atof(text[7]), atof(text[8]));
        if (steps) { prepare_steps(&s); found = follow(&s, atof(text[9])); }
        else found = balance(&s, atoi(text[9]));
        times[i] = 1e6 * (now() - start);
    }
    printf("%.3f %d %s %.17g\n", median(times, runs), found.steps, found.settles ? "settles" : "moves-on", found.contact);
    free(times);
    return 0;
}
