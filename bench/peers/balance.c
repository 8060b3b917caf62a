/* A peer for steady states with several elastic contacts (Jenkins elements) and dashpots: harmonic balance with the
 * alternation between frequency and time.
 *
 *   balance MASSES ZETA DASHPOT STIFFNESS FROM TO COUNT BETA HARMONICS [RUNS]
 *
 * The chain is that of joints.c. The displacements are sums of the odd harmonics up to HARMONICS. The exact law of each
 * contact gives its force at SAMPLES instants (1024) of a cycle, after one cycle from a slider at 0. Newton's method
 * with the derivatives of these forces solves the equations. It starts from the solution at the previous frequency, or,
 * if this does not converge, from the response with all contacts stuck. A step that does not reduce the residual is
 * halved.
 *
 * Prints: milliseconds for all frequencies (median of RUNS), the number of frequencies that converge, the mean number of
 * Newton steps, then for each frequency the amplitude of the last mass over the samples, or none.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "timing.h"

#ifndef SAMPLES
#define SAMPLES 1024
#endif
enum { MOST = 8, ODD = 32, SIZE = 2 * MOST * ODD, MOST_STEPS = 60 };
static const double PI = 3.14159265358979323846, CONVERGED = 1e-10;

typedef struct { int n, odd; double r, zeta, dashpot, kappa, level[MOST]; } Scene;

static double wave[2 * ODD][SAMPLES];         /* cosines and sines of the odd harmonics */
static double matrix[SIZE][SIZE], force[MOST][2 * ODD], slope[MOST][2 * ODD][2 * ODD];
static double stiff[MOST][MOST], damp[MOST][MOST];

/* Adds value w w^T of the storey j. */
static void storey(double a[MOST][MOST], int j, double value) {
    a[j][j] += value;
    if (!j) return;
    a[j][j - 1] -= value; a[j - 1][j] -= value; a[j - 1][j - 1] += value;
}

/* Makes the matrices of springs and of damping. */
static void linear(const Scene *s) {
    int n = s->n;
    memset(stiff, 0, sizeof stiff); memset(damp, 0, sizeof damp);
    for (int i = 0; i < n; i++) {
        double angle = PI * (2 * i + 1) / (2 * n + 1), norm = 0, phi[MOST], rate = 2 * sin(angle / 2);
        for (int k = 0; k < n; k++) { phi[k] = sin(angle * (k + 1)); norm += phi[k] * phi[k]; }
        for (int k = 0; k < n; k++) for (int l = 0; l < n; l++) damp[k][l] += 2 * s->zeta * rate * phi[k] * phi[l] / norm;
    }
    for (int j = 0; j < n; j++) { storey(stiff, j, 1); storey(damp, j, s->dashpot); }
}

/* The relative displacement of a storey, coefficient by coefficient. Mass i has the coefficients x[i * 2 * odd + c]. */
static double across(const Scene *s, const double *x, int j, int c) {
    int width = 2 * s->odd;
    return x[j * width + c] - (j ? x[(j - 1) * width + c] : 0);
}

/* Computes the harmonics of the force of a contact. If `derives` is set, also computes their derivatives with respect to
 * those of its displacement. */
static void contact(const Scene *s, const double *x, int j, int derives) {
    int width = 2 * s->odd;
    double z[2 * ODD], d[2 * ODD], place = 0, f = 0, before = 0;
    for (int c = 0; c < width; c++) z[c] = across(s, x, j, c);
    memset(force[j], 0, sizeof force[j]);
    if (derives) memset(slope[j], 0, sizeof slope[j]);
    for (int k = 0; k <= 2 * SAMPLES - 1; k++) {
        int i = k % SAMPLES, last = (i + SAMPLES - 1) % SAMPLES;
        before = place; place = 0;
        for (int c = 0; c < width; c++) place += z[c] * wave[c][i];
        f = k ? f + s->kappa * (place - before) : s->kappa * place;
        if (fabs(f) > s->level[j]) {
            f = copysign(s->level[j], f);
            memset(d, 0, sizeof d);
        } else if (derives) for (int c = 0; c < width; c++) {
            d[c] = k ? d[c] + s->kappa * (wave[c][i] - wave[c][last]) : s->kappa * wave[c][i];
        }
        if (k < SAMPLES) continue;
        for (int row = 0; row < width; row++) {
            double w = 2 * wave[row][i] / SAMPLES;
            force[j][row] += w * f;
            if (derives) for (int c = 0; c < width; c++) slope[j][row][c] += w * d[c];
        }
    }
}

/* Computes the residual, and the matrix of derivatives if `derives` is set. Returns the largest absolute residual. */
static double residual(const Scene *s, const double *x, double *left, int derives) {
    int n = s->n, width = 2 * s->odd, size = n * width;
    if (derives) for (int i = 0; i < size; i++) memset(matrix[i], 0, size * sizeof matrix[i][0]);
    for (int j = 0; j < n; j++) contact(s, x, j, derives);
    for (int i = 0; i < n; i++) for (int h = 0; h < s->odd; h++) {
        double w = (2 * h + 1) * s->r;
        int a = i * width + 2 * h, b = a + 1;
        left[a] = i == n - 1 && !h ? -1 : 0; left[b] = 0;
        for (int k = 0; k < n; k++) {
            double spring = stiff[i][k] - (i == k ? w * w : 0), loss = w * damp[i][k];
            int c = k * width + 2 * h, d = c + 1;
            left[a] += spring * x[c] + loss * x[d];
            left[b] += spring * x[d] - loss * x[c];
            if (derives) { matrix[a][c] += spring; matrix[a][d] += loss; matrix[b][d] += spring; matrix[b][c] -= loss; }
        }
    }
    for (int j = 0; j < n; j++) for (int row = 0; row < width; row++) {
        int up = j * width, down = (j - 1) * width;
        left[up + row] += force[j][row];
        if (j) left[down + row] -= force[j][row];
        if (derives) for (int c = 0; c < width; c++) {
            double value = slope[j][row][c];
            matrix[up + row][up + c] += value;
            if (!j) continue;
            matrix[up + row][down + c] -= value; matrix[down + row][up + c] -= value; matrix[down + row][down + c] += value;
        }
    }
    double most = 0;
    for (int i = 0; i < size; i++) most = fmax(most, fabs(left[i]));
    return most;
}

