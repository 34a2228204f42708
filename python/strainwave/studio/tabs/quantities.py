"""What the numbers that several studies ask for may be."""

from strainwave.quantities import Quantity, WholeNumber

MARGIN = Quantity("µm", 0.0, 1e4)
SEED = WholeNumber("", 0, 2**31 - 1)
