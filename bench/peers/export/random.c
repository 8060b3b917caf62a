/* Runs an exported stepper under random inputs, and prints a hash of all bits of its results.  bench/peers/export/src/main.rs
 * makes the same run in Rust.  Every 100 steps the program also saves the state, takes three steps under another input,
 * gives bad arguments, and restores the state: the hash does not change.
 *
 * Compile with -DSHAKEN or without. */
#include "drive.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#ifdef SHAKEN
#include "shaken.h"
#define OF(name) shaken_##name
#define STATUS(name) SHAKEN_##name
#define MASSES SHAKEN_MASSES
#define DT 1e-3
typedef double real;
#else
#include "pushed.h"
#define OF(name) pushed_##name
#define STATUS(name) PUSHED_##name
#define MASSES PUSHED_MASSES
#define DT (1.0f / 512.0f)
typedef float real;
#endif

static uint64_t hash = UINT64_C(0xcbf29ce484222325);

static void add(const void *data, size_t size)
{
    const unsigned char *const bytes = (const unsigned char *)data;
    size_t k;
    for (k = 0; k < size; k++) {
        hash = (hash ^ bytes[k]) * UINT64_C(0x100000001b3);
    }
}

static struct OF(input) draw(void)
{
    struct OF(input) input;
    const double first = random_number();
    const double second = random_number();
    const double third = random_number();
#ifdef SHAKEN
    input.displacement = first * 2e-6;
    input.velocity = second * 2e-3;
    input.friction = 4.0 + 4.0 * third;
#else
    input.force = (real)first * 16.0f;
    input.force_double = (real)second * 16.0f;
    input.friction = 4.0f + 4.0f * (real)third;
#endif
    return input;
}

/* Continues a copy of a stepper from an image.  Its next step must have the same bits.  A changed image must fail. */
static void disturb_image(const struct OF(stepper) *stepper, struct OF(input) input)
{
    static unsigned bit = 0;
    struct OF(stepper_image) image;
    struct OF(stepper) first = *stepper;
    struct OF(stepper) second;
    struct OF(stepper) before;
    struct OF(stepped) steps[2];
    memset(&second, 0, sizeof second);
    memset(steps, 0, sizeof steps);
    input.friction = (real)1.0;
    expect(OF(stepper_image)(stepper, &image) == STATUS(OK), "image");
    expect(OF(stepper_start_from_image)(&second, &image) == STATUS(OK), "a stepper from an image");
    expect(OF(stepper_advance)(&first, &input, &steps[0]) == STATUS(OK), "advance the first");
    expect(OF(stepper_advance)(&second, &input, &steps[1]) == STATUS(OK), "advance the second");
    expect(memcmp(&steps[0].force, &steps[1].force, sizeof(real)) == 0, "the force after an image");
    expect((steps[0].sliding == steps[1].sliding) && (steps[0].events == steps[1].events), "the events after an image");
    before = second;
    bit = (bit + 1u) % (8u * (unsigned)sizeof image.bytes);
    image.bytes[bit / 8u] = (uint8_t)(image.bytes[bit / 8u] ^ (1u << (bit % 8u)));
    expect(OF(stepper_start_from_image)(&second, &image) == STATUS(IMAGE_DAMAGED), "a changed image");
    expect(memcmp(&before, &second, sizeof second) == 0, "a changed image changed a stepper");
}

/* Takes steps that a saved state undoes, and gives bad arguments. */
static void disturb(struct OF(stepper) *stepper, struct OF(input) input)
{
    struct OF(stepper_saved) saved;
    struct OF(stepped) stepped;
    struct OF(stepped) before;
    struct OF(stepper) copy;
    struct OF(masses) masses;
    int k;
    memset(&saved, 0, sizeof saved);
    memset(&copy, 0, sizeof copy);
    expect(OF(stepper_restore)(stepper, &saved) == STATUS(NOT_STARTED), "a saved state that is empty");
    expect(OF(stepper_masses)(&copy, &masses) == STATUS(NOT_STARTED), "a stepper that is empty");
    expect(OF(stepper_save)(stepper, &saved) == STATUS(OK), "save");
    for (k = 0; k < 3; k++) {
        expect(OF(stepper_advance)(stepper, &input, &stepped) == STATUS(OK), "advance");
    }
    before = stepped;
    expect(OF(stepper_advance)(stepper, NULL, &stepped) == STATUS(NULL_POINTER), "no input");
    expect(OF(stepper_advance)(NULL, &input, &stepped) == STATUS(NULL_POINTER), "no stepper");
    expect(OF(stepper_advance)(stepper, &input, NULL) == STATUS(NULL_POINTER), "no result");
    expect(OF(stepper_begin)(stepper, &input) == STATUS(BEGUN), "begin after a step");
    expect(OF(stepper_set_stiction)(stepper, (real)0.5) == STATUS(STICTION), "mu below 1");
    input.friction = (real)-1.0;
    expect(OF(stepper_advance)(stepper, &input, &stepped) == STATUS(FRICTION), "negative friction");
    input.friction = (real)NAN;
    expect(OF(stepper_advance)(stepper, &input, &stepped) == STATUS(FRICTION), "friction NaN");
    expect(memcmp(&before, &stepped, sizeof stepped) == 0, "an error changed the result");
    expect(OF(stepper_start)(&copy, (real)0.0) == STATUS(STEP), "a step of 0 s");
    disturb_image(stepper, input);
    expect(OF(stepper_start)(&copy, (real)(2.0 * DT)) == STATUS(OK), "another step");
    expect(OF(stepper_restore)(&copy, &saved) == STATUS(SAVED), "a saved state of another step");
    expect(OF(stepper_restore)(stepper, &saved) == STATUS(OK), "restore");
}