/* Solves matrix x = b by Gauss's elimination with row exchanges. The solution overwrites b. */
static void solve(int n, double *b) {
    static double *rows[SIZE];
    for (int i = 0; i < n; i++) rows[i] = matrix[i];
    for (int i = 0; i < n; i++) {
        int best = i;
        for (int k = i + 1; k < n; k++) if (fabs(rows[k][i]) > fabs(rows[best][i])) best = k;
        double *row = rows[i], value = b[i];
        rows[i] = rows[best]; rows[best] = row; b[i] = b[best]; b[best] = value;
        for (int k = i + 1; k < n; k++) {
            double f = rows[k][i] / rows[i][i];
            if (f == 0) continue;
            for (int l = i + 1; l < n; l++) rows[k][l] -= f * rows[i][l];
            b[k] -= f * b[i];
        }
    }
    for (int i = n - 1; i >= 0; i--) {
        for (int k = i + 1; k < n; k++) b[i] -= rows[i][k] * b[k];
        b[i] /= rows[i][i];
    }
}

/* Newton's method. Returns the number of steps, or 0 without convergence. */
static int balance(const Scene *s, double *x) {
    static double left[SIZE], trial[SIZE], other[SIZE];
    int size = 2 * s->odd * s->n;
    for (int step = 1; step <= MOST_STEPS; step++) {
        double most = residual(s, x, left, 1);
        if (most <= CONVERGED) return step;
        solve(size, left);
        double part = 1;
        for (int tries = 0; tries < 6; tries++, part /= 2) {
            for (int i = 0; i < size; i++) trial[i] = x[i] - part * left[i];
            if (residual(s, trial, other, 0) < most) break;
        }
        memcpy(x, trial, size * sizeof *x);
    }
    return 0;
}

/* Computes the response with all contacts stuck: one Newton step from 0, without a limit of the contact forces. */
static void stuck(const Scene *s, double *x) {
    static double left[SIZE];
    Scene free = *s;
    int size = 2 * s->odd * s->n;
    for (int j = 0; j < s->n; j++) free.level[j] = 1e30;
    memset(x, 0, size * sizeof *x);
    residual(&free, x, left, 1);
    solve(size, left);
    for (int i = 0; i < size; i++) x[i] = -left[i];
}

int main(int count, char **text) {
    if (count < 10) { fprintf(stderr, "balance MASSES ZETA DASHPOT STIFFNESS FROM TO COUNT BETA HARMONICS [RUNS]\n"); return 2; }
    int n = atoi(text[1]), points = atoi(text[7]), odd = (atoi(text[9]) + 1) / 2, runs = count > 10 ? atoi(text[10]) : 1;
    double from = atof(text[5]), to = atof(text[6]), beta = atof(text[8]);
    if (n < 1 || n > MOST || points < 2 || runs < 1 || odd < 1 || odd > ODD) return 2;
    for (int h = 0; h < odd; h++) for (int i = 0; i < SAMPLES; i++) {
        double angle = 2 * PI * (2 * h + 1) * i / SAMPLES;
        wave[2 * h][i] = cos(angle); wave[2 * h + 1][i] = sin(angle);
    }
    double *times = malloc(runs * sizeof *times), *sizes = calloc(points, sizeof *sizes), steps = 0;
    int converged = 0;
    static double x[SIZE];
    for (int run = 0; run < runs; run++) {
        double start = now();
        converged = 0; steps = 0;
        int known = 0;
        for (int k = 0; k < points; k++) {
            Scene s = {.n = n, .odd = odd, .zeta = atof(text[2]), .dashpot = atof(text[3]), .kappa = atof(text[4])};
            s.r = from + (to - from) * k / (points - 1);
            for (int j = 0; j < n; j++) s.level[j] = (1 - 0.1 * j) * beta;
            linear(&s);
            int found = known ? balance(&s, x) : 0;
            if (!found) { stuck(&s, x); found = balance(&s, x); }
            known = found > 0; converged += known; steps += found;
            sizes[k] = -1;
            for (int i = 0; known && i < SAMPLES; i++) {
                double place = 0;
                for (int c = 0; c < 2 * odd; c++) place += x[(n - 1) * 2 * odd + c] * wave[c][i];
                sizes[k] = fmax(sizes[k], fabs(place));
            }
        }
        times[run] = 1e3 * (now() - start);
    }
    printf("%.3f %d %.1f\n", median(times, runs), converged, converged ? steps / converged : 0);
    for (int k = 0; k < points; k++) if (sizes[k] < 0) puts("none"); else printf("%.17g\n", sizes[k]);
    free(times); free(sizes);
    return 0;
}
