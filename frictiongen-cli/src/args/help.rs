//! Texts that `--help` prints below the options.
#![allow(missing_docs, reason = "each text says what it is about")]

pub const GRIDS: &str = "\
Grids:
  A grid is a number, a range a:step:b (b included), or a comma-separated list of those:
  0.9   0.2:0.01:2.5   0,0.5,1:0.1:2,inf
  A grid of decimal numbers has decimal points. A frequency may be 0 and inf; a friction is
  finite. At most 10 million points.

Exit status:
  0, or 2 with one line on standard error for each thing that is wrong.";

pub const UNITS: &str = "\
Units:
  The scene's own: with masses in kg and springs in N/m, forces are in N, lengths in m and
  angular frequencies in rad/s.
  --hz or --omega       adds frequency_Hz (and omega_rad_s) beside r
  --force P or --base Y adds friction_N, gives amplitudes in m and phases in degrees; limits come
                        as friction forces in N beside beta
  r and beta refer to the first mass and the first spring listed: another order of them changes r
  and beta, and no physical answer. In degrees, the phase of a contact a - b of two masses is that
  of b relative to a.

";

pub const LIMITS: &str = "\
Quantities:
  continuous limit  beta_lim, exact: below it a motion exists in which the contact slides all the time
  without search    beta_lim with the velocity constraint taken at the reversal alone: not smaller
  per mode          beta_lim with each mode's own maximum of the constraint: not larger
  sliding limit     beta*_lim: from it on a state exists in which the contact never slides
  With stiction 1 the contact slides all the time below the first and sticks from the second on. Above 1
  other states may exist beside these: `orbit --states` lists them.

";

pub const RESPONSES: &str = "\
Regimes:
  continuous  the contact slides all the time: exact amplitudes, phases and harmonics
  stick-slip  the contact stops and slides in turn: the steady state from rest
  stuck       the contact never slides: amplitude and phase of each mass
  unbounded   on an undamped resonance: the margin says whether the contact slides (negative)
              or is stuck
  Of several states the answer is the one that motion from rest ends in: every mass at 0 without
  velocity where the excitation is at its maximum. A base then stands at Y, and a contact with it may
  stick off its centre.

Answers:
  closed form  exact, of a contact that always or never slides
  orbit        exact, from event to event: as `orbit` gives it, with its stability
  not from rest  a stable state, where motion from rest does not settle
  subharmonic  the same, of a stable state that repeats after several cycles
  last 64 cycles  the motion does not settle: what it did last, the amplitude the largest seen
  otherwise    why there is none, in the words of `orbit`; its cells are empty (JSON: null)
  no cycle     at a frequency ratio of 0 or infinity, between the limits

Quantities:
  margin      beta/min(beta_lim, beta*_lim) - 1, negative below both limits: the closed form exists,
              and with stiction 1 it is the only state
  offset      middle of the contact's motion over P/k1, for base motion over Y; with a load, m
  amplitude   largest displacement of the cycle over P/k1, for base motion over Y; with a load, m
  centred     half the distance between the least and the largest displacement
  phase       lag of that maximum behind the excitation's, rad, in (-pi, pi]; with a load, degrees
  fundamental lag of the fundamental component X_1
  X_n         harmonics, x = Re(sum of X_n exp(i n t)): amplitude |X_n| and lag -arg X_n, rad;
              with a load, m and degrees

";

pub const ORBITS: &str = "\
Regimes:
  the state's own: continuous, stick-slip, stuck; unbounded where there is none

States:
  stable     small deviations die
  marginal   some deviation stays, or dies more slowly than any power: one of a continuum of
             steady states, or at its end; also the stuck contact, which stays where it is
  unbounded  none: on an undamped resonance
  undamped   none: nothing damps a mode that the load drives and the contact does not touch
  unstable   none was found that deviations do not leave
  unsettled  none: the motion from rest repeats neither after one cycle nor after up to 64; the values
             are of its last 64 cycles, and the amplitude is the largest in those
  crowded    a cycle has more than 64 segments

Quantities:
  period      after how many cycles of the excitation the motion repeats: 1, or more for a subharmonic state
  stops       how often the contact stops in a period
  reversals   how often it changes its direction without a stop
  stuck       the part of the period for which it sticks
  offset      middle of the contact's motion over P/k1, for base motion over Y; with a load, m
  multiplier  by how much the deviation that dies most slowly is multiplied in a period
  amplitude   largest displacement of the period over P/k1, for base motion over Y; with a load, m
  centred     half the distance between the least and the largest displacement
  phase       lag of that maximum behind the excitation's, rad, in (-pi, pi]; with a load, degrees
  fundamental lag of the fundamental component X_1
  X_n         harmonics, x = Re(sum of X_n exp(i n t)): amplitude |X_n| and lag -arg X_n, rad;
              X_0 is the mean; with a load, m and degrees

