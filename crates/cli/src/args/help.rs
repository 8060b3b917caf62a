//! Texts that `--help` prints below the options.
#![allow(missing_docs, reason = "each text says what it is about")]

pub const GRIDS: &str = "\
Grids:
  A grid is a number, a range a:step:b (b included), a range a:b of frequencies in 100 equal steps, or a
  comma-separated list of these:
  0.9   0.2:0.01:2.5   0.2:2.5   0,0.5,1:0.1:2,inf
  `map` also accepts a range a:b of frictions.
  Decimals have a point, not a comma. A frequency may be 0 or inf. A friction must be finite.
  A grid has at most 10 million points.

Exit status:
  0 without errors. Otherwise 2, with one line on standard error for each error.";

pub const CYCLES: &str = "\
Motion:
  The motion starts from rest with undeformed springs, or from the state --from x1,...;v1,... in m and m/s. The
  search follows it until the states at which a contact starts to slide repeat. A base that drives the scene is at
  rest. Without a contact with a `speed`, every motion comes to rest.

Quantities:
  period_s, frequency_hz  duration of a cycle, and its inverse
  amplitude       largest |x| of a motion, or largest relative displacement of a contact, in a cycle
  stops, reversals, stuck_fraction, slip, force, energy  as of `orbit`, for one cycle

Exit status:
  0 without errors, also if no cycle exists. Otherwise 2, with one line on standard error for each error.";

pub const BRANCHES: &str = "\
Search:
  A branch starts at the steady state that motion from rest reaches at the first value A, or that motion from the state
  --from reaches. It follows the state, also where it is unstable, until the parameter leaves the interval, the branch
  closes, or no further state is found. Branches without a connection to a known one are not found.

Parameters:
  hz, r, omega, friction, beta, load, and the numbers of the description by the symbols of `sensitivity`, with dots for
  blanks: m.upper, k.base-lower, zeta.1, c.a-b, mu.pads, stiffness.pads, share.pads, speed.pads

Events:
  fold                    the parameter turns back
  symmetry breaking       two asymmetric states begin, mirror images of each other
  crossing of branches    another branch passes through this state
  period doubling         a state with twice the period begins
  torus                   two complex multipliers leave or enter the unit circle
  jump of stability       a multiplier jumps across the unit circle where a stop appears or vanishes
  stops of C change       a stop or a reversal of the contact C appears or vanishes
  C begins or ceases to slide

";

pub const UNITS: &str = "\
Units:
  The units are those of the scene. With masses in kg and springs in N/m, forces are in N, lengths
  in m and angular frequencies in rad/s.
  --hz or --omega       adds the column frequency_Hz; --omega also adds the column omega_rad_s
  --force P or --base Y adds the column friction_N; amplitudes are then in m, phases in degrees, and
                        limits also in N
  r and beta refer to the first mass and the first spring of the description. If the description lists
  the masses in another order, r and beta change, but no physical result does. With --force or --base,
  the phase of a contact a - b of two masses is the phase of b relative to a.

";

pub const FROM: &str = "\
Steady states and their start:
  Several steady states may exist. The answer is the one that motion from rest reaches. At rest, every
  mass is at 0 without velocity, the excitation is at its maximum, and a moving base is at Y.
  A contact that never slides may rest at any place within an interval. The answer is then the state in
  the middle, without a constant force in the contact. offset is the place where motion from rest leaves
  the contact.
  --from rest and --from \"x1,...;v1,...\" give the state that motion reaches from there. A contact that
  never slides then stays at offset. A state has the displacements of all masses in the order of the
  description, a semicolon, and their velocities, in m and m/s with a load, otherwise dx/dtau. With
  stiction 1, the start does not change a continuous response.

";

