/* Computes steady states with a plain exact event stepper, to compare them with those of frictiongen.
 *
 *   stepper MASSES CONTACT EXCITED ZETA R BETA [MOST_CYCLES [RUNS]]
 *   stepper MASSES CONTACT EXCITED ZETA - MU [MOST_CYCLES]
 *
 * A chain of equal masses and springs on the base, with one contact of mass CONTACT with the wall and modal damping
 * ZETA. A harmonic force acts on mass EXCITED. With EXCITED = 0 the base moves, and the wall moves with the base. mu is
 * 1 unless MU is given. The run starts from rest in relative motion and takes steps of 1/50 cycle with the exact
 * propagator of the present phase, sliding or stuck. An event is a change of sign at the end of a step, which is
 * bisected to 1e-12. The run ends when the state repeats from cycle to cycle within 1e-9.
 *
 * Prints: microseconds (median of RUNS), number of cycles, whether the state repeats, stops and reversals of the last
 * cycle, amplitude of the relative motion in the contact, amplitude of the mass in contact. With - in place of R, the
 * program reads pairs of r and beta from standard input, and prints a line for each pair, without the time. The total
 * time goes to standard error.
 */
#include <complex.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "timing.h"

#ifndef STEPS
#define STEPS 50
#endif
enum { MOST = 10, STATES = 2 * MOST };
static const double PI = 3.14159265358979323846, REPEATS = 1e-9, EVENT = 1e-12;

typedef struct {
    int n, j, base;              /* number of masses, mass in contact, 1 if the base moves */
    double r, beta, mu;
    double k[MOST][MOST], c[MOST][MOST], p[MOST]; /* x'' = p cos t - c x' - k x without friction */
    double phi[MOST][MOST];      /* mode shapes, [mode][mass] */
    double w[MOST], zeta;        /* natural frequencies over that of the excitation, damping ratio */
    double complex v[MOST];      /* complex amplitudes of the modes under the load */
    double push[MOST];           /* static displacement of each mode under the force beta */
    double step[MOST][2][2];     /* sliding: exact propagator of each mode over one step */
    int m;                       /* number of states while the contact sticks */
    double a[STATES][STATES], e[STATES][STATES]; /* stuck: matrix a of x' = a x, e = exp(a step) */
    double complex held[STATES]; /* stuck: complex amplitudes of the states under the load */
    double bend[MOST];           /* stuck: static displacements for a displacement of the contact of 1 */
} Scene;

typedef struct {
    double t;                    /* time since the start of the cycle, in rad */
    int way;                     /* direction of sliding: -1 or 1, 0 while stuck */
    double q[MOST], u[MOST];     /* modal displacements and velocities */
} State;

typedef struct { int cycles, repeats, stops, reversals; double contact, mass; } Found;

/* Solves m x = b by Gauss's elimination with row exchanges. The solution overwrites b. */
static void solve(int n, double complex m[STATES][STATES], double complex *b) {
    for (int i = 0; i < n; i++) {
        int best = i;
        for (int k = i + 1; k < n; k++) if (cabs(m[k][i]) > cabs(m[best][i])) best = k;
        for (int k = 0; k < n; k++) { double complex s = m[i][k]; m[i][k] = m[best][k]; m[best][k] = s; }
        double complex s = b[i]; b[i] = b[best]; b[best] = s;
        for (int k = i + 1; k < n; k++) {
            double complex f = m[k][i] / m[i][i];
            for (int l = i; l < n; l++) m[k][l] -= f * m[i][l];
            b[k] -= f * b[i];
        }
    }
    for (int i = n - 1; i >= 0; i--) {
        for (int k = i + 1; k < n; k++) b[i] -= m[i][k] * b[k];
        b[i] /= m[i][i];
    }
}