";

pub const STATES: &str = "\
Several states:
  --states lists every steady state that is found from rest, from the stuck contact, from the closed form
  and from motions at neighbouring frictions. CSV and JSON say which one motion from rest ends in
  (from_rest) and which is one of a continuum (marginal).

";

pub const GRIDS_IN_TIME: &str = "\
Grids:
  A grid is a number, a range a:step:b (b included), or a comma-separated list of those:
  0.9   0.2:0.01:2.5   0.5,1:0.1:2
  A grid of decimal numbers has decimal points. A frequency is above 0 and below infinity:
  at 0 a cycle never ends, and at infinity nothing has time to move (`limits` and `response` answer
  at both). A friction is finite. At most 10 million points.

Exit status:
  0, or 2 with one line on standard error for each thing that is wrong.";

pub const TIMES: &str = "\
Motions:
  contact and every mass, or those of --of. Each has a displacement, over P/k1 or for base motion
  over Y, and a velocity, its derivative by tau = omega t; with a load, m and m/s. A mass's are
  absolute, the contact's relative.
  tau is 0 at a maximum of the excitation; skipped cycles count
  contact.friction  over P, for base motion over k1 Y; with a load, N: against the sliding, and
                    while the contact sticks what holds it
  contact.state     stuck, or forward or backward by the sign of the relative velocity
  The speeds of `friction: stribeck` need a load: --force or --base

State to start from:
  --from \"x1,x2;v1,v2\"  displacements, then velocities of all masses in the description's order, at a
                        maximum of the excitation; with a load, in m and m/s. From rest without it.

Steady states:
  --steady, in any regime; an undamped one, or one of several, is that which is reached from rest.
  Where a stuck contact stays depends on what was before: here, on the motion from rest.

Events:
  stop, break-away, reversal (it turns without a stop): exact, between the first sample and the last

Spectrum:
  x = Re(sum of X exp(i n tau)): amplitude |X| and lag -arg X of every order n, rad or degrees of its
  own cycle; order 0 is the mean. Orders are multiples of 1/cycles, up to half the samples of a cycle.
  Of a run from its samples, tau from the first one; what vibrates faster is folded back, to some
  10/samples^3 of the amplitude. With --steady exact, up to order 9999.
  A run has a spectrum of lines only where it has settled: skip cycles, and take whole periods.

";

pub const ONE_POINT: &str = "\
One frequency, above 0 and below infinity, and one friction. At most 10 million samples of all motions
together.

Exit status:
  0, or 2 with one line on standard error for each thing that is wrong.";

pub const CURVES: &str = "\
Curves:
  The range is refined where a curve bends and at its peaks. A piece is what may be joined: it ends
  where the regime changes, at a pole, at a jump, and where there is no answer.
  --from up and --from down sweep the frequency: each point starts from the state of the point before,
  as in a laboratory; displacements and velocities go over unchanged. --from up,down gives both.
  answer   closed form, orbit, or last 64 cycles of a motion that does not settle; otherwise why
           there is none, in the words of `orbit`
  force    largest friction force of the cycle over P (base motion: k1 Y); with a load, N
  work     that friction takes out of a cycle over P^2/k1 (base motion: k1 Y^2); with a load, the
           mean power in W

";

pub const RANGES: &str = "\
Ranges:
  A range of frequencies is a:b, above 0; a:step:b also says how far apart points are at most.
  Frictions are a number, a range a:step:b, or a comma-separated list of those.

Exit status:
  0, or 2 with one line on standard error for each thing that is wrong.";

pub const MAPS: &str = "\
Regions:
  continuous        the contact slides all the time
  stuck             it never slides
  n stops           it stops n times in a cycle of the excitation
  sliding reversals its direction changes without a stop, in a motion other than the continuous one
  subharmonic       the motion repeats after several cycles
  unsettled         it does not repeat; otherwise why there is no answer, in the words of `orbit`
A region's boundary with the continuous and the stuck regime is a limit, exactly. --boundaries traces
the others by halving: each digit takes the motion longer to settle. 3 are a picture's.
Ctrl-C keeps the frequencies that are done.

";

