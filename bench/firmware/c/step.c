/* The exported stepper on bare metal.  No function `abort` exists, so that the program links only if no panic can be
 * reached.
 *
 * -DEMPTY    starts and loops
 * -DMEASURE  runs the song of 4000 steps, and prints the instructions of its steps and the final state
 * neither    steps for ever */
#include "two.h"

extern uint32_t stack_top, bss_start, bss_end;
static void run(void);

void reset(void)
{
    uint32_t *at;
    *(volatile uint32_t *)0xe000ed88u |= 0xfu << 20; /* the FPU */
    __asm__ volatile("dsb\n\tisb" ::: "memory");
    for (at = &bss_start; at < &bss_end; at++) {
        *(volatile uint32_t *)at = 0;
    }
    run();
    for (;;) {
    }
}

__attribute__((section(".vectors"), used)) static const void *const vectors[2] = {&stack_top, (const void *)reset};

#ifdef EMPTY
static void run(void) {}
#else
static struct two_stepper stepper;
#ifndef MEASURE
__attribute__((noinline)) static void run(void)
{
    struct two_input input = {0.0f, 0.0f, 3.0f};
    struct two_stepped stepped;
    if (two_stepper_start(&stepper, 1e-3f) != TWO_OK) {
        return;
    }
    for (;;) {
        __asm__ volatile("" : : "r"(&input) : "memory");
        (void)two_stepper_advance(&stepper, &input, &stepped);
        __asm__ volatile("" : : "r"(&stepped) : "memory");
    }
}
#else
#define STEPS 4000

static uint32_t call(uint32_t operation, const void *argument)
{
    register uint32_t r0 __asm__("r0") = operation;
    register const void *r1 __asm__("r1") = argument;
    __asm__ volatile("bkpt 0xab" : "+r"(r0) : "r"(r1) : "memory");
    return r0;
}

static void print(const char *text)
{
    (void)call(4u, text);
}

static void print_number(uint32_t number, uint32_t base)
{
    char text[12];
    char *at = text + sizeof text - 1;
    *at = '\0';
    do {
        at--;
        *at = "0123456789abcdef"[number % base];
        number /= base;
    } while (number != 0u);
    print(at);
}

/* SysTick at 25 MHz: 8 ticks are 5 instructions (`bench::timer`). */
static uint32_t ticks(void)
{
    return 0xffffffu - *(volatile uint32_t *)0xe000e018u;
}

/* The song of `scenes::steps::script`, with a moving base. */
static void turn(float *pair, float c, float s)
{
    const float first = pair[0] * c - pair[1] * s;
    pair[1] = pair[1] * c + pair[0] * s;
    pair[0] = first;
}

__attribute__((noinline)) static int32_t advance(const struct two_input *input, struct two_stepped *stepped)
{
    return two_stepper_advance(&stepper, input, stepped);
}

static void row(const char *what, uint32_t number)
{
    print(what);
    print_number(number, 10u);
    print("\n");
}

__attribute__((noinline)) static void run(void)
{
    float slow[2] = {1.0f, 0.0f};
    float fast[2] = {1.0f, 0.0f};
    uint32_t sum = 0u;
    uint32_t least = 0xffffffffu;
    uint32_t most = 0u;
    uint32_t none;
    struct two_masses masses;
    union {
        float number;
        uint32_t bits;
    } place, velocity;
    int k;
    *(volatile uint32_t *)0xe000e014u = 0xffffffu;
    *(volatile uint32_t *)0xe000e018u = 0u;
    *(volatile uint32_t *)0xe000e010u = 5u;
    if (two_stepper_start(&stepper, 1e-3f) != TWO_OK) {
        print("wrong: start\n");
    }
    none = ticks();
    none = ticks() - none;
    for (k = 0; k < STEPS; k++) {
        struct two_input input;
        struct two_stepped stepped;
        uint32_t start;
        uint32_t count;
        int32_t status;
        turn(slow, 0.999895581402694f, 0.014450823207274f);
        turn(fast, 0.999005111495252f, 0.044595820503261f);
        input.displacement = 0.0075f * (slow[1] + 0.6f * fast[1]);
        input.velocity = 0.0075f * (14.451326206513f * slow[0] + 0.6f * 44.610615680975f * fast[0]);
        input.friction = 3.0f;
        start = ticks();
        status = advance(&input, &stepped);
        count = ((ticks() - start) & 0xffffffu) - none;
        count = (count * 5u + 4u) / 8u;
        if (status != TWO_OK) {
            print("wrong: advance\n");
        }
        if ((stepped.events == 0u) && (stepped.sliding != 0) && (count < least)) {
            least = count;
        }
        if (count > most) {
            most = count;
        }
        sum += count;
    }
    (void)two_stepper_masses(&stepper, &masses);
    place.number = masses.mass_m2.displacement;
    velocity.number = masses.mass_m2.velocity;
    row("sliding, by the tables|", least);
    row("mean of a song|", sum / STEPS);
    row("worst of a song|", most);
    print("bits|");
    print_number(place.bits, 16u);
    print(" ");
    print_number(velocity.bits, 16u);
    print("\n");
    (void)call(0x18u, (const void *)0x20026u);
}
#endif
#endif