/* Computes the modes of a symmetric matrix by Jacobi's rotations. */
static void modes(int n, double m[MOST][MOST], double phi[MOST][MOST], double *lambda) {
    for (int i = 0; i < n; i++) for (int k = 0; k < n; k++) phi[i][k] = i == k;
    for (int sweep = 0; sweep < 30; sweep++)
        for (int a = 0; a < n; a++)
            for (int b = a + 1; b < n; b++) {
                if (m[a][b] == 0) continue;
                double h = (m[b][b] - m[a][a]) / (2 * m[a][b]);
                double t = (h < 0 ? -1 : 1) / (fabs(h) + sqrt(h * h + 1));
                double c = 1 / sqrt(t * t + 1), s = t * c;
                for (int k = 0; k < n; k++) {
                    double x = m[k][a], y = m[k][b];
                    m[k][a] = c * x - s * y; m[k][b] = s * x + c * y;
                }
                for (int k = 0; k < n; k++) {
                    double x = m[a][k], y = m[b][k];
                    m[a][k] = c * x - s * y; m[b][k] = s * x + c * y;
                    x = phi[a][k]; y = phi[b][k];
                    phi[a][k] = c * x - s * y; phi[b][k] = s * x + c * y;
                }
            }
    for (int i = 0; i < n; i++) lambda[i] = m[i][i];
}

/* Computes the exact 2 x 2 propagator of a free mode over t. */
static void free_mode(double w, double zeta, double t, double out[2][2]) {
    double d = w * sqrt(1 - zeta * zeta), e = exp(-zeta * w * t);
    double c = e * cos(d * t), s = e * sin(d * t) / d;
    out[0][0] = c + zeta * w * s; out[0][1] = s;
    out[1][0] = -w * w * s; out[1][1] = c - zeta * w * s;
}

/* Replaces x by exp(a t) x, by Taylor's series. */
static void free_stuck(const Scene *s, double t, double *x) {
    double term[STATES], next[STATES];
    memcpy(term, x, sizeof term);
    for (int k = 1; k < 60; k++) {
        double size = 0, all = 0;
        for (int i = 0; i < s->m; i++) {
            next[i] = 0;
            for (int l = 0; l < s->m; l++) next[i] += s->a[i][l] * term[l];
            next[i] *= t / k;
        }
        for (int i = 0; i < s->m; i++) {
            term[i] = next[i]; x[i] += next[i];
            size = fmax(size, fabs(next[i])); all = fmax(all, fabs(x[i]));
        }
        if (size <= 1e-17 * all) return;
    }
}

/* Returns the index in the chain of the i-th mass that can move while the contact sticks. */
static int place(const Scene *s, int i) { return i < s->j ? i : i + 1; }

static void prepare(Scene *s, int n, int contact, int excited, double zeta, double r, double beta) {
    memset(s, 0, sizeof *s);
    s->n = n; s->j = contact - 1; s->base = excited == 0; s->r = r; s->beta = beta; s->zeta = zeta; s->mu = 1;
    double chain[MOST][MOST] = {{0}}, lambda[MOST], r2 = r * r, h = 2 * PI / STEPS;
    for (int i = 0; i < n; i++) {
        chain[i][i] = i + 1 < n ? 2 : 1;
        if (i + 1 < n) chain[i][i + 1] = chain[i + 1][i] = -1;
        /* In coordinates relative to a moving base, the base's acceleration acts on every mass. */
        s->p[i] = s->base ? 1 : (i == excited - 1) / r2;
    }
    for (int i = 0; i < n; i++) for (int k = 0; k < n; k++) s->k[i][k] = chain[i][k] / r2;
    modes(n, chain, s->phi, lambda);
    for (int i = 0; i < n; i++) {
        s->w[i] = sqrt(lambda[i]) / r;
        double load = 0;
        for (int k = 0; k < n; k++) load += s->phi[i][k] * s->p[k];
        s->v[i] = load / (s->w[i] * s->w[i] - 1 + 2 * I * zeta * s->w[i]);
        s->push[i] = s->phi[i][s->j] * beta / lambda[i];
        free_mode(s->w[i], zeta, h, s->step[i]);
        for (int k = 0; k < n; k++) for (int l = 0; l < n; l++)
            s->c[k][l] += 2 * zeta * s->w[i] * s->phi[i][k] * s->phi[i][l];
    }
    int f = n - 1;
    s->m = 2 * f;
    double complex m[STATES][STATES], b[STATES];
    for (int i = 0; i < f; i++) {
        s->a[i][f + i] = 1;
        for (int k = 0; k < f; k++) {
            s->a[f + i][k] = -s->k[place(s, i)][place(s, k)];
            s->a[f + i][f + k] = -s->c[place(s, i)][place(s, k)];
            m[i][k] = s->k[place(s, i)][place(s, k)];
        }
        b[i] = -s->k[place(s, i)][s->j];
    }
    solve(f, m, b);
    for (int i = 0; i < f; i++) s->bend[i] = creal(b[i]);
    for (int i = 0; i < s->m; i++) {
        for (int k = 0; k < s->m; k++) m[i][k] = (i == k) * I - s->a[i][k];
        s->held[i] = i < f ? 0 : s->p[place(s, i - f)];
    }
    solve(s->m, m, s->held);
    for (int k = 0; k < s->m; k++) {
        double x[STATES] = {0};
        x[k] = 1;
        free_stuck(s, h, x);
        for (int i = 0; i < s->m; i++) s->e[i][k] = x[i];
    }
}

