/* Computes steady states with several elastic contacts (Jenkins elements) and dashpots, to compare them with those of
 * frictiongen. The method is a plain exact event stepper.
 *
 *   joints MASSES ZETA DASHPOT STIFFNESS FROM TO COUNT BETA REPEATS [RUNS]
 *
 * A chain of equal masses and springs on the base, with modal damping ZETA. Each storey has a contact and a dashpot
 * between its two floors. STIFFNESS is the stiffness of each contact divided by that of a spring. DASHPOT is the
 * coefficient of each dashpot divided by the square root of spring times mass. The friction of storey i divided by the
 * load is (1.1 - 0.1 i) BETA. A harmonic force acts on the last mass, at COUNT frequency ratios from FROM to TO.
 *
 * At each frequency the stepper runs from rest. It takes STEPS_A_CYCLE (50) steps in a cycle, with the exact propagator
 * of the present pattern of sliding and stuck contacts. It computes a propagator when its pattern first occurs. An event
 * is a change of sign at the end of a step. Bisection finds its time to 1e-12 rad. The run ends when the state repeats
 * from cycle to cycle within REPEATS.
 *
 * Prints: milliseconds for all frequencies (median of RUNS), the number of frequencies that settle, the mean number of
 * cycles, then for each frequency the displacement of the last mass at a maximum of the load.
 */
#include <complex.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "timing.h"

#ifndef STEPS_A_CYCLE
#define STEPS_A_CYCLE 50
#endif
enum { MOST = 8, STATES = 2 * MOST, STEPS = STEPS_A_CYCLE, MOST_CYCLES = 20000 };
static const double PI = 3.14159265358979323846, EVENT = 1e-12;

typedef struct {                 /* the linear chain with some contacts stuck: x' = a x + b cos t + g */
    double a[STATES][STATES];    /* x has displacements, then velocities */
    double e[STATES][STATES];    /* exp(a h) for one step h */
    double complex v[STATES];    /* complex amplitudes of the states under the load */
    double push[MOST][STATES];   /* static state under a force of 1 in each contact */
} Pattern;

typedef struct {
    int n;
    double r, zeta, dashpot, kappa, level[MOST];
    Pattern *patterns[1 << MOST];
} Scene;

typedef struct { double t; int way[MOST]; double anchor[MOST], x[STATES]; } State; /* anchor: place without force */

/* Solves the complex system m x = b by Gauss's elimination with row exchanges. The solution overwrites b. */
static void solve(int n, double complex m[STATES][STATES], double complex *b) {
    for (int i = 0; i < n; i++) {
        int best = i;
        for (int k = i + 1; k < n; k++) if (cabs(m[k][i]) > cabs(m[best][i])) best = k;
        if (best != i) {
            for (int k = i; k < n; k++) { double complex s = m[i][k]; m[i][k] = m[best][k]; m[best][k] = s; }
            double complex s = b[i]; b[i] = b[best]; b[best] = s;
        }
        for (int k = i + 1; k < n; k++) {
            double complex f = m[k][i] / m[i][i];
            if (f == 0) continue;
            for (int l = i; l < n; l++) m[k][l] -= f * m[i][l];
            b[k] -= f * b[i];
        }
    }
    for (int i = n - 1; i >= 0; i--) {
        for (int k = i + 1; k < n; k++) b[i] -= m[i][k] * b[k];
        b[i] /= m[i][i];
    }
}

#include "propagate.h"

/* Adds value w w^T of the storey j to the rows of the velocities. */
static void storey(int n, double a[STATES][STATES], int j, int column, double value) {
    a[n + j][column + j] += value;
    if (!j) return;
    a[n + j][column + j - 1] -= value; a[n + j - 1][column + j] -= value; a[n + j - 1][column + j - 1] += value;
}

/* Makes matrices, propagator, and the answers to load and constant forces, of a set of stuck contacts. */
static Pattern *pattern(Scene *s, int stuck) {
    if (s->patterns[stuck]) return s->patterns[stuck];
    Pattern *p = s->patterns[stuck] = calloc(1, sizeof *p);
    int n = s->n, m = 2 * n;
    double r2 = s->r * s->r;
    /* The modes of the chain have a closed form: lambda = 4 sin^2, shapes are sines. */
    for (int i = 0; i < n; i++) {
        double angle = PI * (2 * i + 1) / (2 * n + 1), norm = 0, phi[MOST];
        for (int k = 0; k < n; k++) { phi[k] = sin(angle * (k + 1)); norm += phi[k] * phi[k]; }
        double rate = 2 * sin(angle / 2);
        for (int k = 0; k < n; k++) for (int l = 0; l < n; l++) {
            p->a[n + k][l] -= rate * rate * phi[k] * phi[l] / norm / r2;
            p->a[n + k][n + l] -= 2 * s->zeta * rate / s->r * phi[k] * phi[l] / norm;
        }
        p->a[i][n + i] = 1;
    }
    for (int j = 0; j < n; j++) {
        storey(n, p->a, j, n, -s->dashpot / s->r);
        if (stuck >> j & 1) storey(n, p->a, j, 0, -s->kappa / r2);
    }
    for (int which = 0; which <= n; which++) {
        double complex matrix[STATES][STATES], right[STATES] = {0};
        for (int i = 0; i < m; i++) for (int k = 0; k < m; k++) matrix[i][k] = (i == k && !which ? I : 0) - p->a[i][k];
        if (!which) right[m - 1] = 1 / r2;
        else { right[n + which - 1] = 1 / r2; if (which > 1) right[n + which - 2] = -1 / r2; }
        solve(m, matrix, right);
        for (int i = 0; i < m; i++) { if (which) p->push[which - 1][i] = creal(right[i]); else p->v[i] = right[i]; }
    }
    for (int k = 0; k < m; k++) {
        double x[STATES] = {0};
        x[k] = 1;
        propagate(m, p->a, 2 * PI / STEPS, x);
        for (int i = 0; i < m; i++) p->e[i][k] = x[i];
    }
    return p;
}

