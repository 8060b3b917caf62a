/* Runs the exported stepper of two contacts as src/bin/paired.rs does, and prints the bits of its results.  Every 100 steps
 * the program also takes steps that a saved state and an image undo, and gives bad arguments. */
#include "pair.h"
#include "drive.h"
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void print(double number, const char *end)
{
    uint64_t bits;
    memcpy(&bits, &number, sizeof bits);
    printf("%016" PRIx64 "%s", bits, end);
}

static void disturb(struct pair_stepper *stepper, struct pair_input input)
{
    static struct pair_stepper_saved saved;
    static struct pair_stepper other;
    static struct pair_stepper_image image;
    struct pair_stepped stepped;
    expect(pair_stepper_save(stepper, &saved) == PAIR_OK, "save");
    expect(pair_stepper_image(stepper, &image) == PAIR_OK, "image");
    expect(pair_stepper_advance(stepper, &input, &stepped) == PAIR_OK, "advance");
    expect(pair_stepper_begin(stepper, &input) == PAIR_BEGUN, "begin after a step");
    expect(pair_stepper_set_stiction(stepper, 1u, 0.5) == PAIR_STICTION, "mu below 1");
    input.friction_pads = -1.0;
    expect(pair_stepper_advance(stepper, &input, &stepped) == PAIR_FRICTION, "negative friction");
    expect(pair_stepper_start(&other, 0.0) == PAIR_STEP, "a step of 0 s");
    expect(pair_stepper_start(&other, 2e-3) == PAIR_OK, "another step");
    expect(pair_stepper_restore(&other, &saved) == PAIR_SAVED, "a saved state of another step");
    expect(pair_stepper_restore(stepper, &saved) == PAIR_OK, "restore");
    expect(pair_stepper_start_from_image(stepper, &image) == PAIR_OK, "a stepper from an image");
    image.bytes[20] ^= 1u;
    expect(pair_stepper_start_from_image(stepper, &image) == PAIR_IMAGE_DAMAGED, "a changed image");
}

int main(int count, char **arguments)
{
    static struct pair_stepper stepper;
    const long steps = count > 1 ? strtol(arguments[1], NULL, 10) : 1000;
    struct pair_progress progress;
    long k;
    expect(pair_stepper_advance(&stepper, NULL, NULL) == PAIR_NULL_POINTER, "no input");
    expect(pair_stepper_start(&stepper, 1e-3) == PAIR_OK, "start");
    for (k = 0; k < steps; k++) {
        struct pair_input input;
        struct pair_stepped stepped;
        struct pair_masses masses;
        struct pair_contacts contacts;
        struct pair_work work;
        double values[18];
        int place;
        input.force = 16.0 * random_number();
        input.force_upper = 16.0 * random_number();
        input.friction_brace = 4.0 + 4.0 * random_number();
        input.friction_pads = 4.0 + 4.0 * random_number();
        if (k % 100 == 99) {
            disturb(&stepper, input);
        }
        expect(pair_stepper_advance(&stepper, &input, &stepped) == PAIR_OK, "advance");
        expect(pair_stepper_masses(&stepper, &masses) == PAIR_OK, "masses");
        expect(pair_stepper_contacts(&stepper, &contacts) == PAIR_OK, "contacts");
        expect(pair_stepper_work(&stepper, &work) == PAIR_OK, "work");
        expect(pair_stepper_progress(&stepper, &progress) == PAIR_OK, "progress");
        memcpy(values, &input, sizeof input);
        memcpy(values + 4, &masses, sizeof masses);
        values[8] = contacts.contact_brace.displacement;
        values[9] = contacts.contact_brace.velocity;
        values[10] = contacts.contact_brace.force;
        values[11] = contacts.contact_pads.displacement;
        values[12] = contacts.contact_pads.velocity;
        values[13] = contacts.contact_pads.force;
        memcpy(values + 14, &work, sizeof work);
        for (place = 0; place < 18; place++) {
            print(values[place], ",");
        }
        print((double)stepped.events, ",");
        print((double)progress.exceeded, "\n");
    }
    expect(progress.steps == (uint64_t)steps, "the number of steps");
    return 0;
}