pub const LIMITS: &str = "\
Quantities:
  continuous limit  beta_lim, exact. Below beta_lim a motion exists in which the contact slides all the time
  without search    upper bound on beta_lim, from the assumption that the contact is closest to stopping
                    at a reversal
  per mode          lower bound on beta_lim, from the sum of the largest velocity constraints of each mode
  sliding limit     beta*_lim. At or above it a steady state exists in which the contact never slides
  With stiction 1 the contact slides all the time below beta_lim, and is stuck from beta*_lim on. With
  a larger stiction other states may exist as well. `orbit --states` searches for them.
  With several contacts, the limits refer to the common friction. beta_lim comes from steady states at 16
  frictions and a bisection. It is 0 with an elastic contact, which sticks after each reversal. slides_first
  is the contact that slides first below beta*_lim.

";

pub const RESPONSES: &str = "\
Regimes:
  continuous  the contact slides all the time. Amplitudes, phases and harmonics are exact
  stick-slip  the contact sticks and slides in turn
  stuck       the contact never slides (it locks). The output has amplitude and phase of each mass
  unbounded   the excitation is on an undamped resonance, and the amplitude grows without limit. The
              contact slides if the margin is negative. Otherwise it is stuck

Answers:
  closed form  an exact formula, for a contact that always slides or never slides
  orbit        an exact steady state, computed from event to event; the next word is its stability, as
               in `orbit`
  not from rest  motion from rest does not become periodic. The values belong to another stable state
  subharmonic  a stable state, computed from event to event, that repeats after several cycles
  last 64 cycles  the motion does not become periodic. The values belong to its last 64 cycles, and the
               amplitude is the largest of these cycles
  no cycle     at a frequency ratio of 0 or infinity, with a friction between the limits, there is no
               steady state
  any other word is the reason why there is no answer. `orbit --help` explains these words. The cells of
               such a line are empty (JSON: null)

Quantities:
  margin      beta/min(beta_lim, beta*_lim) - 1. It is negative below both limits. The closed form exists
              there, and with stiction 1 no other state exists
  offset      mean of the largest and the smallest displacement of the contact, (max + min)/2, divided
              by P/k1 (by Y for base motion); with --force or --base, in m. Of a contact that never slides,
              the place where motion from the start leaves it
  amplitude   largest displacement in the cycle, divided by P/k1 (by Y for base motion); with --force or
              --base, in m
  phase       lag of the largest displacement behind the maximum of the excitation, in rad, from -pi to
              pi; with --force or --base, in degrees
  fundamental phase lag of the fundamental component X_1
  X_n         harmonics, x = Re(sum of X_n exp(i n t)): amplitude |X_n|, and lag -arg X_n in
              rad; with --force or --base, in m and degrees

";

pub const ORBITS: &str = "\
Regimes:
  continuous, stick-slip or stuck; unbounded if there is no steady state

States:
  stable     small deviations from the steady state die out
  marginal   some small deviation does not die out, or dies out more slowly than exponentially. The
             state belongs to a continuum of steady states, or is the end of one. A stuck state is also
             marginal
  These words mean that there is no steady state:
  unbounded  the excitation is on an undamped resonance
  undamped   the load drives a mode that has no damping and on which the contact does not act
  unstable   small deviations grow in every steady state that the search found
  unsettled  motion from rest does not repeat after any number of cycles up to 64. The values belong to
             its last 64 cycles, and the amplitude is the largest of these cycles
  crowded    between two events the contact slides or sticks, and a cycle has more than 4096 such segments
  With a stiction above 1, motion from rest may take long to settle, or wander for ever. The search follows
  it for some 4000 cycles, and starts Newton's method from the states that the motion visits. If the motion
  still has not settled, the answer is the stable state that Newton's method found, otherwise the stuck
  state, if the contacts can stick. In CSV and JSON, from_rest is then false, and cycles_followed is the
  number of followed cycles. A note below a printed table has this number.

