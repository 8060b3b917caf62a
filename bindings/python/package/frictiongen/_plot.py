"""Pictures of answers.  The functions import matplotlib only when they draw."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from . import _answers as answers
    from ._recording import Recording

#: Line style of each regime.
STROKES = {"continuous": "-", "stick-slip": "--", "stuck": ":"}


def _axes(ax: Axes | None) -> Axes:
    if ax is not None:
        return ax
    try:
        import matplotlib.pyplot
    except ImportError as error:
        raise ImportError("plot() needs matplotlib, which is not installed: pip install matplotlib") from error
    return matplotlib.pyplot.subplots(constrained_layout=True)[1]


def _frequency(answer: Any) -> tuple[Any, str]:
    """Returns the frequencies in the caller's unit, and the label of the axis."""
    if "omega_rad_s" in answer:
        return answer.omega_rad_s, "angular frequency (rad/s)"
    if "frequency_Hz" in answer:
        return answer.frequency_Hz, "frequency (Hz)"
    return answer.r, "frequency ratio r"


def _friction(answer: Any) -> tuple[Any, str]:
    return (answer.friction_N, "friction (N)") if "friction_N" in answer else (answer.beta, "friction ratio β")


def _column(answer: Any, motion: str, name: str, unit: str) -> tuple[Any, str]:
    """Returns a column of a motion, and the label of its axis."""
    inner = answer[motion]
    if f"{name}_{unit}" in inner:
        return inner[f"{name}_{unit}"], f"{name} of {motion} ({unit})"
    return inner[name], f"{name} of {motion}"


def _edges(values: Any) -> Any:
    """Returns the bounds of cells around these values.

    A bound lies in the middle between two values.  The first and the last bound lie half a step beyond the values, but
    not below 0.
    """
    middles = 0.5 * (values[1:] + values[:-1])
    first, last = values[0] - (middles[0] - values[0]), values[-1] + (values[-1] - middles[-1])
    return np.maximum(np.concatenate([[first], middles, [last]]), 0.0)


def _within(ax: Axes, along: Any) -> None:
    """Limits the frequency axis to the range of the data."""
    if np.size(along) > 1:
        ax.margins(x=0)


def _first(answer: Any, of: str | None) -> str:
    """Returns `of`.  The default is the first mass, or the contact if there is no mass."""
    if of is not None:
        return of
    return str(next(iter(answer.masses), next(iter(answer.motions))))


def limits(answer: answers.Limits, ax: Axes | None) -> Axes:
    ax = _axes(ax)
    along, label = _frequency(answer)
    for name in ("continuous_limit", "continuous_limit_without_search", "continuous_limit_per_mode", "sliding_limit"):
        unit = "_N" if f"{name}_N" in answer else ""
        if f"{name}{unit}" in answer:
            values = np.where(np.isfinite(answer[f"{name}{unit}"]), answer[f"{name}{unit}"], np.nan)
            ax.plot(along, values, label=name.replace("_", " "))
    ax.set_xlabel(label)
    ax.set_ylabel("friction (N)" if "sliding_limit_N" in answer else "friction ratio β")
    _within(ax, along)
    ax.set_ylim(bottom=0.0)
    ax.legend()
    return ax


def response(answer: answers.Response | answers.ByContact, ax: Axes | None, of: str | None) -> Axes:
    ax = _axes(ax)
    along, label = _frequency(answer)
    friction, _ = _friction(answer)
    unit = " N" if "friction_N" in answer else ""
    values, title = _column(answer, _first(answer, of), "amplitude", "m")
    values = np.reshape(values, (np.size(along), np.size(friction)))
    for place, force in enumerate(np.ravel(friction)):
        marker = "." if np.size(along) == 1 else ""
        ax.plot(np.ravel(along), values[:, place], marker=marker, label=f"{force:g}{unit}")
    ax.set_xlabel(label)
    ax.set_ylabel(title)
    _within(ax, along)
    ax.set_ylim(bottom=0.0)
    ax.legend(title="friction")
    return ax


def curve(answer: answers.Curve, ax: Axes | None, of: str | None) -> Axes:
    ax = _axes(ax)
    along, label = _frequency(answer)
    friction, _ = _friction(answer)
    unit = " N" if "friction_N" in answer else ""
    values, title = _column(answer, _first(answer, of), "amplitude", "m")
    starts = answer["start"] if "start" in answer else np.full(friction.shape, "")
    ways = {"": "", "rest": ", from rest"}
    for place, (force, start) in enumerate(dict.fromkeys(zip(friction.tolist(), starts.tolist()))):
        way = ways.get(start, f", swept {start}")
        ax.plot([], [], color=f"C{place}", label=f"{force:g}{unit}{way}")
        of_curve = (friction == force) & (starts == start)
        for piece in np.unique(answer.piece[of_curve & (answer.piece > 0)]):
            of_piece = of_curve & (answer.piece == piece)
            stroke = STROKES.get(str(answer.regime[of_piece][0]), "-")
            ax.plot(along[of_piece], values[of_piece], stroke, color=f"C{place}")
    ax.set_xlabel(label)
    ax.set_ylabel(title)
    ax.set_yscale("log")
    _within(ax, along)
    ax.legend(title="friction; dashed: with stops,\ndotted: stuck")
    return ax


