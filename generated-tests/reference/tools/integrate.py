"""An event-driven integrator of the governing equations, in physical coordinates.

r^2 M x'' + C x' + K x + w f = p cos(tau), z = w'x - s cos(tau); f = beta sgn z' while the contact
slides; it stops where z' vanishes and |f| <= mu beta would hold it; it breaks away at |f| = mu beta.

Between events the state is a sum of exponentials: the eigenvalues of the first-order matrix, sliding, or
of the equations projected on the null space of w, stuck.  Events are bracketed on a dense grid, in which
every local minimum is refined as well, and then found by Brent's method.
"""

import numpy as np
from scipy.linalg import eigh, null_space
from scipy.optimize import brentq

TAU = 2 * np.pi
PER_PERIOD = 24  # grid points in a period of the fastest exponential
CLUSTER = 2.0 ** -np.arange(18, 0, -1)  # so near to its start is a segment looked at


class Lost(Exception):
    """The motion is not known: rounding decides whether the contact starts, or which of two events is first."""


class Scene:
    def __init__(self, masses, springs, contact, excitation, zeta, mu):
        self.masses, self.springs, self.mu = masses, springs, mu
        self.contact, self.excitation, self.zeta = contact, excitation, zeta
        n = self.n = len(masses)
        self.gamma = np.array(masses, float) / masses[0]
        k1 = springs[0][2]
        self.k, self.p, self.w = np.zeros((n, n)), np.zeros(n), np.zeros(n)
        for a, b, stiffness in springs:
            kappa = stiffness / k1
            ends = [e - 1 for e in (a, b) if isinstance(e, int)]
            for e in ends:
                self.k[e, e] += kappa
            if len(ends) == 2:
                self.k[ends[0], ends[1]] -= kappa
                self.k[ends[1], ends[0]] -= kappa
            elif excitation == "base" and "base" in (a, b):
                self.p[ends[0]] += kappa
        if excitation != "base":
            self.p[excitation - 1] = 1.0
        a, b = contact
        self.s = 1.0 if b == "base" and excitation == "base" else 0.0
        if isinstance(b, int):
            a, b = min(a, b), max(a, b)
            self.w[b - 1], self.w[a - 1] = 1.0, -1.0
        else:
            self.w[a - 1] = 1.0
        root = np.sqrt(self.gamma)
        squares, shapes = eigh(self.k / np.outer(root, root))
        self.sigma, shapes = np.sqrt(squares), shapes / root[:, None]
        load = self.gamma[:, None] * shapes
        ratios = np.zeros(n) if zeta is None else np.array(zeta, float)
        self.c_over_r = load @ np.diag(2 * ratios * self.sigma) @ load.T
        self.inverse_mass = self.w @ (self.w / self.gamma)

    def text(self, name):
        node = lambda e: f"m{e}" if isinstance(e, int) else e
        fields = [
            "masses: { " + ", ".join(f"m{i + 1}: {m}" for i, m in enumerate(self.masses)) + " }",
            "springs: { " + ", ".join(f"{node(a)} - {node(b)}: {k}" for a, b, k in self.springs) + " }",
            f"contact: {node(self.contact[0])} - {node(self.contact[1])}",
            f"excitation: {node(self.excitation)}",
        ]
        if self.zeta is not None:
            fields.append("damping: modal[" + ", ".join(map(str, self.zeta)) + "]")
        if self.mu != 1:
            fields.append(f"stiction: {self.mu}")
        return f"struct {name} {{ " + ", ".join(fields) + " }"


class Exponentials:
    """Real part of the sum of columns e^{rate t}: a vector function of the time since the start of a segment."""

    def __init__(self, columns, rates):
        self.columns, self.rates = columns, rates

    def at(self, t):
        return (self.columns @ np.exp(self.rates * t)).real

    def row(self, row, extra=None):
        out = row @ self.columns
        return out if extra is None else out + extra


class Segment:
    """A motion between two events. `contact` is 0 for a stuck contact, else the direction of sliding, +1 or -1."""

    def __init__(self, start, contact, motion, function):
        self.start, self.contact, self.motion, self.function = start, contact, motion, function
        self.length, self.event, self.force = None, None, None