Quantities:
  period      number of cycles of the excitation after which the motion repeats: 1, or more for a
              subharmonic state
  stops       number of stops of the contact in a period
  reversals   number of changes of the sliding direction without a stop, in a period
  stuck       fraction of the period during which the contact sticks
  offset      mean of the largest and the smallest displacement of the contact, (max + min)/2, divided
              by P/k1 (by Y for base motion); with --force or --base, in m. Of a contact that never slides,
              the place where motion from the start leaves it
  multiplier  factor by which the deviation that dies out most slowly changes in a period (Floquet
              multiplier)
  amplitude   largest displacement in the period, divided by P/k1 (by Y for base motion); with
              --force or --base, in m
  phase       lag of the largest displacement behind the maximum of the excitation, in rad, from -pi to
              pi; with --force or --base, in degrees
  fundamental phase lag of the fundamental component X_1
  X_n         harmonics, x = Re(sum of X_n exp(i n t)): amplitude |X_n|, and lag -arg X_n in
              rad; X_0 is the mean; with --force or --base, in m and degrees

";

pub const STATES: &str = "\
Several states:
  --states lists the steady states that a search finds, stable or not. The search follows motions from rest or
  from --from, from the stuck contact, from the closed form, from motions at neighbouring frictions and from 8
  states that are spread over all directions. If several states may exist, it also applies Newton's method to
  these states, and adds the mirror image of each asymmetric state. It may miss other states. In CSV and JSON,
  from_rest marks the state that motion from rest or from --from reaches, and marginal marks a state of
  a continuum. If the search finds no state, the list has one line for the motion, whose state is the reason.

";

pub const GRIDS_IN_TIME: &str = "\
Grids:
  A grid is a number, a range a:step:b (b included), a range a:b of frequencies in 100 equal steps, or a
  comma-separated list of these:
  0.9   0.2:0.01:2.5   0.2:2.5   0.5,1:0.1:2
  Decimals have a point, not a comma. A frequency must be above 0 and below infinity: at 0 a cycle
  never ends, and at infinity nothing has time to move. For 0 and inf use `limits` or `response`.
  A friction must be finite. A grid has at most 10 million points.

Exit status:
  0 without errors. Otherwise 2, with one line on standard error for each error.";

pub const TIMES: &str = "\
Motions:
  The output has the contact and every mass, or the motions of --of. Each motion has a displacement,
  divided by P/k1 (by Y for base motion), and a velocity, the derivative with respect to tau = omega t.
  With --force or --base, displacements are in m and velocities in m/s. Motions of masses are absolute. The
  motion of the contact is relative. The run starts at tau = 0, at a maximum of the excitation. --skip does not
  shift tau
  contact.friction  the friction force, divided by P (by k1 Y for base motion); with --force or
                    --base, in N. While the contact sticks, it is the force that keeps the contact at rest
  contact.state     stuck, forward or backward; the direction is the sign of the relative velocity
  A description with `friction: stribeck`, `stops`, `speed` or `constant` needs a load, --force or --base.

Initial state:
  A run starts from rest, or from --from. --steady gives one period of the steady state in any regime.

Free vibrations:
  --from \"x1,x2;v1,v2\" --until S --friction F  the motion from this state, in m and m/s, during S seconds without
                        a load. A moving base is at rest. The output has times in s, m, m/s and N

Inputs:
  --input TEXT --until S --friction F  the motion under inputs in closed form, from rest or --from, in s, m, m/s and N
  const 5 N                         5 N at all times
  step 5 N from 1 s                 5 N from 1 s on; `for 3 s` ends it after 3 s
  ramp 5 N from 1 s for 2 s         a straight line from 0 to 5 N in 2 s, then 5 N
  sine 5 N at 2 Hz from 1 s         5 sin(2 pi 2 (t - 1)) N from 1 s on; `for 3 s` ends it after 3 s
  half-sine 10 g from 1 s for 11 ms   a pulse, one half wave of a sine
  rectangle 10 g from 1 s for 11 ms   a rectangular pulse
  chirp 5 N at 1 Hz to 9 Hz for 20 s  a sine whose frequency changes linearly from 1 Hz to 9 Hz in 20 s
  Without `from` an input starts at 0 s. A force acts on the mass of `excitation`, or on the mass of `on NAME`. The
  units of forces and motions are those of recordings: N, kN, mm, m/s, m/s2, g. The unit of a motion moves the base.
  Several inputs act together, but only one can move the base. At a jump, a sample has the state before the jump. All
  inputs are exact but a chirp. It consists of pieces of constant frequency, and its error is at most 1e-6 of the
  amplitude.

