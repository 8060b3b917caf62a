"""Methods that follow steady states along a parameter, and that find limit cycles."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

from .. import _native
from .._answers.branches import Branches, LimitCycles
from .base import Base, names, state

if TYPE_CHECKING:
    from numpy.typing import ArrayLike


class Branching(Base):
    """Methods for branches of steady states and for limit cycles, of scenes with any number of contacts."""

    __slots__ = ()

    def branch(
        self,
        along: str,
        over: tuple[float, float],
        *,
        r: float | None = None,
        hz: float | None = None,
        omega: float | None = None,
        beta: float | None = None,
        friction: float | None = None,
        force: float | str | None = None,
        base: float | str | None = None,
        of: str | Iterable[str] | None = None,
        start: str | tuple[ArrayLike, ArrayLike] | None = None,
        states: bool = False,
        switch: int = 0,
        points: int = 1000,
    ) -> Branches:
        """Follows steady states, stable or not, along a parameter through folds, with every bifurcation.

        The search is local: it finds no branch that is not connected to one that it knows.

        :param along: the parameter: `r`, `hz`, `omega`, `beta`, `friction`, `load`, or a number of the description, such as
            `m upper`, `k base - lower`, `mu pads`, `share pads`, `speed pads`.  Leave its own argument out.
        :param over: first and last value of the parameter.  The branch starts at the first.
        :param of: names of the motions to return besides all contacts, as for :meth:`by_contact`.
        :param start: the initial state of the motion to the first point, as for :meth:`orbit`.
        :param states: whether every state that :meth:`states` finds at the first value starts a branch.  By default, only
            the state that motion from rest or from `start` reaches does.
        :param switch: depth of the branches that begin at bifurcations: 1 follows those on the first branches, 2 also
            those on these, and so on.
        :param points: largest number of points on a branch.

        >>> import frictiongen
        >>> block = frictiongen.System('''struct Block {
        ...     masses: { m: 1 }, springs: { base - m: 1 }, contact: m - base, excitation: base, stiction: 1.5,
        ... }''')
        >>> found = block.branch("r", (0.8, 0.5), beta=0.1, switch=1)
        >>> "symmetry breaking" in found.event, found.ends.parent.tolist()
        (True, [-1, 0])
        >>> float(found.value[0]), str(found.state[0])
        (0.8, 'stable')
        """
        first, last = over
        return Branches(
            *_native.branch(
                self._native,
                (along, (first, last), (switch, bool(states), points)),
                (r, hz, omega),
                (beta, friction),
                ((force, base), state(start)),
                names(of),
            )
        )

    def limit_cycle(
        self,
        *,
        friction: ArrayLike,
        start: str | tuple[ArrayLike, ArrayLike] | None = None,
        of: str | Iterable[str] | None = None,
    ) -> LimitCycles:
        """Finds the periodic motion that a moving surface keeps up without a load, such as stick-slip on a belt.

        The description needs no `excitation`.

        :param friction: common friction force in N: a number, or a list or an array.
        :param start: "rest", or initial displacements and velocities of all masses, in m and m/s.  The default is rest.
        :param of: names of the motions to return besides all contacts, as for :meth:`by_contact`.

        >>> import frictiongen
        >>> belt = frictiongen.System('''struct Belt {
        ...     masses: { block: 1 }, springs: { block - wall: 1 },
        ...     contacts: { pads: block - wall { speed: 0.3, stiction: 2 } },
        ... }''')
        >>> cycles = belt.limit_cycle(friction=[0.0, 1.0])
        >>> cycles.period_s.round(3).tolist(), cycles.without
        ([10.391], [0.0])
        """
        return LimitCycles(*_native.limit_cycle(self._native, friction, state(start), names(of)))
