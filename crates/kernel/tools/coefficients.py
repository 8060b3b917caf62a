#!/usr/bin/env python3
"""Coefficients of the kernel's scalar functions as Rust constants, with their errors (needs mpmath).

The output is the same on every run: nothing here depends on the clock or on the platform.
"""

from mpmath import mp, mpf

mp.prec = 300


# --- rounding and printing -------------------------------------------------------------------


def rounded(value, bits):
    """`value` to the nearest number of `bits` significant bits."""
    with mp.workprec(bits):
        return +value


def literal(value, bits):
    """The shortest decimal that reads back as `value` rounded to `bits` (24 or 53) bits."""
    exact = rounded(value, bits)
    for digits in range(1, 18):
        text = "%.*e" % (digits - 1, float(exact))
        if rounded(mpf(text), bits) == exact:
            return repr(float(text))
    raise AssertionError(value)


def pair(value):
    """`value` as the unevaluated sum of two doubles."""
    hi = float(value)
    return hi, float(value - mpf(hi))


# --- Remez exchange --------------------------------------------------------------------------


def horner(coefficients, u):
    total = mpf(0)
    for c in reversed(coefficients):
        total = total * u + c
    return total


def remez(f, weight, low, high, count):
    """The polynomial of `count` coefficients for which max |weight * (p - f)| on [low, high] is
    least, and that maximum."""
    low, high = mpf(low), mpf(high)
    points = 40 * (count + 1)
    middle, half = (low + high) / 2, (high - low) / 2
    grid = [middle - half * mp.cos(mp.pi * k / points) for k in range(points + 1)]
    values = [(u, f(u), weight(u)) for u in grid]
    nodes = [middle - half * mp.cos(mp.pi * k / count) for k in range(count + 1)]
    for _ in range(30):
        matrix = mp.matrix(count + 1, count + 1)
        right = mp.matrix(count + 1, 1)
        for i, u in enumerate(nodes):
            for j in range(count):
                matrix[i, j] = u**j
            matrix[i, count] = (-1) ** i / weight(u)
            right[i] = f(u)
        solution = mp.lu_solve(matrix, right)
        coefficients = [solution[j] for j in range(count)]
        errors = [w * (horner(coefficients, u) - g) for u, g, w in values]
        extrema, start = [], 0
        for i in range(1, len(grid) + 1):
            if i == len(grid) or (errors[i] > 0) != (errors[start] > 0):
                extrema.append(max(range(start, i), key=lambda k: abs(errors[k])))
                start = i
        while len(extrema) > count + 1:
            extrema.pop(0 if abs(errors[extrema[0]]) < abs(errors[extrema[-1]]) else -1)
        if len(extrema) < count + 1:
            raise AssertionError("the error curve lost an alternation")
        nodes = [grid[k] for k in extrema]
        worst = max(abs(e) for e in errors)
        if worst <= abs(solution[count]) * mpf("1.0005"):
            break
    return coefficients, worst


# --- the functions that are approximated -----------------------------------------------------


def factorial_series(sign, first, scale):
    """sum_k sign^k scale^(2k + first) / (2k + first)! u^k."""
    powers = [(k, 2 * k + first) for k in range(70)]
    table = [mpf(sign) ** k * scale**n / mp.factorial(n) for k, n in powers]
    return lambda u: horner(table, u)


PI = mp.pi
# sin(pi r) = pi r + r u SIN(u), cos(pi r) = 1 - pi^2/2 u + u^2 COS(u), u = r^2.
SIN_TAIL = factorial_series(-1, 3, PI)
COS_TAIL = factorial_series(-1, 4, PI)
# 1 - sin(pi z)/(pi z) = pi^2/6 u + u^2 SINC(u), u = z^2.
SINC_TAIL = factorial_series(-1, 5, PI)
# e^a - 1 - a = a^2 EXP(a).
EXP_TAIL = lambda a: horner([1 / mp.factorial(n + 2) for n in range(70)], a)
# 2 (sinh a - a) = a^3 SINH(u), u = a^2.
SINH_TAIL = factorial_series(1, 3, mpf(1))


def sin_weight(u):
    r = mp.sqrt(u)
    return r * u / mp.sin(PI * r) if u else mpf(0) + mpf(2) ** -60


def cos_weight(u):
    return max(u * u / mp.cos(PI * mp.sqrt(u)), mpf(2) ** -60)


def sinc_weight(u):
    return max(u / (PI**2 / 6 - u * SINC_TAIL(u) / PI), mpf(2) ** -60)


# A little more than a quarter: a remainder may pass it by its tail.
EDGE = mpf("0.2501") ** 2

FITS = [
    # name, function, weight, low, high, coefficients for f64, for f32
    ("SIN", lambda u: -SIN_TAIL(u), sin_weight, 0, EDGE, 6, 3),
    ("COS", COS_TAIL, cos_weight, 0, EDGE, 6, 3),
    ("SINC", lambda u: -SINC_TAIL(u) / PI, sinc_weight, 0, mpf("0.5625"), 8, 5),
    ("EXP", EXP_TAIL, lambda a: 1 / EXP_TAIL(a), -1, 1, 15, 9),
    ("SINH", lambda u: 2 * SINH_TAIL(u), lambda u: 1 / (2 * SINH_TAIL(u)), 0, 4, 9, 5),
]

# name, value, bits of the first part for f64, for f32 (the second part is the remainder)
SPLITS = [
    ("PI", PI, 36, 16),
    ("HALF_PI_SQUARED", PI**2 / 2, 53, 24),
    ("SIXTH_PI_SQUARED", PI**2 / 6, 18, 8),
]


def constants():
    for bits, column in ((53, 5), (24, 6)):
        print(f"// {'f64' if bits == 53 else 'f32'}")
        for name, value, double, single in SPLITS:
            high = rounded(value, double if bits == 53 else single)
            print(f"{name}: {literal(high, bits)}, {literal(value - high, bits)}")
        for fit in FITS:
            name, f, weight, low, high = fit[:5]
            coefficients, worst = remez(f, weight, low, high, fit[column])
            print(f"// {name}: error {mp.nstr(worst, 3)} = 2^{mp.nstr(mp.log(worst, 2), 4)}")
            for c in coefficients:
                print(f"    {literal(c, bits)},")
    print("// double-double")
    ln2 = mp.log(2)
    one = mp.floor(ln2 * 2**42) / mpf(2) ** 42
    two = mp.floor((ln2 - one) * 2**84) / mpf(2) ** 84
    print(f"LN_2 parts: {float(one)!r}, {float(two)!r}, {float(ln2 - one - two)!r}")
    print(f"PI: {pair(PI)}")
    for n in range(38):
        hi, lo = pair(1 / mp.factorial(n))
        print(f"    Dd::new({hi!r}, {lo!r}),")


if __name__ == "__main__":
    constants()