Events:
  The events are stop, break-away, and reversal (the contact changes its direction without a stop). The
  instants are exact. The list has all events between the first and the last sample.

Spectrum:
  x = Re(sum of X exp(i n tau)). The spectrum has amplitude |X| and lag -arg X of every order n. The lag
  is in rad or degrees of a cycle of that order. Order 0 is the mean. Orders are multiples of 1/cycles,
  up to half the number of samples in a cycle.
  The spectrum of a run comes from its samples, with tau counted from the first one. Faster vibrations
  appear at wrong orders (aliasing), with about 10/samples^3 of the amplitude. With --steady the spectrum
  is exact, up to order 9999.
  The spectrum of a run consists of lines only if the motion has settled. Skip the first cycles, and
  compute whole periods.

";

pub const ONE_POINT: &str = "\
Give one frequency, above 0 and below infinity, and one friction. All motions together have at most
10 million samples.

Exit status:
  0 without errors. Otherwise 2, with one line on standard error for each error.";

pub const CURVES: &str = "\
Curves:
  Points are closer where a curve bends and at its peaks. Lines join only points of the same piece. A
  piece ends where the regime changes, at a pole, at a jump, and at a point without an answer.
  --from up and --from down sweep the frequency, as in a laboratory. Each point starts from the state of
  the previous point, with the same displacements and velocities, the first point from rest. A contact
  that never slides stays where the motion leaves it. --from up,down gives both sweeps.
  answer   closed form; orbit; or last 64 cycles, of a motion that does not become periodic. Any other
           word is the reason why there is no answer. `orbit --help` explains these words
  force    largest friction force in the cycle, divided by P (by k1 Y for base motion); with --force
           or --base, in N
  work     energy that friction dissipates in a cycle, divided by P^2/k1 (by k1 Y^2 for base motion);
           with --force or --base, the mean power in W

";

pub const RANGES: &str = "\
Ranges:
  A range of frequencies is a:b, above 0. In a:step:b, step is the largest distance between points.
  Frictions are a number, a range a:step:b, or a comma-separated list of these.

Exit status:
  0 without errors. Otherwise 2, with one line on standard error for each error.";

pub const MAPS: &str = "\
Regions:
  continuous        the contact slides all the time
  stuck             the contact never slides: it locks
  n stops           the contact stops n times in a cycle of the excitation
  sliding reversals the contact reverses without a stop, but the motion is not the continuous motion
  subharmonic       the motion repeats after several cycles of the excitation
  unsettled         the motion does not repeat
  any other word is the reason why there is no answer. `orbit --help` explains these words
With stiction 1 the boundaries of the continuous
and the stuck region are the exact limits. With a larger stiction, motion from rest may continue to
slide above both limits. --boundaries finds the boundaries of the other regions by bisection. Each additional
digit takes longer than the one before, because the motion settles more slowly near a boundary. Pictures use 3 digits.
Ctrl-C keeps the frequencies that are already computed.

";

pub const DIFFERENCES: &str = "\
Comparison:
  parameters   every field that differs, with its relative change
  answers      limits and amplitudes of both scenes from the exact formulas, at the same frequencies
               in Hz and the same friction force. Each line has the largest difference, relative to
               the larger of the two values. The frequencies are logarithmically spaced from 0.2
               times the lowest to 1.5 times the highest natural frequency of both scenes. A declared
               `range` narrows this range.
  code         lines, bytes and counted operations of the Rust code that the macro emits. Lines and
               bytes include documentation comments, but not the header comment of `expand`.
A description with errors cannot be compared as a scene. The command then prints the errors and the lines
that differ.

Exit status:
  0 if both descriptions are valid. Otherwise 2.";

pub const OPTIMA: &str = "\
What is searched:
  For one friction the search finds the largest amplitude over the band a:b, over all regimes. It
  evaluates the amplitude on a grid of frequencies, which is closer at the resonances of the chain with
  every set of stuck contacts, and refines the largest maxima. With the best friction this largest
  amplitude is smallest. A finer grid with steps of 0.25 % checks the result. The best friction lies
  between zero and the friction that keeps all contacts stuck over the whole band. The amplitude is
  infinite if friction does not bound an undamped resonance.