/* Returns displacement or velocity of a mass from its modal coordinates or their rates. */
static double of(const Scene *s, const double *modal, int mass) {
    double sum = 0;
    for (int i = 0; i < s->n; i++) sum += s->phi[i][mass] * modal[i];
    return sum;
}

/* Returns the contact force that would keep the contact at rest, in the unit of beta. */
static double load(const Scene *s, const State *x) {
    double sum = s->p[s->j] * cos(x->t);
    for (int i = 0; i < s->n; i++)
        sum -= s->phi[i][s->j] * (s->w[i] * s->w[i] * x->q[i] + 2 * s->zeta * s->w[i] * x->u[i]);
    return sum * s->r * s->r;
}

/* Returns the state after a time t. If `whole` is set, t is one step, whose propagators are known. */
static State after(const Scene *s, const State *x, double t, int whole) {
    State y = *x;
    y.t = x->t + t;
    double complex here = cexp(I * x->t), there = cexp(I * y.t);
    if (x->way) {
        for (int i = 0; i < s->n; i++) {
            double g[2][2];
            const double (*m)[2] = s->step[i];
            if (!whole) { free_mode(s->w[i], s->zeta, t, g); m = (const double (*)[2])g; }
            double complex a = s->v[i] * here, b = s->v[i] * there;
            double q = x->q[i] - creal(a) + x->way * s->push[i], u = x->u[i] + cimag(a);
            y.q[i] = m[0][0] * q + m[0][1] * u + creal(b) - x->way * s->push[i];
            y.u[i] = m[1][0] * q + m[1][1] * u - cimag(b);
        }
        return y;
    }
    int f = s->n - 1;
    double z = of(s, x->q, s->j), d[STATES] = {0}, g[STATES], at[MOST], rate[MOST];
    for (int i = 0; i < f; i++) {
        d[i] = of(s, x->q, place(s, i)) - s->bend[i] * z - creal(s->held[i] * here);
        d[f + i] = of(s, x->u, place(s, i)) - creal(s->held[f + i] * here);
    }
    if (whole) {
        for (int i = 0; i < s->m; i++) {
            g[i] = 0;
            for (int k = 0; k < s->m; k++) g[i] += s->e[i][k] * d[k];
        }
    } else {
        memcpy(g, d, sizeof g);
        free_stuck(s, t, g);
    }
    at[s->j] = z; rate[s->j] = 0;
    for (int i = 0; i < f; i++) {
        at[place(s, i)] = g[i] + s->bend[i] * z + creal(s->held[i] * there);
        rate[place(s, i)] = g[f + i] + creal(s->held[f + i] * there);
    }
    for (int i = 0; i < s->n; i++) {
        y.q[i] = y.u[i] = 0;
        for (int k = 0; k < s->n; k++) { y.q[i] += s->phi[i][k] * at[k]; y.u[i] += s->phi[i][k] * rate[k]; }
    }
    return y;
}

