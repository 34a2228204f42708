"""The compiled kernel: profiles, neutral curves, placement, signed clearance.

Everything is in mm and radians; angles run clockwise from +Y. Clearance > 0 is a gap, < 0 a depth. Arguments may be
numbers or arrays of any shape; results have that shape and further axes as stated. Arguments that are not finite raise
`ValueError`.
"""

from typing import final

import numpy as np
from numpy.typing import ArrayLike, NDArray

__all__ = [
    "CONTACT_KINDS",
    "BatchCurves",
    "BatchMetrics",
    "BatchProfiles",
    "Clearances",
    "Engagement",
    "GeometryError",
    "MotionMinimum",
    "NeutralCurve",
    "Profile",
    "evaluate_batch",
]

CONTACT_KINDS: tuple[str, ...]
"""Names of the contact kinds in `Clearances.kind`."""

class GeometryError(ValueError):
    """A geometry that cannot be built."""

    code: str
    """A stable name in kebab-case."""
    numbers: dict[str, float]
    """The figures of this case by name, units in the names (mm, rad)."""

@final
class Profile:
    """One half (x >= 0) of a symmetric tooth by arc length, from the tooth's axis at the tip to mid-space.

    `flank` is the nominal flank as rows x, y, normal angle, curvature, length, shape (n, 5), without tip land, fillet
    and root floor: it is moved by `offset` along its normal, its first piece is cut or extended to the addendum circle,
    its last to the root circle (with a tangent fillet where `fillet_radius` > 0), and land and floor, arcs about the
    gear's centre, are added. `internal` is true for the circular spline. Raises `GeometryError`.
    """

    def __new__(
        cls,
        flank: ArrayLike,
        *,
        teeth: int,
        pitch_radius: float,
        internal: bool,
        addendum: float,
        dedendum: float,
        offset: float = 0.0,
        fillet_radius: float = 0.0,
    ) -> Profile: ...
    @property
    def segments(self) -> NDArray[np.float64]:
        """Pieces as rows x, y, normal angle, curvature, length; shape (n, 5)."""
    @property
    def roles(self) -> list[str]:
        """What each piece is: "tip land", "flank", "fillet" or "root floor"."""
    @property
    def knots(self) -> NDArray[np.float64]:
        """Arc lengths of the joins from 0 to the length; shape (n + 1,)."""
    @property
    def length(self) -> float: ...
    @property
    def teeth(self) -> int: ...
    @property
    def pitch_radius(self) -> float: ...
    @property
    def internal(self) -> bool: ...
    @property
    def tip_land_width(self) -> float:
        """Arc length of the whole tip land, both halves."""
    @property
    def root_floor_width(self) -> float:
        """Arc length of the whole root floor, both halves."""
    def position(self, u: ArrayLike) -> NDArray[np.float64]:
        """Points at arc lengths `u`; shape u.shape + (2,). Beyond its ends the profile's first and last piece go on."""
    def tangent(self, u: ArrayLike) -> NDArray[np.float64]:
        """Unit tangents from tip to root; shape u.shape + (2,)."""
    def normal(self, u: ArrayLike) -> NDArray[np.float64]:
        """Outward unit normals; shape u.shape + (2,)."""
    def curvature(self, u: ArrayLike) -> NDArray[np.float64]:
        """Curvatures in 1/mm, > 0 convex, < 0 concave; shape u.shape."""

@final
class NeutralCurve:
    """The deformed neutral curve of the flexspline's rim: closed, convex, even about both axes, major axis along +Y.

    `model` is "first-order", "shifted" or "inextensible". The constructors raise `GeometryError`.
    """

    @staticmethod
    def harmonics(radius: float, w0: float, model: str, coefficients: list[float]) -> NeutralCurve:
        """w/w0 = sum of coefficients[n] cos 2n phi."""
    @staticmethod
    def ring(radius: float, w0: float, model: str, pieces: ArrayLike) -> NeutralCurve:
        """Rows phi_end, p, c, c_phi, s, s_phi over 0 <= phi <= pi/2, shape (n, 6):
        w/w0 = p + (c + c_phi phi) cos phi + (s + s_phi phi) sin phi."""
    @staticmethod
    def ellipse(radius: float, w0: float, equidistant: float) -> NeutralCurve:
        """The curve `equidistant` mm outside an ellipse, with major semi-axis radius + w0 and perimeter 2 pi radius."""
    @property
    def radius(self) -> float:
        """Radius of the undeformed neutral circle."""
    @property
    def w0(self) -> float: ...
    @property
    def perimeter(self) -> float: ...
    def displacement(self, phi: ArrayLike) -> NDArray[np.float64]:
        """r(phi) - radius and its first two derivatives by phi; shape phi.shape + (3,)."""
    def position(self, phi: ArrayLike) -> NDArray[np.float64]:
        """Points of the curve; shape phi.shape + (2,)."""
    def curvature(self, phi: ArrayLike) -> NDArray[np.float64]: ...
    def psi(self, phi: ArrayLike) -> NDArray[np.float64]:
        """-arctan(r'/r): how far the normal is turned from the radius."""
    def arc_length(self, phi: ArrayLike) -> NDArray[np.float64]: ...
    def angle_at(self, s: ArrayLike) -> NDArray[np.float64]:
        """The polar angle at arc length `s`, the inverse of `arc_length`."""
    def tangential_displacement(self, phi: ArrayLike) -> NDArray[np.float64]:
        """Shift, > 0 towards +phi, of the material point now at `phi` along the tangent of the circle it came from."""