Quantities:
  friction     the best friction, in N with --force or --base, otherwise as beta
  what limits it  why no other friction is better. `two equal peaks`: more friction raises one and lowers
                  the other. `one peak at its least`: more friction and less friction both raise the only
                  largest peak. `flat`: the peak is the same over an interval of friction, because no
                  contact slides at its frequency. `stuck`: all contacts are stuck over the whole band
  how the search ended  it converged; or the best friction is at a jump, beyond which the amplitude is larger;
                  or the search stopped early, at its limit of work or by Ctrl-C, and prints the best friction
                  so far. If it did not converge, an interval of frictions contains the best friction
  beyond the jump  largest amplitude with a friction just beyond the jump
  above the best  ranges of friction in which the largest amplitude is at most 1, 5 or 10 per cent larger
                  than the best
  change in per cent  change of the amplitude if a parameter increases by one per cent and the friction
                  is again the best for the new value; only with --force or --base

With several --of NAME/VALUE:
  The search minimises the largest quotient of a quantity and its value over the band. Use an allowable
  value for each quantity: a largest quotient below 1 then keeps all of them.

With --vary NAME=a:b:
  The search also chooses one number of the description, between a and b, in the unit of that number.
  Names are those of `sensitivity`: m upper, k base - lower, zeta 1, a, b, mu. zeta is the ratio of all
  modes, k2 the second spring, m1 the first mass. The search finds the best friction at 17 values from a
  to b, and then refines the smallest amplitude between neighbouring values. It may miss a minimum
  between these values. Frequencies, forces and lengths keep their units while the number changes.
  Without a load, r and beta refer to the first mass and spring of the original description.
  With --keep as well, the search takes only frictions within the bounds. A value at which no friction
  holds them has the amplitude inf.
  With the fields `contacts` and `dampers`, the names `c base - lower` of a dashpot and `share pads`, `stiffness
  pads`, `mu pads` of one contact work too. `share` alone means the shares of all contacts but the first. A search
  of shares begins at the shares of the description, changes one number at a time, and finds a local minimum.

Exit status:
  0 without errors. Otherwise 2, with one line on standard error for each error.

";

pub const FEATURES: &str = "\
Features:
  resonance                 a resonance of the chain, and a friction. Without damping, the amplitude is bounded from
                            this friction on (6.2). With damping, the contact slides all the time up to this friction
  resonance if stuck        a resonance of the chain with its contact stuck. At this frequency the contact slides up to
                            the given friction
  limit for r -> 0, inf     for r -> 0 or inf, the friction up to which the contact slides (beta*_lim), and the
                            friction up to which it slides all the time (beta_lim)
  antiresonance             a frequency at which the amplitude is zero without friction
  invariant point           a frequency with the same amplitude, or fundamental component, for every friction up to
                            the given one. Exact for the contact and for fundamentals, otherwise an estimate (6.9, 6.10)
  grows with friction       a range in which more friction makes the motion larger
With --beta or --friction, for each friction:
  quasi-static start        the limit of the amplitude for r -> 0
  slides                    ranges in which the contact slides at this friction and at every smaller one
  regime                    the regimes along frequency
  peak by estimate          at each resonance, the amplitude by the estimate (7.60)
  peak                      at each resonance, the largest amplitude over all regimes
With two frictions or more:
  same amplitude            frequencies at which two neighbouring frictions have exactly the same amplitude
With several contacts, dashpots or masses that no spring holds:
  resonance                 a damped natural frequency of the chain with a set of stuck contacts, its damping ratio, and
                            the friction from which no contact slides at this frequency
  decay                     an overdamped mode, which is two decay rates
  limit of sliding          the largest friction in the range below which a contact slides
  limit of continuous motion  at a damped resonance, the friction up to which all contacts slide all the time
  antiresonance             a frequency at which the mass rests, without damping, free and with all contacts stuck