/* Returns 1 if the state shows that the present phase (sliding or stuck) has ended. */
static int over(const Scene *s, const State *x) {
    return x->way ? x->way * of(s, x->u, s->j) <= 0 : fabs(load(s, x)) > s->mu * s->beta;
}

static void look(const Scene *s, const State *x, Found *found) {
    double z = of(s, x->q, s->j);
    found->contact = fmax(found->contact, fabs(z));
    found->mass = fmax(found->mass, fabs(z + (s->base ? cos(x->t) : 0)));
}

static Found follow(const Scene *s, int most) {
    State x = {0}, before;
    Found found = {0};
    x.way = fabs(load(s, &x)) > s->mu * s->beta ? (load(s, &x) > 0 ? 1 : -1) : 0;
    for (found.cycles = 1; found.cycles <= most; found.cycles++) {
        before = x;
        found.stops = found.reversals = 0;
        found.contact = found.mass = 0;
        for (int k = 1; k <= STEPS; k++) {
            double end = 2 * PI * k / STEPS;
            int whole = 1;
            for (;;) {
                State y = after(s, &x, end - x.t, whole);
                if (!over(s, &y)) { x = y; break; }
                double low = 0, high = end - x.t;
                while (high - low > EVENT) {
                    double middle = (low + high) / 2;
                    y = after(s, &x, middle, 0);
                    if (over(s, &y)) high = middle; else low = middle;
                }
                y = after(s, &x, high, 0);
                double force = load(s, &y);
                if (x.way && fabs(force) <= s->mu * s->beta) { y.way = 0; found.stops++; }
                else { found.reversals += x.way != 0; y.way = force > 0 ? 1 : -1; }
                if (x.way) look(s, &y, &found);
                x = y;
                whole = 0;
                if (end - x.t <= 0) break;
            }
            x.t = end;
            look(s, &x, &found);
        }
        x.t = 0;
        double moved = 0;
        for (int i = 0; i < s->n; i++)
            moved = fmax(moved, fmax(fabs(x.q[i] - before.q[i]), fabs(x.u[i] - before.u[i])));
        if (moved <= REPEATS) { found.repeats = 1; return found; }
    }
    found.cycles = most;
    return found;
}

static int many(int n, int contact, int excited, double zeta, double mu, int most) {
    double r, beta, all = 0;
    while (scanf("%lf %lf", &r, &beta) == 2) {
        Scene s;
        double start = now();
        prepare(&s, n, contact, excited, zeta, r, beta);
        s.mu = mu;
        Found found = follow(&s, most);
        all += now() - start;
        printf("%d %d %d %d %.17g\n", found.cycles, found.repeats, found.stops, found.reversals, found.contact);
    }
    fprintf(stderr, "%.6f\n", all);
    return 0;
}

int main(int count, char **text) {
    if (count < 7) { fprintf(stderr, "stepper MASSES CONTACT EXCITED ZETA R BETA [MOST_CYCLES [RUNS]]\n"); return 2; }
    int n = atoi(text[1]), contact = atoi(text[2]), excited = atoi(text[3]);
    int most = count > 7 ? atoi(text[7]) : 20000, runs = count > 8 ? atoi(text[8]) : 1;
    if (n < 1 || n > MOST || contact < 1 || contact > n || excited < 0 || excited > n || runs < 1) return 2;
    if (!strcmp(text[5], "-")) return many(n, contact, excited, atof(text[4]), atof(text[6]), most);
    double *times = malloc(runs * sizeof *times);
    Scene s;
    Found found;
    for (int i = 0; i < runs; i++) {
        double start = now();
        prepare(&s, n, contact, excited, atof(text[4]), atof(text[5]), atof(text[6]));
        found = follow(&s, most);
        times[i] = 1e6 * (now() - start);
    }
    printf("%.3f %d %s %d %d %.17g %.17g\n", median(times, runs), found.cycles,
           found.repeats ? "repeats" : "moves-on", found.stops, found.reversals, found.contact, found.mass);
    free(times);
    return 0;
}
