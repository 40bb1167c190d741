"""Numbers of bodies, as far as friction and touching are concerned."""

YARN, CORE, SHEAVE = range(3)