pub const OPTIMA: &str = "\
What is searched:
  The largest amplitude over the band a:b at one friction, over all regimes: about every resonance,
  of the chain and of the chain with its contact stuck, their sub-harmonics, where the regime
  changes, and on a grid between. The least of it between no friction and so much that the contact
  is stuck over the whole band; infinite where an undamped resonance is not bounded.

Quantities:
  friction     in N with a load, else beta
  what limits it  equal peaks: one rises with friction, another falls; or one peak at its least
  how the search ended  converged; or at a jump to a larger steady state; or the work of one search was
                  done, and it is the best so far: the least then lies between two frictions
  above the best  the friction between which the largest amplitude is within 1, 5 and 10 per cent
  per cent of it  how the optimum moves with each parameter, while friction follows; with a load

With --vary NAME=a:b:
  One number of the description is chosen too, between a and b, in its own unit. Names are those of
  `sensitivity`: m upper, k base - lower, zeta 1, a, b, mu; zeta is the ratio of all modes, k2 the
  second spring, m1 the first mass. The best friction is found at 17 values, a and b among them, and
  the least between two of them from which it falls and then rises; a valley that 17 values do not
  tell may be missed. Forces, lengths and frequencies keep their units; without a load groups are
  those of the description.

Exit status:
  0, or 2 with one line on standard error for each thing that is wrong.

";

pub const FEATURES: &str = "\
Features:
  resonance                 of the chain; without damping the friction from which it is bounded (6.2), with damping
                            the friction up to which the contact slides all the time there
  resonance if stuck        of the chain with its contact held, and the friction up to which it slides there
  limit for r -> 0, inf     the friction up to which the contact slides (all the time) at either end
  antiresonance             without friction the motion vanishes
  invariant point           every friction up to the one given has this amplitude, or fundamental component: exact for
                            the contact and for fundamentals, else of the estimated amplitude (6.9, 6.10)
  grows with friction       a range in which more friction enlarges the motion
With --beta or --friction, for each:
  quasi-static start        the amplitude for r -> 0
  slides                    ranges in which the contact slides at this friction and at every smaller one
  regime                    the regimes along frequency
  peak by estimate; peak    at each resonance: by (7.60), and the largest amplitude itself, over all regimes
With two frictions or more:
  same amplitude            where neighbouring frictions have the same exact amplitude

Found:
  exact    a closed form
  all      by intervals: none in the range is missed
  sampled  by close samples, refined: a pair nearer than these may be missed

Ranges:
  A range is a:b, above 0; without one, from 0.55 times the lowest resonance to 1.5 times the highest. Towards r = 0
  most features repeat without end.

Sensitivities:
  by how many per cent the first number of a line changes for one per cent of the parameter that moves it
  most; JSON has the derivatives with respect to all. With a load at constant N and m, else at constant groups.

Exit status:
  0, or 2 with one line on standard error for each thing that is wrong.

";

pub const SENSITIVITIES: &str = "\
Parameters:
  m, k      each mass and spring
  zeta i    the damping ratio of mode i; a, b of Rayleigh damping
  mu        static over kinetic friction force
  F, P or Y, f  with a load: friction force, load and frequency in Hz. All derivatives are taken at
            constant values of the others, so that the first mass and spring move r and beta
  beta, r   without a load: derivatives are taken at constant r and beta

Answers:
  exact       derivatives of the closed form, of the steady state with stops, or of the stuck response
  bend        none: an event is about to come or to go, or a limit is met
  marginal    none: the steady state is one of a continuum
  degenerate  none: two modes coincide and move apart, or the contact is about to drive a mode
  otherwise   why there is no steady state, in the words of `orbit`

Quantities:
  X, d/dp     on the first line the answer, then its derivative with respect to the parameter
  (p/X) d/dp  by how many per cent X changes for one per cent of p; of a phase p d/dp
  limits      beta_lim and beta*_lim at this frequency; with a load in N

";

pub const TABLES: &str = "\
What the description declares (accuracy, range, side, budget) holds where no option says otherwise.

Without --format the figures of the tables are printed: accuracy, pieces, bytes, the largest errors
and where, operations. With it, the code or the data:
  rust  a file without dependencies: limits(r); contact(r, beta) if the scene provides a motion;
        stuck_<mass>(r) and holding_force(r) if it provides stuck
  c     the same in C99; with -o name.c the header name.h beside it
  json  the tables as data
Where only the exact formulas keep the accuracy, there is no code without the library: it says so.

Exit status:
  0, or 2 with one line on standard error for each thing that is wrong.";
