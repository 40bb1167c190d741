"""Materials of yarns that are modelled as beams or solids."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class YarnMaterial:
    """Transversely isotropic yarn (forms.materials).

    Raises:
        ValueError: If the law is not positive definite.
    """

    axial_modulus: float  # E_a, MPa
    transverse_modulus: float  # E_t, MPa
    axial_shear_modulus: float  # G_a, MPa
    axial_poisson: float = 0.0  # contraction across by stretching along, -
    transverse_poisson: float = 0.0  # contraction across by stretching across, -

    def __post_init__(self) -> None:
        for name in ("axial_modulus", "transverse_modulus", "axial_shear_modulus"):
            if not getattr(self, name) > 0.0:
                raise ValueError(f"{name} is {getattr(self, name)} MPa: it must be positive")
        if not abs(self.transverse_poisson) < 1.0:
            raise ValueError(f"transverse_poisson is {self.transverse_poisson}: |.| < 1 needed")
        ratio = self.transverse_modulus / self.axial_modulus
        if not 1.0 - self.transverse_poisson - 2.0 * ratio * self.axial_poisson**2 > 0.0:
            raise ValueError(
                f"axial_poisson is {self.axial_poisson}: the law is not positive definite unless "
                "1 - transverse_poisson - 2 E_t / E_a axial_poisson^2 > 0"
            )

    @classmethod
    def isotropic(cls, modulus: float, poisson: float) -> YarnMaterial:
        """Isotropic material: modulus in MPa, Poisson ratio."""
        return cls(modulus, modulus, modulus / (2.0 * (1.0 + poisson)), poisson, poisson)
