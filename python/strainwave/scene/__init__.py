"""What is to be seen of a gear as plain data, outlines in mm; nothing here knows a plotting library."""

from strainwave.scene.assembly import assembly_scene
from strainwave.scene.scene import Scene
from strainwave.scene.shape import Role, Shape
from strainwave.scene.turning import Fixed, Turning
from strainwave.scene.view import View

__all__ = ["Fixed", "Role", "Scene", "Shape", "Turning", "View", "assembly_scene"]