@final
class Engagement:
    """Both splines and the neutral curve between them.

    The tooth of index k sits at arc length k * perimeter / z_f. It meets one relative pose for each real k whatever the
    wave generator's angle: flexspline tooth i has k = i - generator_angle * z_c / (2 pi). Raises `GeometryError`.
    """

    def __new__(cls, flexspline: Profile, circular_spline: Profile, curve: NeutralCurve) -> Engagement: ...
    def flexspline_poses(self, index: ArrayLike, generator_angle: float = 0.0) -> NDArray[np.float64]:
        """Tooth frames as x, y, angle in the global frame, circular spline fixed; shape index.shape + (3,)."""
    def circular_spline_poses(self, index: ArrayLike) -> NDArray[np.float64]:
        """Frames of the teeth clockwise of spaces `index` as x, y, angle; shape index.shape + (3,)."""
    def relative_poses(self, index: ArrayLike) -> NDArray[np.float64]:
        """Flexspline tooth frames as x, y, angle in the frame of the space in which they stand: origin on its axis at
        the circular spline's pitch circle, y outward; shape index.shape + (3,)."""
    def clearances(self, index: ArrayLike) -> Clearances:
        """Signed clearances of both flanks; points and normals in the global frame at generator angle 0."""
    def clearances_at(self, poses: ArrayLike) -> Clearances:
        """The same for any poses in the frame of a space, shape (..., 3); points and normals in that frame."""
    def circumferential(self, index: ArrayLike) -> NDArray[np.float64]:
        """Arcs at the circular spline's pitch circle through which it turns until the left, the right flank touches;
        nan where half a pitch brings no contact; shape index.shape + (2,)."""
    def radial_clearances(self, index: ArrayLike) -> NDArray[np.float64]:
        """Flexspline tip to circular-spline root circle, circular-spline tip circle to flexspline root floor;
        shape index.shape + (2,)."""
    def minimum_in_motion(self, tolerance: float) -> MotionMinimum:
        """The least gap over all real indices, certified to `tolerance` mm. Ctrl-C stops the search."""
    def play_in_motion(self, tolerance: float) -> float:
        """The least circumferential backlash over all real indices, mm, within `tolerance`; nan where none. Ctrl-C
        stops the search."""

@final
class Clearances:
    """Signed clearances with their witnesses; the axis of length 2 after the index's shape is left, right flank.

    Right is the half x > 0 of the flexspline tooth, its clockwise side.
    """

    @property
    def gap(self) -> NDArray[np.float64]:
        """Signed clearance in mm, > 0 a gap, < 0 a depth; shape (..., 2)."""
    @property
    def flexspline_u(self) -> NDArray[np.float64]:
        """Arc length of the witness on the flexspline's profile; shape (..., 2)."""
    @property
    def circular_spline_u(self) -> NDArray[np.float64]: ...
    @property
    def flexspline_segment(self) -> NDArray[np.int64]:
        """Index into `Profile.segments`; shape (..., 2)."""
    @property
    def circular_spline_segment(self) -> NDArray[np.int64]: ...
    @property
    def flexspline_half(self) -> NDArray[np.int64]:
        """+1 on the half x >= 0 of its own tooth frame, -1 on the mirrored half; shape (..., 2)."""
    @property
    def circular_spline_half(self) -> NDArray[np.int64]: ...
    @property
    def circular_spline_tooth(self) -> NDArray[np.int64]:
        """+1 the tooth clockwise of the space, -1 the other one, +-2 the next; shape (..., 2)."""
    @property
    def kind(self) -> NDArray[np.int64]:
        """Index into `CONTACT_KINDS`; shape (..., 2)."""
    @property
    def flexspline_point(self) -> NDArray[np.float64]:
        """Witness on the flexspline; shape (..., 2, 2)."""
    @property
    def circular_spline_point(self) -> NDArray[np.float64]: ...
    @property
    def normal(self) -> NDArray[np.float64]:
        """Unit normals from the flexspline outward: moving the tooth along one closes its gap; shape (..., 2, 2)."""

