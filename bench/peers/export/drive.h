/* Random numbers and a check for the programs that run an exported stepper.  src/lib.rs has the same numbers in Rust. */
#ifndef DRIVE_H
#define DRIVE_H
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

static uint64_t state = UINT64_C(88172645463325252);

static double random_number(void)
{
    state ^= state << 13;
    state ^= state >> 7;
    state ^= state << 17;
    return (double)(state >> 40) / 8388608.0 - 1.0;
}

static void expect(int is_right, const char *what)
{
    if (!is_right) {
        fprintf(stderr, "wrong: %s\n", what);
        exit(1);
    }
}

#endif