class Integrator:
    def __init__(self, scene, r, beta, rule=None):
        self.scene, self.r, self.beta = scene, r, beta
        # `stops_at` is the largest force at which the contact stops: mu beta, or `rule` to try a wrong rule.
        self.grip = scene.mu * beta
        self.stops_at = self.grip if rule is None else rule
        n, s = scene.n, scene.s
        self.n, m = n, np.diag(scene.gamma)
        c, k = r * scene.c_over_r, scene.k
        self.c = c
        inverse = np.diag(1 / scene.gamma) / r**2
        a = np.block([[np.zeros((n, n)), np.eye(n)], [-inverse @ k, -inverse @ c]])
        self.sliding = self.solved(a, np.r_[np.zeros(n), inverse @ scene.p])
        self.push = np.linalg.solve(a, np.r_[np.zeros(n), inverse @ scene.w]) * beta
        # Stuck: x = basis q + hat (z0 + s cos tau).
        hat = self.hat = scene.w / (scene.w @ scene.w)
        basis = self.basis = null_space(scene.w[None, :]) if n > 1 else np.zeros((1, 0))
        self.q = n - 1
        if self.q:
            mass = r**2 * basis.T @ m @ basis
            a = np.block([
                [np.zeros((n - 1, n - 1)), np.eye(n - 1)],
                [-np.linalg.solve(mass, basis.T @ k @ basis), -np.linalg.solve(mass, basis.T @ c @ basis)],
            ])
            load = basis.T @ (scene.p + s * (r**2 * m @ hat - 1j * c @ hat - k @ hat))
            self.stuck = self.solved(a, np.r_[np.zeros(n - 1), np.linalg.solve(mass, load)])
            self.lift = np.r_[np.linalg.solve(basis.T @ k @ basis, -basis.T @ k @ hat), np.zeros(n - 1)]

    @staticmethod
    def solved(a, load):
        rates, vectors = np.linalg.eig(a)
        if np.linalg.cond(vectors) > 1e8:
            raise Lost("a defective matrix")
        steady = np.linalg.solve(1j * np.eye(len(a)) - a, load.astype(complex))
        return rates, vectors, np.linalg.inv(vectors), steady

    def assembled(self, parts, tau, state, static):
        rates, vectors, inverse, steady = parts
        turned = steady * np.exp(1j * tau)
        free = inverse @ (state - turned.real - static)
        columns = np.column_stack([vectors * free, turned, static])
        return Exponentials(columns, np.r_[rates, 1j, 0])

    def segment(self, tau, state, contact):
        """Returns the segment that starts from the state (x, x'), with the functions whose first zero ends it."""
        scene, n = self.scene, self.n
        if contact:
            motion = self.assembled(self.sliding, tau, state, self.push * contact)
            row = contact * scene.w @ motion.columns[n:]
            row[-2] += contact * scene.s * -1j * np.exp(1j * tau)
            return Segment(tau, contact, motion, [Exponentials(row[None, :], motion.rates)])
        x, v = state[:n], state[n:]
        z0 = scene.w @ x - scene.s * np.cos(tau)
        excitation = scene.s * np.exp(1j * tau)
        if self.q:
            held = self.assembled(
                self.stuck, tau, np.r_[self.basis.T @ x, self.basis.T @ v], self.lift * z0
            )
            rates, q = held.rates, self.basis @ held.columns[: n - 1]
        else:
            rates, q = np.array([1j, 0]), np.zeros((n, 2), complex)
        place = q.astype(complex)
        place[:, -2] += self.hat * excitation
        place[:, -1] += self.hat * z0
        velocity = place * rates
        load = np.zeros_like(place)
        load[:, -2] = scene.p * np.exp(1j * tau)
        inertia = self.r**2 * scene.gamma[:, None] * (velocity * rates)
        force = self.hat @ (load - inertia - self.c @ velocity - scene.k @ place)
        motion = Exponentials(np.vstack([place, velocity]), rates)
        grip = np.zeros_like(force)
        grip[-1] = self.grip
        gaps = [Exponentials((grip - force)[None, :], rates), Exponentials((grip + force)[None, :], rates)]
        return Segment(tau, 0, motion, gaps)

    def holding(self, tau, state):
        scene, n = self.scene, self.n
        x, v = state[:n], state[n:]
        rest = scene.p * np.cos(tau) - self.c @ v - scene.k @ x
        return (scene.w @ (rest / scene.gamma) + scene.s * self.r**2 * np.cos(tau)) / scene.inverse_mass

    def first_zero(self, function, reach):
        """Returns the first zero of a function that starts from zero or above, and its least minimum before."""
        columns, rates = function.columns[0], function.rates
        scale = np.abs(columns).sum()
        value = lambda t: float((columns @ np.exp(rates * t)).real)
        slope = lambda t: float(((columns * rates) @ np.exp(rates * t)).real)
        step = TAU / PER_PERIOD / max(1.0, np.abs(rates).max())
        nearest, positive, start, last = np.inf, False, 0.0, None
        steps = step * np.arange(1, 65)
        both = np.column_stack([columns, columns * rates])
        while start < reach:
            grid = start + steps if start else np.r_[step * CLUSTER, steps]
            grid = np.r_[grid[grid < reach], reach] if grid[-1] >= reach else grid
            values, slopes = (np.exp(np.outer(grid, rates)) @ both).real.T
            start = grid[-1]
            if not positive:
                above = np.flatnonzero(values > 1e-13 * scale)
                first = above[0] if len(above) else len(grid)
                if (values[:first] < -1e-12 * scale).any():
                    raise Lost("the contact does not start")
                if not len(above):
                    continue
                positive = True
                grid, values, slopes = grid[first:], values[first:], slopes[first:]
            else:
                grid, values, slopes = np.r_[last[0], grid], np.r_[last[1], values], np.r_[last[2], slopes]
            last = grid[-1], values[-1], slopes[-1]
            crossed = values[1:] <= 0
            # The function has a minimum between these points, which may be negative.
            turned = (slopes[:-1] < 0) & (slopes[1:] > 0) & ~crossed
            for i in np.flatnonzero(crossed | turned):
                left, right = grid[i], grid[i + 1]
                if not crossed[i]:
                    right = brentq(slope, left, right, xtol=1e-15)
                    least = value(right)
                    if least > 0:
                        nearest = min(nearest, least)
                        continue
                return brentq(value, left, right, xtol=1e-16, rtol=9e-16), nearest / scale
        return None, nearest / scale

    def start(self, tau, state):
        """Returns 0 if the contact is stuck in this state, and otherwise the direction of sliding, +1 or -1."""
        velocity = self.scene.w @ state[self.n :] + self.scene.s * np.sin(tau)
        if abs(velocity) > 1e-14:
            return int(np.sign(velocity))
        force = self.holding(tau, state)
        return 0 if abs(force) <= self.grip else int(np.sign(force))

    def advance(self, tau, state, contact, reach):
        """Returns one segment, the state after it, and the state of the contact after it."""
        segment = self.segment(tau, state, contact)
        found = [self.first_zero(f, reach) for f in segment.function]
        segment.nearest = min(near for _, near in found)
        zeros = [zero for zero, _ in found]
        if all(zero is None for zero in zeros):
            segment.length = reach
            return segment, segment.motion.at(reach), contact
        which = min((i for i, zero in enumerate(zeros) if zero is not None), key=lambda i: zeros[i])
        length = segment.length = zeros[which]
        after = segment.motion.at(length)
        now = tau + length
        if contact == 0:
            segment.event, segment.force = "slip", self.grip
            return segment, after, 1 if which == 0 else -1
        force = segment.force = self.holding(now, after)
        if abs(abs(force) - self.stops_at) < 1e-10 * self.grip:
            raise Lost("a stop or a reversal")
        if abs(force) <= self.stops_at:
            segment.event = "stop"
            return segment, after, 0
        if np.sign(force) == contact:
            raise Lost("a graze")
        segment.event = "reversal"
        return segment, after, -contact

    def run(self, state, cycles=None, tau=0.0, length=None, contact=None, events=None):
        """Returns the segments over whole cycles, a length, or a number of events, then the last state and contact."""
        contact = self.start(tau, state) if contact is None else contact
        left = TAU * cycles if length is None else length
        segments = []
        while left > 0 and (events is None or events > 0):
            segment, state, contact = self.advance(tau % TAU, state, contact, left)
            left -= segment.length
            if left < 1e-12:
                left = 0
            tau += segment.length
            segments.append(segment)
            if events is not None and segment.event:
                events -= 1
        return segments, state, contact
