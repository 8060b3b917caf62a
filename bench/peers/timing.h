/* Measures the times of the programs in this folder: a clock, and the median of several runs. */
#include <stdlib.h>
#include <time.h>

/* Returns the time in seconds of a clock that never goes back. */
static double now(void) {
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return t.tv_sec + 1e-9 * t.tv_nsec;
}

static int ascending(const void *a, const void *b) {
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* Returns the median of the times, and sorts them. */
static double median(double *times, int runs) {
    qsort(times, runs, sizeof *times, ascending);
    return times[runs / 2];
}