def _order(region: str) -> tuple[int, str]:
    """Returns the sort key of a region.  The keys sort regions from sliding to stuck."""
    first = ("continuous", "sliding reversals")
    last = ("subharmonic", "unsettled")
    if region in first:
        return first.index(region), ""
    if region[0].isdigit():
        return 2 + int(region.split()[0]), ""
    if region in last:
        return 1000 + last.index(region), ""
    return (3000, "") if region == "stuck" else (2000, region)


def _places(regions: Any, known: list[str]) -> Any:
    """Returns the index of each region among the known ones."""
    codes = np.zeros(regions.shape, int)
    for place, region in enumerate(known):
        codes[regions == region] = place
    return codes


def map(answer: answers.Map, ax: Axes | None, shade: str) -> Axes:
    along, label = _frequency(answer)
    friction, name = _friction(answer)
    if answer.r.ndim != 1 or answer.beta.ndim != 1 or min(answer.shape) < 2:
        raise ValueError("a picture of a map needs at least two frequencies and two frictions")
    ax = _axes(ax)
    cells = _edges(along), _edges(friction)
    if shade == "region":
        import matplotlib

        regions = sorted(set(answer.region.ravel().tolist()), key=_order)
        codes = _places(answer.region, regions)

        colours = matplotlib.colormaps["viridis"].resampled(len(regions))
        drawn = ax.pcolormesh(*cells, codes.T, cmap=colours, vmin=-0.5, vmax=len(regions) - 0.5)
        bar = ax.figure.colorbar(drawn, ax=ax, ticks=range(len(regions)))
        bar.ax.set_yticklabels(regions)
    else:
        if shade == "stuck":
            values, title = answer.stuck_fraction, "stuck part of the period"
        else:
            values, title = _column(answer, shade, "amplitude", "m")
        # Amplitudes at resonances are larger by orders of magnitude.
        norm = None if shade == "stuck" or not (values > 0).any() else "log"
        drawn = ax.pcolormesh(*cells, values.T, norm=norm)
        ax.figure.colorbar(drawn, ax=ax, label=title)
    top = float(np.max(friction))
    for limit, stroke in (("continuous_limit", "-"), ("sliding_limit", "--")):
        line = answer[f"{limit}_N"] if f"{limit}_N" in answer else answer[limit]
        ax.plot(along, np.where(line <= top, line, np.nan), stroke, color="white", label=limit.replace("_", " "))
    ax.set_xlabel(label)
    ax.set_ylabel(name)
    return ax


def branches(answer: answers.Branches, ax: Axes | None, of: str | None) -> Axes:
    ax = _axes(ax)
    values, title = _column(answer, _first(answer, of), "amplitude", "m")
    for place in np.unique(answer.branch):
        of_branch = answer.branch == place
        line = np.where(of_branch, values, np.nan)
        grows = answer.state == "unstable"
        ax.plot(answer.value, np.where(grows, np.nan, line), "-", color=f"C{place}", label=f"branch {place}")
        ax.plot(answer.value, np.where(grows, line, np.nan), "--", color=f"C{place}")
    marked = answer.event != ""
    ax.plot(answer.value[marked], values[marked], "k.", label="events")
    ax.set_xlabel(f"{answer.along} ({answer.unit})" if answer.unit else answer.along)
    ax.set_ylabel(title)
    ax.legend(title="dashed: unstable")
    return ax


def history(answer: answers.History | answers.Steps | answers.Driven | answers.Cycle, ax: Axes | None) -> Axes:
    ax = _axes(ax)
    unit = ""
    along, label = (answer.time_s, "time (s)") if "time_s" in answer else (answer["tau"], "phase of the load (rad)")
    for motion in answer.motions:
        inner = answer[motion]
        if "displacement_m" in inner or "displacement" in inner:
            unit = "m" if "displacement_m" in inner else ""
            values, _ = _column(answer, motion, "displacement", "m")
            ax.plot(along, values, label=motion)
    contact = answer.contact
    if "state" in contact or "sticks" in contact:
        sticks = contact.state == "stuck" if "state" in contact else contact.sticks
        low, high = ax.get_ylim()
        ax.fill_between(along, low, high, where=sticks, color="0.9", zorder=0, label="stuck")
        ax.set_ylim(low, high)
    ax.set_xlabel(label)
    ax.set_ylabel("displacement (m)" if unit else "displacement")
    ax.legend()
    return ax