Found:
  exact    a formula gives the feature
  estimate the formula (7.60) for the fundamental component gives the peak. The next line has the exact peak
  all      a search by interval arithmetic finds the feature. It misses no feature in the range
  sampled  the search looks for the feature in small steps of the frequency, and then refines it. It may miss two
           features within one step

Ranges:
  A range is a:b, above 0. The default is from 0.55 times the lowest resonance to 1.5 times the highest. Towards
  r = 0 most features repeat infinitely often.

Sensitivities:
  Each line names the parameter to which the line's first number is most sensitive, and the change of this number
  in per cent for one per cent more of the parameter. JSON has the derivatives with respect to all parameters. With
  a load, the derivatives are at constant friction in N and constant load in N or m. Without a load, they are at
  constant r and beta.

Exit status:
  0 without errors. Otherwise 2, with one line on standard error for each error.

";

pub const SENSITIVITIES: &str = "\
Parameters:
  m, k      each mass and spring
  zeta i    the damping ratio of mode i; a, b of Rayleigh damping
  mu        ratio of static to kinetic friction force
  c, share, stiffness  each dashpot, and the numbers of each of several contacts
  F, P or Y, f  with --force or --base: friction force, load and frequency in Hz. Each derivative keeps all other
            parameters constant. The first mass and the first spring therefore change r and beta
  beta, r   without a load: derivatives are taken at constant r and beta

Answers:
  exact       exact derivatives of the closed form, of the steady state with stops, or of the stuck response
  These words mean that there is no derivative:
  bend        the answer has a corner here, because the friction equals a limit, or because a small change
              of a parameter adds or removes an event (a stop, a break-away or a reversal of the contact)
  marginal    the steady state is one of a continuum of steady states
  degenerate  two modes have the same frequency, and a change of the parameter separates them; or the
              contact does not act on a mode, and a change of the parameter makes it act on this mode
  any other word is the reason why there is no steady state. `orbit --help` explains these words

Quantities:
  X, d/dp     first line: the value X of the answer; other lines: its derivative dX/dp by the parameter p
  (p/X) d/dp  relative sensitivity (p/X) dX/dp: per cent of X for one per cent of p; for a phase, p dX/dp
  limits      the continuous limit beta_lim and the sliding limit beta*_lim at this frequency; with
              --force or --base, in N

";

pub const TABLES: &str = "\
The accuracy, range, side and budget of the description apply unless an option replaces them.

Without --format the output describes the tables: their accuracy, pieces and bytes, the largest errors
and their frequencies, and the operations. The tables are compared with exact values at many points.
With --prove an accuracy of 1e-6 or coarser is proven between the points as well. The output says
whether the tables are compared or proven. With --format it is code or data:
  rust  a file without dependencies: limits(r); contact(r, beta) if the scene provides a motion;
        stuck_<mass>(r) and holding_force(r) if it provides stuck
  c     the same functions in C99; -o name.c also writes the header name.h next to it
  json  the tables as data
If only the exact formulas reach the accuracy, `compile` cannot write code without the library, and
ends with an error.

Exit status:
  0 without errors. Otherwise 2, with one line on standard error for each error.";

pub const EXPORTS: &str = "\
With --to c the folder is a crate of Rust without std, which cargo builds to a static library:
  NAME.h          the functions, for C99 and C++, with the description, units and statuses
  src/lib.rs      the solver, and the functions of the header
  NAME.friction   the description
  Cargo.toml      the crate, with the library `frictiongen` of this version, or that of --library
  main.c          an example, which a later export does not overwrite
  Makefile, CMakeLists.txt
The functions are those of `provide`: limits, motion, stuck, orbit, simulation, stepper, self_check.

With --to fmu the command writes an FMU for co-simulation, which FMI 3.0 defines, of a scene with
`provide: [stepper]` and a `step`. It builds the binary for this machine with cargo. The crate stays
in the folder NAME_fmu beside NAME.fmu.

Exit status:
  0 without errors. Otherwise 2, with one line on standard error for each error.";
