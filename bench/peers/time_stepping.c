/* Integrates motions in time with usual fixed-step methods, to compare them with frictiongen's stepper.
 *
 *   time_stepping METHOD MASSES CONTACT EXCITED A B R BETA STEPS CYCLES [RUNS]
 *
 * A chain of equal masses and springs on the base (base - 1 - 2 - ...), with one contact of mass CONTACT with the wall,
 * mu = 1, and damping C = a M + b K in units of m and k. A force cos t acts on mass EXCITED. A cycle has STEPS steps.
 * In units of m = k = P = 1 the run starts from rest and covers CYCLES cycles. METHOD is one of:
 *
 *   moreau-half   Moreau-Jean with theta = 1/2: impulses of the contact over a step, the velocity at its end
 *   moreau-one    Moreau-Jean with theta = 1
 *   rk4           fourth-order Runge-Kutta method. The contact is switched at the end of a step: it is stopped if
 *                 the velocity has changed its sign, and released if the force is too large
 *   rk4-located   rk4 with the sign change and the break-away located within the step by bisection
 *
 * Every method gets the exact force at the ends of a step, and the Runge-Kutta methods also get it in the middle.
 *
 * Prints nanoseconds a step (median of RUNS), and stops and reversals of the last cycle. Then prints a line for each
 * step of the last cycle. It has the displacements of the contact's mass and of the first mass at the end of the step.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "timing.h"

enum { MOST = 64 };
static const double PI = 3.14159265358979323846;

typedef struct {
    int n, j, e, steps;
    double a, b, r, beta, dt;
    double theta, lower[MOST], pivot[MOST]; /* parameter of the method, and LU factors of the implicit step's matrix */
    double column[MOST], inverse_mass;      /* velocities after a unit impulse in the contact: of all masses, of its mass */
    double *force;                          /* the load at each half step of a cycle */
} Chain;

typedef struct { double x[MOST], v[MOST]; int way; } State; /* way: direction of sliding (-1 or 1), 0 while stuck */

static double stiffness(const Chain *c, const double *x, int i) {
    double f = (i + 1 < c->n ? 2 : 1) * x[i];
    if (i) f -= x[i - 1];
    if (i + 1 < c->n) f -= x[i + 1];
    return f;
}

/* ---- Moreau-Jean ---- */

/* Solves (M + h theta C + h^2 theta^2 K) x = y and stores x in y. The matrix is tridiagonal. */
static void implicit(const Chain *c, double *y) {
    for (int i = 1; i < c->n; i++) y[i] -= c->lower[i] * y[i - 1];
    y[c->n - 1] /= c->pivot[c->n - 1];
    for (int i = c->n - 2; i >= 0; i--) y[i] = y[i] / c->pivot[i] - c->lower[i + 1] * y[i + 1];
}

static void prepare(Chain *c) {
    double h = c->dt * c->theta, off = -(h * c->b + h * h);
    for (int i = 0; i < c->n; i++) {
        c->pivot[i] = 1 + h * c->a + (i + 1 < c->n ? 2 : 1) * (h * c->b + h * h);
        if (i) {
            c->lower[i] = off / c->pivot[i - 1];
            c->pivot[i] -= c->lower[i] * off;
        }
    }
    memset(c->column, 0, sizeof c->column);
    c->column[c->j] = 1;
    implicit(c, c->column);
    c->inverse_mass = c->column[c->j];
}

static void moreau(const Chain *c, State *s, double here, double there) {
    double h = c->dt, y[MOST], q[MOST];
    /* y becomes the change of the velocities without friction. */
    for (int i = 0; i < c->n; i++) q[i] = s->x[i] + (h * c->theta + c->b) * s->v[i];
    for (int i = 0; i < c->n; i++) y[i] = -h * (stiffness(c, q, i) + c->a * s->v[i]);
    y[c->e] += h * (c->theta * there + (1 - c->theta) * here);
    implicit(c, y);
    double impulse = (s->v[c->j] + y[c->j]) / c->inverse_mass, most = h * c->beta;
    int way = impulse > most ? 1 : impulse < -most ? -1 : 0;
    if (way) impulse = way * most;
    for (int i = 0; i < c->n; i++) {
        double v = s->v[i] + y[i] - c->column[i] * impulse;
        if (i == c->j && !way) v = 0;
        s->x[i] += h * ((1 - c->theta) * s->v[i] + c->theta * v);
        s->v[i] = v;
    }
    s->way = way;
}

/* ---- Runge-Kutta ---- */

static void rates(const Chain *c, const State *s, double force, double *x, double *v) {
    for (int i = 0; i < c->n; i++) {
        double q = stiffness(c, s->x, i) + c->a * s->v[i];
        if (c->b != 0) q += c->b * stiffness(c, s->v, i);
        x[i] = s->v[i];
        v[i] = -q;
    }
    v[c->e] += force;
    if (s->way) v[c->j] -= s->way * c->beta;
    else x[c->j] = v[c->j] = 0;
}

static double holding(const Chain *c, const State *s, double force) {
    return (c->j == c->e ? force : 0) - stiffness(c, s->x, c->j) - c->a * s->v[c->j] - c->b * stiffness(c, s->v, c->j);
}

