"""The gear as solids: closed triangle meshes of its parts, undeformed or assembled, within a chord error."""

from strainwave.assembly.circular_spline import circular_spline_mesh
from strainwave.assembly.flexspline import flexspline_mesh
from strainwave.assembly.mesh import Mesh
from strainwave.assembly.wave_generator import wave_generator_mesh

__all__ = ["Mesh", "circular_spline_mesh", "flexspline_mesh", "wave_generator_mesh"]