static double across(const double *x, int j) { return x[j] - (j ? x[j - 1] : 0); }

static double force(const Scene *s, const State *x, int j) {
    return x->way[j] ? x->way[j] * s->level[j] : s->kappa * (across(x->x, j) - x->anchor[j]);
}

/* Returns the state after a time t. If `whole` is set, t is one step, whose propagator is known. */
static State after(Scene *s, const State *x, double t, int whole) {
    int n = s->n, m = 2 * n, stuck = 0;
    for (int j = 0; j < n; j++) if (!x->way[j]) stuck |= 1 << j;
    Pattern *p = pattern(s, stuck);
    double rest[STATES] = {0}, d[STATES] = {0}, g[STATES];
    for (int j = 0; j < n; j++) {
        double constant = x->way[j] ? -x->way[j] * s->level[j] : s->kappa * x->anchor[j];
        for (int i = 0; i < m; i++) rest[i] += constant * p->push[j][i];
    }
    double complex here = cexp(I * x->t), there = cexp(I * (x->t + t));
    State y = *x;
    y.t = x->t + t;
    for (int i = 0; i < m; i++) d[i] = x->x[i] - creal(p->v[i] * here) - rest[i];
    if (whole) {
        for (int i = 0; i < m; i++) { g[i] = 0; for (int k = 0; k < m; k++) g[i] += p->e[i][k] * d[k]; }
    } else {
        memcpy(g, d, sizeof g);
        propagate(m, p->a, t, g);
    }
    for (int i = 0; i < m; i++) y.x[i] = g[i] + creal(p->v[i] * there) + rest[i];
    return y;
}

/* Returns 1 if the state shows that the present phase of a contact has ended. */
static int ends(const Scene *s, const State *x, int j) {
    return x->way[j] ? x->way[j] * across(x->x + s->n, j) <= 0 : fabs(force(s, x, j)) > s->level[j];
}

static int over(const Scene *s, const State *x) {
    for (int j = 0; j < s->n; j++) if (ends(s, x, j)) return 1;
    return 0;
}

/* Runs until the state repeats. Returns the number of cycles, or 0. */
static int follow(Scene *s, double repeats, double *place) {
    State x = {0}, before;
    for (int cycle = 1; cycle <= MOST_CYCLES; cycle++) {
        before = x;
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
                x = y;
                for (int j = 0; j < s->n; j++) {
                    if (!ends(s, &y, j)) continue;
                    double f = force(s, &y, j);
                    if (y.way[j]) { x.way[j] = 0; x.anchor[j] = across(y.x, j) - y.way[j] * s->level[j] / s->kappa; }
                    else x.way[j] = f > 0 ? 1 : -1;
                }
                if (end - x.t <= 0) break;
            }
            x.t = end;
        }
        x.t = 0;
        double moved = 0;
        for (int i = 0; i < 2 * s->n; i++) moved = fmax(moved, fabs(x.x[i] - before.x[i]));
        *place = x.x[s->n - 1];
        if (moved <= repeats) return cycle;
    }
    return 0;
}

int main(int count, char **text) {
    if (count < 10) { fprintf(stderr, "joints MASSES ZETA DASHPOT STIFFNESS FROM TO COUNT BETA REPEATS [RUNS]\n"); return 2; }
    int n = atoi(text[1]), points = atoi(text[7]), runs = count > 10 ? atoi(text[10]) : 1, settled = 0;
    double from = atof(text[5]), to = atof(text[6]), beta = atof(text[8]), repeats = atof(text[9]);
    if (n < 1 || n > MOST || points < 2 || runs < 1) return 2;
    double *times = malloc(runs * sizeof *times), *places = calloc(points, sizeof *places), cycles = 0;
    for (int i = 0; i < runs; i++) {
        double start = now();
        settled = 0; cycles = 0;
        for (int k = 0; k < points; k++) {
            Scene s = {.n = n, .zeta = atof(text[2]), .dashpot = atof(text[3]), .kappa = atof(text[4])};
            s.r = from + (to - from) * k / (points - 1);
            for (int j = 0; j < n; j++) s.level[j] = (1 - 0.1 * j) * beta;
            int found = follow(&s, repeats, places + k);
            settled += found > 0; cycles += found;
            for (int j = 0; j < 1 << n; j++) free(s.patterns[j]);
        }
        times[i] = 1e3 * (now() - start);
    }
    printf("%.3f %d %.1f\n", median(times, runs), settled, settled ? cycles / settled : 0);
    for (int k = 0; k < points; k++) printf("%.17g\n", places[k]);
    free(times); free(places);
    return 0;
}