/* Adds steady states from rest and from another state, and the Floquet multipliers. */
static void add_orbits(void)
{
    const real r = (real)0.5;
    const real beta = (real)0.125;
    const real part = (real)0.25;
    struct OF(orbit_start) start;
    struct OF(orbit) rest;
    struct OF(orbit) other;
    struct OF(complex) multiplier;
    real values[2 * MASSES];
    uint32_t index;
    int k;
    for (k = 0; k < 2 * MASSES; k++) {
        values[k] = part;
    }
    memcpy(&start, values, sizeof start);
    expect(OF(orbit)(r, beta, &rest) == STATUS(OK), "orbit");
    expect(OF(orbit_from)(r, beta, &start, &other) == STATUS(OK), "orbit_from");
    expect(rest.multipliers > 0u, "the number of multipliers");
    for (index = 0; index < rest.multipliers; index++) {
        expect(OF(orbit_multiplier)(r, beta, index, &multiplier) == STATUS(OK), "orbit_multiplier");
        add(&multiplier.re, sizeof multiplier.re);
        add(&multiplier.im, sizeof multiplier.im);
    }
    expect(OF(orbit_multiplier)(r, beta, index, &multiplier) == STATUS(MULTIPLIER), "a multiplier too many");
    add(&rest.stuck_fraction, sizeof rest.stuck_fraction);
    add(&rest.stops, sizeof rest.stops);
    add(&other.stuck_fraction, sizeof other.stuck_fraction);
    add(&other.stops, sizeof other.stops);
    values[0] = (real)NAN;
    memcpy(&start, values, sizeof start);
    rest = other;
    expect(OF(orbit_from)(r, beta, &start, &other) == STATUS(STATE), "a start that is NaN");
    expect(memcmp(&rest, &other, sizeof rest) == 0, "an error changed a steady state");
}

int main(int count, char **arguments)
{
    static struct OF(stepper) stepper;
    const long steps = count > 1 ? strtol(arguments[1], NULL, 10) : 10000;
    unsigned long long events = 0;
    unsigned long long stuck = 0;
    long k;
    struct OF(progress) progress;
    int32_t status = OF(stepper_start)(&stepper, DT);
    for (k = 0; (k < steps) && (status == 0); k++) {
        const struct OF(input) input = draw();
        struct OF(stepped) stepped;
        struct OF(masses) masses;
        struct OF(contact) contact;
        real values[2 * MASSES];
        if (k % 100 == 99) {
            disturb(&stepper, input);
        }
        status = OF(stepper_advance)(&stepper, &input, &stepped);
        if (status == 0) {
            status = OF(stepper_masses)(&stepper, &masses);
        }
        if (status == 0) {
            status = OF(stepper_contact)(&stepper, &contact);
        }
        if (status != 0) {
            break;
        }
        memcpy(values, &masses, sizeof values);
        add(&stepped.force, sizeof stepped.force);
        add(values, sizeof values);
        events += stepped.events;
        stuck += contact.sliding == 0 ? 1u : 0u;
    }
    if (status == 0) {
        status = OF(stepper_progress)(&stepper, &progress);
    }
    if (status != 0) {
        fprintf(stderr, "%s\n", OF(status_text)(status));
        return 1;
    }
    expect(progress.steps == (uint64_t)steps, "the number of steps");
    add_orbits();
    printf("%016llx %llu %llu %llu\n", (unsigned long long)hash, events, stuck, (unsigned long long)progress.exceeded);
    return 0;
}