@final
class MotionMinimum:
    """The certified least gap over continuous tooth index."""

    @property
    def gap(self) -> float: ...
    @property
    def index(self) -> float: ...
    @property
    def tolerance(self) -> float: ...
    @property
    def lower_bound(self) -> float:
        """Nowhere is the gap below this."""
    @property
    def evaluations(self) -> int: ...
    @property
    def slope_bound(self) -> float:
        """No outline point moves faster than this, mm per index."""
    @property
    def curvature_bound(self) -> float:
        """Bound of the gap's second derivative where the witness is smooth and nothing overlaps, mm/index²."""

@final
class BatchProfiles:
    """The profiles of one spline in a batch. Arguments as for `Profile`, with a first axis of 1 or as many rows as the
    batch has: `flank` has shape (rows, n, 5), the numbers shape (rows,)."""

    def __new__(
        cls,
        flank: ArrayLike,
        *,
        teeth: int,
        pitch_radius: ArrayLike,
        internal: bool,
        addendum: ArrayLike,
        dedendum: ArrayLike,
        offset: ArrayLike,
        fillet_radius: ArrayLike,
    ) -> BatchProfiles: ...

@final
class BatchCurves:
    """The neutral curves of a batch. Arguments as for `NeutralCurve`, with a first axis of 1 or as many rows as the
    batch has; `model` is one for all."""

    @staticmethod
    def harmonics(radius: ArrayLike, w0: ArrayLike, model: str, coefficients: ArrayLike) -> BatchCurves:
        """`coefficients` has shape (rows, n)."""
    @staticmethod
    def ring(radius: ArrayLike, w0: ArrayLike, model: str, pieces: ArrayLike) -> BatchCurves:
        """`pieces` has shape (rows, n, 6)."""
    @staticmethod
    def ellipse(radius: ArrayLike, w0: ArrayLike, equidistant: ArrayLike) -> BatchCurves: ...

@final
class BatchMetrics:
    """The answers of a batch, in mm, as arrays of shape (rows,); nan or -1 where a row has none."""

    @property
    def min_gap(self) -> NDArray[np.float64]: ...
    @property
    def min_index(self) -> NDArray[np.float64]:
        """Tooth index k >= 0 of the least gap; half indices are the second lobe of an odd number of teeth."""
    @property
    def teeth_below(self) -> NDArray[np.int64]:
        """Teeth 1 ... z_f // 4 with 0 <= gap < threshold."""
    @property
    def interfering(self) -> NDArray[np.int64]:
        """Teeth 0 ... z_f // 4 with gap < 0."""
    @property
    def first_interfering(self) -> NDArray[np.int64]:
        """The first of them, or -1."""
    @property
    def play(self) -> NDArray[np.float64]:
        """The least circumferential backlash of any tooth at generator angle 0."""
    @property
    def tip_clearance(self) -> NDArray[np.float64]: ...
    @property
    def root_clearance(self) -> NDArray[np.float64]: ...
    @property
    def min_in_motion(self) -> NDArray[np.float64]: ...
    @property
    def min_in_motion_index(self) -> NDArray[np.float64]: ...
    @property
    def lower_bound_in_motion(self) -> NDArray[np.float64]: ...
    @property
    def errors(self) -> list[str | None]:
        """The error code of each row that could not be built, None for the others."""
    def reason(self, row: int) -> str | None:
        """The message of one row; None where it was built. Raises `IndexError`."""
    def __len__(self) -> int: ...

def evaluate_batch(
    flexsplines: BatchProfiles,
    circular_splines: BatchProfiles,
    curves: BatchCurves,
    *,
    threshold: float,
    play: bool,
    radial: bool,
    in_motion: float | None = None,
    threads: int = 0,
) -> BatchMetrics:
    """Evaluates designs on `threads` cores (0: all). `threshold` in mm; `in_motion` is the tolerance in mm of the
    certified minimum in motion, if that is wanted. The results do not depend on the number of threads. Ctrl-C stops it
    (`KeyboardInterrupt`)."""
