"""What a solve of Newton's method came to."""

from __future__ import annotations

from dataclasses import dataclass, replace


@dataclass(frozen=True)
class NewtonResult:
    """Outcome of a solve: whether it converged, in how many iterations, and the last relative residual."""

    converged: bool
    iterations: int
    linear_solves: int
    residual: float
    reason: str

    def after(self, other: NewtonResult) -> NewtonResult:
        """This outcome with the cost of another attempt before it."""
        return replace(
            self,
            iterations=other.iterations + self.iterations,
            linear_solves=other.linear_solves + self.linear_solves,
        )

    @property
    def exhausted(self) -> bool:
        """Whether it only ran out of iterations."""
        return self.reason == "diverged max it"
