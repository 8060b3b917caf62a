"""Pictures of answers.  matplotlib is imported where one is asked for, and nowhere else."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from . import _results

#: The stroke of each regime.
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
    """Frequencies as they were given, and their label."""
    if "omega_rad_s" in answer:
        return answer.omega_rad_s, "angular frequency (rad/s)"
    if "frequency_Hz" in answer:
        return answer.frequency_Hz, "frequency (Hz)"
    return answer.r, "frequency ratio r"


def _friction(answer: Any) -> tuple[Any, str]:
    return (answer.friction_N, "friction (N)") if "friction_N" in answer else (answer.beta, "friction ratio β")


def _column(answer: Any, motion: str, name: str, unit: str) -> tuple[Any, str]:
    """A column of a motion, and its label."""
    inner = answer[motion]
    if f"{name}_{unit}" in inner:
        return inner[f"{name}_{unit}"], f"{name} of {motion} ({unit})"
    return inner[name], f"{name} of {motion}"


def _first(answer: Any, of: str | None) -> str:
    """The motion asked for, or the first mass, or else the contact."""
    if of is not None:
        return of
    return next((name for name in answer.motions if name != "contact"), "contact")


def limits(answer: _results.Limits, ax: Axes | None) -> Axes:
    ax = _axes(ax)
    along, label = _frequency(answer)
    for name in ("continuous_limit", "continuous_limit_without_search", "continuous_limit_per_mode", "sliding_limit"):
        unit = "_N" if f"{name}_N" in answer else ""
        if f"{name}{unit}" in answer:
            values = np.where(np.isfinite(answer[f"{name}{unit}"]), answer[f"{name}{unit}"], np.nan)
            ax.plot(along, values, label=name.replace("_", " "))
    ax.set_xlabel(label)
    ax.set_ylabel("friction (N)" if "sliding_limit_N" in answer else "friction ratio β")
    ax.legend()
    return ax


def response(answer: _results.Response, ax: Axes | None, of: str | None) -> Axes:
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
    ax.legend(title="friction")
    return ax


def curve(answer: _results.Curve, ax: Axes | None, of: str | None) -> Axes:
    ax = _axes(ax)
    along, label = _frequency(answer)
    friction, _ = _friction(answer)
    unit = " N" if "friction_N" in answer else ""
    values, title = _column(answer, _first(answer, of), "amplitude", "m")
    for place, force in enumerate(dict.fromkeys(friction.tolist())):
        ax.plot([], [], color=f"C{place}", label=f"{force:g}{unit}")
        for piece in np.unique(answer.piece[(friction == force) & (answer.piece > 0)]):
            of_piece = (friction == force) & (answer.piece == piece)
            stroke = STROKES.get(str(answer.regime[of_piece][0]), "-")
            ax.plot(along[of_piece], values[of_piece], stroke, color=f"C{place}")
    ax.set_xlabel(label)
    ax.set_ylabel(title)
    ax.set_yscale("log")
    ax.legend(title="friction; dashed: with stops,\ndotted: stuck")
    return ax


def _order(region: str) -> tuple[int, str]:
    """Regions from sliding to stuck."""
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
    """The place of each region among those that are known."""
    codes = np.zeros(regions.shape, int)
    for place, region in enumerate(known):
        codes[regions == region] = place
    return codes


def map(answer: _results.Map, ax: Axes | None, shade: str) -> Axes:
    along, label = _frequency(answer)
    friction, name = _friction(answer)
    if answer.r.ndim != 1 or answer.beta.ndim != 1 or min(answer.shape) < 2:
        raise ValueError("a picture of a map needs at least two frequencies and two frictions")
    ax = _axes(ax)
    if shade == "region":
        import matplotlib

        regions = sorted(set(answer.region.ravel().tolist()), key=_order)
        codes = _places(answer.region, regions)

        colours = matplotlib.colormaps["viridis"].resampled(len(regions))
        drawn = ax.pcolormesh(
            along, friction, codes.T, cmap=colours, vmin=-0.5, vmax=len(regions) - 0.5, shading="nearest"
        )
        bar = ax.figure.colorbar(drawn, ax=ax, ticks=range(len(regions)))
        bar.ax.set_yticklabels(regions)
    else:
        if shade == "stuck":
            values, title = answer.stuck_fraction, "stuck part of the period"
        else:
            values, title = _column(answer, shade, "amplitude", "m")
        # Resonances stand out by orders of magnitude.
        norm = None if shade == "stuck" or not (values > 0).any() else "log"
        drawn = ax.pcolormesh(along, friction, values.T, norm=norm, shading="nearest")
        ax.figure.colorbar(drawn, ax=ax, label=title)
    top = float(np.max(friction))
    for limit, stroke in (("continuous_limit", "-"), ("sliding_limit", "--")):
        line = answer[f"{limit}_N"] if f"{limit}_N" in answer else answer[limit]
        ax.plot(along, np.where(line <= top, line, np.nan), stroke, color="white", label=limit.replace("_", " "))
    ax.set_xlabel(label)
    ax.set_ylabel(name)
    return ax


def history(answer: _results.History | _results.Steps, ax: Axes | None) -> Axes:
    ax = _axes(ax)
    unit = ""
    for motion in answer.motions:
        inner = answer[motion]
        unit = "m" if "displacement_m" in inner else ""
        if f"displacement{'_m' if unit else ''}" in inner:
            values, _ = _column(answer, motion, "displacement", "m")
            ax.plot(answer.time_s, values, label=motion)
    low, high = ax.get_ylim()
    ax.fill_between(
        answer.time_s, low, high, where=answer["contact"].state == "stuck", color="0.9", zorder=0, label="stuck"
    )
    ax.set_ylim(low, high)
    ax.set_xlabel("time (s)")
    ax.set_ylabel("displacement (m)" if unit else "displacement")
    ax.legend()
    return ax


def sensitivities(answer: _results.Sensitivities, ax: Axes | None) -> Axes:
    ax = _axes(ax)
    name = "amplitude_m" if "amplitude_m" in answer else "amplitude"
    ax.barh(answer.parameter[::-1], answer[name].relative[::-1])
    ax.axvline(0.0, color="black", linewidth=0.8)
    ax.set_xlabel("per cent of the amplitude for one per cent of the parameter")
    return ax