def sensitivities(answer: answers.Sensitivities, ax: Axes | None) -> Axes:
    ax = _axes(ax)
    names = ("amplitude_m", "amplitude", "energy_J", "energy")
    name = next(name for name in names if name in answer)
    ax.barh(answer.parameter[::-1], answer[name].relative[::-1])
    ax.axvline(0.0, color="black", linewidth=0.8)
    ax.set_xlabel(f"per cent of the {name.split('_')[0]} for one per cent of the parameter")
    return ax


def features(answer: answers.Features, ax: Axes | None) -> Axes:
    ax = _axes(ax)
    # The axes are in Hz and N with a load, otherwise non-dimensional.
    load = "continuous_limit_N" in answer.ends
    along = "frequency_Hz" if load else "r"
    unit = "_N" if load else ""
    bound = answer.resonances
    ax.plot(bound[along], bound[f"threshold{unit}"], "^", color="C0", label="threshold of a resonance")
    for held in answer.held_resonances[along]:
        ax.axvline(held, color="0.6", linestyle=":", label="resonance if stuck")
    points = answer.invariant_points
    ax.plot(points[along], points[f"continuous_limit{unit}"], "o", color="C3", label="invariant point, up to its limit")
    ranges = answer.regimes
    friction = ranges["friction_N" if load else "beta"]
    for place, regime in enumerate(ranges.regime):
        ends = [ranges[along][place], ranges[f"to_{along}"][place]]
        stroke = STROKES.get(str(regime), "-")
        ax.plot(ends, [friction[place]] * 2, stroke, color="black", label=str(regime))
    handles, labels = ax.get_legend_handles_labels()
    once = dict(zip(labels, handles, strict=True))
    ax.legend(once.values(), once.keys())
    ax.set_xlabel("frequency (Hz)" if load else "frequency ratio r")
    ax.set_ylabel("friction (N)" if load else "friction ratio β")
    return ax


def recording(answer: Recording, ax: Axes | None) -> Axes:
    ax = _axes(ax)
    for name, unit in answer.units.items():
        ax.plot(answer.time_s, answer[name], label=f"{name} ({unit})")
    ax.set_xlabel("time (s)")
    ax.legend()
    return ax


def transmissibilities(answer: answers.Transmissibilities, ax: Axes | None) -> Axes:
    ax = _axes(ax)
    for name in answer.motions:
        motion = answer[name]
        if "transmissibility" in motion:
            ax.errorbar(
                answer.frequency_Hz, motion.transmissibility, 2 * motion.deviation, fmt="o", capsize=3, label=name
            )
    ax.set_xlabel("frequency (Hz)")
    ax.set_ylabel("transmissibility")
    ax.legend()
    return ax


def residuals(answer: answers.Identification, ax: Axes | None) -> Axes:
    ax = _axes(ax)
    if np.isnan(answer.residual_real).any():
        ax.plot(answer.frequency_Hz, answer.residual_over_deviation, "o", color="black", label="size")
    else:
        ax.plot(answer.frequency_Hz, answer.residual_real, "o", color="black", label="real part")
        ax.plot(answer.frequency_Hz, answer.residual_imaginary, "o", color="black", fillstyle="none", label="imaginary part")
    for level in (-2.0, 0.0, 2.0):
        ax.axhline(level, color="0.6", linewidth=0.8)
    ax.set_xlabel("frequency (Hz)")
    ax.set_ylabel("residual over deviation")
    ax.legend()
    return ax


def fit(answer: answers.Fit, ax: Axes | None) -> Axes:
    ax = _axes(ax)
    low, high = answer.frequency_Hz.min(), answer.frequency_Hz.max()
    hz = np.linspace(0.9 * low, 1.05 * high, 400)
    computed = answer.system.response(hz=hz, friction=0.0, base=1.0)
    for place, name in enumerate(dict.fromkeys(answer.of.tolist())):
        of_mass = answer.of == name
        ax.plot(answer.frequency_Hz[of_mass], answer.transmissibility[of_mass], "o", color=f"C{place}", label=name)
        ax.plot(hz, computed[name].amplitude_m, color=f"C{place}", label=f"{name}, fitted")
    ax.set_yscale("log")
    ax.set_xlabel("frequency (Hz)")
    ax.set_ylabel("transmissibility")
    ax.legend()
    return ax
