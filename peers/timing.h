/* Times of the peers: a clock, and the median of several runs. */
#include <stdlib.h>
#include <time.h>

/* Seconds of a clock that never goes back. */
static double now(void) {
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return t.tv_sec + 1e-9 * t.tv_nsec;
}

static int ascending(const void *a, const void *b) {
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* Sorts the times. */
static double median(double *times, int runs) {
    qsort(times, runs, sizeof *times, ascending);
    return times[runs / 2];
}