static void rk4(const Chain *c, State *s, double h, const double *force) {
    double x[4][MOST], v[4][MOST];
    State t = *s;
    static const double part[4] = { 0, 0.5, 0.5, 1 };
    static const int at[4] = { 0, 1, 1, 2 };
    for (int k = 0; k < 4; k++) {
        if (k)
            for (int i = 0; i < c->n; i++) {
                t.x[i] = s->x[i] + h * part[k] * x[k - 1][i];
                t.v[i] = s->v[i] + h * part[k] * v[k - 1][i];
            }
        rates(c, &t, force[at[k]], x[k], v[k]);
    }
    for (int i = 0; i < c->n; i++) {
        s->x[i] += h / 6 * (x[0][i] + 2 * (x[1][i] + x[2][i]) + x[3][i]);
        s->v[i] += h / 6 * (v[0][i] + 2 * (v[1][i] + v[2][i]) + v[3][i]);
    }
}

/* Returns 1 if the state shows that the present phase of the contact (sliding or stuck) has ended. */
static int over(const Chain *c, const State *s, double force) {
    return s->way ? s->way * s->v[c->j] <= 0 : fabs(holding(c, s, force)) > c->beta;
}

/* Sets the next phase of the contact: sliding in one direction, or stuck. */
static void turn(const Chain *c, State *s, double force) {
    double f = holding(c, s, force);
    s->v[c->j] = 0;
    s->way = fabs(f) <= c->beta ? 0 : f > 0 ? 1 : -1;
}

static void switched(const Chain *c, State *s, const double *force) {
    rk4(c, s, c->dt, force);
    if (over(c, s, force[2])) turn(c, s, force[2]);
}

static void located(const Chain *c, State *s, double t, const double *force) {
    double left = c->dt;
    State next = *s;
    rk4(c, &next, left, force);
    double end = force[2];
    for (int events = 0; over(c, &next, end) && events < 8; events++) {
        double low = 0, high = left, now = t + c->dt - left, three[3];
        three[0] = cos(c->r * now);
        for (int k = 0; k < 60 && high - low > 1e-15 * c->dt; k++) {
            double middle = 0.5 * (low + high);
            next = *s;
            three[1] = cos(c->r * (now + 0.5 * middle));
            three[2] = cos(c->r * (now + middle));
            rk4(c, &next, middle, three);
            if (over(c, &next, three[2])) high = middle; else low = middle;
        }
        next = *s;
        three[1] = cos(c->r * (now + 0.5 * high));
        three[2] = cos(c->r * (now + high));
        rk4(c, &next, high, three);
        int broke = next.way == 0;
        double f = holding(c, &next, three[2]);
        turn(c, &next, three[2]);
        /* At a break-away the force equals the friction force up to rounding, which must not keep the contact stuck. */
        if (broke && !next.way) next.way = f > 0 ? 1 : -1;
        *s = next;
        left -= high;
        if (left <= 0) return;
        now = t + c->dt - left;
        three[0] = cos(c->r * now);
        three[1] = cos(c->r * (now + 0.5 * left));
        three[2] = end;
        rk4(c, &next, left, three);
    }
    *s = next;
}

int main(int count, char **text) {
    static const char *names[] = { "moreau-half", "moreau-one", "rk4", "rk4-located" };
    if (count < 11) { fprintf(stderr, "time_stepping METHOD MASSES CONTACT EXCITED A B R BETA STEPS CYCLES [RUNS]\n"); return 2; }
    int method = -1;
    for (int i = 0; i < 4; i++) if (!strcmp(text[1], names[i])) method = i;
    Chain c = { .n = atoi(text[2]), .j = atoi(text[3]) - 1, .e = atoi(text[4]) - 1, .a = atof(text[5]), .b = atof(text[6]),
                .r = atof(text[7]), .beta = atof(text[8]), .steps = atoi(text[9]) };
    int cycles = atoi(text[10]), runs = count > 11 ? atoi(text[11]) : 1;
    if (method < 0 || c.n < 1 || c.n > MOST || c.j < 0 || c.j >= c.n || c.e < 0 || c.e >= c.n || c.steps < 1 ||
        cycles < 1 || runs < 1) return 2;
    c.dt = 2 * PI / c.r / c.steps;
    c.theta = method == 0 ? 0.5 : 1;
    prepare(&c);
    c.force = malloc((2 * c.steps + 1) * sizeof *c.force);
    double *shown = malloc(2 * c.steps * sizeof *shown), *times = malloc(runs * sizeof *times);
    for (int k = 0; k <= 2 * c.steps; k++) c.force[k] = cos(PI * k / c.steps);
    int stops = 0, reversals = 0;
    for (int run = 0; run < runs; run++) {
        State s = { .way = 0 };
        if (fabs(holding(&c, &s, 1)) > c.beta) s.way = 1;
        double start = now();
        for (int cycle = 0; cycle < cycles; cycle++) {
            stops = reversals = 0;
            for (int k = 0; k < c.steps; k++) {
                const double *force = c.force + 2 * k;
                int before = s.way;
                if (method < 2) moreau(&c, &s, force[0], force[2]);
                else if (method == 2) switched(&c, &s, force);
                else located(&c, &s, k * c.dt, force);
                stops += before && !s.way;
                reversals += before * s.way < 0;
                shown[2 * k] = s.x[c.j];
                shown[2 * k + 1] = s.x[0];
            }
        }
        times[run] = 1e9 * (now() - start) / ((double)cycles * c.steps);
    }
    printf("%.3f %d %d\n", median(times, runs), stops, reversals);
    for (int k = 0; k < c.steps; k++) printf("%.17g %.17g\n", shown[2 * k], shown[2 * k + 1]);
    free(c.force); free(shown); free(times);
    return 0;
}
